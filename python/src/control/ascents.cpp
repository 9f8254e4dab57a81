// SPDX-License-Identifier: MIT
// Ascents from the Moon to its near-rectilinear halo orbit: control/lunar_ascent.hpp,
// tracking_ascent.hpp, powered_ascent.hpp, framed_ascent.hpp.
#include <cmath>
#include <string>
#include <vector>

#include "hodograph/control/framed_ascent.hpp"
#include "hodograph/control/powered_ascent.hpp"
#include "hodograph/control/tracking_ascent.hpp"
#include "python/src/control/solving.hpp"
#include "python/src/made.hpp"

namespace pybind11::detail {

template <>
struct type_caster<hodograph::AscentReference> : hodograph_made_caster<hodograph::AscentReference> {
};

}  // namespace pybind11::detail

namespace hodograph::python {

namespace {

using Progress = std::optional<AscentProgress>;

AscentSolving solving_of(std::size_t guesses, std::size_t max_iterations, double time_limit_s,
                         const py::dict& settings, Watch& watch) {
  AscentSolving solving;
  solving.guesses = guesses;
  solving.max_iterations = max_iterations;
  solving.time_limit_s = time_limit_s;
  solving.progress = [&watch](std::size_t guess, const SolverIteration& at) {
    return watch.goes_on(guess, at);
  };
  solving.more = settings_of(settings);
  return solving;
}

void bind_shared(py::module_& m) {
  Record<SolverIteration>(m, "SolverIteration", "One iteration of a solver, as it is reported.")
      .field("iteration", &SolverIteration::iteration)
      .field("objective", &SolverIteration::objective)
      .field("primal_infeasibility", &SolverIteration::primal_infeasibility)
      .field("dual_infeasibility", &SolverIteration::dual_infeasibility)
      .field("barrier", &SolverIteration::barrier)
      .field("restoring", &SolverIteration::restoring);
  Record<AscentStart>(m, "AscentStart", "A place on the Moon's surface.")
      .field("name", &AscentStart::name)
      .field("direction", &AscentStart::direction, "From its centre, of length 1.");
  m.def(
      "ascent_starts",
      [] {
        const auto all = ascent_starts();
        return std::vector<AscentStart>(all.begin(), all.end());
      },
      "+z (the north pole), -z, +x (the far side), -x, -y, +y.");
  m.def(
      "ascent_start", [](const std::string& name) { return ascent_start(name).value(); },
      py::arg("name"), "The place with this name. Raises HodographError: unsupported.");
  m.attr("moon_radius_km") = moon_radius_km;
  m.attr("arrival_distance_km") = arrival_distance_km;
  using R = AscentReference;
  made_class<R>(m, "AscentReference",
                "A periodic orbit with its path, xi in revolutions from 0 to 1, in LU, closed.")
      .def(py::init([](const PeriodicOrbit& orbit, double tolerance) {
             auto reference = unlocked([&] { return R::make(orbit, tolerance).value(); });
             return made(std::move(reference), "", orbit, tolerance);
           }),
           py::arg("orbit"), py::arg("tolerance") = default_reference_tolerance,
           "The path of an orbit to a tolerance (LU).")
      .def_static(
          "gateway", [] { return made(unlocked([] { return R::gateway().value(); }), "gateway"); },
          "The orbit of the PHODCOS paper, lunar_gateway_nrho().")
      .def_property_readonly("orbit", &R::orbit)
      .def_property_readonly("path", &R::path)
      .def_property_readonly("period_s", &R::period_s, "Seconds a revolution.")
      .def_property_readonly("moon", &R::moon, "The Moon's centre, LU, (3,).")
      .def(
          "derivatives",
          [](const R& reference, const Doubles& revolutions) {
            require_finite(numbers(revolutions), "revolutions");
            return filled_like(revolutions, {4, 3}, [&](auto from, auto to) {
              double* next = to.data();
              for (const double x : from) {
                for (const auto& row : reference.derivatives(x)) {
                  for (std::size_t i = 0; i < 3; ++i) *next++ = row[i];
                }
              }
            });
          },
          py::arg("revolutions"), "p and three derivatives by revolutions, (..., 4, 3).")
      .def("__repr__", [](const R& reference) {
        return "<hodograph.AscentReference: period " + to_text(reference.period_s()) + " s>";
      });
  Record<AscentSolved>(m, "AscentSolved", "How an answer was found.")
      .field("objective", &AscentSolved::objective)
      .field("guess", &AscentSolved::guess, "That led to it, from 0.")
      .field("tried", &AscentSolved::tried)
      .field("converged", &AscentSolved::converged)
      .field("iterations", &AscentSolved::iterations)
      .field("seconds", &AscentSolved::seconds)
      .field("constraint_error", &AscentSolved::constraint_error)
      .field("status", &AscentSolved::status, "The solver's words.");
}

void bind_tracking(py::module_& m) {
  py::enum_<TrackingSetting>(m, "TrackingSetting", "Two settings that go by the same text.")
      .value("one_revolution", TrackingSetting::one_revolution, "What the text describes.")
      .value("four_revolutions", TrackingSetting::four_revolutions, "The figure; does not arrive.");
  using T = TrackingAscent;
  Record<T>(m, "TrackingAscent", "The ascent of the PHODCOS paper, problem (25).")
      .field("start", &T::start)
      .field("xi", &T::xi, "The nodes, (N + 1,).")
      .field("position", &T::position, "(N + 1, 3), LU.")
      .field("reference", &T::reference, "The orbit's points, (N + 1, 3), LU.")
      .field("speed", &T::speed)
      .field("theta", &T::theta)
      .field("phi", &T::phi)
      .field("acceleration", &T::acceleration, "(N,).")
      .field("theta_rate", &T::theta_rate, "(N,).")
      .field("phi_rate", &T::phi_rate, "(N,).")
      .field("position_error_km", &T::position_error_km)
      .field("orientation_error", &T::orientation_error, "Radians.")
      .field("speed_unit_m_s", &T::speed_unit_m_s)
      .field("time_unit_s", &T::time_unit_s)
      .field("end_error_km", &T::end_error_km)
      .field("lowest_height_km", &T::lowest_height_km)
      .field("largest_thrust_m_s2", &T::largest_thrust_m_s2)
      .field("arrives", &T::arrives)
      .field("solved", &T::solved);
  const TrackingOptions usual{};
  m.def(
      "tracking_ascent",
      [](const AscentReference& reference, const AscentStart& start, TrackingSetting setting,
         std::size_t intervals, double singular_theta, std::size_t guesses,
         std::size_t max_iterations, double time_limit_s, const Progress& progress,
         const py::dict& settings) {
        Watch watch(progress);
        const TrackingOptions options{
            setting, intervals, singular_theta,
            solving_of(guesses, max_iterations, time_limit_s, settings, watch)};
        return watch.run([&] { return tracking_ascent(reference, start, options); });
      },
      py::arg("reference"), py::arg("start"), py::kw_only(), py::arg("setting") = usual.setting,
      py::arg("intervals") = usual.intervals, py::arg("singular_theta") = usual.singular_theta,
      py::arg("guesses") = usual.solving.guesses,
      py::arg("max_iterations") = usual.solving.max_iterations,
      py::arg("time_limit_s") = usual.solving.time_limit_s, py::arg("progress") = py::none(),
      py::arg("settings") = py::dict(),
      "Solves the ascent (25) from one start. progress(guess, SolverIteration) is called after "
      "every iteration;\nFalse stops with HodographError: cancelled. settings: Ipopt's own. Raises "
      "HodographError: outside_domain, no_convergence.");
}

void bind_powered(py::module_& m) {
  py::enum_<PoweredObjective>(m, "PoweredObjective", "What a powered ascent spends least of.")
      .value("least_energy", PoweredObjective::least_energy)
      .value("least_time", PoweredObjective::least_time);
  Record<Repropagation>(m, "Repropagation", "What following the thrust again found.")
      .field("position_error_km", &Repropagation::position_error_km)
      .field("velocity_error_m_s", &Repropagation::velocity_error_m_s)
      .field("orbit_error_km", &Repropagation::orbit_error_km)
      .field("orbit_velocity_error_m_s", &Repropagation::orbit_velocity_error_m_s)
      .field("lowest_height_km", &Repropagation::lowest_height_km)
      .field("lowest_later_height_km", &Repropagation::lowest_later_height_km)
      .field("steps", &Repropagation::steps);
  using T = PoweredAscent;
  Record<T>(m, "PoweredAscent", "An ascent with gravity and a thrust vector.")
      .field("start", &T::start)
      .field("duration_s", &T::duration_s)
      .field("phase", &T::phase, "Where it meets the orbit, revolutions in [0, 1).")
      .field("time_s", &T::time_s, "The nodes, (N + 1,).")
      .field("position", &T::position, "(N + 1, 3), km from the Moon's centre.")
      .field("velocity", &T::velocity, "(N + 1, 3), km/s.")
      .field("thrust", &T::thrust, "(N, 3), m/s^2.")
      .field("position_error_km", &T::position_error_km)
      .field("orientation_error", &T::orientation_error, "Radians.")
      .field("velocity_change_m_s", &T::velocity_change_m_s)
      .field("again", &T::again)
      .field("solved", &T::solved);
  const PoweredOptions usual{};
  const auto bind = [&](const char* name, auto solve, const char* doc) {
    m.def(
        name,
        [solve](const AscentReference& reference, const AscentStart& start,
                PoweredObjective objective, double duration_s, double thrust_limit_m_s2,
                double surface_km, double margin_km, std::size_t intervals, std::size_t guesses,
                std::size_t max_iterations, double time_limit_s, const Progress& progress,
                const py::dict& settings) {
          Watch watch(progress);
          const PoweredOptions options{
              objective,
              duration_s,
              thrust_limit_m_s2,
              surface_km,
              margin_km,
              intervals,
              solving_of(guesses, max_iterations, time_limit_s, settings, watch)};
          return watch.run([&] { return solve(reference, start, options); });
        },
        py::arg("reference"), py::arg("start"), py::kw_only(),
        py::arg("objective") = usual.objective, py::arg("duration_s") = usual.duration_s,
        py::arg("thrust_limit_m_s2") = usual.thrust_limit_m_s2,
        py::arg("surface_km") = usual.surface_km, py::arg("margin_km") = usual.margin_km,
        py::arg("intervals") = usual.intervals, py::arg("guesses") = usual.solving.guesses,
        py::arg("max_iterations") = usual.solving.max_iterations,
        py::arg("time_limit_s") = usual.solving.time_limit_s, py::arg("progress") = py::none(),
        py::arg("settings") = py::dict(), doc);
  };
  bind("powered_ascent", &powered_ascent,
       "The ascent from one start under gravity and a limited thrust; as tracking_ascent.");
  bind("powered_ascent_along_path", &powered_ascent_along_path,
       "The same in the coordinates of the orbit's path.");
}

}  // namespace

void bind_ascents(py::module_& m) {
  bind_shared(m);
  bind_tracking(m);
  bind_powered(m);
}

}  // namespace hodograph::python
