// SPDX-License-Identifier: MIT
// A quotient of polynomials in pieces, each a Chebyshev series with a bound of its error: how the
// rates of rolls are integrated.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>

#include "rows.hpp"

namespace hodograph::frame_detail {

/// numerator/denominator on [0, 1].
template <class S>
struct Fraction {
  Row<S> numerator, denominator;
};

/// The degree of a series: shorter pieces (lower degrees) cost memory, longer ones time.
inline constexpr std::size_t series_degree = 15;

/// Where less than that is asked for: coefficients after this one are 0.
inline constexpr std::size_t short_series_degree = 11;
/// The finest tolerance, radians, for short series: finer ones take more pieces than long series.
inline constexpr double short_series_tolerance = 0x1.0p-27;

/// On [begin, end] the fraction is Σ c_k T_k(x), x = -1 at begin and 1 at end, within `error`.
struct RateSeries {
  double begin = 0.0, end = 1.0;
  std::array<double, series_degree + 1> c{};
  double error = 0.0;
};

/// ∫ of the series over its piece, without the error.
double integral(const RateSeries& piece);
/// An enclosure of the integral of the fraction over the piece.
Enclosure enclosed_integral(const RateSeries& piece);

/// Splits [0, 1] until the series of every piece agrees with the fraction to rounding, and hands
/// the pieces to `take`, from left to right; where that returns false, the piece is split further.
/// False where the denominator may vanish (or is not positive).
///
/// Promise: |fraction - series| ≤ error on the piece; rounding included where S is Enclosure, up to
/// an estimate of it (each operation counted) where S is double.
///
/// Method: p interpolates P/Q at the Chebyshev nodes. Whatever p is, P/Q - p = (P - p Q)/Q, and
/// P - p Q is a polynomial: |P/Q - p| ≤ Σ |its Chebyshev coefficients| / (least Bernstein
/// coefficient of Q). A piece is accepted where this is rounding: Σ |...| ≤ m ε (|p| |Q| + |P|), m
/// the number of terms a coefficient has and |.| the sum of the sizes of Chebyshev coefficients.
///
/// With a tolerance τ > 0, radians, a piece of length h is accepted where h · error ≤ h τ, too: the
/// integral over [0, 1] is then within τ; shorter series are tried where that is enough.
bool expand(const Fraction<double>& fraction, const std::function<bool(const RateSeries&)>& take,
            double tolerance = 0.0);
bool expand(const Fraction<Enclosure>& fraction,
            const std::function<bool(const RateSeries&)>& take);

}  // namespace hodograph::frame_detail
