// SPDX-License-Identifier: MIT
// Private to orbit/: one step of the motion by its own Taylor series in long double.
#pragma once

#include <algorithm>
#include <cmath>

#include "hodograph/orbit/motion_series.hpp"

namespace hodograph {

/// Order of the series.
inline constexpr std::size_t series_order = 28;

/// A step is this part of the estimated radius of convergence, e⁻². The first term left out of the
/// position is then e^{-2·29} = 2^-83 of the motion's size; of the fourth derivative,
/// C(29, 4) e^{-2·25} = 2^-57 of its own: both below rounding where they are used.
inline constexpr long double series_fraction = 0.1353352832366127L;

using MotionSeries = Vector3<Taylor<long double, series_order>>;

/// How far the series may be used: series_fraction of the radius of convergence, which the root
/// test on the last two coefficients estimates in units of `size`, the distance from the nearer
/// primary. Infinite where both coefficients vanish.
inline long double series_step(const MotionSeries& series, long double size) {
  long double inverse_radius = 0.0L;
  for (const std::size_t k : {series_order - 1, series_order}) {
    const long double term =
        std::max(std::max(std::abs(series.x[k]), std::abs(series.y[k])), std::abs(series.z[k]));
    inverse_radius =
        std::max(inverse_radius, std::pow(term / size, 1.0L / static_cast<long double>(k)));
  }
  return series_fraction / inverse_radius;
}

inline long double sum_series(const Taylor<long double, series_order>& series, long double t) {
  long double sum = series[series_order];
  for (std::size_t k = series_order; k-- > 0;) sum = sum * t + series[k];
  return sum;
}

/// The state at time t of the series.
inline OrbitState<long double> sum_series(const MotionSeries& series, long double t) {
  OrbitState<long double> state;
  for (std::size_t i = 0; i < 3; ++i) {
    state.position[i] = sum_series(series[i], t);
    long double slope = 0.0L;
    for (std::size_t k = series_order; k > 0; --k) {
      slope = slope * t + static_cast<long double>(k) * series[i][k];
    }
    state.velocity[i] = slope;
  }
  return state;
}

}  // namespace hodograph
