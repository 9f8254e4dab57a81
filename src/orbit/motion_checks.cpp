// SPDX-License-Identifier: MIT
#include "motion_checks.hpp"

#include <array>
#include <limits>

namespace hodograph::motion_checks {

std::string text(long double value) { return to_text(static_cast<double>(value)); }

std::optional<Fault> check_start(const ThreeBodySystem& system,
                                 const OrbitState<long double>& start,
                                 const PropagationOptions& options) {
  if (auto fault = check_system(system)) return fault;
  const std::array<const char*, 3> axes{"x", "y", "z"};
  for (const bool is_velocity : {false, true}) {
    const Vector3<long double>& part = is_velocity ? start.velocity : start.position;
    for (std::size_t i = 0; i < 3; ++i) {
      if (is_finite(part[i])) continue;
      const std::string quantity = std::string(is_velocity ? "velocity " : "position ") + axes[i];
      return Fault{FaultCode::not_finite,
                   "the initial state's " + quantity + " is " + text(part[i]) +
                       "; all six components must be finite",
                   (is_velocity ? 3 : 0) + i,
                   quantity,
                   static_cast<double>(part[i]),
                   {}};
    }
  }
  const long double tolerance = options.step_tolerance;
  constexpr long double least = std::numeric_limits<long double>::epsilon();
  if (!(tolerance >= least && tolerance < 1.0L)) {
    return Fault{FaultCode::outside_domain,
                 "the step tolerance is " + text(tolerance) + "; it must be at least " +
                     text(least) + " and below 1",
                 {},
                 "step_tolerance",
                 static_cast<double>(tolerance),
                 static_cast<double>(least)};
  }
  if (!(options.collision_distance > 0.0) || !is_finite(options.collision_distance)) {
    return Fault{FaultCode::outside_domain,
                 "the collision distance is " + to_text(options.collision_distance) +
                     "; it must be positive and finite, for the equations are singular at the "
                     "primaries",
                 {},
                 "collision_distance",
                 options.collision_distance,
                 0.0};
  }
  if (auto fault = check_distance(Primary::larger, norm(offset_from_larger(system, start.position)),
                                  0.0L, options)) {
    return fault;
  }
  return check_distance(Primary::smaller, norm(offset_from_smaller(system, start.position)), 0.0L,
                        options);
}

std::optional<Fault> check_distance(Primary primary, long double distance, long double time,
                                    const PropagationOptions& options) {
  const long double least = options.collision_distance;
  if (distance >= least) return std::nullopt;
  return Fault{FaultCode::outside_domain,
               "the motion comes within " + text(distance) + " length units of the " +
                   (primary == Primary::larger ? "larger" : "smaller") + " primary at time " +
                   text(time) + "; it must stay at least " + to_text(options.collision_distance) +
                   " away",
               {},
               "distance",
               static_cast<double>(distance),
               options.collision_distance};
}

Fault too_many_steps(long double reached, long double wanted, const PropagationOptions& options) {
  return {FaultCode::no_convergence,
          "the propagation reached time " + text(reached) + " of " + text(wanted) + " in the " +
              std::to_string(options.max_steps) +
              " steps allowed; ask for a shorter time or allow more steps",
          {},
          "time",
          static_cast<double>(reached),
          static_cast<double>(wanted)};
}

Fault stalled(long double reached, long double wanted) {
  return {FaultCode::no_convergence,
          "the propagation cannot go on at time " + text(reached) + " of " + text(wanted) +
              ": the motion is too fast there for the numbers' range",
          {},
          "time",
          static_cast<double>(reached),
          static_cast<double>(wanted)};
}

}  // namespace hodograph::motion_checks
