// SPDX-License-Identifier: MIT
// A path as points, frames and series along ξ, ready for pictures.
#pragma once

#include "hodograph/io/document.hpp"
#include "hodograph/io/report.hpp"

namespace hodograph::cli {

/// The path as a polyline with about `frames` frames along it, equally spaced in arc length.
FramedPolyline framed_polyline(const PathDocument& document, std::size_t points,
                               std::size_t frames);

/// Fills in the path and its speed, curvature, torsion and body rate along ξ.
void add_drawing(ReportData& data, const PathDocument& document);

}  // namespace hodograph::cli
