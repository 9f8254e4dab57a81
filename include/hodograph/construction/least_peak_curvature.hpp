// SPDX-License-Identifier: MIT
// The planar PH quintic of least peak curvature between two end states, over the end speeds or over
// the arc length, with a bound on the length.
//
// Source: "Path planning with Pythagorean-hodograph curves for unmanned or autonomous vehicles",
// section 6. The peak curvature may have several local minima, also kinks, and falls again where
// paths become very long; so the whole range is searched, then every dip of it.
#pragma once

#include <cstddef>
#include <optional>

#include "hodograph/construction/prescribed_length.hpp"
#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/result.hpp"

namespace hodograph {

/// Where the least peak curvature lies.
enum class PeakMinimum {
  interior,         ///< inside the range: a minimum, and the least of those found
  at_length_bound,  ///< on the bound of the length: longer paths would be smoother
  at_range_end,     ///< on an end of the range of speeds
  straight_line,    ///< the straight line, of no curvature
};

/// A minimum that is local.
struct LocalMinimum {
  double parameter = 0.0;       ///< the speed ℓ0, or the length S
  double peak_curvature = 0.0;  ///< an upper bound of |κ|, to about 2^-40 of itself
};

struct LeastPeakCurvature {
  PlanarPhCurve<2> curve;    ///< over a parameter interval of length 1
  Enclosure peak_curvature;  ///< the largest |κ|, certain, rounding included
  double begin_speed = 0.0;  ///< ℓ0 = |dr/dξ| at the start
  double end_speed = 0.0;    ///< ℓ1, at the end
  PeakMinimum kind = PeakMinimum::interior;
  /// The least local minimum inside the range, where there is one; absent where the peak curvature
  /// only falls (or rises) along the range.
  std::optional<LocalMinimum> interior{};
};

/// The range of end speeds that is searched; both 0: from 1/16 of the points' distance (of the
/// length bound where the points coincide) to 16 times that.
struct SpeedRange {
  double least = 0.0, most = 0.0;
};

/// Over ℓ = |dr/dξ| at both ends, with |r| the C¹ Hermite interpolant of planar_hermite.
///
/// Method: 256 speeds, evenly in the logarithm, and golden sections in every dip; the minimiser is
/// found to about 1e-8 of itself (a smooth minimum does not fix it better in double), its curvature
/// is certified. A dip narrower than the samples' distance (2 %) may be missed. A few
/// milliseconds. Faults: those of prescribed_length_curve for the data; outside_domain (a length
/// bound or a range that is not positive, finite and increasing); no_interpolant (the bound below
/// the points' distance, with both numbers; no speed of the range gives a path within the bound).
Result<LeastPeakCurvature> least_peak_curvature_of_equal_speeds(const DirectedPoint& begin,
                                                                const DirectedPoint& end,
                                                                double most_length,
                                                                const SpeedRange& range = {});

/// Over ℓ0 and ℓ1 separately: a golden section of golden sections, after a grid of 48 by 48. Some
/// tens of milliseconds; otherwise as above. `interior` gives ℓ0.
Result<LeastPeakCurvature> least_peak_curvature_of_speeds(const DirectedPoint& begin,
                                                          const DirectedPoint& end,
                                                          double most_length,
                                                          const SpeedRange& range = {});

/// Over the length S, from the points' distance to the bound, with prescribed_length_curve.
/// Method, faults and accuracy as for equal speeds; the samples are even in the logarithm of S
/// less the distance, from 2^-12 of that up.
Result<LeastPeakCurvature> least_peak_curvature_of_length(const DirectedPoint& begin,
                                                          const DirectedPoint& end,
                                                          double most_length);

}  // namespace hodograph
