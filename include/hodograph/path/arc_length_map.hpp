// SPDX-License-Identifier: MIT
// From arc length to parameter: the inverse of the exact arc-length polynomial, and its only home.
//
// Laws (each has a test):
//   1. s(u) = target to rounding: within accuracy::arc_length_error(n) of h max|A_i|².
//   2. Monotone without exception: s1 < s2 gives xi1 <= xi2, cusps and stretches at rest included.
//   3. Exact at the ends: 0 gives the first knot, the total length gives the last.
//   4. A bounded number of evaluations, whatever the curve; one or two as a rule.
//
// Law 2 rests on a definition, not on luck. Let ŝ be the computed arc length. The points u = j 2^-D
// are the nodes of a balanced search tree; descending it by the test ŝ(node) <= t ends in one cell
// [j, j + 1) 2^-D, and a search tree orders its outcomes whatever its keys are. Inside the cell u
// is linear in t, and rounding is monotone. So u is a monotone function of t even where ŝ is not.
// The fast way to the cell is Halley's iteration from a tabulated guess; its cell is accepted where
// a bound of the rounding of ŝ proves that the descent would end there too, and the descent itself
// is run where it does not (next to a zero of the speed, or within rounding of a node).
// With D = half the digits + 4, the tangent replaces the curve within a cell to less than rounding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "hodograph/foundation/accuracy.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// The u in [0, 1] at which the curve has come the arc length s from its start. Lengths at and
/// below 0 give 0, at and above the curve's own length 1.
template <PreimageAlgebra A, std::size_t n>
typename A::Scalar parameter_at_arc_length(const PhCurve<A, n>& curve, const typename A::Scalar& s);

/// The place at which the path has come the arc length s. Domain: 0 ≤ s ≤ path.arc_length(), else
/// Error outside_domain, as all that follow.
template <PreimageAlgebra A, std::size_t n>
PathLocation<typename A::Scalar> location_at_arc_length(const Path<A, n>& path,
                                                        const typename A::Scalar& s);

/// The ξ at which the path has come the arc length s.
template <PreimageAlgebra A, std::size_t n>
typename A::Scalar parameter_at_arc_length(const Path<A, n>& path, const typename A::Scalar& s);

/// The point of the path at arc length s, within rounding of position(parameter_at_arc_length(s)),
/// and faster than either: one evaluation where the speed changes little, seldom more than two.
template <PreimageAlgebra A, std::size_t n>
point_t<A> point_at_arc_length(const Path<A, n>& path, const typename A::Scalar& s);

}  // namespace hodograph

#include "hodograph/path/detail/arc_length_map_impl.hpp"
