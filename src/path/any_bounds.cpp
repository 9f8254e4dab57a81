// SPDX-License-Identifier: MIT
#include "hodograph/path/any_bounds.hpp"

#include "hodograph/path/bounds.hpp"
#include "hodograph/path/detail/any_degree.hpp"

namespace hodograph {

Enclosure arc_length_enclosure(const AnyPath& path) {
  return path.visit([](const auto& p) { return arc_length_enclosure(p); });
}

Extremes speed_extremes(const AnyPath& path, const RangeGoal& goal) {
  return path.visit([&](const auto& p) { return speed_extremes(p, goal); });
}

Extremes curvature_extremes(const AnyPath& path, const RangeGoal& goal) {
  return path.visit([&](const auto& p) { return curvature_extremes(p, goal); });
}

std::vector<Extremes> bounding_box(const AnyPath& path, const RangeGoal& goal) {
  return path_detail::in_any_degree(path, [&](const auto& p) {
    const auto box = bounding_box(p, goal);
    return std::vector<Extremes>(box.begin(), box.end());
  });
}

Extremes angular_rate_extremes_per_xi(const AnyPath& path, const RangeGoal& goal) {
  return path_detail::in_any_degree(
      path, [&](const auto& p) { return angular_rate_extremes_per_xi(p, goal); });
}

Extremes angular_rate_extremes_per_arc_length(const AnyPath& path, const RangeGoal& goal) {
  return path_detail::in_any_degree(
      path, [&](const auto& p) { return angular_rate_extremes_per_arc_length(p, goal); });
}

CurvatureParts curvature_parts(const AnyPath& path, std::size_t per_segment) {
  return path.visit([&](const auto& p) { return curvature_parts(p, per_segment); });
}

}  // namespace hodograph
