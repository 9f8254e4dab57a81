// SPDX-License-Identifier: MIT
// Private to control/: the powered ascent as a shooting model, and its units.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "hodograph/control/multiple_shooting.hpp"
#include "hodograph/control/powered_ascent.hpp"
#include "hodograph/orbit/three_body.hpp"

namespace hodograph::ascent_detail {

/// Lengths of 1000 km and times of 1000 s: speeds are in km/s, accelerations in m/s².
struct PoweredUnits {
  double length, time, speed, acceleration;  ///< one LU, TU, LU/TU, LU/TU² in them

  explicit PoweredUnits(const ThreeBodySystem& system)
      : length(system.length_unit_km / 1000.0),
        time(system.time_unit_s / 1000.0),
        speed(length / time),
        acceleration(speed / time) {}
};

/// r and v from the Moon's centre, thrust u, parameters T and the phase where it meets the orbit.
struct PoweredModel {
  static constexpr std::size_t states = 6, controls = 3, parameters = 2;
  static constexpr std::size_t path_constraints = 2, end_constraints = 6;
  template <class S>
  using State = std::array<S, states>;
  template <class S>
  using Control = std::array<S, controls>;
  template <class S>
  using Parameters = std::array<S, parameters>;

  AscentReference reference;
  PoweredUnits units;
  bool least_time = false;
  double intervals = 1.0;

  /// Acceleration without thrust and without the turning of the frame's part in it, m/s².
  template <class S>
  std::array<S, 3> pull(const std::array<S, 3>& r) const {
    return evaluated_apart(
        [this]<class T>(const std::array<T, 3>& at) {
          const ThreeBodySystem& system = reference.orbit().system;
          const double shrink = 1.0 / units.length;
          const Vector3<T> place{at[0] * shrink + T(1.0 - system.mass_ratio), at[1] * shrink,
                                 at[2] * shrink};
          const Vector3<T> g = pseudo_potential_gradient(system, place);
          return std::array<T, 3>{g.x * units.acceleration, g.y * units.acceleration,
                                  g.z * units.acceleration};
        },
        r);
  }
  template <class S>
  State<S> motion(const State<S>& x, const Control<S>& u) const {
    const std::array<S, 3> g = pull(std::array<S, 3>{x[0], x[1], x[2]});
    const double twice_rate = 2.0 / units.time;
    return {
        x[3],       x[4], x[5], g[0] + twice_rate * x[4] + u[0], g[1] - twice_rate * x[3] + u[1],
        g[2] + u[2]};
  }
  template <class S>
  State<S> derivative(double, const State<S>& x, const Control<S>& u,
                      const Parameters<S>& p) const {
    State<S> slope = motion(x, u);
    for (S& component : slope) component = p[0] * component;
    return slope;
  }
  template <class S>
  S stage_cost(std::size_t, const State<S>&, const Control<S>& u, const Parameters<S>& p) const {
    if (least_time) return S(0.0);
    return (1.0 / intervals) * (p[0] * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]));
  }
  template <class S>
  S end_cost(const State<S>&, const Parameters<S>& p) const {
    return least_time ? p[0] : S(0.0);
  }
  /// |r|² and |u|².
  template <class S>
  std::array<S, 2> path_values(std::size_t, const State<S>& x, const Control<S>& u,
                               const Parameters<S>&) const {
    return {x[0] * x[0] + x[1] * x[1] + x[2] * x[2], u[0] * u[0] + u[1] * u[1] + u[2] * u[2]};
  }
  /// The orbit at a phase, with the derivatives that S carries.
  template <class S>
  State<S> orbit_state(const S& phase) const {
    const auto jet = reference.derivatives(value_of(phase));
    const double rate = 1000.0 / reference.period_s();
    const Vector3<double> place = jet[0] - reference.moon();
    State<S> result;
    for (std::size_t i = 0; i < 3; ++i) {
      if constexpr (std::same_as<S, double>) {
        result[i] = units.length * place[i];
        result[3 + i] = units.length * rate * jet[1][i];
      } else {
        result[i] = units.length * phase.through(place[i], jet[1][i], jet[2][i]);
        result[3 + i] = units.length * rate * phase.through(jet[1][i], jet[2][i], jet[3][i]);
      }
    }
    return result;
  }
  template <class S>
  State<S> end_values(const State<S>& x, const Parameters<S>& p) const {
    State<S> difference = orbit_state(p[1]);
    for (std::size_t i = 0; i < states; ++i) difference[i] = x[i] - difference[i];
    return difference;
  }
};

/// A way that the solver may start from: N + 1 states (r, v), N thrusts, and the phase of its end.
struct PoweredGuess {
  std::vector<std::array<double, 6>> states;
  std::vector<Vector3<double>> thrust;
  double phase = 0.0;
};

/// Round the Moon in the plane of the start and a point of the orbit near its lowest, the shorter
/// way or the longer one, the height growing evenly, with the thrust that this takes.
PoweredGuess way_round_the_moon(const PoweredModel& model, const AscentStart& start,
                                const PoweredOptions& options, std::size_t number);

/// Bad numbers among the options.
std::optional<Fault> check(const PoweredOptions& options);

/// An answer as it is told: from the N + 1 states (r, v) and the N thrusts, the duration in 1000 s,
/// and the phase where it meets the orbit; what following it again finds is in it.
PoweredAscent powered_answer(const PoweredModel& model, const AscentStart& start,
                             const PoweredOptions& options, const AscentSolved& solved,
                             const std::vector<std::array<double, 6>>& states,
                             const std::vector<Vector3<double>>& thrust, double time, double phase);

/// Follows the thrust of an answer by a Runge-Kutta pair of orders 7 and 8 in long double.
Repropagation followed_again(const PoweredModel& model, const PoweredAscent& answer);

}  // namespace hodograph::ascent_detail
