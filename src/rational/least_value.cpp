// SPDX-License-Identifier: MIT
// Local minima on a grid, narrowed.
#include "least_value.hpp"

#include "flint.hpp"
#include "hodograph/rational/hermite_curves.hpp"

namespace hodograph::rational_detail {

std::vector<Rational> dips(const std::function<Rational(const Rational&)>& f, const Rational& begin,
                           const Rational& end, std::size_t cells, long bits,
                           const Rational& bound) {
  const std::vector<Rational> grid = equidistant(begin, end, cells + 1);
  std::vector<Rational> values;
  for (const Rational& t : grid) values.push_back(f(t));
  std::vector<Rational> result;
  for (std::size_t i = 0; i <= cells; ++i) {
    if (i > 0 && values[i - 1] < values[i]) continue;
    if (i < cells && values[i + 1] <= values[i]) continue;
    // The minimum is within one cell of the node: five points, the best of which is kept.
    Rational t = grid[i], best = values[i];
    Rational step = grid[1] - grid[0];
    for (long k = 0; k < bits; ++k) {
      step *= Rational(1, 2);
      for (const Rational& candidate : {t - step, t + step}) {
        if (candidate < begin || end < candidate) continue;
        Rational there = f(candidate);
        if (there < best) {
          best = std::move(there);
          t = candidate;
        }
      }
    }
    if (best < bound) result.push_back(t);
  }
  return result;
}

namespace {
Rational simplest_between(const Rational& x, Rational margin, long bits) {
  fmpq_div_2exp(raw(margin), raw(margin), static_cast<ulong>(bits));
  Rational result;
  fmpq_simplest_between(raw(result), raw(x - margin), raw(x + margin));
  return result;
}
}  // namespace

Rational simplest(const Rational& x, long bits) {
  return x.is_zero() ? x : simplest_between(x, x.sign() < 0 ? -x : x, bits);
}
Rational simplest_within(const Rational& x, long bits) { return simplest_between(x, 1, bits); }

}  // namespace hodograph::rational_detail
