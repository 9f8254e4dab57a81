// SPDX-License-Identifier: MIT
// What periodic rational frames share.
#pragma once

#include "hodograph/foundation/result.hpp"
#include "segment_rates.hpp"

namespace hodograph::frame_detail {

/// cos ψ and sin ψ of a closed path, exactly ±1 and 0 where ψ is a multiple of π within rounding.
/// Faults: unsupported, not_continuous (a tangent or a preimage that jumps), zero_speed.
Result<PeriodicTurn> closing_turn(const PreimageTable& path);
/// The fault of a γ for which w vanishes.
std::optional<Fault> gamma_fault(const PeriodicTurn& turn);
/// w on a segment.
Row<Complex<double>> turn_on_segment(const PreimageTable& path, const PeriodicTurn& turn,
                                     std::size_t segment);

}  // namespace hodograph::frame_detail
