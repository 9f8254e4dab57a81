// SPDX-License-Identifier: MIT
// What the kernels of the rotation-minimising frames read and write: some pieces of a path, one in
// each lane. Plain numbers; nothing here that a kernel file might instantiate for a newer processor
// than the program runs on.
#pragma once

#include <cstddef>

namespace hodograph::frame_detail {

inline constexpr std::size_t most_lanes = 8, most_kernel_degree = 8, most_nodes = 16;

/// Pieces u in [middle - half, middle + half] of segments.
struct PieceLanes {
  const double* preimage[most_lanes];  ///< n + 1 Bernstein coefficients of 4 numbers
  alignas(64) double middle[most_lanes], half[most_lanes];
  alignas(64) double size[most_lanes];  ///< at least |A_i|² for every i
};

/// What is known of them, x in [-1, 1] on each.
struct PieceGroup {
  alignas(64) double preimage[4 * (most_kernel_degree + 1)][most_lanes];  ///< powers of x
  alignas(
      64) double half_roll[most_nodes][most_lanes];  ///< half the roll is Σ_k half_roll[k] x^(k+1)
  alignas(64) double begin[most_lanes], end[most_lanes];  ///< the roll at x = -1 and 1, 0 at x = 0
  /// Bounds, radians: what the series leaves out over the piece; rounding that goes on from piece
  /// to piece; that of one value; |roll|. All infinite where the speed may vanish.
  alignas(64) double truncation[most_lanes], carried[most_lanes], local[most_lanes],
      turn[most_lanes];
};

/// Where frames are wanted: on lane l at ξ[first[l]], ..., count[l] of them. The frames of later
/// parameters may be written, too: they are anything until their own pieces have their turn.
struct FrameLanes {
  alignas(64) double angle[most_lanes];                      ///< the roll at x = 0
  alignas(64) double center[most_lanes], scale[most_lanes];  ///< x = (ξ - center) scale
  std::size_t first[most_lanes], count[most_lanes];
  std::size_t used;    ///< lanes
  std::size_t points;  ///< of the whole path
  const double* xi;
  double* frames;  ///< 9 numbers each
};

struct MinimisingKernels {
  std::size_t lanes, nodes;
  void (*expand)(const PieceLanes&, PieceGroup&);
  void (*frames)(const PieceGroup&, const FrameLanes&);
  bool (*ascend)(const double* numbers, std::size_t count);  ///< none below the one before; no NaN
};

}  // namespace hodograph::frame_detail
