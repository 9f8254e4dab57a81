// SPDX-License-Identifier: MIT
// What the frame kernels read; nothing here that a kernel file might instantiate for a newer
// processor than the program runs on.
#pragma once

#include <cstddef>

namespace hodograph::frame_detail {

inline constexpr std::size_t rolled_degree = 16;

/// On a stretch of ξ, x = (ξ - xi) scale in [-1, 1]: half the roll is Σ_{k≥1} half_roll[k-1] x^k,
/// at most π/8, beyond the turn that is in the preimage already.
struct RolledPiece {
  double xi = 0.0, scale = 1.0;
  double half_roll[rolled_degree] = {};
};

/// Frames (9 numbers, axis after axis) at `count` ξ of one piece, where A = Σ preimage[4k..4k+3]
/// x^k, k ≤ degree, turned by the roll at x = 0. False where a speed is zero.
using RolledKernel = bool (*)(const RolledPiece&, std::size_t degree, const double* preimage,
                              const double* xi, std::size_t count, double* frames);

}  // namespace hodograph::frame_detail
