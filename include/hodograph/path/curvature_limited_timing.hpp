// SPDX-License-Identifier: MIT
// The fastest timing of a path whose lateral acceleration v²|κ| keeps a bound at every point.
#pragma once

#include <cstddef>

#include "hodograph/foundation/result.hpp"
#include "hodograph/path/curvature_parts.hpp"
#include "hodograph/path/timing_law.hpp"

namespace hodograph {

/// What a vehicle can do along a path: its largest lateral acceleration, and TimingLaw's limits,
/// whose cruise speed is the largest anywhere.
struct LateralLimit {
  double lateral_acceleration = 1.0;
  TrapezoidalSpeed along{};
  std::size_t parts_per_segment = 32;  ///< more come closer to the bound, from below
};

/// The fastest law with v² ≤ lateral_acceleration/κ_i on every part i of the path, κ_i the part's
/// rigorous curvature bound, under the longitudinal limits (TimingLaw::under_limits). So v²|κ|
/// keeps the bound at every point of the exact path, up to four roundings of the speed; the slower
/// limit of two neighbouring parts holds beyond their border by as much as rounding may have moved
/// it. Faults: outside_domain (numbers that are not positive), no_interpolant (a stretch where the
/// curvature has no bound: a point of zero speed; the speeds at the ends, see under_limits).
Result<TimingLaw> curvature_limited_timing(const CurvatureParts& parts, const LateralLimit& limit,
                                           double start_time = 0.0);

template <class A, std::size_t n>
Result<TimingLaw> curvature_limited_timing(const Path<A, n>& path, const LateralLimit& limit,
                                           double start_time = 0.0) {
  return curvature_limited_timing(
      curvature_parts(path, limit.parts_per_segment > 0 ? limit.parts_per_segment : 1), limit,
      start_time);
}

}  // namespace hodograph
