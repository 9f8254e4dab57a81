// SPDX-License-Identifier: MIT
// Rolls that go on from segment to segment.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "segment_rates.hpp"
#include "hodograph/frame/roll.hpp"

namespace hodograph::frame_detail {

/// Partial fractions are taken where their error is estimated below this many radians (and as much
/// of the angle): what the certified series state of themselves on a piece of a turn.
inline constexpr double closed_form_error = 64.0 * 0x1.0p-52;

/// The turns at the inner knots, for a closed path then at the closing one. Faults: zero_speed,
/// not_continuous, with the index of the knot.
Result<std::vector<KnotTurn>> knot_turns(const PreimageTable& path);

/// The roll with dθ/du = rate(k, A) σ² /σ - 2N/σ (no rate: 0) from θ = begin, continuous as a
/// frame.
Result<FrameRoll> chained_roll(
    const PreimageTable& path, RollKind kind, double begin, const std::vector<KnotTurn>& turns,
    const std::function<double(std::size_t, const ScaledPreimage&)>& rate);

/// The fault of an angle that is not finite.
std::optional<Fault> angle_fault(double angle, const char* quantity);

}  // namespace hodograph::frame_detail
