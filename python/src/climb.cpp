// SPDX-License-Identifier: MIT
// Climbs, climbs within limits and routes of them: construction/climb.hpp, climb_path.hpp.
#include "hodograph/construction/climb_path.hpp"

#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"
#include "python/src/curves.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

using Point = Vector3<double>;

struct Climb {
  AnyPath curve = unit_line();
  double climb_angle = 0.0, ground_length = 0.0, rotation_index = 0.0, margin = 0.0;
  TieBreak tie = TieBreak::none;
  bool loop_free = true;
};
struct Solution {
  AnyPath curve = unit_line();
  double rotation_index = 0.0;
};
struct LimitedClimb {
  AnyPath path = unit_line();
  double climb_angle = 0.0, ground_length = 0.0;
  TurnLimitedShape shape = TurnLimitedShape::one_span;
  std::size_t whole_turns = 0;
  double arc_radius = 0.0, most_ground_curvature = 0.0;
};
struct Route {
  AnyPath path = unit_line();
  std::vector<Vector2<double>> headings;
  std::vector<ClimbSpan> spans;
  std::vector<ClimbJoint> joints;
};

HeadedPoint headed(const Doubles& position, const Doubles& heading, const std::string& name) {
  return {point_of<Point>(position, name), point_of<Vector2<double>>(heading, name + "_heading")};
}
DirectedPoint3 directed(const Doubles& position, const Doubles& direction,
                        const std::string& name) {
  return {point_of<Point>(position, name), point_of<Point>(direction, name + "_direction")};
}

Climb climb_of(const ClimbCurve& made) {
  return {path_of(made.curve), made.climb_angle, made.ground_length, made.rotation_index,
          made.margin,         made.tie,         made.loop_free};
}
std::vector<Solution> solutions_of(const std::vector<ClimbSolution>& made) {
  std::vector<Solution> all;
  for (const auto& one : made) all.push_back({path_of(one.curve), one.rotation_index});
  return all;
}
LimitedClimb limited_of(const ClimbPath& made) {
  return {AnyPath(made.path), made.climb_angle, made.ground_length,        made.shape,
          made.whole_turns,   made.arc_radius,  made.most_ground_curvature};
}

/// Many climbs: the preimages (n, 3, 4) and what is known of each, (n,).
std::tuple<Doubles, Doubles, Doubles, Doubles> many(const Doubles& begins,
                                                    const Doubles& begin_headings,
                                                    const Doubles& ends,
                                                    const Doubles& end_headings,
                                                    const Doubles& angles, const Doubles& steps) {
  const auto from = points_of<Point>(begins, "begins"), to = points_of<Point>(ends, "ends");
  const auto leaving = points_of<Vector2<double>>(begin_headings, "begin_headings");
  const auto arriving = points_of<Vector2<double>>(end_headings, "end_headings");
  const std::size_t count = from.size();
  const auto refuse = [count](const char* name, const Doubles& array) {
    refuse_shape(name, "as many rows as begins: " + std::to_string(count), array);
  };
  if (leaving.size() != count) refuse("begin_headings", begin_headings);
  if (to.size() != count) refuse("ends", ends);
  if (arriving.size() != count) refuse("end_headings", end_headings);
  const auto number_of = [&](const Doubles& array, const char* name) {
    if (array.ndim() > 1 || (array.ndim() == 1 && numbers(array).size() != count)) {
      refuse(name, array);
    }
    return [&array](std::size_t i) { return array.data()[array.ndim() == 0 ? 0 : i]; };
  };
  const auto angle = number_of(angles, "climb_angles");
  const auto step = number_of(steps, "h");
  std::vector<ClimbProblem> problems(count);
  for (std::size_t i = 0; i < count; ++i) {
    problems[i] = {{from[i], leaving[i]}, {to[i], arriving[i]}, angle(i), step(i)};
  }
  std::vector<ClimbAnswer> answers(count);
  if (const auto fault = unlocked([&] { return climb_curves(problems, answers); })) {
    throw Error(*fault);
  }
  const auto rows = static_cast<py::ssize_t>(count);
  Doubles preimages(Shape{rows, 3, 4}), lengths(Shape{rows}), indices(Shape{rows}),
      margins(Shape{rows});
  double* q = preimages.mutable_data();
  for (std::size_t i = 0; i < count; ++i) {
    for (const auto& a : answers[i].preimage) {
      for (std::size_t j = 0; j < 4; ++j) *q++ = a[j];
    }
    lengths.mutable_data()[i] = answers[i].ground_length;
    indices.mutable_data()[i] = answers[i].rotation_index;
    margins.mutable_data()[i] = answers[i].margin;
  }
  return {preimages, lengths, indices, margins};
}

void bind_types(py::module_& m) {
  Record<Climb>(m, "ClimbCurve", "A climb, and how good it is.")
      .field("curve", &Climb::curve, "One helical quintic on [0, h].")
      .field("climb_angle", &Climb::climb_angle, "Radians; negative: descent.")
      .field("ground_length", &Climb::ground_length, "The path's own is this over the cosine.")
      .field("rotation_index", &Climb::rotation_index, "Of the plan, radians.")
      .field("margin", &Climb::margin, "By how much the next solution's exceeds it.")
      .field("tie", &Climb::tie)
      .field("loop_free", &Climb::loop_free, "No loop that it could do without.");
  Record<Solution>(m, "ClimbSolution", "One of several climbs between the same ends.")
      .field("curve", &Solution::curve)
      .field("rotation_index", &Solution::rotation_index);
  Record<LimitedClimb>(m, "ClimbPath", "A climb that a vehicle can fly.")
      .field("path", &LimitedClimb::path)
      .field("climb_angle", &LimitedClimb::climb_angle, "Radians; negative in descent.")
      .field("ground_length", &LimitedClimb::ground_length)
      .field("shape", &LimitedClimb::shape)
      .field("whole_turns", &LimitedClimb::whole_turns)
      .field("arc_radius", &LimitedClimb::arc_radius, "Of its arcs; 0 for one span.")
      .field("most_ground_curvature", &LimitedClimb::most_ground_curvature, "Certified.");
  Record<ClimbSpan>(m, "ClimbSpan", "One span of a route, between two waypoints.")
      .field("first", &ClimbSpan::first, "Segment of the path.")
      .field("last", &ClimbSpan::last, "Segment of the path.")
      .field("climb_angle", &ClimbSpan::climb_angle)
      .field("ground_length", &ClimbSpan::ground_length)
      .field("shape", &ClimbSpan::shape)
      .field("whole_turns", &ClimbSpan::whole_turns)
      .field("most_ground_curvature", &ClimbSpan::most_ground_curvature, "Certified.");
  Record<ClimbJoint>(m, "ClimbJoint", "What is continuous where two spans meet; -1: it jumps.")
      .field("waypoint", &ClimbJoint::waypoint)
      .field("knot", &ClimbJoint::knot)
      .field("pitch_change", &ClimbJoint::pitch_change, "Of the climb angle, radians.")
      .field("position", &ClimbJoint::position)
      .field("preimage", &ClimbJoint::preimage)
      .field("frame", &ClimbJoint::frame)
      .field("angular_velocity", &ClimbJoint::angular_velocity);
  Record<Route>(m, "ClimbRoute", "The helical spline through waypoints.")
      .field("path", &Route::path)
      .field("headings", &Route::headings, "At the waypoints, (n, 2).")
      .field("spans", &Route::spans)
      .field("joints", &Route::joints, "At the inner waypoints.");
}

void bind_curves(py::module_& m) {
  m.def(
      "climb_curve",
      [](const Doubles& begin, const Doubles& begin_heading, const Doubles& end,
         const Doubles& end_heading, double climb_angle, double h, LengthSolutions among) {
        return climb_of(climb_curve(headed(begin, begin_heading, "begin"),
                                    headed(end, end_heading, "end"), climb_angle, h, among)
                            .value());
      },
      py::arg("begin"), py::arg("begin_heading"), py::arg("end"), py::arg("end_heading"),
      py::arg("climb_angle"), py::kw_only(), py::arg("h") = 1.0,
      py::arg("among") = LengthSolutions::published,
      "The helical quintic between points (3,) with headings over ground (2,) that climbs at the "
      "angle,\nradians. Raises HodographError: not_finite, outside_domain, no_interpolant (too "
      "little climb for the angle).");
  m.def(
      "climb_curve_of_ground_length",
      [](const Doubles& begin, const Doubles& begin_heading, const Doubles& end,
         const Doubles& end_heading, double ground_length, double h, LengthSolutions among) {
        return climb_of(climb_curve_of_ground_length(headed(begin, begin_heading, "begin"),
                                                     headed(end, end_heading, "end"), ground_length,
                                                     h, among)
                            .value());
      },
      py::arg("begin"), py::arg("begin_heading"), py::arg("end"), py::arg("end_heading"),
      py::arg("ground_length"), py::kw_only(), py::arg("h") = 1.0,
      py::arg("among") = LengthSolutions::published,
      "The same with the given length over ground; level where the altitudes agree.");
  m.def(
      "climb_solutions",
      [](const Doubles& begin, const Doubles& begin_heading, const Doubles& end,
         const Doubles& end_heading, double climb_angle, double h, LengthSolutions among) {
        return solutions_of(climb_solutions(headed(begin, begin_heading, "begin"),
                                            headed(end, end_heading, "end"), climb_angle, h, among)
                                .value());
      },
      py::arg("begin"), py::arg("begin_heading"), py::arg("end"), py::arg("end_heading"),
      py::arg("climb_angle"), py::kw_only(), py::arg("h") = 1.0,
      py::arg("among") = LengthSolutions::published,
      "All such climbs, by increasing rotation index.");
  m.def(
      "helical_curve",
      [](const Doubles& axis, const Doubles& begin, const Doubles& begin_direction,
         const Doubles& end, const Doubles& end_direction, double h, LengthSolutions among) {
        return climb_of(helical_curve(point_of<Point>(axis, "axis"),
                                      directed(begin, begin_direction, "begin"),
                                      directed(end, end_direction, "end"), h, among)
                            .value());
      },
      py::arg("axis"), py::arg("begin"), py::arg("begin_direction"), py::arg("end"),
      py::arg("end_direction"), py::kw_only(), py::arg("h") = 1.0,
      py::arg("among") = LengthSolutions::published,
      "The helical quintic about an axis between points with directions (3,) equally inclined to "
      "it.");
  m.def(
      "helical_solutions",
      [](const Doubles& axis, const Doubles& begin, const Doubles& begin_direction,
         const Doubles& end, const Doubles& end_direction, double h, LengthSolutions among) {
        return solutions_of(helical_solutions(point_of<Point>(axis, "axis"),
                                              directed(begin, begin_direction, "begin"),
                                              directed(end, end_direction, "end"), h, among)
                                .value());
      },
      py::arg("axis"), py::arg("begin"), py::arg("begin_direction"), py::arg("end"),
      py::arg("end_direction"), py::kw_only(), py::arg("h") = 1.0,
      py::arg("among") = LengthSolutions::published, "All of them.");
  m.def("climb_curves", &many, py::arg("begins"), py::arg("begin_headings"), py::arg("ends"),
        py::arg("end_headings"), py::arg("climb_angles"), py::arg("h") = 1.0,
        "Many climbs at once: points (n, 3), headings (n, 2), angles (n,) or one. Preimages (n, 3, "
        "4), lengths\nover ground, rotation indices and margins (n,).");
}

void bind_limited(py::module_& m) {
  m.def(
      "climb_path",
      [](const Doubles& begin, const Doubles& begin_heading, const Doubles& end,
         const Doubles& end_heading, double climb_angle, double turn_radius) {
        const auto from = headed(begin, begin_heading, "begin"),
                   to = headed(end, end_heading, "end");
        return limited_of(
            unlocked([&] { return climb_path(from, to, climb_angle, turn_radius).value(); }));
      },
      py::arg("begin"), py::arg("begin_heading"), py::arg("end"), py::arg("end_heading"),
      py::arg("climb_angle"), py::arg("turn_radius"),
      "The climb of exactly the angle (radians) that keeps the turn radius, seen from above; 0: "
      "none.\nRaises HodographError: those of climb_curve.");
  m.def(
      "climb_path_within",
      [](const Doubles& begin, const Doubles& begin_heading, const Doubles& end,
         const Doubles& end_heading, double climb_angle, double descent_angle, double turn_radius,
         double most_detour) {
        const auto from = headed(begin, begin_heading, "begin"),
                   to = headed(end, end_heading, "end");
        const ClimbLimits limits{climb_angle, descent_angle, turn_radius};
        return limited_of(
            unlocked([&] { return climb_path(from, to, limits, most_detour).value(); }));
      },
      py::arg("begin"), py::arg("begin_heading"), py::arg("end"), py::arg("end_heading"),
      py::kw_only(), py::arg("climb_angle") = 0.0, py::arg("descent_angle") = 0.0,
      py::arg("turn_radius") = 0.0, py::arg("most_detour") = 0.25,
      "A climb within the steepest climb and descent (radians) and the turn radius, of an angle "
      "that is found.");
  m.def(
      "climb_path_of_ground_length",
      [](const Doubles& begin, const Doubles& begin_heading, const Doubles& end,
         const Doubles& end_heading, double ground_length, double turn_radius) {
        const auto from = headed(begin, begin_heading, "begin"),
                   to = headed(end, end_heading, "end");
        return limited_of(unlocked([&] {
          return climb_path_of_ground_length(from, to, ground_length, turn_radius).value();
        }));
      },
      py::arg("begin"), py::arg("begin_heading"), py::arg("end"), py::arg("end_heading"),
      py::arg("ground_length"), py::arg("turn_radius") = 0.0,
      "The climb of a given length over ground that keeps the turn radius.");
  Record<ClimbWaypoint> record(m, "ClimbWaypoint", "A waypoint of a helical spline.");
  record.def(
      py::init([](const Doubles& position, const std::optional<Doubles>& heading,
                  std::optional<double> climb_angle, std::optional<double> ground_length) {
        ClimbWaypoint waypoint{point_of<Point>(position, "position"), std::nullopt, climb_angle,
                               ground_length};
        if (heading) waypoint.heading = point_of<Vector2<double>>(*heading, "heading");
        return waypoint;
      }),
      py::arg("position"), py::kw_only(), py::arg("heading") = py::none(),
      py::arg("climb_angle") = py::none(), py::arg("ground_length") = py::none(),
      "A place (3,), a heading (2,) or the rule's, and the angle (radians) or the length over "
      "ground of\nthe span that begins here, or neither: found within the limits.");
  record.field("position", &ClimbWaypoint::position, "(3,).")
      .field("heading", &ClimbWaypoint::heading, "(2,), or None.")
      .field("climb_angle", &ClimbWaypoint::climb_angle, "Radians, or None.")
      .field("ground_length", &ClimbWaypoint::ground_length, "Or None.");
  m.def(
      "climb_route",
      [](const std::vector<ClimbWaypoint>& waypoints, double climb_angle, double descent_angle,
         double turn_radius, TangentRule headings, double most_detour) {
        const ClimbRouteOptions options{
            {climb_angle, descent_angle, turn_radius}, headings, most_detour};
        auto made = unlocked([&] { return climb_route(waypoints, options).value(); });
        return Route{AnyPath(std::move(made.path)), std::move(made.headings), std::move(made.spans),
                     std::move(made.joints)};
      },
      py::arg("waypoints"), py::kw_only(), py::arg("climb_angle") = 0.0,
      py::arg("descent_angle") = 0.0, py::arg("turn_radius") = 0.0,
      py::arg("headings") = TangentRule::t1, py::arg("most_detour") = 0.25,
      "The helical spline through waypoints: a climb on each span, within the limits. Raises\n"
      "HodographError with the index of the span or waypoint.");
}

}  // namespace

void bind_climb(py::module_& m) {
  bind_types(m);
  bind_curves(m);
  bind_limited(m);
}

}  // namespace hodograph::python
