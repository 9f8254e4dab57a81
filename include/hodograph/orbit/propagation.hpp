// SPDX-License-Identifier: MIT
// Following a three-body motion, and its dependence on the start, through time.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "hodograph/foundation/result.hpp"
#include "hodograph/orbit/three_body.hpp"

namespace hodograph {

/// A motion that comes nearer than this to a primary's centre (LU; 390 m for Earth and Moon) is
/// refused: both primaries are far larger, and the equations are singular there.
inline constexpr double default_collision_distance = 1e-6;

/// The local error of a step, relative to the state: the propagation's rounding per step (some
/// ten additions of stages) is of this size, so asking for less buys nothing.
inline constexpr long double default_step_tolerance =
    16 * std::numeric_limits<long double>::epsilon();

/// Attempted steps of one propagation. A revolution of a near-rectilinear halo orbit takes about
/// 500; this is the bound that turns an endless request into a Fault within seconds.
inline constexpr std::size_t default_max_steps = 200'000;

/// How a motion is followed.
struct PropagationOptions {
  long double step_tolerance = default_step_tolerance;  ///< at least epsilon, below 1
  double collision_distance =
      default_collision_distance;             ///< LU, from either primary's centre; > 0
  std::size_t max_steps = default_max_steps;  ///< attempted steps
};

/// Where a motion got to.
struct Propagation {
  OrbitState<long double> state;           ///< at the end
  std::size_t steps = 0;                   ///< attempted steps
  long double closest_approach_larger{};   ///< smallest distance from the larger primary, LU
  long double closest_approach_smaller{};  ///< smallest distance from the smaller primary, LU
};

/// The state transition matrix Φ = ∂(r, v)(t) / ∂(r, v)(0), rows and columns x, y, z, vx, vy, vz.
using TransitionMatrix = std::array<std::array<long double, 6>, 6>;

/// A motion with its first variation.
struct VariationalPropagation {
  Propagation motion;
  TransitionMatrix transition{};
};

/// The state `duration` (TU, either sign) after `start`, by an embedded Runge-Kutta pair of orders
/// 7 and 8 (Fehlberg; Boost.odeint) in long double with step control. The global error is about
/// step_tolerance times the number of steps times the growth |Φ|; the default keeps one revolution
/// of a near-rectilinear halo orbit within 1e-15 LU.
/// Closest approaches are those at the steps' ends and, where a step passes a minimum, of the cubic
/// through its ends (relative error below 1e-5).
/// Faults: not_finite (a component, or the duration); outside_domain (the system, an option, or a
/// start or a passage within collision_distance of a primary); no_convergence (more than max_steps
/// steps, or a step too short to advance time; the sentence says how far it got).
Result<Propagation> propagate(const ThreeBodySystem& system, const OrbitState<long double>& start,
                              long double duration, const PropagationOptions& options = {});

/// The same motion together with its transition matrix, from the variational equations
/// Φ' = [0 I; H 2J] Φ, H the Hessian of Ω and J = [0 1 0; -1 0 0; 0 0 0]. Faults as propagate.
Result<VariationalPropagation> propagate_variations(const ThreeBodySystem& system,
                                                    const OrbitState<long double>& start,
                                                    long double duration,
                                                    const PropagationOptions& options = {});

/// The least time after `start` (TU, at most `limit`) at which the motion crosses the plane y = 0,
/// the start itself excluded, to rounding. This is half the period of an orbit that is symmetric
/// about that plane and starts on it. Faults as propagate; no_convergence where there is no
/// crossing before `limit`.
Result<long double> next_plane_crossing(const ThreeBodySystem& system,
                                        const OrbitState<long double>& start, long double limit,
                                        const PropagationOptions& options = {});

}  // namespace hodograph
