// SPDX-License-Identifier: MIT
// Following a path as fast as a vehicle can, once or again and again: control/path_following.hpp,
// receding_horizon.hpp.
#include "hodograph/control/path_following.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "hodograph/control/receding_horizon.hpp"
#include "python/src/control/solving.hpp"

namespace hodograph::python {

namespace {

FollowStart start_of(double xi, const std::optional<Doubles>& offset, double heading, double speed,
                     const std::optional<Doubles>& velocity) {
  FollowStart start;
  start.xi = xi;
  start.heading = heading;
  start.speed = speed;
  if (offset) {
    const auto size = static_cast<std::size_t>(offset->size());
    if (offset->ndim() > 1 || size < 1 || size > 2) refuse_shape("offset", "() or (2,)", *offset);
    for (std::size_t i = 0; i < size; ++i) start.offset[i] = offset->data()[i];
  }
  if (velocity) start.velocity = point_of<Vector3<double>>(*velocity, "velocity");
  return start;
}

Doubles offset_of(const FollowStart& start) {
  return array_of(std::vector<double>(start.offset.begin(), start.offset.end()));
}

void bind_start(py::module_& m) {
  py::class_<FollowStart>(m, "FollowStart", "Where a vehicle is, and how it moves.")
      .def(py::init(&start_of), py::arg("xi") = 0.0, py::kw_only(), py::arg("offset") = py::none(),
           py::arg("heading") = 0.0, py::arg("speed") = 0.0, py::arg("velocity") = py::none(),
           "offset: eta in the plane, (eta_2, eta_3) in space; heading: in the plane, against the "
           "tangent, to the\nleft (radians); speed: in space along the tangent unless a velocity "
           "(3,) is given.")
      .def_readonly("xi", &FollowStart::xi)
      .def_property_readonly("offset", &offset_of, "(2,); the second is 0 in the plane.")
      .def_readonly("heading", &FollowStart::heading)
      .def_readonly("speed", &FollowStart::speed)
      .def_readonly("velocity", &FollowStart::velocity, "(3,), or None.")
      .def(
          "__eq__",
          [](const FollowStart& a, const FollowStart& b) {
            return a.xi == b.xi && a.offset == b.offset && a.heading == b.heading &&
                   a.speed == b.speed && a.velocity == b.velocity;
          },
          py::is_operator())
      .def("__repr__",
           [](const FollowStart& s) {
             return "FollowStart(" + to_text(s.xi) + ", offset=[" + to_text(s.offset[0]) + ", " +
                    to_text(s.offset[1]) + "], heading=" + to_text(s.heading) +
                    ", speed=" + to_text(s.speed) + ")";
           })
      .def(py::pickle(
          [](const FollowStart& s) {
            return py::make_tuple(s.xi, offset_of(s), s.heading, s.speed, s.velocity);
          },
          [](const py::tuple& t) {
            return start_of(t[0].cast<double>(), t[1].cast<Doubles>(), t[2].cast<double>(),
                            t[3].cast<double>(), t[4].cast<std::optional<Doubles>>());
          }));
}

/// One number, or one point, of every node.
template <class M>
auto column(M FollowNode::*member) {
  return [member](const Following& following) {
    std::vector<M> values;
    values.reserve(following.nodes.size());
    for (const FollowNode& node : following.nodes) values.push_back(node.*member);
    if constexpr (std::is_same_v<M, double>) {
      return array_of(values);
    } else {
      return values;
    }
  };
}

Doubles offsets_of(const Following& following) {
  Doubles rows({static_cast<py::ssize_t>(following.nodes.size()), py::ssize_t{2}});
  double* to = rows.mutable_data();
  for (const FollowNode& node : following.nodes) {
    for (const double x : node.offset) *to++ = x;
  }
  return rows;
}

void bind_result(py::module_& m) {
  using N = FollowNode;
  using F = Following;
  Record<N>(m, "FollowNode", "A node of a motion along a path.")
      .field("time", &N::time)
      .field("xi", &N::xi)
      .field("arc_length", &N::arc_length)
      .field("offset", &N::offset, "(2,); the second is 0 in the plane.")
      .field("heading", &N::heading)
      .field("speed", &N::speed)
      .field("position", &N::position, "(3,); z = 0 in the plane.")
      .field("velocity", &N::velocity)
      .field("acceleration", &N::acceleration)
      .field("along", &N::along, "Acceleration along the velocity.")
      .field("lateral", &N::lateral, "Across it.")
      .field("stretch", &N::stretch, "h > 0.");
  Record<F> following(
      m, "Following",
      "A motion along a path: arrays over its N + 1 nodes, and what is known of it all.");
  following.field("nodes", &F::nodes, "FollowNode of each.");
  following.def_property_readonly("time", column(&N::time))
      .def_property_readonly("xi", column(&N::xi))
      .def_property_readonly("arc_length", column(&N::arc_length))
      .def_property_readonly("offset", &offsets_of, "(N + 1, 2); the second is 0 in the plane.")
      .def_property_readonly("heading", column(&N::heading))
      .def_property_readonly("speed", column(&N::speed))
      .def_property_readonly("position", column(&N::position), "(N + 1, 3); z = 0 in the plane.")
      .def_property_readonly("velocity", column(&N::velocity), "(N + 1, 3).")
      .def_property_readonly("acceleration", column(&N::acceleration), "(N + 1, 3).")
      .def_property_readonly("along", column(&N::along), "Acceleration along the velocity.")
      .def_property_readonly("lateral", column(&N::lateral), "Across it.")
      .def_property_readonly("stretch", column(&N::stretch), "h > 0.");
  following.field("duration", &F::duration)
      .field("progress", &F::progress)
      .field("tube", &F::tube, "The largest offset with h > 0, certified.")
      .field("largest_offset", &F::largest_offset, "Over all the motion.")
      .field("least_stretch", &F::least_stretch, "h over sigma, likewise.")
      .field("largest_lateral", &F::largest_lateral, "In the plane: of the lateral acceleration.")
      .field("objective", &F::objective)
      .field("constraint_error", &F::constraint_error)
      .field("seconds", &F::seconds)
      .field("iterations", &F::iterations);
}

void bind_follow(py::module_& m) {
  py::enum_<FollowIndependent>(m, "FollowIndependent", "The independent variable.")
      .value("time", FollowIndependent::time)
      .value("progress", FollowIndependent::progress);
  py::enum_<FollowAim>(m, "FollowAim", "What a motion is to be.")
      .value("least_time", FollowAim::least_time)
      .value("most_progress", FollowAim::most_progress);
  const FollowLimits limits{};
  const FollowOptions usual{};
  m.def(
      "follow",
      [](const AnyPath& path, const FollowStart& start, double speed, double acceleration,
         double offset, double braking, double lateral_acceleration, double turn_radius,
         FollowIndependent independent, FollowAim aim, std::optional<double> xi_end,
         std::optional<double> end_speed, double duration, double effort, double least_forward,
         std::size_t intervals, std::size_t max_iterations, double time_limit_s,
         const std::optional<SolverProgress>& progress, const py::dict& settings) {
        Watch watch(progress);
        FollowOptions options;
        options.independent = independent;
        options.aim = aim;
        options.xi_end = xi_end;
        options.end_speed = end_speed;
        options.duration = duration;
        options.effort = effort;
        options.least_forward = least_forward;
        options.intervals = intervals;
        options.solver.max_iterations = max_iterations;
        options.solver.time_limit_s = time_limit_s;
        options.solver.more = settings_of(settings);
        options.solver.progress = [&watch](const SolverIteration& at) { return watch.goes_on(at); };
        const FollowLimits vehicle{speed,       acceleration, braking, lateral_acceleration,
                                   turn_radius, offset};
        return watch.run([&] { return follow(path, vehicle, start, options); });
      },
      py::arg("path"), py::arg("start"), py::kw_only(), py::arg("speed"), py::arg("acceleration"),
      py::arg("offset"), py::arg("braking") = limits.braking,
      py::arg("lateral_acceleration") = limits.lateral_acceleration,
      py::arg("turn_radius") = limits.turn_radius, py::arg("independent") = usual.independent,
      py::arg("aim") = usual.aim, py::arg("xi_end") = py::none(), py::arg("end_speed") = py::none(),
      py::arg("duration") = usual.duration, py::arg("effort") = usual.effort,
      py::arg("least_forward") = usual.least_forward, py::arg("intervals") = usual.intervals,
      py::arg("max_iterations") = usual.solver.max_iterations,
      py::arg("time_limit_s") = usual.solver.time_limit_s, py::arg("progress") = py::none(),
      py::arg("settings") = py::dict(),
      "The fastest motion along a path from a FollowStart, at most `offset` from it: a car in the "
      "plane, a point in\nspace. progress(SolverIteration) is called after every iteration; False "
      "stops with HodographError: cancelled.\nRaises HodographError: outside_domain, unsupported, "
      "zero_speed, no_convergence.");
}

void bind_horizon(py::module_& m) {
  Record<HorizonPlan>(m, "HorizonPlan", "One plan of a receding horizon.")
      .field("following", &HorizonPlan::following)
      .field("latency_s", &HorizonPlan::latency_s)
      .field("iterations", &HorizonPlan::iterations)
      .field("warm", &HorizonPlan::warm, "Started from the plan before.")
      .field("finished", &HorizonPlan::finished, "Solved to the tolerances.")
      .field("recovered", &HorizonPlan::recovered, "The vehicle was out of bounds, or so.");
  const FollowLimits limits{};
  const HorizonOptions usual{};
  /// A horizon, and whether it has planned.
  struct Horizon {
    RecedingHorizon solver;
    bool planned = false;
  };
  py::class_<Horizon>(m, "RecedingHorizon",
                      "Plans for one path and one vehicle, each as far along the path as possible. "
                      "Not for several\nthreads at once.")
      .def(py::init([](const AnyPath& path, double speed, double acceleration, double offset,
                       double braking, double lateral_acceleration, double turn_radius, double step,
                       std::size_t intervals, double effort, double centre, double time_limit_s,
                       std::size_t max_iterations) {
             const FollowLimits vehicle{speed,       acceleration, braking, lateral_acceleration,
                                        turn_radius, offset};
             HorizonOptions options;
             options.step = step;
             options.intervals = intervals;
             options.effort = effort;
             options.centre = centre;
             options.time_limit_s = time_limit_s;
             options.max_iterations = max_iterations;
             return unlocked([&] {
               return Horizon{RecedingHorizon::make(path, vehicle, options).value(), false};
             });
           }),
           py::arg("path"), py::kw_only(), py::arg("speed"), py::arg("acceleration"),
           py::arg("offset"), py::arg("braking") = limits.braking,
           py::arg("lateral_acceleration") = limits.lateral_acceleration,
           py::arg("turn_radius") = limits.turn_radius, py::arg("step") = usual.step,
           py::arg("intervals") = usual.intervals, py::arg("effort") = usual.effort,
           py::arg("centre") = usual.centre, py::arg("time_limit_s") = usual.time_limit_s,
           py::arg("max_iterations") = usual.max_iterations)
      .def(
          "plan",
          [](Horizon& horizon, const FollowStart& measured) {
            HorizonPlan plan = unlocked([&] { return horizon.solver.plan(measured).value(); });
            horizon.planned = true;
            return plan;
          },
          py::arg("measured"), "The plan from a measured FollowStart.")
      .def(
          "predicted",
          [](const Horizon& horizon) {
            if (!horizon.planned) {
              throw Error(Fault{FaultCode::outside_domain, "plan first, then predict", std::nullopt,
                                "plan", std::nullopt, std::nullopt});
            }
            return horizon.solver.predicted();
          },
          "Where the vehicle is after one step of the last plan's first control.")
      .def("__repr__", [](const Horizon& horizon) {
        return std::string("<hodograph.RecedingHorizon: ") +
               (horizon.planned ? "has planned>" : "has not planned>");
      });
}

}  // namespace

void bind_following(py::module_& m) {
  bind_start(m);
  bind_result(m);
  bind_follow(m);
  bind_horizon(m);
}

}  // namespace hodograph::python
