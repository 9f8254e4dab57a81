// SPDX-License-Identifier: MIT
// A motion as pieces of polynomials of degree seven in time: what the trajectory files of small
// quadrotors (Crazyswarm, uav_trajectories) hold.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "hodograph/foundation/result.hpp"
#include "hodograph/planning/swarm/timed_motion.hpp"

namespace hodograph::cli {

/// x, y and z as polynomials in the time since the piece began, the coefficients of 1, t, ..., t^7.
struct PolynomialPiece {
  double duration = 0.0;
  std::array<std::array<double, 8>, 3> coefficients{};
};

struct PolynomialFlight {
  std::vector<PolynomialPiece> pieces;
  /// No point of the pieces, evaluated exactly, is further than this from where the motion is at
  /// that time: certified, rounding included.
  double error = 0.0;
};

/// The motion from `begin` on (it stands until it starts). Every piece meets the motion's place,
/// velocity, acceleration and jerk at both ends, up to rounding; pieces end where segments of the
/// path and pieces of the timing law do, and are halved until the error is at most `tolerance` (and
/// by how much the rounding of the durations shifts the times).
///
/// The error: at times δ apart the distance is computed; in between it is at most the larger of two
/// neighbours and M δ²/8, M a bound of the second derivative of both: κ v² + |a| of the motion, the
/// sum of the coefficients' sizes of the polynomial; where κ is large, v δ/2 instead of κ v² δ²/8.
/// Faults: outside_domain (a tolerance that is not positive; a path that stands still within, where
/// the motion has no velocity), tolerance_not_reached (rounding or the number of pieces forbid it,
/// with the error that is reached).
Result<PolynomialFlight> polynomial_flight(const AnyPath& path, const TimedMotion& motion,
                                           double begin, double tolerance);

/// One row a piece: the duration and eight coefficients each for x, y, z and yaw, which is 0, under
/// the header that such files have.
std::string crazyswarm_csv(const PolynomialFlight& flight);

}  // namespace hodograph::cli
