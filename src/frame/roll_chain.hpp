// SPDX-License-Identifier: MIT
// Rolls that go on from segment to segment.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "frame/segment_rates.hpp"
#include "hodograph/frame/roll.hpp"

namespace hodograph::frame_detail {

/// Partial fractions are taken where their error is estimated below this many radians (and as much
/// of the angle): what the certified series state of themselves on a piece of a turn.
inline constexpr double closed_form_error = 64.0 * 0x1.0p-52;

/// The turns at the inner knots, for a closed path then at the closing one. Faults: zero_speed,
/// not_continuous, with the index of the knot.
Result<std::vector<KnotTurn>> knot_turns(const PreimageTable& path);

/// What to add to -2N: k, for the rate k σ² /σ - 2N/σ by u; nothing for 0.
using EvenRate = std::function<double(std::size_t segment, const ScaledPreimage&)>;

/// The roll with that rate from θ = begin, continuous as a frame.
Result<FrameRoll> chained_roll(const PreimageTable& path, RollKind kind, double begin,
                               const std::vector<KnotTurn>& turns, const EvenRate& even,
                               RollIntegration integration);

/// The fault of an angle that is not finite.
std::optional<Fault> angle_fault(double angle, const char* quantity);

}  // namespace hodograph::frame_detail
