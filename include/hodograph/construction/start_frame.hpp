// SPDX-License-Identifier: MIT
// The rotation that takes i, j, k to a wanted frame at the start of a path, from what a user
// gives: a direction and a normal, or a direction and a roll from level.
#pragma once

#include "hodograph/algebra/quaternion.hpp"
#include "hodograph/foundation/result.hpp"

namespace hodograph {

/// The unit quaternion q, q_w ≥ 0, with q i q* along `direction` and q j q* along the part of
/// `normal` perpendicular to it. Neither needs length 1.
/// Faults: not_finite, outside_domain (index 0: a zero direction; index 1: a normal that is zero or
/// parallel to the direction within accuracy::join_error). Accuracy: a few ε over the sine of the
/// angle between the two.
Result<Quaternion<double>> frame_towards(const Vector3<double>& direction,
                                         const Vector3<double>& normal);

/// The same with the normal level and to the left, k × direction (j for a vertical direction), then
/// turned about the direction by `roll` radians, positive from the left upwards (from e2 to e3).
/// Faults: not_finite, outside_domain (a zero direction). Accuracy: a few ε; nearly vertical
/// directions have a level normal too, which turns quickly between them.
Result<Quaternion<double>> level_frame(const Vector3<double>& direction, double roll = 0.0);

}  // namespace hodograph
