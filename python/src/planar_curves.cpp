// SPDX-License-Identifier: MIT
// Single planar quintics: Hermite data, prescribed lengths, corners:
// construction/planar_hermite.hpp, prescribed_length.hpp, corner.hpp, waypoint_tangents.hpp.
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "hodograph/construction/corner.hpp"
#include "hodograph/construction/planar_hermite.hpp"
#include "hodograph/construction/prescribed_length.hpp"
#include "hodograph/construction/waypoint_tangents.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"
#include "python/src/curves.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

using Point = Vector2<double>;

struct Hermite {
  AnyPath curve = unit_line();
  double rotation_index = 0.0, margin = 0.0;
  TieBreak tie = TieBreak::none;
};
struct Solution {
  AnyPath curve = unit_line();
  double rotation_index = 0.0;
};
struct OfLength {
  AnyPath curve = unit_line();
  double rotation_index = 0.0, margin = 0.0;
  TieBreak tie = TieBreak::none;
  double unavoidable_rotation = 0.0;
  bool loop_free = true;
};
struct Rounded {
  AnyPath curve = unit_line();
  double leg = 0.0;
  CornerShape shape;
};

template <class Solutions>
std::vector<Solution> solutions_of(const Solutions& made) {
  std::vector<Solution> all;
  for (const auto& one : made) all.push_back({path_of(one.curve), one.rotation_index});
  return all;
}

PlanarHermitePoint hermite_point(const Doubles& position, const Doubles& derivative,
                                 const std::string& name) {
  return {point_of<Point>(position, name), point_of<Point>(derivative, name + "_derivative")};
}
DirectedPoint directed(const Doubles& position, const Doubles& direction, const std::string& name) {
  return {point_of<Point>(position, name), point_of<Point>(direction, name + "_direction")};
}
Corner corner_at(const Doubles& before, const Doubles& corner, const Doubles& after) {
  return {point_of<Point>(before, "before"), point_of<Point>(corner, "corner"),
          point_of<Point>(after, "after")};
}
Rounded rounded_of(const RoundedCorner& made) {
  return {path_of(made.curve), made.leg, made.shape};
}

/// Throws Error (not_finite) unless it is a number.
double finite(double x, const char* name) {
  if (std::isfinite(x)) return x;
  throw Error(Fault{FaultCode::not_finite,
                    std::string(name) + " should be a finite number; got " + to_text(x),
                    std::nullopt, name, x, std::nullopt});
}

void bind_types(py::module_& m) {
  py::enum_<TieBreak>(m, "TieBreak", "What decided between solutions of equal rotation index.")
      .value("none", TieBreak::none, "There was no tie.")
      .value("regularity", TieBreak::regularity, "The larger least speed.")
      .value("left_turn", TieBreak::left_turn, "The curve that turns to the left.")
      .value("order", TieBreak::order, "Nothing but the order.");
  py::enum_<LengthSolutions>(m, "LengthSolutions", "Which solutions there are to choose from.")
      .value("published", LengthSolutions::published, "Two.")
      .value("all", LengthSolutions::all, "Four: also a full turn more or less.");
  m.attr("accuracy_of_rotation_index") = accuracy_of_rotation_index;
  Record<Hermite>(m, "PlanarHermite", "The chosen one of four Hermite interpolants.")
      .field("curve", &Hermite::curve, "One quintic on [0, h].")
      .field("rotation_index", &Hermite::rotation_index, "The least of the four, radians.")
      .field("margin", &Hermite::margin, "By how much the next larger one exceeds it.")
      .field("tie", &Hermite::tie);
  Record<Solution>(m, "PlanarSolution", "One of several solutions.")
      .field("curve", &Solution::curve)
      .field("rotation_index", &Solution::rotation_index, "Radians.");
  Record<OfLength>(m, "PrescribedLength", "The curve of a length, and how good it is.")
      .field("curve", &OfLength::curve, "One quintic on [0, h].")
      .field("rotation_index", &OfLength::rotation_index, "The least of the solutions, radians.")
      .field("margin", &OfLength::margin, "By how much the next larger one exceeds it.")
      .field("tie", &OfLength::tie)
      .field("unavoidable_rotation", &OfLength::unavoidable_rotation, "Radians.")
      .field("loop_free", &OfLength::loop_free, "No loop that it could do without.");
  Record<CornerShape>(m, "CornerShape", "The numbers of a rounded corner for a leg of 1.")
      .field("turning_angle", &CornerShape::turning_angle, "Radians, positive to the left.")
      .field("peak_curvature", &CornerShape::peak_curvature, "|kappa| at the middle.")
      .field("arc_length", &CornerShape::arc_length)
      .field("deviation", &CornerShape::deviation, "Of the middle from the corner point.");
  Record<Rounded>(m, "RoundedCorner", "A corner rounded by one quintic.")
      .field("curve", &Rounded::curve, "On [0, h].")
      .field("leg", &Rounded::leg, "From either end to the corner point.")
      .field("shape", &Rounded::shape, "For this leg.");
}

void bind_hermite(py::module_& m) {
  m.def(
      "planar_hermite",
      [](const Doubles& begin, const Doubles& begin_derivative, const Doubles& end,
         const Doubles& end_derivative, double h) {
        const auto made = planar_hermite(hermite_point(begin, begin_derivative, "begin"),
                                         hermite_point(end, end_derivative, "end"), h)
                              .value();
        return Hermite{path_of(made.curve), made.rotation_index, made.margin, made.tie};
      },
      py::arg("begin"), py::arg("begin_derivative"), py::arg("end"), py::arg("end_derivative"),
      py::kw_only(), py::arg("h") = 1.0,
      "The C1 Hermite quintic between points with derivatives, (2,) each, over [0, h]: the one of "
      "four that\nturns least. Raises HodographError: not_finite, outside_domain, zero_speed, "
      "no_interpolant.");
  m.def(
      "planar_hermite_solutions",
      [](const Doubles& begin, const Doubles& begin_derivative, const Doubles& end,
         const Doubles& end_derivative, double h) {
        return solutions_of(
            planar_hermite_solutions(hermite_point(begin, begin_derivative, "begin"),
                                     hermite_point(end, end_derivative, "end"), h)
                .value());
      },
      py::arg("begin"), py::arg("begin_derivative"), py::arg("end"), py::arg("end_derivative"),
      py::kw_only(), py::arg("h") = 1.0, "All four, by increasing rotation index.");
  m.def(
      "hermite_data_of_control_points",
      [](const Doubles& p0, const Doubles& p1, const Doubles& p4, const Doubles& p5, double h) {
        if (!(finite(h, "h") > 0.0)) {
          throw Error(Fault{FaultCode::outside_domain,
                            "a parameter interval has a positive length; got " + to_text(h),
                            std::nullopt, "h", h, 0.0});
        }
        const auto data =
            hermite_data_of_control_points(point_of<Point>(p0, "p0"), point_of<Point>(p1, "p1"),
                                           point_of<Point>(p4, "p4"), point_of<Point>(p5, "p5"), h);
        return std::pair(array_of(std::vector<Point>{data[0].position, data[1].position}),
                         array_of(std::vector<Point>{data[0].derivative, data[1].derivative}));
      },
      py::arg("p0"), py::arg("p1"), py::arg("p4"), py::arg("p5"), py::kw_only(), py::arg("h") = 1.0,
      "Positions (2, 2) and derivatives (2, 2) at the ends of a quintic with these control "
      "points.");
  m.def(
      "direction_of_angle",
      [](double theta) { return array_of(direction_of_angle(finite(theta, "theta"))); },
      py::arg("theta"), "(cos theta, sin theta).");
  m.def(
      "prescribed_length_curve",
      [](const Doubles& begin, const Doubles& begin_direction, const Doubles& end,
         const Doubles& end_direction, double length, double h, LengthSolutions among) {
        const auto made =
            prescribed_length_curve(directed(begin, begin_direction, "begin"),
                                    directed(end, end_direction, "end"), length, h, among)
                .value();
        return OfLength{path_of(made.curve),       made.rotation_index, made.margin, made.tie,
                        made.unavoidable_rotation, made.loop_free};
      },
      py::arg("begin"), py::arg("begin_direction"), py::arg("end"), py::arg("end_direction"),
      py::arg("length"), py::kw_only(), py::arg("h") = 1.0,
      py::arg("among") = LengthSolutions::published,
      "The quintic of exactly this arc length between two points with directions (of any length): "
      "of its\nsolutions, the one that turns least. Raises HodographError: not_finite, "
      "outside_domain, no_interpolant (the\nlength is below the distance).");
  m.def(
      "prescribed_length_solutions",
      [](const Doubles& begin, const Doubles& begin_direction, const Doubles& end,
         const Doubles& end_direction, double length, double h, LengthSolutions among) {
        return solutions_of(prescribed_length_solutions(directed(begin, begin_direction, "begin"),
                                                        directed(end, end_direction, "end"), length,
                                                        h, among)
                                .value());
      },
      py::arg("begin"), py::arg("begin_direction"), py::arg("end"), py::arg("end_direction"),
      py::arg("length"), py::kw_only(), py::arg("h") = 1.0,
      py::arg("among") = LengthSolutions::published, "All of them, by increasing rotation index.");
  m.def(
      "crosses_itself",
      [](const AnyPath& path) {
        const auto* quintic = path.get_if<PlanarPath<2>>();
        if (quintic == nullptr || quintic->segment_count() != 1) {
          throw Error(Fault{FaultCode::unsupported,
                            "this is decided for a path of one planar quintic; got one of " +
                                std::to_string(path.segment_count()) + " segments of degree " +
                                std::to_string(path.degree()) + " in " +
                                std::to_string(path.dimension()) + " dimensions",
                            std::nullopt, "path", static_cast<double>(path.degree()), 5.0});
        }
        return crosses_itself(quintic->segment(0));
      },
      py::arg("path"),
      "Whether one planar quintic meets itself. Raises HodographError: unsupported.");
}

void bind_corners(py::module_& m) {
  m.def(
      "corner_shape",
      [](const Doubles& before, const Doubles& corner, const Doubles& after) {
        return corner_shape(corner_at(before, corner, after)).value();
      },
      py::arg("before"), py::arg("corner"), py::arg("after"),
      "The numbers of the corner between three points (2,), for a leg of 1. Raises HodographError: "
      "not_finite,\noutside_domain.");
  m.def(
      "corner_of_leg",
      [](const Doubles& before, const Doubles& corner, const Doubles& after, double leg, double h) {
        return rounded_of(corner_of_leg(corner_at(before, corner, after), leg, h).value());
      },
      py::arg("before"), py::arg("corner"), py::arg("after"), py::arg("leg"), py::kw_only(),
      py::arg("h") = 1.0, "The corner rounded from the distance of its ends to the corner point.");
  m.def(
      "corner_of_curvature",
      [](const Doubles& before, const Doubles& corner, const Doubles& after, double most_curvature,
         double h) {
        return rounded_of(
            corner_of_curvature(corner_at(before, corner, after), most_curvature, h).value());
      },
      py::arg("before"), py::arg("corner"), py::arg("after"), py::arg("most_curvature"),
      py::kw_only(), py::arg("h") = 1.0,
      "The smallest one whose curvature is at most this. Raises HodographError: also "
      "no_interpolant.");
  m.def(
      "corner_of_deviation",
      [](const Doubles& before, const Doubles& corner, const Doubles& after, double most_deviation,
         double h) {
        return rounded_of(
            corner_of_deviation(corner_at(before, corner, after), most_deviation, h).value());
      },
      py::arg("before"), py::arg("corner"), py::arg("after"), py::arg("most_deviation"),
      py::kw_only(), py::arg("h") = 1.0, "The largest one that deviates by at most this.");
  m.def(
      "corner_of_room",
      [](const Doubles& before, const Doubles& corner, const Doubles& after, double h) {
        return rounded_of(corner_of_room(corner_at(before, corner, after), h).value());
      },
      py::arg("before"), py::arg("corner"), py::arg("after"), py::kw_only(), py::arg("h") = 1.0,
      "The largest one that the lines have room for.");
  m.def(
      "corner_clearance_factor",
      [](double turning_angle) {
        return corner_clearance_factor(finite(turning_angle, "turning_angle"));
      },
      py::arg("turning_angle"),
      "The clearance from an obstacle's vertex, over the smallest turning radius, that a corner "
      "needs.");
  m.def(
      "rounded_polyline_of_legs",
      [](const Doubles& points, const Doubles& legs, bool closed) -> AnyPath {
        const auto corners = points_of<Point>(points, "points");
        if (legs.ndim() != 1) refuse_shape("legs", "(n,), one a corner", legs);
        return rounded_polyline_of_legs(corners, numbers(legs), closed).value();
      },
      py::arg("points"), py::arg("legs"), py::kw_only(), py::arg("closed") = false,
      "The polyline (n, 2) with the leg of every corner given. Raises HodographError: those of\n"
      "rounded_polyline, mismatched_size.");
  m.def(
      "waypoint_tangents",
      [](const Doubles& points, TangentRule rule, bool closed) {
        WaypointOptions options;
        options.rule = rule;
        options.closed = closed;
        return array_of(waypoint_tangents(points_of<Point>(points, "points"), options).value());
      },
      py::arg("points"), py::kw_only(), py::arg("rule") = TangentRule::t2,
      py::arg("closed") = false, "The unit tangents (n, 2) at waypoints (n, 2) by a rule.");
}

}  // namespace

void bind_planar_curves(py::module_& m) {
  bind_types(m);
  bind_hermite(m);
  bind_corners(m);
}

}  // namespace hodograph::python
