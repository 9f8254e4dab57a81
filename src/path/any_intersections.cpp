// SPDX-License-Identifier: MIT
// Of hodograph/path/any_planar.hpp the intersections.
#include <algorithm>

#include "hodograph/path/any_planar.hpp"
#include "hodograph/path/detail/any_degree.hpp"
#include "hodograph/path/intersections.hpp"

namespace hodograph {

std::vector<PathIntersection> intersections(const AnyPath& first, const AnyPath& second) {
  for (const AnyPath* path : {&first, &second}) {
    if (path->dimension() != 2) throw Error(path_detail::of_other_dimension("an intersection", 3));
  }
  if (first.preimage_degree() < second.preimage_degree()) {
    return intersections(with_preimage_degree(first, second.preimage_degree()).value(), second);
  }
  return path_detail::in_planar_degree(first, [&]<class P>(const P& p) {
    const AnyPath other = with_preimage_degree(second, P::preimage_degree).value();
    return intersections(p, *other.get_if<P>());
  });
}

std::vector<PathIntersection> self_intersections(const AnyPath& path) {
  if (path.dimension() != 2) throw Error(path_detail::of_other_dimension("an intersection", 3));
  return path_detail::in_planar_degree(path, [](const auto& p) { return self_intersections(p); });
}

Result<std::vector<LineIntersection>> line_intersections(const AnyPath& path,
                                                         const Vector2<double>& q,
                                                         const Vector2<double>& d) {
  if (path.dimension() != 2) return path_detail::of_other_dimension("an intersection", 3);
  return path_detail::in_planar_degree(path,
                                       [&](const auto& p) { return line_intersections(p, q, d); });
}

Result<std::vector<LineIntersection>> segment_intersections(const AnyPath& path,
                                                            const Vector2<double>& a,
                                                            const Vector2<double>& b) {
  if (path.dimension() != 2) return path_detail::of_other_dimension("an intersection", 3);
  return path_detail::in_planar_degree(
      path, [&](const auto& p) { return segment_intersections(p, a, b); });
}

}  // namespace hodograph
