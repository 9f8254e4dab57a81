// SPDX-License-Identifier: MIT
// What the planar constructions share: the scale of their data and the order of their solutions.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "hodograph/construction/planar_hermite.hpp"

namespace hodograph::planar_detail {

using Preimage = std::array<Complex<double>, 3>;

/// The power of two c for which c² times a size is safe to square and to square root: 1 for
/// ordinary sizes, else so that c² size lies in [1/2, 4).
inline double prescale(double size) {
  constexpr double ordinary = 0x1.0p+160;
  if (size < ordinary && 1.0 < size * ordinary) return 1.0;
  int exponent = 0;
  std::frexp(size, &exponent);
  // c² itself must not overflow where the size is subnormal.
  constexpr int least = 2 * (std::numeric_limits<double>::min_exponent / 2);
  return std::ldexp(1.0, -(std::max(exponent, least) / 2));
}

/// The least of σ = |w|² on [0, 1], to rounding.
double least_speed(const Preimage& w);

/// Why one of two solutions whose turns agree within rounding comes before the other; `order` where
/// nothing but their order tells. `first` is set to whether it is the first one.
TieBreak break_tie(const Preimage& one, const Preimage& other, bool& first);

/// Sorts solutions by their turns, ties as TieBreak says; which of them come first, second, ...
/// The tie between the first two is reported.
template <std::size_t count>
struct Ranking {
  std::array<std::size_t, count> order{};
  TieBreak tie = TieBreak::none;
};
template <std::size_t count>
Ranking<count> ranked(const std::array<Preimage, count>& preimages,
                      const std::array<double, count>& turns) {
  Ranking<count> ranking;
  for (std::size_t i = 0; i < count; ++i) ranking.order[i] = i;
  const auto before = [&](std::size_t i, std::size_t j, TieBreak& tie) {
    tie = TieBreak::none;
    if (std::abs(turns[i] - turns[j]) > 0.5 * accuracy_of_rotation_index) {
      return turns[i] < turns[j];
    }
    bool first = true;
    tie = break_tie(preimages[i], preimages[j], first);
    return first;
  };
  for (std::size_t i = 1; i < count; ++i) {  // insertion keeps the order of what is equal
    const std::size_t candidate = ranking.order[i];
    std::size_t at = i;
    for (TieBreak tie{}; at > 0 && !before(ranking.order[at - 1], candidate, tie); --at) {
      ranking.order[at] = ranking.order[at - 1];
    }
    ranking.order[at] = candidate;
  }
  before(ranking.order[0], ranking.order[1], ranking.tie);
  return ranking;
}

/// c² d as a complex number.
inline Complex<double> scaled(double square, const Vector2<double>& d) {
  return {square * d.x, square * d.y};
}

/// The preimage of scaled data in the data's own scale.
inline BernsteinPolynomial<Complex<double>, 2> restored(const Preimage& w, double scale) {
  const double factor = 1.0 / scale;
  return BernsteinPolynomial<Complex<double>, 2>({factor * w[0], factor * w[1], factor * w[2]});
}

/// The fault of numbers out of double's range.
inline Fault planar_range_fault(std::size_t index) {
  return {FaultCode::no_interpolant,
          "segment " + std::to_string(index) +
              ": its numbers are too large, or the parameter step is too small for them, to be "
              "computed with",
          index,
          "range",
          std::nullopt,
          std::nullopt};
}

// Batches, compiled once for every instruction set (src/construction/kernels); the results have the
// bits of the single constructions.

/// Rows of a batch: d0, d1, v (6 numbers) to w0, w1, w2, turn, next (8 numbers).
inline constexpr std::size_t hermite_numbers_in = 6, hermite_numbers_out = 8;
void solve_hermites(const double* in, std::size_t count, double* out);
/// Rows of directions, chord and length (7 numbers) to w0, w1, w2, turn, next (8 numbers).
inline constexpr std::size_t length_numbers_in = 7, length_numbers_out = 8;
void solve_prescribed_lengths(const double* in, std::size_t count, double* out);
/// One such row to w0, both w1 and w2 in canonical position, the number that turns them back, the
/// turns of both solutions and, twice, half of the unavoidable one (14 numbers): what single
/// numbers would give, in lanes.
inline constexpr std::size_t one_length_numbers_out = 14;
void solve_prescribed_length(const double* in, double* out);

/// The turns of four preimages at once, in lanes. In: four numbers each of re w0, im w0, re w1, im
/// w1, re w2, im w2.
void four_turns(const double* in, double* turns);

}  // namespace hodograph::planar_detail
