// SPDX-License-Identifier: MIT
// The points of a path where the distance to a given point is stationary, and the nearest of all.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/detail/distance_search.hpp"
#include "hodograph/path/path.hpp"
#include "hodograph/path/stationary_point.hpp"

namespace hodograph {

/// All local extremes of |r(ξ) - q| on a path, in ascending order of ξ: the zeros of (r - q)·r',
/// the knots where its one-sided values have opposite signs, and both ends of an open path.
///
/// The distance is that of the exact curve of the stored numbers (see path/bounds.hpp). Every zero
/// of (r - q)·r', a polynomial of degree 4n + 1 on each segment, lies in one of the `xi` enclosures
/// (theorem, rounding included; up to the rounding of ξ = ξ_k + h u). A point of zero speed is a
/// zero. Where (r - q)·r' is not distinguished from zero, as on an arc about q, the whole stretch
/// is one entry, `undecided`, represented by its middle. Two zeros on either side of a knot that
/// are within the rounding of the join are one.
///
/// Faults: not_finite (a coordinate of q). Cost: one root isolation a segment.
template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
Result<std::vector<StationaryPoint<point_t<A>>>> stationary_points(const Path<A, n>& path,
                                                                   const point_t<A>& q) {
  if (auto fault = path_detail::query_fault(q)) return *fault;
  return path_detail::all_stationary_points(path, q);
}

/// The nearest point of a path, and the rigorous distance.
template <class Point>
struct NearestPoint {
  StationaryPoint<Point> at;
  Enclosure distance;  ///< contains min |r(ξ) - q| over the whole path, rounding included
};

/// The point of the path nearest to q; of several equally near ones, one. Cost: the cheap bounds
/// |r - q| ≥ (|a - q| + |b - q| - L)/2 (a, b the ends of a segment, L its length: |r - a| + |r - b|
/// ≤ L) for all segments, and one root isolation for each that these do not exclude. Faults:
/// not_finite (a coordinate of q).
template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
Result<NearestPoint<point_t<A>>> nearest_point(const Path<A, n>& path, const point_t<A>& q) {
  if (auto fault = path_detail::query_fault(q)) return *fault;
  const auto found = path_detail::search_nearest(path, q);
  return NearestPoint<point_t<A>>{found.at, found.distance};
}

}  // namespace hodograph
