// SPDX-License-Identifier: MIT
// hodograph._orbit: the three-body problem, periodic orbits, propagation, reference frames, orbits
// as curves and their fits: orbit/.
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/complex.h>
#include "hodograph/orbit/motion_series.hpp"
#include "hodograph/orbit/orbit_curve.hpp"
#include "hodograph/orbit/reference_frame.hpp"

#include "python/src/made.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

using State = OrbitState<long double>;
using Jet = MotionJet<double, 5>;

/// A state from an array (6,): position and velocity.
State state_of(const Doubles& array) {
  if (array.ndim() != 1 || array.shape(0) != 6) refuse_shape("state", "(6,)", array);
  const double* x = array.data();
  return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
}

Doubles array_of_state(const State& state) {
  Doubles result(6);
  for (std::size_t i = 0; i < 3; ++i) {
    result.mutable_data()[i] = static_cast<double>(state.position[i]);
    result.mutable_data()[3 + i] = static_cast<double>(state.velocity[i]);
  }
  return result;
}

Doubles array_of_matrix(const TransitionMatrix& matrix) {
  Doubles result({6, 6});
  double* to = result.mutable_data();
  for (const auto& row : matrix) {
    for (const long double x : row) *to++ = static_cast<double>(x);
  }
  return result;
}

PropagationOptions propagation_of(double step_tolerance, double collision_distance,
                                  std::size_t max_steps) {
  return {step_tolerance, collision_distance, max_steps};
}

// The members of PropagationOptions as keyword arguments, in the order of propagation_of.
#define HODOGRAPH_PROPAGATION                                              \
  py::arg("step_tolerance") = static_cast<double>(default_step_tolerance), \
  py::arg("collision_distance") = default_collision_distance,              \
  py::arg("max_steps") = default_max_steps

/// Points (..., 3), one after the other, with their exact functions in double.
template <class Value>
auto at_points(std::size_t size, const Value& value) {
  return [size, value](const ThreeBodySystem& system, const Doubles& positions) {
    if (positions.ndim() < 1 || positions.shape(positions.ndim() - 1) != 3) {
      refuse_shape("positions", "(..., 3)", positions);
    }
    require_finite(numbers(positions), "positions");
    Shape shape = shape_of(positions);
    shape.pop_back();
    if (size == 3) shape.push_back(3);
    if (size == 9) shape.insert(shape.end(), {3, 3});
    Doubles result(shape);
    const double* from = positions.data();
    double* to = result.mutable_data();
    const auto count = static_cast<std::size_t>(positions.size()) / 3;
    for (std::size_t k = 0; k < count; ++k, from += 3, to += size) {
      const Vector3<double> p{from[0], from[1], from[2]};
      if (norm(offset_from_larger(system, p)) == 0.0 ||
          norm(offset_from_smaller(system, p)) == 0.0) {
        throw Error(Fault{FaultCode::outside_domain,
                          "the potential is infinite at the primaries; point " + std::to_string(k) +
                              " is one of them",
                          k, "positions", std::nullopt, std::nullopt});
      }
      value(system, p, to);
    }
    return result;
  };
}

Doubles like(const Jet& jet) {
  Doubles result({5, 3});
  double* to = result.mutable_data();
  for (const auto& row : jet) {
    for (std::size_t i = 0; i < 3; ++i) *to++ = row[i];
  }
  return result;
}

Jet jet_of(const Doubles& array) {
  if (array.ndim() != 2 || array.shape(0) != 5 || array.shape(1) != 3) {
    refuse_shape("jet", "(5, 3)", array);
  }
  Jet jet{};
  for (std::size_t k = 0; k < 5; ++k) {
    for (std::size_t i = 0; i < 3; ++i) jet[k][i] = array.data()[3 * k + i];
  }
  return jet;
}

void bind_system(py::module_& m) {
  Record<ThreeBodySystem> system(m, "ThreeBodySystem",
                                 "The constants of two primaries that circle their "
                                 "barycentre.");
  system.def(py::init([](double mass_ratio, double length_unit_km, double time_unit_s) {
               const ThreeBodySystem made{mass_ratio, length_unit_km, time_unit_s};
               if (const auto fault = check_system(made)) throw Error(*fault);
               return made;
             }),
             py::arg("mass_ratio"), py::arg("length_unit_km"), py::arg("time_unit_s"),
             "Raises HodographError: outside_domain (a mass ratio outside (0, 1/2] and the like).");
  system.field("mass_ratio", &ThreeBodySystem::mass_ratio, "Of the smaller primary.")
      .field("length_unit_km", &ThreeBodySystem::length_unit_km, "Kilometres in one LU.")
      .field("time_unit_s", &ThreeBodySystem::time_unit_s, "Seconds in one TU.");
  m.attr("earth_moon_system") = earth_moon_system;
  m.def("pseudo_potential",
        at_points(1, [](const ThreeBodySystem& s, const Vector3<double>& p,
                        double* to) { *to = pseudo_potential(s, p); }),
        py::arg("system"), py::arg("positions"),
        "Omega at points (..., 3) of the rotating frame, LU^2/TU^2, shape (...).");
  m.def("pseudo_potential_gradient",
        at_points(3,
                  [](const ThreeBodySystem& s, const Vector3<double>& p, double* to) {
                    const auto g = pseudo_potential_gradient(s, p);
                    for (std::size_t i = 0; i < 3; ++i) to[i] = g[i];
                  }),
        py::arg("system"), py::arg("positions"), "Its gradient, (..., 3), LU/TU^2.");
  m.def("pseudo_potential_hessian",
        at_points(9,
                  [](const ThreeBodySystem& s, const Vector3<double>& p, double* to) {
                    for (const auto& row : pseudo_potential_hessian(s, p)) {
                      for (std::size_t i = 0; i < 3; ++i) *to++ = row[i];
                    }
                  }),
        py::arg("system"), py::arg("positions"), "Its Hessian, (..., 3, 3), 1/TU^2.");
  m.def(
      "three_body_acceleration",
      [](const ThreeBodySystem& bodies, const Doubles& state) {
        require_finite(numbers(state), "state");
        const State s = state_of(state);
        const auto a = three_body_acceleration(bodies, s);
        return Vector3<double>{static_cast<double>(a.x), static_cast<double>(a.y),
                               static_cast<double>(a.z)};
      },
      py::arg("system"), py::arg("state"), "The acceleration (3,) of a state (6,).");
  m.def(
      "jacobi_constant",
      [](const ThreeBodySystem& bodies, const Doubles& state) {
        require_finite(numbers(state), "state");
        return static_cast<double>(jacobi_constant(bodies, state_of(state)));
      },
      py::arg("system"), py::arg("state"), "C = 2 Omega - |r'|^2 of a state (6,).");
  m.def(
      "motion_derivatives",
      [](const ThreeBodySystem& bodies, const Doubles& state) {
        require_finite(numbers(state), "state");
        Jet jet{};
        const auto exact = motion_derivatives(bodies, state_of(state));
        for (std::size_t k = 0; k < 5; ++k) {
          for (std::size_t i = 0; i < 3; ++i) jet[k][i] = static_cast<double>(exact[k][i]);
        }
        return like(jet);
      },
      py::arg("system"), py::arg("state"),
      "Position and four derivatives (5, 3) of the motion through a state (6,).");
}

/// Each long double as two doubles, whose sum it is exactly, and back.
Doubles in_two(const std::vector<long double>& numbers) {
  std::vector<double> parts;
  for (const long double x : numbers) {
    const auto high = static_cast<double>(x);
    parts.push_back(high);
    parts.push_back(static_cast<double>(x - static_cast<long double>(high)));
  }
  return array_of(parts);
}
std::vector<long double> of_two(const Doubles& array, std::size_t count) {
  const auto parts = numbers_of(array, "numbers");
  if (parts.size() != 2 * count) refuse_shape("numbers", std::to_string(2 * count), array);
  std::vector<long double> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    numbers.push_back(static_cast<long double>(parts[2 * i]) +
                      static_cast<long double>(parts[2 * i + 1]));
  }
  return numbers;
}

std::vector<long double> numbers_of_motion(const Propagation& p) {
  return {p.state.position[0],       p.state.position[1],       p.state.position[2],
          p.state.velocity[0],       p.state.velocity[1],       p.state.velocity[2],
          p.closest_approach_larger, p.closest_approach_smaller};
}

void bind_propagation(py::module_& m) {
  py::class_<Propagation>(m, "Propagation", "Where a motion got to.")
      .def_property_readonly(
          "state", [](const Propagation& p) { return array_of_state(p.state); }, "(6,).")
      .def_readonly("steps", &Propagation::steps)
      .def_property_readonly(
          "closest_approach_larger",
          [](const Propagation& p) { return static_cast<double>(p.closest_approach_larger); },
          "LU.")
      .def_property_readonly(
          "closest_approach_smaller",
          [](const Propagation& p) { return static_cast<double>(p.closest_approach_smaller); },
          "LU.")
      .def("__repr__",
           [](const Propagation& p) {
             return "<hodograph.Propagation: " + std::to_string(p.steps) + " steps>";
           })
      .def(
          "__eq__",
          [](const Propagation& a, const Propagation& b) {
            return a.steps == b.steps && numbers_of_motion(a) == numbers_of_motion(b);
          },
          py::is_operator())
      .def(py::pickle(
          [](const Propagation& p) {
            return py::make_tuple(p.steps, in_two(numbers_of_motion(p)));
          },
          [](const py::tuple& t) {
            require_members(t, 2);
            const auto x = of_two(t[1].cast<Doubles>(), 8);
            return Propagation{
                {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}}, t[0].cast<std::size_t>(), x[6], x[7]};
          }));
  py::class_<VariationalPropagation>(m, "VariationalPropagation",
                                     "A motion with its first variation.")
      .def_readonly("motion", &VariationalPropagation::motion)
      .def_property_readonly(
          "transition",
          [](const VariationalPropagation& p) { return array_of_matrix(p.transition); },
          "The state transition matrix, (6, 6).")
      .def("__repr__",
           [](const VariationalPropagation& p) {
             return "<hodograph.VariationalPropagation: " + std::to_string(p.motion.steps) +
                    " steps>";
           })
      .def(
          "__eq__",
          [](const VariationalPropagation& a, const VariationalPropagation& b) {
            return a.motion.steps == b.motion.steps && a.transition == b.transition &&
                   numbers_of_motion(a.motion) == numbers_of_motion(b.motion);
          },
          py::is_operator())
      .def(py::pickle(
          [](const VariationalPropagation& p) {
            std::vector<long double> all;
            for (const auto& row : p.transition) all.insert(all.end(), row.begin(), row.end());
            return py::make_tuple(p.motion, in_two(all));
          },
          [](const py::tuple& t) {
            require_members(t, 2);
            const auto x = of_two(t[1].cast<Doubles>(), 36);
            VariationalPropagation p{t[0].cast<Propagation>(), {}};
            for (std::size_t i = 0; i < 36; ++i) p.transition[i / 6][i % 6] = x[i];
            return p;
          }));
  m.def(
      "propagate",
      [](const ThreeBodySystem& system, const Doubles& start, double duration,
         double step_tolerance, double collision_distance, std::size_t max_steps) {
        const State from = state_of(start);
        const auto options = propagation_of(step_tolerance, collision_distance, max_steps);
        return unlocked([&] { return propagate(system, from, duration, options).value(); });
      },
      py::arg("system"), py::arg("start"), py::arg("duration"), py::kw_only(),
      HODOGRAPH_PROPAGATION,
      "The state `duration` TU (either sign) after a state (6,), in long double.\nRaises "
      "HodographError: not_finite, outside_domain (a collision), no_convergence.");
  m.def(
      "propagate_variations",
      [](const ThreeBodySystem& system, const Doubles& start, double duration,
         double step_tolerance, double collision_distance, std::size_t max_steps) {
        const State from = state_of(start);
        const auto options = propagation_of(step_tolerance, collision_distance, max_steps);
        return unlocked(
            [&] { return propagate_variations(system, from, duration, options).value(); });
      },
      py::arg("system"), py::arg("start"), py::arg("duration"), py::kw_only(),
      HODOGRAPH_PROPAGATION, "The same motion together with its transition matrix.");
  m.def(
      "next_plane_crossing",
      [](const ThreeBodySystem& system, const Doubles& start, double limit, double step_tolerance,
         double collision_distance, std::size_t max_steps) {
        const State from = state_of(start);
        const auto options = propagation_of(step_tolerance, collision_distance, max_steps);
        return unlocked([&] {
          return static_cast<double>(next_plane_crossing(system, from, limit, options).value());
        });
      },
      py::arg("system"), py::arg("start"), py::arg("limit"), py::kw_only(), HODOGRAPH_PROPAGATION,
      "The least time (TU, at most `limit`) at which the motion crosses the plane y = 0.");
}

/// All numbers of an orbit, one after the other: visit(orbit, take) with take(long double&).
template <class Orbit, class Take>
void visit_numbers(Orbit& orbit, const Take& take) {
  for (std::size_t i = 0; i < 3; ++i) take(orbit.initial.position[i]);
  for (std::size_t i = 0; i < 3; ++i) take(orbit.initial.velocity[i]);
  for (auto* x : {&orbit.period, &orbit.crossing_residual, &orbit.closure, &orbit.jacobi,
                  &orbit.closest_approach_larger, &orbit.closest_approach_smaller}) {
    take(*x);
  }
  for (auto& row : orbit.monodromy) {
    for (auto& x : row) take(x);
  }
}

std::vector<long double> numbers_of_orbit(const PeriodicOrbit& orbit) {
  std::vector<long double> all;
  visit_numbers(orbit, [&](const long double& x) { all.push_back(x); });
  return all;
}

py::tuple stored(const PeriodicOrbit& orbit) {
  return py::make_tuple(orbit.system, orbit.iterations, in_two(numbers_of_orbit(orbit)),
                        orbit.stability_indices[0], orbit.stability_indices[1]);
}

PeriodicOrbit restored(const py::tuple& t) {
  require_members(t, 5);
  PeriodicOrbit orbit;
  const std::size_t count = numbers_of_orbit(orbit).size();
  orbit.system = t[0].cast<ThreeBodySystem>();
  orbit.iterations = t[1].cast<std::size_t>();
  const auto numbers = of_two(t[2].cast<Doubles>(), count);
  orbit.stability_indices = {t[3].cast<std::complex<double>>(), t[4].cast<std::complex<double>>()};
  std::size_t next = 0;
  visit_numbers(orbit, [&](long double& x) { x = numbers[next++]; });
  return orbit;
}

void bind_orbits(py::module_& m) {
  py::enum_<HeldQuantity>(m, "HeldQuantity", "Which number of a guess a correction leaves alone.")
      .value("x", HeldQuantity::x, "The distance along the line of primaries.")
      .value("z", HeldQuantity::z, "The height above their plane.")
      .value("period", HeldQuantity::period);
  const auto number = [](auto member) {
    return [member](const PeriodicOrbit& orbit) { return static_cast<double>(orbit.*member); };
  };
  using O = PeriodicOrbit;
  py::class_<O>(m, "PeriodicOrbit",
                "A periodic orbit that crosses y = 0 perpendicularly at its start and half a "
                "period later; kept in\nlong double, shown in double.")
      .def_readonly("system", &O::system)
      .def_property_readonly(
          "initial", [](const O& orbit) { return array_of_state(orbit.initial); }, "(6,).")
      .def_property_readonly("period", number(&O::period), "TU.")
      .def_property_readonly("crossing_residual", number(&O::crossing_residual))
      .def_property_readonly("closure", number(&O::closure),
                             "The largest component of state(period) - state(0).")
      .def_property_readonly("jacobi", number(&O::jacobi), "The Jacobi constant.")
      .def_property_readonly("closest_approach_larger", number(&O::closest_approach_larger), "LU.")
      .def_property_readonly("closest_approach_smaller", number(&O::closest_approach_smaller),
                             "LU.")
      .def_readonly("iterations", &O::iterations, "Of the correction that found it.")
      .def_property_readonly(
          "monodromy", [](const O& orbit) { return array_of_matrix(orbit.monodromy); },
          "The transition matrix over one period, (6, 6).")
      .def_property_readonly(
          "stability_indices",
          [](const O& orbit) {
            return std::vector<std::complex<double>>(orbit.stability_indices.begin(),
                                                     orbit.stability_indices.end());
          },
          "(lambda + 1/lambda)/2 for the two non-trivial pairs of eigenvalues.")
      .def("__repr__",
           [](const O& orbit) {
             return "<hodograph.PeriodicOrbit: period " +
                    to_text(static_cast<double>(orbit.period)) + " TU, Jacobi constant " +
                    to_text(static_cast<double>(orbit.jacobi)) + ">";
           })
      .def(
          "__eq__",
          [](const O& a, const O& b) {
            return numbers_of_orbit(a) == numbers_of_orbit(b) && a.iterations == b.iterations &&
                   a.stability_indices == b.stability_indices &&
                   py::cast(a.system).equal(py::cast(b.system));
          },
          py::is_operator())
      .def("__copy__", [](const O& orbit) { return orbit; })
      .def(
          "__deepcopy__", [](const O& orbit, const py::dict&) { return orbit; }, py::arg("memo"))
      .def(py::pickle(&stored, &restored));
  m.attr("crossing_tolerance") = static_cast<double>(crossing_tolerance);
  m.attr("mean_synodic_month_days") = mean_synodic_month_days;
  m.def(
      "correct_symmetric_orbit",
      [](const ThreeBodySystem& system, double x, double z, double vy, std::optional<double> period,
         HeldQuantity held, std::size_t max_iterations, double step_tolerance,
         double collision_distance, std::size_t max_steps) {
        SymmetricGuess guess{x, z, vy, std::nullopt};
        if (period) guess.period = *period;
        const CorrectionOptions options{
            max_iterations, propagation_of(step_tolerance, collision_distance, max_steps)};
        return unlocked(
            [&] { return correct_symmetric_orbit(system, guess, held, options).value(); });
      },
      py::arg("system"), py::arg("x"), py::arg("z"), py::arg("vy"), py::arg("period") = py::none(),
      py::kw_only(), py::arg("held") = HeldQuantity::z,
      py::arg("max_iterations") = default_max_corrections, HODOGRAPH_PROPAGATION,
      "The periodic orbit nearest to a start (x, 0, z) with velocity (0, vy, 0), by Newton's "
      "method with one\nquantity held. Raises HodographError: no_convergence, outside_domain, "
      "not_finite, zero_speed.");
  m.def(
      "continue_to_period",
      [](const O& start, double period, std::size_t max_iterations, double step_tolerance,
         double collision_distance, std::size_t max_steps) {
        const CorrectionOptions options{
            max_iterations, propagation_of(step_tolerance, collision_distance, max_steps)};
        return unlocked([&] { return continue_to_period(start, period, options).value(); });
      },
      py::arg("start"), py::arg("period"), py::kw_only(),
      py::arg("max_iterations") = default_max_corrections, HODOGRAPH_PROPAGATION,
      "The member of the orbit's family with a period (TU), by continuation.");
  m.def(
      "lunar_gateway_nrho", [] { return unlocked([] { return lunar_gateway_nrho().value(); }); },
      "The near-rectilinear halo orbit of the PHODCOS paper, period 7.008 d.");
  m.def(
      "synodic_9_2_nrho", [] { return unlocked([] { return synodic_9_2_nrho().value(); }); },
      "The orbit in 9:2 resonance with the synodic month, period 6.562 d.");
}

void bind_frames(py::module_& m) {
  m.def(
      "to_earth_centred_inertial",
      [](const ThreeBodySystem& system, const Doubles& jet, double time) {
        require_finite({&time, 1}, "time");
        return like(to_earth_centred_inertial<double, 5>(system, jet_of(jet), time));
      },
      py::arg("system"), py::arg("jet"), py::arg("time"),
      "Position and four derivatives (5, 3), with respect to TU, of the rotating frame as seen "
      "from "
      "the larger\nprimary in axes that do not turn, at a time (TU).");
  m.def(
      "from_earth_centred_inertial",
      [](const ThreeBodySystem& system, const Doubles& jet, double time) {
        require_finite({&time, 1}, "time");
        return like(from_earth_centred_inertial<double, 5>(system, jet_of(jet), time));
      },
      py::arg("system"), py::arg("jet"), py::arg("time"), "The inverse.");
  m.def(
      "smaller_primary_inertial",
      [](double time) {
        require_finite({&time, 1}, "time");
        return smaller_primary_inertial(time);
      },
      py::arg("time"), "Where the smaller primary is then: (cos t, sin t, 0), LU.");
}

void bind_curves(py::module_& m) {
  py::enum_<OrbitFrame>(m, "OrbitFrame", "The frame an orbit's curve is drawn in.")
      .value("rotating", OrbitFrame::rotating, "Primaries at rest; the orbit is closed.")
      .value("earth_centred_inertial", OrbitFrame::earth_centred_inertial);
  py::enum_<OrbitParameter>(m, "OrbitParameter", "What an orbit's parameter is.")
      .value("time", OrbitParameter::time, "TU since the initial state.")
      .value("revolutions", OrbitParameter::revolutions);
  using C = OrbitCurve;
  py::class_<C>(m, "OrbitCurve",
                "A periodic orbit as a curve: position and four derivatives anywhere. fit() takes "
                "it as a callable.")
      .def(py::init([](const PeriodicOrbit& orbit, OrbitFrame frame, OrbitParameter parameter,
                       std::size_t revolutions) {
             return unlocked([&] { return C::make(orbit, frame, parameter, revolutions).value(); });
           }),
           py::arg("orbit"), py::kw_only(), py::arg("frame") = OrbitFrame::rotating,
           py::arg("parameter") = OrbitParameter::time, py::arg("revolutions") = 1,
           "Raises HodographError: outside_domain, not_continuous.")
      .def(
          "__call__",
          [](const C& curve, const Doubles& xi) {
            require_finite(numbers(xi), "xi");
            return filled_like(xi, {5, 3}, [&](auto from, auto to) {
              double* next = to.data();
              for (const double x : from) {
                for (const auto& row : curve(x)) {
                  for (std::size_t i = 0; i < 3; ++i) *next++ = row[i];
                }
              }
            });
          },
          py::arg("xi"), "Position (LU) and four derivatives, (..., 5, 3), at any finite xi.")
      .def_property_readonly("end", &C::end, "xi runs from 0 to this.")
      .def_property_readonly("revolutions", &C::revolutions)
      .def_property_readonly("frame", &C::frame)
      .def_property_readonly("parameter", &C::parameter)
      .def_property_readonly("orbit", &C::orbit)
      .def_property_readonly("series_count", &C::series_count)
      .def("__repr__",
           [](const C& curve) {
             return "<hodograph.OrbitCurve: xi from 0 to " + to_text(curve.end()) + ", " +
                    std::to_string(curve.revolutions()) +
                    (curve.revolutions() == 1 ? " revolution>" : " revolutions>");
           })
      .def(py::pickle(
          [](const C& c) {
            return py::make_tuple(c.orbit(), c.frame(), c.parameter(), c.revolutions());
          },
          [](const py::tuple& t) {
            return C::make(t[0].cast<PeriodicOrbit>(), t[1].cast<OrbitFrame>(),
                           t[2].cast<OrbitParameter>(), t[3].cast<std::size_t>())
                .value();
          }));
}

}  // namespace

}  // namespace hodograph::python

PYBIND11_MODULE(_orbit, m) {
  using namespace hodograph::python;
  m.doc() = "The three-body problem and its periodic orbits.";
  py::module_::import("hodograph._core");
  bind_system(m);
  bind_propagation(m);
  bind_orbits(m);
  bind_frames(m);
  bind_curves(m);
  add_equality_of_states(py::type::of<hodograph::OrbitCurve>());
}
