// SPDX-License-Identifier: MIT
// The coefficients of a path's own polynomials, whatever its kind.
#pragma once

#include <vector>

#include "hodograph/path/any_path.hpp"

namespace hodograph::control_detail {

/// The Bernstein coefficients of (displacement from the segment's start, arc length) of every
/// segment, 2n + 2 a segment, dimension + 1 numbers each: as the library holds them.
std::vector<double> integral_coefficients(const AnyPath& path);

}  // namespace hodograph::control_detail
