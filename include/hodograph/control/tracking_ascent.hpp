// SPDX-License-Identifier: MIT
// The ascent of the PHODCOS paper, optimal control problem (25), as published.
//
// States p (LU), speed v, gimbal angles θ, φ; controls acceleration a and rates of the angles; all
// per unit of ξ, N equal intervals of constant controls, Runge-Kutta steps of order four:
//   p' = v (cos φ cos θ, sin φ, cos φ sin θ),  v' = a,  θ' = ω_θ,  φ' = ω_φ                 (24)
//   minimise Σ_{k<N} |p_k - p_orbit(ξ_k)|² + 1e-10 |u_k|²                                   (25)
//   0.001 ≤ v ≤ 50, |ω_θ|, |ω_φ| ≤ 500; start 1.05 · 1740 km from the Moon's centre, v = 0.01
//   outward.
// ξ is time in revolutions (or quarters of them), so this is following a moving point, without
// gravity and with nothing that keeps the lander out of the Moon. For an ascent that could be flown
// see powered_ascent.hpp.
#pragma once

#include <cstddef>
#include <numbers>
#include <vector>

#include "hodograph/control/lunar_ascent.hpp"

namespace hodograph {

/// Two settings that go by the same text.
enum class TrackingSetting {
  one_revolution,    ///< ξ0 = 0.5, Ξ = 0.08, one revolution a unit of ξ: what the text describes
  four_revolutions,  ///< ξ0 = 0.125, Ξ = 0.02, four revolutions a unit: the figure; does not arrive
};

/// π/4, halfway between the two axes that θ turns between: our choice, the publication names none.
inline constexpr double default_singular_theta = 0.25 * std::numbers::pi;

struct TrackingOptions {
  TrackingSetting setting = TrackingSetting::one_revolution;
  std::size_t intervals = 100;  ///< 2 ... 100000
  /// θ0 where the start is ±y: there cos φ = 0 and the direction does not depend on θ, but what
  /// follows does: the objective changes by half with it.
  double singular_theta = default_singular_theta;
  AscentSolving solving{.max_iterations = 100};
};

struct TrackingAscent {
  AscentStart start;
  TrackingOptions options;
  std::vector<double> xi;                                  ///< N + 1 nodes
  std::vector<Vector3<double>> position, reference;        ///< LU, at the nodes
  std::vector<double> speed, theta, phi;                   ///< at the nodes
  std::vector<double> acceleration, theta_rate, phi_rate;  ///< N
  std::vector<double> position_error_km;                   ///< at the nodes
  /// The angle between the lander's direction and the orbit's tangent e1, radians, at the nodes.
  std::vector<double> orientation_error;
  double speed_unit_m_s{};       ///< metres a second of one unit of v
  double time_unit_s{};          ///< seconds of one unit of ξ
  double end_error_km{};         ///< at the last node
  double lowest_height_km{};     ///< least distance of a node from the centre, less 1737.4 km
  double largest_thrust_m_s2{};  ///< largest |(v direction)'| of an interval's begin or end
  bool arrives{};                ///< end_error_km below arrival_distance_km
  AscentSolved solved;
};

/// Nearer than this to the orbit at the end counts as arrived: the published setting ends 29 km
/// away from every start, the figure's hundreds.
inline constexpr double arrival_distance_km = 50.0;

/// Solves (25) from one start. Accuracy: a local minimum to the tolerances of SolverOptions,
/// defects at most default_constraint_tolerance. Faults: outside_domain (options), no_convergence
/// (no guess led to a solution; the solver's words for the last), cancelled.
Result<TrackingAscent> tracking_ascent(const AscentReference& reference, const AscentStart& start,
                                       const TrackingOptions& options = {});

}  // namespace hodograph
