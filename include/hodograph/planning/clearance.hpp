// SPDX-License-Identifier: MIT
// How near a planar path comes to the obstacles of a world: certified, for every point of the path.
//
// Source: this project's. A piece of the path is as far from its chord as its control points are
// from the points of the chord at the same parameters, at most; that falls by four with every
// halving, so a few halvings near the nearest place decide.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/detail/enclosed_curve.hpp"
#include "hodograph/path/path.hpp"
#include "hodograph/planning/world.hpp"

namespace hodograph {

/// How near a path comes to one obstacle (or to the bounds from inside).
struct ObstacleClearance {
  std::uint32_t obstacle = 0;  ///< WorldVertex::bounds for the bounds
  /// Contains the least distance between the path and the solid, rounding included; 0 is in it
  /// where the path meets the solid, and it is {0} where the path begins inside.
  Enclosure distance;
  double xi = 0.0;            ///< where the path comes as near as distance.upper(), within rounding
  Vector2<double> nearest{};  ///< the nearest point of the obstacle's boundary to that place
};

/// What clearances() found.
struct PathClearance {
  std::vector<ObstacleClearance> near{};  ///< in ascending order of obstacles, the bounds last
  /// Every obstacle that is not in `near`, and the bounds if they are not, are at least this far.
  double reach = 0.0;
  /// The least distance to any: of `near`, or at least reach where that is empty.
  Enclosure least() const;
};

/// An enclosure of the distance is at most this wide, in units of the largest coordinate of world
/// and path.
inline constexpr double clearance_width = 0x1p-38;

namespace planning_detail {

/// One segment of a path: its control points, each coordinate off by at most `error`.
struct ControlPolygon {
  std::span<const Vector2<double>> points{};
  double error = 0.0;
  double xi_begin = 0.0, xi_end = 0.0;
};

/// The position of a segment in Bernstein form, of degree 2n + 1; the error is returned.
template <std::size_t n>
double control_points(const PlanarPhCurve<n>& curve, std::vector<Vector2<double>>& points) {
  const path_detail::EnclosedCurve<Complex<double>, n> exact(curve);
  const Enclosure factor = (exact.step() * path_detail::power_of_two(exact.exponent())) *
                           path_detail::power_of_two(exact.exponent());
  const auto displacement = exact.hodograph().antiderivative();
  const auto start = path_detail::enclosed(curve.start());
  double error = 0.0;
  for (const auto& d : displacement.coefficients()) {
    Vector2<double> p;
    for (std::size_t j = 0; j < 2; ++j) {
      const Enclosure c = start[j] + factor * d[j];
      p[j] = c.middle();
      error = std::max(error, c.width());
    }
    points.push_back(p);
  }
  return error;
}

}  // namespace planning_detail

/// The edges of a world, indexed. A value; copies share the index, which never changes.
class ClearanceIndex {
 public:
  /// Cost: O(n log n).
  explicit ClearanceIndex(World world);

  const World& world() const;

  /// The distance of the path from every obstacle, and from the bounds, that it comes within
  /// `reach` of. Units: those of the coordinates. The distance is that of the exact curve of the
  /// stored numbers (see path/bounds.hpp). Faults: outside_domain (a reach that is negative or not
  /// finite; a path that leaves largest_world_coordinate).
  template <std::size_t n>
  Result<PathClearance> clearance(const PlanarPath<n>& path, double reach) const {
    std::vector<Vector2<double>> points;
    std::vector<double> errors;
    points.reserve(path.segment_count() * (2 * n + 2));
    for (const auto& curve : path.segments()) {
      errors.push_back(planning_detail::control_points(curve, points));
    }
    std::vector<planning_detail::ControlPolygon> polygons;
    for (std::size_t k = 0; k < path.segment_count(); ++k) {
      polygons.push_back({std::span(points).subspan(k * (2 * n + 2), 2 * n + 2), errors[k],
                          path.knots()[k], path.knots()[k + 1]});
    }
    return clearance_of(polygons, reach);
  }

 private:
  struct Edges;
  Result<PathClearance> clearance_of(std::span<const planning_detail::ControlPolygon> path,
                                     double reach) const;
  std::shared_ptr<const Edges> edges_;
};

}  // namespace hodograph
