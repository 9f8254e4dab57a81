// SPDX-License-Identifier: MIT
// Plans with their proof: planning/plan.hpp, tangent_plan.hpp.
#include "hodograph/planning/plan.hpp"

#include <string>
#include <vector>

#include "hodograph/planning/tangent_plan.hpp"
#include "python/src/bindings.hpp"
#include "python/src/made.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

using Point = Vector2<double>;

PlanarPath<2> straight() { return *unit_line().get_if<PlanarPath<2>>(); }

const PlanarPath<2>& quintics(const AnyPath& path) {
  return path_as<PlanarPath<2>>(path, "planar quintics");
}

void bind_certificates(py::module_& m) {
  Record<VehicleLimits> limits(m, "VehicleLimits",
                               "What a vehicle asks of its path, in the world's lengths.");
  limits
      .def(py::init([](double turn_radius, double clearance, double width) {
             return VehicleLimits{turn_radius, clearance, width};
           }),
           py::kw_only(), py::arg("turn_radius"), py::arg("clearance") = 0.0,
           py::arg("width") = 0.0)
      .def("distance", &VehicleLimits::distance,
           "How far its middle stays from obstacles and bounds: clearance + width/2.");
  limits.field("turn_radius", &VehicleLimits::turn_radius, "The least radius of curvature.")
      .field("clearance", &VehicleLimits::clearance,
             "The least distance from obstacles and bounds, beyond half the width.")
      .field("width", &VehicleLimits::width, "Of the vehicle.");
  Record<PlanCertificate> certificate(m, "PlanCertificate", "What is proven of a path in a world.");
  certificate.field("arc_length", &PlanCertificate::arc_length, "Contains the length.")
      .field("curvature", &PlanCertificate::curvature, "Contains the largest |kappa|.")
      .field("clearance", &PlanCertificate::clearance)
      .def("proves", &PlanCertificate::proves, py::arg("limits"), py::arg("largest_coordinate"),
           "True where it proves the limits, the clearance up to planning_tolerance of the largest "
           "coordinate.");
  m.attr("planning_tolerance") = planning_tolerance;
  m.attr("clearance_width") = clearance_width;
  m.def(
      "largest_curvature",
      [](const AnyPath& path) {
        const auto& quintic = quintics(path);
        return unlocked([&] { return largest_curvature(quintic); });
      },
      py::arg("path"), "The largest |kappa| of a planar quintic path, enclosed to 2^-40 of it.");
  m.def(
      "certify_plan",
      [](const AnyPath& path, const ClearanceIndex& index, double reach) {
        const auto& quintic = quintics(path);
        return unlocked([&] { return certify_plan(quintic, index, reach).value(); });
      },
      py::arg("path"), py::arg("index"), py::arg("reach"),
      "Length, curvature and clearance of a planar quintic path in a world, enclosed; obstacles "
      "further than\n`reach` are not listed.");
}

void bind_planner(py::module_& m) {
  Record<CrowdedCorner>(m, "CrowdedCorner", "A corner that had no room.")
      .field("point", &CrowdedCorner::point, "(2,).")
      .field("vertex", &CrowdedCorner::vertex)
      .field("turning_angle", &CrowdedCorner::turning_angle, "Radians, positive to the left.")
      .field("turn_radius", &CrowdedCorner::turn_radius,
             "About the largest radius that the lines beside it have room for.");
  Record<Plan>(m, "Plan", "A path that keeps its limits, with the proof.",
               Plan{straight(), {}, {}, {}, {}, 0, {}})
      .field("path", &Plan::path, "Lines and corners in turn, G2; xi is the arc length.")
      .field("polyline", &Plan::polyline, "What was rounded.")
      .field("legs", &Plan::legs, "L of every corner.")
      .field("offsets", &Plan::offsets, "The offset of every corner's vertex.")
      .field("certificate", &Plan::certificate)
      .field("attempts", &Plan::attempts, "Polylines tried, this one included.")
      .field("given_up", &Plan::given_up, "One for every attempt that was given up.");
  py::class_<Planner>(m, "Planner", "Plans in one world for one vehicle.")
      .def(py::init([](const World& world, double turn_radius, double clearance, double width) {
             const VehicleLimits limits{turn_radius, clearance, width};
             return unlocked([&] { return Planner::create(world, limits).value(); });
           }),
           py::arg("world"), py::kw_only(), py::arg("turn_radius"), py::arg("clearance") = 0.0,
           py::arg("width") = 0.0,
           "Indexes the world for a vehicle with a least turn radius, a least clearance beyond "
           "half its width,\nand a width. Raises HodographError: outside_domain.")
      .def_property_readonly("world", &Planner::world)
      .def_property_readonly("limits", &Planner::limits)
      .def(
          "plan",
          [](const Planner& planner, const Doubles& start, const Doubles& goal, CornerAim aim,
             std::optional<double> corner_offset, std::size_t most_attempts) {
            const PlanRequest request{point_of<Point>(start, "start"),
                                      point_of<Point>(goal, "goal"), aim, corner_offset,
                                      most_attempts};
            return unlocked([&] { return planner.plan(request).value(); });
          },
          py::arg("start"), py::arg("goal"), py::kw_only(), py::arg("aim") = CornerAim::smallest,
          py::arg("corner_offset") = py::none(),
          py::arg("most_attempts") = PlanRequest{}.most_attempts,
          "The path of the shortest polyline from start (2,) to goal (2,) that can be rounded; "
          "nothing is returned\nthat its certificate does not prove. corner_offset: by how much "
          "more obstacles are grown, None for what\nthe angles ask. Raises HodographError: those "
          "of shortest_polyline, no_route (value: the turn radius,\nbound: the one that has room).")
      .def("__repr__",
           [](const Planner& planner) {
             return "<hodograph.Planner: turn radius " + to_text(planner.limits().turn_radius) +
                    ", distance " + to_text(planner.limits().distance()) + ", " +
                    std::to_string(planner.world().obstacles().size()) + " obstacles>";
           })
      .def(py::pickle(
          [](const Planner& planner) { return py::make_tuple(planner.world(), planner.limits()); },
          [](const py::tuple& t) {
            return Planner::create(t[0].cast<World>(), t[1].cast<VehicleLimits>()).value();
          }));
}

void bind_tangent_plans(py::module_& m) {
  Record<TangentPlan> plan(m, "TangentPlan",
                           "A path through the points of a polyline with tangents by a rule, "
                           "and what is certain of it.",
                           TangentPlan{TangentRule::t1, straight(), {}, 0.0});
  plan.field("rule", &TangentPlan::rule)
      .field("path", &TangentPlan::path)
      .field("certificate", &TangentPlan::certificate)
      .field("curvature_jump", &TangentPlan::curvature_jump,
             "The largest jump of kappa where two pieces meet.")
      .def("keeps_radius", &TangentPlan::keeps_radius, py::arg("radius"),
           "Whether the largest |kappa| is at most 1/radius.")
      .def("keeps_distance", &TangentPlan::keeps_distance, py::arg("distance"),
           "Whether every obstacle and the bounds are at least so far.");
  m.def(
      "tangent_plan",
      [](const Polyline& polyline, TangentRule rule, const ClearanceIndex& index, double reach) {
        return unlocked([&] { return tangent_plan(polyline, rule, index, reach).value(); });
      },
      py::arg("polyline"), py::arg("rule"), py::arg("index"), py::arg("reach"),
      "The path of a rule through the points of a polyline, with its certificate; obstacles "
      "further than\n`reach` are not listed. Raises HodographError: those of waypoint_path.");
}

}  // namespace

void bind_plan(py::module_& m) {
  bind_certificates(m);
  bind_planner(m);
  add_equality_of_states(py::type::of<Planner>());
  bind_tangent_plans(m);
}

}  // namespace hodograph::python
