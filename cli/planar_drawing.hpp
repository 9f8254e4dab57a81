// SPDX-License-Identifier: MIT
// Pictures of planar paths: offsets, curvature comb, curvature profile.
#pragma once

#include <optional>
#include <vector>

#include "cli/offsets.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/io/svg.hpp"

namespace hodograph::cli {

/// The path with offsets along it and their cusps. Throws Error (unsupported) for a path in space,
/// as all of these.
Plot offset_picture(const PathDocument& document, const std::vector<PathOffset>& offsets);

/// Adds offsets and their cusps to the picture of a path.
void add_offsets(Plot& plot, const AnyPath& path, const std::vector<PathOffset>& offsets);

/// The path and, on the outer side of its bends, teeth of length |κ| · scale along the normal. By
/// default the longest tooth is a fixed share of the path's extent. Throws Error (outside_domain)
/// for a scale that is not positive and finite.
Plot curvature_comb(const PathDocument& document, const std::optional<double>& scale);

/// The signed curvature along the arc length, its extremes and inflections marked where they are
/// certain.
Plot curvature_profile(const PathDocument& document);

}  // namespace hodograph::cli
