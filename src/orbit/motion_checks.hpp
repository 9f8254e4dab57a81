// SPDX-License-Identifier: MIT
// Private to orbit/: the checks and sentences that following a motion shares, however it is done.
#pragma once

#include <optional>
#include <string>

#include "hodograph/orbit/propagation.hpp"

namespace hodograph::motion_checks {

/// The two primaries, as sentences name them.
enum class Primary { larger, smaller };

std::string text(long double value);

/// Not finite, or an unusable system or option, or a start too near a primary.
std::optional<Fault> check_start(const ThreeBodySystem& system,
                                 const OrbitState<long double>& start,
                                 const PropagationOptions& options);

/// A passage at `distance` from a primary at `time`, where that is too near.
std::optional<Fault> check_distance(Primary primary, long double distance, long double time,
                                    const PropagationOptions& options);

/// More than max_steps steps.
Fault too_many_steps(long double reached, long double wanted, const PropagationOptions& options);

/// The arithmetic overflowed, or the step no longer advances the time.
Fault stalled(long double reached, long double wanted);

}  // namespace hodograph::motion_checks
