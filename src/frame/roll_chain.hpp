// SPDX-License-Identifier: MIT
// Rolls that go on from segment to segment.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "hodograph/frame/roll.hpp"
#include "segment_rates.hpp"

namespace hodograph::frame_detail {

/// Partial fractions are taken where their error is estimated below this many radians (and as much
/// of the angle). The estimate is one from above: on 400 tame preimages of each degree n = 1, 2, 3,
/// 5, 8 its median was 52, 658, 3560, 2.5e4, 1.5e5 ε, that of the error 0.5, 2, 5, 17, 57 ε.
inline constexpr double closed_form_error = 0x1.0p-39;

/// The turns at the inner knots, for a closed path then at the closing one. Faults: zero_speed,
/// not_continuous, with the index of the knot.
Result<std::vector<KnotTurn>> knot_turns(const PreimageTable& path);

/// What to add to -2N: k, for the rate k σ² /σ - 2N/σ by u; nothing for 0.
using EvenRate = std::function<double(std::size_t segment, const ScaledPreimage&)>;

/// The roll with that rate from θ = begin, continuous as a frame; the series over the whole path
/// within `tolerance` (0: rounding), radians.
Result<FrameRoll> chained_roll(const PreimageTable& path, RollKind kind, double begin,
                               const std::vector<KnotTurn>& turns, const EvenRate& even,
                               RollIntegration integration, double tolerance = 0.0);

/// The fault of an angle that is not finite.
std::optional<Fault> angle_fault(double angle, const char* quantity);

}  // namespace hodograph::frame_detail
