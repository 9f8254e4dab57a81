// SPDX-License-Identifier: MIT
// How planar paths turn and bend, what they go round, and where they meet: path/any_planar.hpp; the
// nearest points of any path: path/any_nearest.hpp.
#include "hodograph/path/any_planar.hpp"

#include <string>
#include <utility>
#include <vector>

#include "hodograph/path/any_nearest.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

void bind_turning(py::module_& m) {
  Record<RotationIndices>(m, "RotationIndices", "The two rotation indices, enclosed, radians.")
      .field("absolute", &RotationIndices::absolute, "The integral of |kappa|.")
      .field("with_sign", &RotationIndices::with_sign, "The integral of kappa.");
  m.def(
      "rotation_index", [](const AnyPath& path) { return rotation_index(path); }, py::arg("path"),
      "The angle by which the tangent of a planar path turns, radians, positive to the left, full "
      "turns\nincluded. Raises HodographError: unsupported (a path in space), as all of this "
      "kind.");
  m.def(
      "absolute_rotation_index", [](const AnyPath& path) { return absolute_rotation_index(path); },
      py::arg("path"),
      "How much the tangent turns to the left and to the right together, radians.");
  m.def(
      "rotation_index_enclosures",
      [](const AnyPath& path) { return rotation_index_enclosures(path); }, py::arg("path"),
      "Both of the exact curve of the stored numbers, enclosed.");
  m.def(
      "rotation_index_enclosure",
      [](const AnyPath& path) { return rotation_index_enclosures(path).with_sign; },
      py::arg("path"), "rotation_index, enclosed.");
  m.def(
      "absolute_rotation_index_enclosure",
      [](const AnyPath& path) { return rotation_index_enclosures(path).absolute; }, py::arg("path"),
      "absolute_rotation_index, enclosed.");
  m.def(
      "signed_area", [](const AnyPath& path) { return signed_area(path); }, py::arg("path"),
      "The area that a planar path goes round, positive to the left; an open one is closed by its "
      "chord.");
  m.def(
      "signed_area_enclosure", [](const AnyPath& path) { return signed_area_enclosure(path); },
      py::arg("path"), "The same, enclosed.");
}

void bind_curvature(py::module_& m) {
  py::enum_<CurvatureExtremeKind>(m, "CurvatureExtremeKind",
                                  "What the signed curvature does at a stationary point.")
      .value("minimum", CurvatureExtremeKind::minimum)
      .value("maximum", CurvatureExtremeKind::maximum)
      .value("undecided", CurvatureExtremeKind::undecided);
  Record<CurvatureStationaryPoint>(m, "CurvatureStationaryPoint", "A zero of kappa'.")
      .field("xi", &CurvatureStationaryPoint::xi)
      .field("xi_range", &CurvatureStationaryPoint::xi_range, "Contains the true parameter.")
      .field("curvature", &CurvatureStationaryPoint::curvature, "Of every point of xi_range.")
      .field("kind", &CurvatureStationaryPoint::kind);
  Record<Inflection>(m, "Inflection", "Where the curvature of a planar path vanishes.")
      .field("xi", &Inflection::xi)
      .field("xi_range", &Inflection::xi_range, "Contains the true parameter.")
      .field("kind", &Inflection::kind, "simple: the curvature changes its sign there.");
  m.def(
      "curvature_stationary_points",
      [](const AnyPath& path) {
        return unlocked([&] { return curvature_stationary_points(path); });
      },
      py::arg("path"),
      "Where the curvature of a planar path is stationary, ascending; every such place lies in an "
      "entry.");
  m.def(
      "inflections",
      [](const AnyPath& path) { return unlocked([&] { return inflections(path); }); },
      py::arg("path"), "Where the curvature of a planar path vanishes, ascending.");
  m.def(
      "curvature_stays_within",
      [](const AnyPath& path, double limit) {
        return unlocked([&] { return curvature_stays_within(path, limit); });
      },
      py::arg("path"), py::arg("limit"), "Whether |kappa| <= limit everywhere on a planar path.");
}

void bind_meetings(py::module_& m) {
  py::enum_<IntersectionKind>(m, "IntersectionKind", "What is certain where curves meet.")
      .value("crossing", IntersectionKind::crossing, "Exactly one common point.")
      .value("undecided", IntersectionKind::undecided, "Within rounding, anything.");
  Record<PathIntersection>(m, "PathIntersection", "Where two planar paths meet.")
      .field("xi_first", &PathIntersection::xi_first)
      .field("xi_second", &PathIntersection::xi_second)
      .field("xi_first_range", &PathIntersection::xi_first_range)
      .field("xi_second_range", &PathIntersection::xi_second_range)
      .field("point", &PathIntersection::point, "Of the first path, (2,).")
      .field("kind", &PathIntersection::kind);
  Record<LineIntersection>(m, "LineIntersection", "Where a planar path meets a line.")
      .field("xi", &LineIntersection::xi)
      .field("xi_range", &LineIntersection::xi_range)
      .field("t", &LineIntersection::t, "Contains the place on the line, in units of its vector.")
      .field("point", &LineIntersection::point, "(2,).")
      .field("kind", &LineIntersection::kind);
  m.def(
      "intersections",
      [](const AnyPath& first, const AnyPath& second) {
        return unlocked([&] { return intersections(first, second); });
      },
      py::arg("first"), py::arg("second"),
      "Where two planar paths meet, ascending in xi of the first; every common point lies in an "
      "entry.");
  m.def(
      "self_intersections",
      [](const AnyPath& path) { return unlocked([&] { return self_intersections(path); }); },
      py::arg("path"), "Where a planar path meets itself, ascending in the smaller xi.");
  using Point = Vector2<double>;
  m.def(
      "line_intersections",
      [](const AnyPath& path, const Doubles& point, const Doubles& direction) {
        return line_intersections(path, point_of<Point>(point, "point"),
                                  point_of<Point>(direction, "direction"))
            .value();
      },
      py::arg("path"), py::arg("point"), py::arg("direction"),
      "Where a planar path meets the whole line through a point along a direction. Raises "
      "HodographError:\nnot_finite, outside_domain (no direction).");
  m.def(
      "segment_intersections",
      [](const AnyPath& path, const Doubles& a, const Doubles& b) {
        return segment_intersections(path, point_of<Point>(a, "a"), point_of<Point>(b, "b"))
            .value();
      },
      py::arg("path"), py::arg("a"), py::arg("b"),
      "Where a planar path meets the segment from a to b; t runs from 0 to 1.");
}

/// StationaryPoint<Point> of either dimension, and NearestPoint.
struct Stationary {
  double xi = 0.0;
  Enclosure xi_range;
  std::vector<double> point;
  double distance = 0.0;
  StationaryKind kind = StationaryKind::undecided;
};
struct Nearest {
  Stationary at;
  Enclosure distance;
};

Stationary stationary_of(const StationaryPoint<Vector3<double>>& at, std::size_t dimension) {
  std::vector<double> point(dimension);
  for (std::size_t i = 0; i < dimension; ++i) point[i] = at.point[i];
  return {at.xi, at.xi_range, std::move(point), at.distance, at.kind};
}

std::span<const double> query(const AnyPath& path, const Doubles& q) {
  if (q.ndim() != 1 || static_cast<std::size_t>(q.shape(0)) != path.dimension()) {
    refuse_shape("q", "(" + std::to_string(path.dimension()) + ",), as the path's points", q);
  }
  return numbers(q);
}

void bind_nearest(py::module_& m) {
  py::enum_<StationaryKind>(m, "StationaryKind", "What the distance does at a stationary point.")
      .value("minimum", StationaryKind::minimum)
      .value("maximum", StationaryKind::maximum)
      .value("undecided", StationaryKind::undecided);
  Record<Stationary>(m, "StationaryPoint", "Where the distance to a point is stationary.")
      .field("xi", &Stationary::xi)
      .field("xi_range", &Stationary::xi_range, "Contains the true parameter.")
      .field("point", &Stationary::point, "r(xi), (d,).")
      .field("distance", &Stationary::distance, "To evaluation accuracy.")
      .field("kind", &Stationary::kind);
  Record<Nearest>(m, "NearestPoint", "The nearest point of a path, and the rigorous distance.")
      .field("at", &Nearest::at)
      .field("distance", &Nearest::distance, "Contains the least distance, rounding included.");
  m.def(
      "stationary_points",
      [](const AnyPath& path, const Doubles& q) {
        const auto at = query(path, q);
        std::vector<Stationary> points;
        for (const auto& one : unlocked([&] { return stationary_points(path, at).value(); })) {
          points.push_back(stationary_of(one, path.dimension()));
        }
        return points;
      },
      py::arg("path"), py::arg("q"),
      "All local extremes of the distance from q (d,) on the path, ascending. Raises "
      "HodographError:\nnot_finite, mismatched_size.");
  m.def(
      "nearest_point",
      [](const AnyPath& path, const Doubles& q) {
        const auto at = query(path, q);
        const auto found = unlocked([&] { return nearest_point(path, at).value(); });
        return Nearest{stationary_of(found.at, path.dimension()), found.distance};
      },
      py::arg("path"), py::arg("q"), "The point of the path nearest to q (d,). Raises as above.");
}

}  // namespace

void bind_planar_analysis(py::module_& m) {
  bind_turning(m);
  bind_curvature(m);
  bind_meetings(m);
  bind_nearest(m);
}

}  // namespace hodograph::python
