// SPDX-License-Identifier: MIT
// All intersections of two planar paths, of one with itself, and of a planar path with a line or a
// segment of one.
//
// The paths are the exact curves of the stored numbers (see path/bounds.hpp). Every common point
// lies in one of the entries (theorem, rounding included; up to the rounding of ξ = ξ_k + h u). A
// `crossing` holds exactly one, where the curves cross with different tangents: certain. Everything
// else is `undecided`: contact with a common tangent, stretches in common (one entry for the whole
// stretch), points of zero speed, an end of a path or segment that lies on the other curve within
// rounding, or curves that miss each other by no more than rounding. At a knot what either side
// finds is one entry; it is a crossing if both sides cross in the same sense, which is certain up
// to the rounding of the join.
#pragma once

#include <cstddef>
#include <vector>

#include "hodograph/foundation/result.hpp"
#include "hodograph/path/detail/intersections_impl.hpp"
#include "hodograph/path/intersection.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// The intersections of two paths, ascending in ξ of the first. For one path with itself, or parts
/// in common, the answer is stretches: see self_intersections.
/// Cost: boxes exclude most pairs of segments; a pair that meets takes some 10 to 100 µs, one that
/// has a stretch in common some 10 ms. Work is bounded for every input.
template <std::size_t n, std::size_t m>
std::vector<PathIntersection> intersections(const PlanarPath<n>& first,
                                            const PlanarPath<m>& second) {
  return path_detail::PathMeetings<n, m>(first, second).run();
}

/// Where a path meets itself: every pair ξ_first < ξ_second with one point lies in one of the
/// entries, ascending in ξ_first, but for what follows each other at a knot (or where a closed path
/// begins). Pieces along which no tangent turns away from some direction have no point in common
/// with themselves; everything else is as for two paths. A crossing is certain. Undecided are,
/// also, stretches gone through twice, points where the path stands still or turns back on itself,
/// and a path that is too close to itself there. Cost: some µs for a segment that turns by less
/// than half a turn, some 100 µs for a loop.
template <std::size_t n>
std::vector<PathIntersection> self_intersections(const PlanarPath<n>& path) {
  return path_detail::PathMeetings<n, n>(path, path).run_with_itself();
}

/// The intersections with the whole line through q along d, ascending in ξ; t is in units of d.
/// Faults: not_finite (a component of q or d), outside_domain (d = 0).
/// Cost: one root isolation of degree 2n + 1 a segment whose control points are on both sides.
template <std::size_t n>
Result<std::vector<LineIntersection>> line_intersections(const PlanarPath<n>& path,
                                                         const Vector2<double>& q,
                                                         const Vector2<double>& d) {
  if (auto fault = path_detail::line_fault(q, d)) return *fault;
  return path_detail::LineMeetings<n>(path, q, d).run();
}

/// The intersections with the segment from a to b, t from 0 to 1. An entry whose t may lie on
/// either side of an end is undecided.
/// Faults: not_finite (a coordinate), outside_domain (a = b, or b - a out of range).
template <std::size_t n>
Result<std::vector<LineIntersection>> segment_intersections(const PlanarPath<n>& path,
                                                            const Vector2<double>& a,
                                                            const Vector2<double>& b) {
  const Vector2<double> d = b - a;
  if (auto fault = path_detail::line_fault(a, d)) return *fault;
  auto found = path_detail::LineMeetings<n>(path, a, b, d).run();
  std::erase_if(
      found, [](const LineIntersection& at) { return at.t.upper() < 0.0 || at.t.lower() > 1.0; });
  for (LineIntersection& at : found) {
    if (at.t.lower() < 0.0 || at.t.upper() > 1.0) at.kind = IntersectionKind::undecided;
  }
  return found;
}

}  // namespace hodograph
