// SPDX-License-Identifier: MIT
// Where to take the points of a path for drawing and export: its only home. Each function returns
// increasing parameters ξ, the first ξ_0 and the last ξ_N; points_at turns them into points.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodograph/foundation/result.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// More points than this (a gigabyte and a half in space) are refused: the request is a mistake.
inline constexpr std::size_t maximum_sample_count = std::size_t{1} << 26;

/// `count` parameters, evenly spaced in ξ; correctly rounded but for 3 roundings.
/// Faults: too_few (count < 2), unsupported (count > maximum_sample_count).
template <PreimageAlgebra A, std::size_t n>
Result<std::vector<typename A::Scalar>> parameters_even_in_xi(const Path<A, n>& path,
                                                              std::size_t count);

/// `count` parameters, evenly spaced in arc length: s(ξ_j) = j L/(count - 1) to rounding.
/// Faults: as above.
template <PreimageAlgebra A, std::size_t n>
Result<std::vector<typename A::Scalar>> parameters_even_in_arc_length(const Path<A, n>& path,
                                                                      std::size_t count);

/// The parameters at arc lengths 0, step, 2 step, ..., and at the end, which may follow sooner.
/// Faults: outside_domain (step not a finite positive number), unsupported (too many steps).
template <PreimageAlgebra A, std::size_t n>
Result<std::vector<typename A::Scalar>> parameters_by_arc_length_step(
    const Path<A, n>& path, const typename A::Scalar& step);

/// `count` parameters in each segment and the last knot, every knot among them: count intervals a
/// segment, evenly spaced. Faults: too_few (count = 0), unsupported (too many).
template <PreimageAlgebra A, std::size_t n>
Result<std::vector<typename A::Scalar>> parameters_per_segment(const Path<A, n>& path,
                                                               std::size_t count);

/// Parameters, every knot among them, such that every point of the path is within `tolerance` of
/// the chord over its interval: a bound, not an estimate. Over an interval of width w in u a curve
/// stays within w²/8 max|r''| of its chord (in the plane across the chord, where it advances
/// monotonically along it); the control points of r'' and r' bound them. Intervals are halved until
/// the bound, with the rounding of the points added, holds. Faults: outside_domain (tolerance not a
/// finite positive number), tolerance_not_reached (index: the segment; the tolerance is below the
/// rounding of the points, or asks for too many).
template <PreimageAlgebra A, std::size_t n>
Result<std::vector<typename A::Scalar>> polyline_parameters(const Path<A, n>& path,
                                                            const typename A::Scalar& tolerance);

/// r(ξ) for every ξ given. Domain: all inside the knots (throws outside_domain).
template <PreimageAlgebra A, std::size_t n>
std::vector<point_t<A>> points_at(const Path<A, n>& path,
                                  std::span<const typename A::Scalar> parameters);

}  // namespace hodograph

#include "hodograph/path/detail/sampling_impl.hpp"
