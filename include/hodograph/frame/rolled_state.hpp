// SPDX-License-Identifier: MIT
// A rolled frame at one point of a path whose degree is known when the program runs.
#pragma once

#include <cstddef>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/frame/preimage_table.hpp"
#include "hodograph/frame/roll.hpp"

namespace hodograph {

struct RolledState {
  Quaternion<double> rotation;       ///< turns i, j, k to the axes; of length 1, its sign that of A
  Frame3<double> frame;              ///< the axes
  Vector3<double> body_rate_per_xi;  ///< χ of this frame, radians per unit ξ
  double roll = 0.0, speed = 0.0;
};

/// The frame of AdaptedFrame(path, roll) at ξ as a rotation, A/|A| (cos θ/2 + i sin θ/2), with its
/// rate. Domain: ξ inside the knots (throws Error outside_domain) where the path moves (throws
/// zero_speed), a roll of this path (throws mismatched_size). Accuracy: that of AdaptedFrame.
RolledState rolled_state(const PreimageTable& path, const FrameRoll& roll, double xi);

/// The angle from e₂ of the Euler-Rodrigues frame at ξ to the part of a vector across the tangent,
/// radians in (-π, π]: the roll whose e₂ points there.
/// Domain: as above; a vector that is finite and not along the tangent (throws Error
/// outside_domain).
double roll_towards(const PreimageTable& path, double xi, const Vector3<double>& side);

}  // namespace hodograph
