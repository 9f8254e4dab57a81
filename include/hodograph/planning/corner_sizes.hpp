// SPDX-License-Identifier: MIT
// How large the rounded corners of a polyline are made: the legs L between their bounds, so that
// neighbours fit on the line they share.
//
// Source: "Path planning with Pythagorean-hodograph curves for unmanned or autonomous vehicles",
// section 7: (19) and (20) bound each L, and two corners cannot use more of a line than there is.
// How the room is shared out is this project's.
#pragma once

#include <span>
#include <vector>

#include "hodograph/foundation/result.hpp"

namespace hodograph {

/// What one corner asks, and what its leg does.
struct CornerRoom {
  double least = 0.0;           ///< L ≥ least (20)
  double most = 0.0;            ///< L ≤ most (19)
  double saving = 0.0;          ///< by how much the path gets shorter for a unit of L; ≥ 0
  double peak_curvature = 0.0;  ///< |κ| at the middle, times L
};

/// What the sizes are chosen for.
enum class CornerAim {
  smallest,              ///< every L as small as it may be: closest to the polyline
  largest,               ///< all rise together from least to most; who meets a full line stays
  least_length,          ///< the path is as short as it can be
  least_peak_curvature,  ///< the largest curvature is least; of those, the smallest corners
};

/// The legs of corners 0 ... n - 1, which stand between lines 0 ... n of the given lengths.
///
/// Method: smallest: the bounds. largest: L_i = least_i + t (most_i - least_i) with one t for all,
/// raised until a line is full; its corners keep their t, the others go on. least_length: the
/// linear program max Σ saving_i L_i, solved exactly along the chain by concave functions of the
/// room that is left. least_peak_curvature: κ = max of peak_i/most_i and, over the lines, (peak_i +
/// peak_j)/ℓ, in closed form, no less than what the least legs leave. Exact but for rounding: legs
/// keep their bounds exactly, and lines to 2 ε of their length.
///
/// Cost: O(n log n), largest and least_length O(n²) at worst. Faults: mismatched_size (not one line
/// more than corners), outside_domain (a number that is negative or not finite, with the index),
/// no_interpolant (with the index of the corner: least > most; of the line: its two least legs need
/// more than its length; with both numbers).
Result<std::vector<double>> corner_sizes(std::span<const double> lines,
                                         std::span<const CornerRoom> corners, CornerAim aim);

}  // namespace hodograph
