// SPDX-License-Identifier: MIT
// Adapted frames along a path at many parameters: everything that does not depend on ξ once.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/frame/detail/rolled_piece.hpp"
#include "hodograph/frame/preimage_table.hpp"
#include "hodograph/frame/roll.hpp"
#include "hodograph/path/interval_index.hpp"

namespace hodograph {

/// The frames of AdaptedFrame(path, roll) in batches: runs of increasing ξ on one piece go through
/// kernels with a point in each lane of a vector register, chosen at run time for the processor.
/// A value; it refers neither to the path nor to the roll.
/// Accuracy: as AdaptedFrame, the roll within roll.error_bound(); axes within 2^-49 of orthonormal.
/// Cost: some 300 bytes a piece of the roll; queries allocate nothing.
class RolledFrames {
 public:
  /// Domain: a roll made for this path (throws Error mismatched_size for other knots).
  RolledFrames(const PreimageTable& path, const FrameRoll& roll);

  /// The frame at ξ. Throws Error outside_domain, zero_speed.
  Frame3<double> at(double xi) const;
  /// at(ξ_i) for every i. Throws Error before anything is written where the spans differ in length
  /// (mismatched_size) or a parameter is outside the knots (outside_domain, with its index); where
  /// the path stands still at a parameter, zero_speed (later frames are then unspecified).
  void at(std::span<const double> xi, std::span<Frame3<double>> frames) const;

 private:
  void add_piece(const std::vector<Quaternion<double>>& preimage, double u_begin, double u_end,
                 double knot, double step, const FrameRoll::Piece* from);

  std::size_t degree_ = 0;
  std::vector<double> starts_;  ///< ξ where pieces begin, and the last knot
  IntervalIndex<double> index_;
  std::vector<frame_detail::RolledPiece> pieces_;
  std::vector<double> preimages_;          ///< powers of x, 4 (degree + 1) a piece
  double begin_angle_ = 0.0, rate_ = 0.0;  ///< of a linear roll, applied point by point
};

}  // namespace hodograph
