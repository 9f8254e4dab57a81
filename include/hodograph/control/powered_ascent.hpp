// SPDX-License-Identifier: MIT
// The ascent from the Moon's surface to its orbit, with gravity: three-body dynamics and a thrust
// vector.
//
// In the rotating frame, from the Moon's centre, in units of 1000 km and 1000 s (so km/s and m/s²):
//   r'' = ∇Ω(r) + 2 n (y', -x', 0) + u,   |u| ≤ thrust limit,   |r| ≥ radius + margin after the
//   start from rest on the surface (at rest in the rotating frame: the Moon's own turning is in it)
//   to (r, r')(T) = a point of the orbit with its velocity, the point being free.
// N equal intervals of constant thrust, Runge-Kutta steps of order four. The answer is followed
// again by a Runge-Kutta pair of orders 7 and 8, which knows nothing of the nodes.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "hodograph/control/lunar_ascent.hpp"

namespace hodograph {

enum class PoweredObjective {
  least_energy,  ///< ∫ |u|² dt over a given time, (m/s²)² 1000 s
  least_time,    ///< T, in 1000 s
};

/// The sphere to start from and to stay above: the Moon's radius in the publication, 2.6 km above
/// its mean radius. Objectives are 0.2 to 0.4 % higher from moon_radius_km.
inline constexpr double default_surface_km = 1740.0;

struct PoweredOptions {
  PoweredObjective objective = PoweredObjective::least_energy;
  double duration_s = 5400.0;              ///< least_energy: T; least_time: where the search starts
  double thrust_limit_m_s2 = 5.0;          ///< > 0
  double surface_km = default_surface_km;  ///< distance of the surface from the Moon's centre
  double margin_km = 0.2;                  ///< ≥ 0, above the surface, at the nodes but the first
  std::size_t intervals = 100;             ///< 2 ... 100000
  AscentSolving solving{};
};

/// What following the thrust again by another method found.
struct Repropagation {
  double position_error_km{};  ///< against the answer's last node
  double velocity_error_m_s{};
  double orbit_error_km{};  ///< against the orbit itself, at the phase found
  double orbit_velocity_error_m_s{};
  /// A height above the surface that all the motion keeps, between the nodes too: below the lowest
  /// by 10 cm at most. It follows from bounds of the acceleration between places 7 s or less apart,
  /// and is certain up to the integrator's error (some 1e-18 of the distance a step).
  double lowest_height_km{};
  double lowest_later_height_km{};  ///< the same from the end of the first interval on
  std::size_t steps = 0;
};

struct PoweredAscent {
  AscentStart start;
  PoweredOptions options;
  double duration_s{};
  double phase{};                         ///< where it meets the orbit, revolutions in [0, 1)
  std::vector<double> time_s;             ///< N + 1 nodes
  std::vector<Vector3<double>> position;  ///< km, from the Moon's centre, rotating frame
  std::vector<Vector3<double>> velocity;  ///< km/s
  std::vector<Vector3<double>> thrust;    ///< m/s², N
  std::vector<double> position_error_km;  ///< from the orbit's point that moves to the meeting
  /// The angle between velocity and the orbit's tangent at that point, radians; at the start, where
  /// there is no velocity, that of the thrust.
  std::vector<double> orientation_error;
  double velocity_change_m_s{};  ///< ∫ |u| dt
  Repropagation again;
  AscentSolved solved;
};

/// Solves the ascent from one start. Accuracy: a local minimum to the tolerances of SolverOptions;
/// how far its Runge-Kutta steps are from the motion stands in `again`.
/// Faults: outside_domain (options), no_convergence (no guess led to a solution), cancelled.
Result<PoweredAscent> powered_ascent(const AscentReference& reference, const AscentStart& start,
                                     const PoweredOptions& options = {});

}  // namespace hodograph
