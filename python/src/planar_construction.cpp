// SPDX-License-Identifier: MIT
// Paths in the plane from data: Hermite data, rounded polylines, waypoints, splines.
#include <optional>
#include <string>
#include <vector>

#include "hodograph/construction/corner.hpp"
#include "hodograph/construction/planar_hermite.hpp"
#include "hodograph/construction/planar_spline.hpp"
#include "hodograph/construction/waypoint_tangents.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"

namespace hodograph::python {

namespace {

using Point = Vector2<double>;

AnyPath hermite(std::vector<double> knots, const Doubles& positions, const Doubles& derivatives,
                bool closed) {
  const auto at = points_of<Point>(positions, "positions");
  const auto along = points_of<Point>(derivatives, "derivatives");
  if (at.size() != along.size()) {
    throw Error(Fault{FaultCode::mismatched_size,
                      "every position has a derivative; got " + std::to_string(at.size()) +
                          " positions and " + std::to_string(along.size()) + " derivatives",
                      std::nullopt, "derivatives", static_cast<double>(along.size()),
                      static_cast<double>(at.size())});
  }
  std::vector<PlanarHermitePoint> points(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) points[i] = {at[i], along[i]};
  return unlocked(
      [&]() -> AnyPath { return planar_hermite_path(std::move(knots), points, closed).value(); });
}

AnyPath rounded(const Doubles& points, std::optional<double> curvature,
                std::optional<double> deviation, bool closed) {
  const auto corners = points_of<Point>(points, "points");
  const CornerRule rule{curvature, deviation, closed};
  return unlocked([&]() -> AnyPath { return rounded_polyline(corners, rule).value(); });
}

AnyPath through_waypoints(const Doubles& points, TangentRule rule, bool closed, double speed) {
  const auto waypoints = points_of<Point>(points, "points");
  WaypointOptions options;
  options.rule = rule;
  options.closed = closed;
  options.speed = speed;
  return unlocked([&]() -> AnyPath { return waypoint_path(waypoints, options).value(); });
}

AnyPath spline(const Doubles& points, bool closed, SplineParameters parameters,
               RepeatedPoints repeated) {
  const auto waypoints = points_of<Point>(points, "points");
  PlanarSplineOptions options;
  options.closed = closed;
  options.parameters = parameters;
  options.repeated = repeated;
  return unlocked([&]() -> AnyPath { return planar_spline(waypoints, options).value().path; });
}

}  // namespace

void bind_planar_construction(py::module_& m) {
  py::enum_<TangentRule>(m, "TangentRule", "How tangents at waypoints are chosen.")
      .value("t1", TangentRule::t1)
      .value("t2", TangentRule::t2);
  py::enum_<SplineParameters>(m, "SplineParameters", "The knots of a planar spline.")
      .value("uniform", SplineParameters::uniform, "1 each, as published.")
      .value("chord_length", SplineParameters::chord_length, "The chord's length.");
  py::enum_<RepeatedPoints>(m, "RepeatedPoints", "What becomes of a point that repeats the last.")
      .value("refuse", RepeatedPoints::refuse)
      .value("merge", RepeatedPoints::merge);

  m.def("planar_hermite_path", &hermite, py::arg("knots"), py::arg("positions"),
        py::arg("derivatives"), py::kw_only(), py::arg("closed") = false,
        "The C1 planar path of quintics through positions (n, 2) with derivatives (n, 2) with "
        "respect to\nxi; of the four curves of every span, the one that turns least.");
  m.def("rounded_polyline", &rounded, py::arg("points"), py::kw_only(),
        py::arg("most_curvature") = py::none(), py::arg("most_deviation") = py::none(),
        py::arg("closed") = false,
        "The polyline with every corner rounded by one symmetric quintic: curvature is "
        "continuous and at\nmost most_curvature, the corner is missed by at most most_deviation.");
  m.def("waypoint_path", &through_waypoints, py::arg("points"), py::kw_only(),
        py::arg("rule") = TangentRule::t2, py::arg("closed") = false, py::arg("speed") = 1.0,
        "The C1 path through points (n, 2) with tangents by a rule.");
  m.def("planar_spline", &spline, py::arg("points"), py::kw_only(), py::arg("closed") = false,
        py::arg("parameters") = SplineParameters::uniform,
        py::arg("repeated") = RepeatedPoints::refuse,
        "The C2 spline of quintics through points (n, 2), natural or periodic.");
}

}  // namespace hodograph::python
