// SPDX-License-Identifier: MIT
#include "hodograph/path/any_nearest.hpp"

#include <optional>
#include <string>

#include "hodograph/path/detail/any_degree.hpp"

namespace hodograph {

namespace {

std::optional<Fault> size_fault(const AnyPath& path, std::span<const double> q) {
  if (q.size() == path.dimension()) return std::nullopt;
  return Fault{FaultCode::mismatched_size,
               "the point has " + std::to_string(q.size()) + " coordinates and the path " +
                   std::to_string(path.dimension()),
               std::nullopt,
               "point",
               static_cast<double>(q.size()),
               static_cast<double>(path.dimension())};
}

template <class Point>
Point point_of(std::span<const double> q) {
  Point point{};
  for (std::size_t i = 0; i < Point::dimension; ++i) point[i] = q[i];
  return point;
}

Vector3<double> in_space(const Vector2<double>& p) { return {p.x, p.y, 0.0}; }
Vector3<double> in_space(const Vector3<double>& p) { return p; }

template <class Point>
StationaryPoint<Vector3<double>> in_space(const StationaryPoint<Point>& at) {
  return {at.xi, at.xi_range, in_space(at.point), at.distance, at.kind};
}

}  // namespace

Result<std::vector<StationaryPoint<Vector3<double>>>> stationary_points(const AnyPath& path,
                                                                        std::span<const double> q) {
  using Points = std::vector<StationaryPoint<Vector3<double>>>;
  if (auto fault = size_fault(path, q)) return *fault;
  return path_detail::in_any_degree(path, [&]<class P>(const P& p) -> Result<Points> {
    const auto found = stationary_points(p, point_of<typename P::Point>(q));
    if (!found) return found.fault();
    Points points;
    for (const auto& at : *found) points.push_back(in_space(at));
    return points;
  });
}

Result<NearestPoint<Vector3<double>>> nearest_point(const AnyPath& path,
                                                    std::span<const double> q) {
  if (auto fault = size_fault(path, q)) return *fault;
  return path_detail::in_any_degree(
      path, [&]<class P>(const P& p) -> Result<NearestPoint<Vector3<double>>> {
        const auto found = nearest_point(p, point_of<typename P::Point>(q));
        if (!found) return found.fault();
        return NearestPoint<Vector3<double>>{in_space(found->at), found->distance};
      });
}

}  // namespace hodograph
