// SPDX-License-Identifier: MIT
// Rotation-minimising frames at many parameters of a path in one go, as accurate as asked for:
// nothing is prepared that these frames do not need, and nothing is kept.
#pragma once

#include <cstddef>
#include <span>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/frame/preimage_table.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// The frames with e₂ at the roll begin from that of the Euler-Rodrigues frame at ξ_0, and from
/// there on without rotation about the tangent, at every ξ_i: those of
/// RolledFrames(path, rotation_minimising_roll_within(path, accuracy, begin)), in a fraction of its
/// time where the frames are few or the accuracy is moderate. Returns a bound of the angle
/// (radians) between these frames and the exact ones: at most `accuracy`, rounding included.
///
/// Method: the rate -2N/σ of the roll in Chebyshev series of 8 or 16 terms on pieces of the
/// segments, several pieces side by side in vector registers; as in rotation_minimising_roll what a
/// series leaves out is bounded by a few of its coefficients (src/frame/rate_series.hpp), and
/// pieces are halved until the bounds add up to half of the accuracy. Where that is not enough
/// (finer than rounding allows here; preimages of degree 0, 5 to 7 and above 8, or larger than
/// 2^200 or smaller than 2^-200), and where ξ does not ascend, the roll itself is made.
///
/// Units: ξ as the knots, angles in radians. Domain: accuracy > 0, begin finite, as many frames as
/// parameters, each inside the knots. Faults: those of rotation_minimising_roll_within, found up to
/// the last ξ; mismatched_size; outside_domain with the index of the parameter. Where one is
/// returned, what was written to `frames` is unspecified.
Result<double> rotation_minimising_frames(const PreimageRows& path, double accuracy,
                                          std::span<const double> xi,
                                          std::span<Frame3<double>> frames, double begin = 0.0);

/// The same of a table of preimages, and of a path.
Result<double> rotation_minimising_frames(const PreimageTable& path, double accuracy,
                                          std::span<const double> xi,
                                          std::span<Frame3<double>> frames, double begin = 0.0);

template <std::size_t n>
Result<double> rotation_minimising_frames(const SpatialPath<n>& path, double accuracy,
                                          std::span<const double> xi,
                                          std::span<Frame3<double>> frames, double begin = 0.0) {
  const PreimageRows rows{n, path.is_closed(), path.knots(), &path,
                          [](const void* from, std::size_t segment) {
                            return static_cast<const SpatialPath<n>*>(from)
                                ->segment(segment)
                                .preimage()
                                .coefficients()
                                .data();
                          }};
  return rotation_minimising_frames(rows, accuracy, xi, frames, begin);
}

}  // namespace hodograph
