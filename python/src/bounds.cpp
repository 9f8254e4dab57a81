// SPDX-License-Identifier: MIT
// Rigorous bounds of what a path is: path/any_bounds.hpp.
#include "hodograph/path/any_bounds.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "hodograph/bernstein/roots.hpp"
#include "hodograph/foundation/answer.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

/// How far bounds are refined unless another relative width is asked for: what people read off.
constexpr double usual_width = 0x1p-20;
const std::size_t usual_subdivisions = RangeGoal{usual_width}.subdivisions;

RangeGoal goal_of(double relative_width, std::size_t subdivisions) {
  if (!(relative_width >= 0.0)) {
    throw Error(Fault{FaultCode::outside_domain,
                      "a relative width is a number from 0 on; got " + to_text(relative_width),
                      std::nullopt, "relative_width", relative_width, 0.0});
  }
  return {relative_width, subdivisions};
}

/// Defines a function of a path and a goal.
template <class Function>
void def_with_goal(py::module_& m, const char* name, const Function& function, const char* doc) {
  m.def(
      name,
      [function](const AnyPath& path, double relative_width, std::size_t subdivisions) {
        const RangeGoal goal = goal_of(relative_width, subdivisions);
        return unlocked([&] { return function(path, goal); });
      },
      py::arg("path"), py::kw_only(), py::arg("relative_width") = usual_width,
      py::arg("subdivisions") = usual_subdivisions, doc);
}

void bind_types(py::module_& m) {
  py::enum_<Answer>(m, "Answer", "yes and no are certain; undecided is within rounding.")
      .value("yes", Answer::yes)
      .value("no", Answer::no)
      .value("undecided", Answer::undecided);
  py::enum_<RootKind>(m, "RootKind", "What is certain of a root.")
      .value("simple", RootKind::simple, "Exactly one, where the derivative is not zero.")
      .value("cluster", RootKind::cluster, "Undecided: multiple, several, or none.");
  Record<Extremes>(m, "Extremes", "Where the smallest and the largest value lie.")
      .field("minimum", &Extremes::minimum)
      .field("maximum", &Extremes::maximum)
      .property("range", &Extremes::range, "The range that no value leaves.");
  Record<SelfDistance>(m, "SelfDistance", "How close parts of a path come to each other.")
      .field("distance", &SelfDistance::distance, "Contains the least distance.")
      .field("separation", &SelfDistance::separation, "How far apart along the path, at least.")
      .field("xi", &SelfDistance::xi, "Two points at most distance.upper apart, (2,).")
      .field("evaluations", &SelfDistance::evaluations, "Pairs of pieces looked at.");
  py::enum_<TubeLimit>(m, "TubeLimit", "What a tube round a path is limited by.")
      .value("curvature", TubeLimit::curvature)
      .value("distance", TubeLimit::distance)
      .value("corner", TubeLimit::corner)
      .value("standstill", TubeLimit::standstill);
  Record<TubeRadius>(m, "TubeRadius", "The largest radius of a tube, and what limits it.")
      .field("radius", &TubeRadius::radius, "Contains the largest radius.")
      .field("limit", &TubeRadius::limit)
      .field("curvature", &TubeRadius::curvature, "The largest curvature.")
      .field("knot", &TubeRadius::knot, "Of a corner.")
      .field("distance", &TubeRadius::distance, "Of distinct parts; None if there are none.");
  Record<CurvatureParts>(m, "CurvatureParts", "A path in parts by arc length, with bounds.")
      .field("per_segment", &CurvatureParts::per_segment)
      .field("arc_lengths", &CurvatureParts::arc_lengths,
             "Where parts begin, and the end, (n + 1,)")
      .field("most_curvature", &CurvatureParts::most_curvature, "A bound of |kappa|, (n,).")
      .field("arc_length_error", &CurvatureParts::arc_length_error);
}

}  // namespace

void bind_bounds(py::module_& m) {
  bind_types(m);
  m.def(
      "arc_length_enclosure", [](const AnyPath& path) { return arc_length_enclosure(path); },
      py::arg("path"), "The arc length, rounding included.");
  def_with_goal(
      m, "speed_extremes",
      [](const AnyPath& path, const RangeGoal& goal) { return speed_extremes(path, goal); },
      "The smallest and the largest parametric speed, enclosed, refined to a relative width.");
  def_with_goal(
      m, "curvature_extremes",
      [](const AnyPath& path, const RangeGoal& goal) { return curvature_extremes(path, goal); },
      "The extremes of the curvature, enclosed: signed in the plane. Unbounded where the speed may "
      "vanish.");
  def_with_goal(
      m, "bounding_box",
      [](const AnyPath& path, const RangeGoal& goal) { return bounding_box(path, goal); },
      "The extremes of every coordinate, enclosed.");
  def_with_goal(
      m, "angular_rate_extremes_per_xi",
      [](const AnyPath& path, const RangeGoal& goal) {
        return angular_rate_extremes_per_xi(path, goal);
      },
      "The extremes of the angular rate of the Euler-Rodrigues frame, radians per unit xi.");
  def_with_goal(
      m, "angular_rate_extremes_per_arc_length",
      [](const AnyPath& path, const RangeGoal& goal) {
        return angular_rate_extremes_per_arc_length(path, goal);
      },
      "The same per unit of arc length.");
  def_with_goal(
      m, "torsion_extremes",
      [](const AnyPath& path, const RangeGoal& goal) {
        return torsion_extremes(path, goal).value();
      },
      "The extremes of the torsion of a path in space of degree up to 17, enclosed. Raises "
      "HodographError:\nunsupported.");
  m.def(
      "bending_energy",
      [](const AnyPath& path) { return unlocked([&] { return bending_energy(path).value(); }); },
      py::arg("path"),
      "The integral of kappa^2 over the arc length. Raises HodographError: zero_speed, not_finite, "
      "unsupported.");
  m.def(
      "bending_energy_enclosure",
      [](const AnyPath& path) {
        return unlocked([&] { return bending_energy_enclosure(path).value(); });
      },
      py::arg("path"), "The same, enclosed: rounding and quadrature included.");
  m.def(
      "self_distance",
      [](const AnyPath& path, double separation, double relative_width, std::size_t subdivisions) {
        const RangeGoal goal = goal_of(relative_width, subdivisions);
        return unlocked([&] { return self_distance(path, separation, goal).value(); });
      },
      py::arg("path"), py::arg("separation"), py::kw_only(),
      py::arg("relative_width") = usual_width, py::arg("subdivisions") = usual_subdivisions,
      "The least distance of points that are at least `separation` apart along the path. Raises\n"
      "HodographError: not_finite, outside_domain (no points so far apart).");
  def_with_goal(
      m, "largest_tube_radius",
      [](const AnyPath& path, const RangeGoal& goal) { return largest_tube_radius(path, goal); },
      "The largest radius of a tube round the path that neither folds nor touches itself.");
  m.def(
      "curvature_parts",
      [](const AnyPath& path, std::size_t per_segment) {
        if (per_segment == 0) {
          throw Error(Fault{FaultCode::too_few, "a segment has at least one part; got 0",
                            std::nullopt, "per_segment", 0.0, 1.0});
        }
        return unlocked([&] { return curvature_parts(path, per_segment); });
      },
      py::arg("path"), py::arg("per_segment") = 32,
      "The path in parts by arc length, each with a rigorous bound of its curvature.");
}

}  // namespace hodograph::python
