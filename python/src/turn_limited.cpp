// SPDX-License-Identifier: MIT
// Planar paths that keep a turn radius, and those of least peak curvature:
// construction/turn_limited.hpp, least_peak_curvature.hpp; how a planar spline was found.
#include "hodograph/construction/turn_limited.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hodograph/construction/least_peak_curvature.hpp"
#include "hodograph/construction/planar_spline.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"
#include "python/src/curves.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

using Point = Vector2<double>;

struct Limited {
  AnyPath path = unit_line();
  TurnLimitedShape shape = TurnLimitedShape::one_span;
  std::size_t whole_turns = 0;
  double arc_radius = 0.0, most_curvature = 0.0;
};
struct LeastPeak {
  AnyPath curve = unit_line();
  Enclosure peak_curvature;
  double begin_speed = 0.0, end_speed = 0.0;
  PeakMinimum kind = PeakMinimum::interior;
  std::optional<LocalMinimum> interior{};
};
struct Spline {
  AnyPath path = unit_line();
  PlanarSplineReport report;
};

DirectedPoint directed(const Doubles& position, const Doubles& direction, const std::string& name) {
  return {point_of<Point>(position, name), point_of<Point>(direction, name + "_direction")};
}
Limited limited_of(const TurnLimitedPath& made) {
  return {AnyPath(made.path), made.shape, made.whole_turns, made.arc_radius, made.most_curvature};
}
LeastPeak peak_of(const LeastPeakCurvature& made) {
  return {path_of(made.curve), made.peak_curvature, made.begin_speed,
          made.end_speed,      made.kind,           made.interior};
}

void bind_types(py::module_& m) {
  py::enum_<TurnLimitedShape>(m, "TurnLimitedShape", "What a turn-limited path is made of.")
      .value("one_span", TurnLimitedShape::one_span, "One quintic.")
      .value("arcs", TurnLimitedShape::arcs, "Arcs and straight lines.")
      .value("swerve", TurnLimitedShape::swerve, "The same with a detour in a straight line.")
      .value("loiter", TurnLimitedShape::loiter, "The same with whole turns.");
  py::enum_<PeakMinimum>(m, "PeakMinimum", "Where the least peak curvature lies.")
      .value("interior", PeakMinimum::interior)
      .value("at_length_bound", PeakMinimum::at_length_bound, "Longer paths would be smoother.")
      .value("at_range_end", PeakMinimum::at_range_end, "On an end of the range of speeds.")
      .value("straight_line", PeakMinimum::straight_line);
  Record<Limited>(m, "TurnLimitedPath", "A path that keeps a turn radius.")
      .field("path", &Limited::path)
      .field("shape", &Limited::shape)
      .field("whole_turns", &Limited::whole_turns)
      .field("arc_radius", &Limited::arc_radius, "Of its arcs; 0 for one span.")
      .field("most_curvature", &Limited::most_curvature, "Certified: |kappa| is at most this.");
  Record<LocalMinimum>(m, "LocalMinimum", "A minimum of the peak curvature that is local.")
      .field("parameter", &LocalMinimum::parameter, "The speed, or the length.")
      .field("peak_curvature", &LocalMinimum::peak_curvature, "An upper bound.");
  Record<LeastPeak>(m, "LeastPeakCurvature", "The quintic of least peak curvature.")
      .field("curve", &LeastPeak::curve, "On [0, 1].")
      .field("peak_curvature", &LeastPeak::peak_curvature, "The largest |kappa|, certain.")
      .field("begin_speed", &LeastPeak::begin_speed)
      .field("end_speed", &LeastPeak::end_speed)
      .field("kind", &LeastPeak::kind)
      .field("interior", &LeastPeak::interior, "The least local minimum, or None.");
  using Report = PlanarSplineReport;
  Record<Report>(m, "PlanarSplineReport", "How a planar spline was found.")
      .field("newton_steps", &Report::newton_steps)
      .field("residual", &Report::residual, "How far a span misses its end, relative.")
      .field("worst_span", &Report::worst_span)
      .field("closure_sign", &Report::closure_sign)
      .field("continued", &Report::continued)
      .field("alternatives_tried", &Report::alternatives_tried)
      .field("alternatives_taken", &Report::alternatives_taken)
      .field("solutions_found", &Report::solutions_found)
      .field("merged_points", &Report::merged_points)
      .field("energy", &Report::energy, "The bending energy, if asked for.");
  Record<Spline>(m, "PlanarSpline", "A planar spline and how it was found.")
      .field("path", &Spline::path)
      .field("report", &Spline::report);
}

void bind_limited(py::module_& m) {
  m.def(
      "turn_limited_path",
      [](const Doubles& begin, const Doubles& begin_direction, const Doubles& end,
         const Doubles& end_direction, double length, double turn_radius) {
        const auto from = directed(begin, begin_direction, "begin"),
                   to = directed(end, end_direction, "end");
        return limited_of(
            unlocked([&] { return turn_limited_path(from, to, length, turn_radius).value(); }));
      },
      py::arg("begin"), py::arg("begin_direction"), py::arg("end"), py::arg("end_direction"),
      py::arg("length"), py::arg("turn_radius"),
      "The planar path of exactly this length with |kappa| <= 1/turn_radius; 0: no radius. Raises\n"
      "HodographError: not_finite, outside_domain, no_interpolant (with the length that is met).");
  m.def(
      "shortest_turn_limited_path",
      [](const Doubles& begin, const Doubles& begin_direction, const Doubles& end,
         const Doubles& end_direction, double turn_radius, double least_length,
         double most_detour) {
        const auto from = directed(begin, begin_direction, "begin"),
                   to = directed(end, end_direction, "end");
        const TurnLimitedChoice choice{least_length, most_detour};
        return limited_of(unlocked(
            [&] { return shortest_turn_limited_path(from, to, turn_radius, choice).value(); }));
      },
      py::arg("begin"), py::arg("begin_direction"), py::arg("end"), py::arg("end_direction"),
      py::arg("turn_radius"), py::kw_only(), py::arg("least_length") = 0.0,
      py::arg("most_detour") = TurnLimitedChoice{}.most_detour,
      "A short path of at least a length with |kappa| <= 1/turn_radius.");
}

template <class Make>
void def_least_peak(py::module_& m, const char* name, const Make& make, const char* doc) {
  m.def(
      name,
      [make](const Doubles& begin, const Doubles& begin_direction, const Doubles& end,
             const Doubles& end_direction, double most_length, double least_speed,
             double most_speed) {
        const auto from = directed(begin, begin_direction, "begin"),
                   to = directed(end, end_direction, "end");
        return peak_of(unlocked([&] {
          return make(from, to, most_length, SpeedRange{least_speed, most_speed}).value();
        }));
      },
      py::arg("begin"), py::arg("begin_direction"), py::arg("end"), py::arg("end_direction"),
      py::arg("most_length"), py::kw_only(), py::arg("least_speed") = 0.0,
      py::arg("most_speed") = 0.0, doc);
}

void bind_least_peak(py::module_& m) {
  def_least_peak(
      m, "least_peak_curvature_of_equal_speeds",
      [](const DirectedPoint& from, const DirectedPoint& to, double most, const SpeedRange& range) {
        return least_peak_curvature_of_equal_speeds(from, to, most, range);
      },
      "The Hermite quintic of least peak curvature over one speed at both ends, within a length; "
      "both speeds 0:\nfrom 1/16 to 16 times the distance. Raises HodographError: not_finite, "
      "outside_domain, no_interpolant.");
  def_least_peak(
      m, "least_peak_curvature_of_speeds",
      [](const DirectedPoint& from, const DirectedPoint& to, double most, const SpeedRange& range) {
        return least_peak_curvature_of_speeds(from, to, most, range);
      },
      "The same over the speeds at both ends separately.");
  m.def(
      "least_peak_curvature_of_length",
      [](const Doubles& begin, const Doubles& begin_direction, const Doubles& end,
         const Doubles& end_direction, double most_length) {
        const auto from = directed(begin, begin_direction, "begin"),
                   to = directed(end, end_direction, "end");
        return peak_of(unlocked(
            [&] { return least_peak_curvature_of_length(from, to, most_length).value(); }));
      },
      py::arg("begin"), py::arg("begin_direction"), py::arg("end"), py::arg("end_direction"),
      py::arg("most_length"), "The same over the arc length, up to a bound.");
}

}  // namespace

void bind_turn_limited(py::module_& m) {
  bind_types(m);
  bind_limited(m);
  bind_least_peak(m);
  const PlanarSplineOptions usual{};
  m.def(
      "planar_spline_with_report",
      [](const Doubles& points, bool closed, SplineParameters parameters, RepeatedPoints repeated,
         std::size_t most_alternatives, bool with_energy) {
        const auto waypoints = points_of<Point>(points, "points");
        PlanarSplineOptions options;
        options.closed = closed;
        options.parameters = parameters;
        options.repeated = repeated;
        options.most_alternatives = most_alternatives;
        options.with_energy = with_energy;
        auto made = unlocked([&] { return planar_spline(waypoints, options).value(); });
        return Spline{AnyPath(std::move(made.path)), made.report};
      },
      py::arg("points"), py::kw_only(), py::arg("closed") = usual.closed,
      py::arg("parameters") = usual.parameters, py::arg("repeated") = usual.repeated,
      py::arg("most_alternatives") = usual.most_alternatives,
      py::arg("with_energy") = usual.with_energy,
      "planar_spline, with how it was found; most_alternatives: sharp turns also tried the other "
      "way round.");
}

}  // namespace hodograph::python
