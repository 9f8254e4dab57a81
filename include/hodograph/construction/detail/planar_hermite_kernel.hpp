// SPDX-License-Identifier: MIT
// The arithmetic of planar Hermite interpolation, without a branch: it runs on numbers and on packs
// of lanes. Whoever calls it has checked and scaled the data.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "hodograph/algebra/complex.hpp"
#include "hodograph/path/detail/quadratic_turn.hpp"

namespace hodograph::planar_detail {

/// The principal square root, to a few ε; 0 for 0. Domain: |z| in range.
template <class S>
[[gnu::always_inline]] inline Complex<S> square_root(const Complex<S>& z) {
  using std::abs;
  using std::sqrt;
  const S zero(0.0), one(1.0), x = abs(z.re), y = abs(z.im);
  const auto steep = x < y;
  const S large = select(steep, y, x), small = select(steep, x, y);
  const auto nothing = large <= zero;
  const S ratio = small / select(nothing, one, large);
  const S size = large * sqrt(one + ratio * ratio);
  const S main = sqrt(S(0.5) * (size + x));
  const S other = S(0.5) * y / select(nothing, one, main);
  const auto backward = z.re < zero;
  const S im = select(backward, main, other);
  return {select(backward, other, main), select(z.im < zero, -im, im)};
}

/// w0, ±w2 and the four w1, in the order (+,+), (+,-), (-,+), (-,-) of the signs of w2 and of the
/// root, with their turns (half of the rotation index).
template <class S>
struct HermiteSolutions {
  Complex<S> w0, w2;
  std::array<Complex<S>, 4> w1;
  std::array<S, 4> turn;
};

/// The turns of four preimages with one w0.
struct PlainTurns {
  template <class S>
  [[gnu::always_inline]] void operator()(const Complex<S>& w0, const std::array<Complex<S>, 4>& w1,
                                         const std::array<Complex<S>, 4>& w2,
                                         std::array<S, 4>& turns) const {
    for (std::size_t k = 0; k < 4; ++k) turns[k] = path_detail::absolute_turn(w0, w1[k], w2[k]);
  }
};

/// d0, d1: the end derivatives; v: the mean velocity; `turns` as PlainTurns.
template <class S, class Turns = PlainTurns>
[[gnu::always_inline]] inline HermiteSolutions<S> solve_hermite(const Complex<S>& d0,
                                                                const Complex<S>& d1,
                                                                const Complex<S>& v,
                                                                const Turns& turns = {}) {
  HermiteSolutions<S> found;
  found.w0 = square_root(d0);
  found.w2 = square_root(d1);
  const Complex<S> common = S(120.0) * v - S(15.0) * (d0 + d1);
  const Complex<S> cross = S(10.0) * (found.w0 * found.w2);
  for (std::size_t sign = 0; sign < 2; ++sign) {
    const Complex<S> root = square_root(sign == 0 ? common + cross : common - cross);
    const Complex<S> w2 = sign == 0 ? found.w2 : -found.w2;
    const Complex<S> mean = S(-3.0) * (found.w0 + w2);
    found.w1[2 * sign] = S(0.25) * (mean + root);
    found.w1[2 * sign + 1] = S(0.25) * (mean - root);
  }
  turns(found.w0, found.w1, {found.w2, found.w2, -found.w2, -found.w2}, found.turn);
  return found;
}

/// The first of the least turns and the next larger one.
template <class S>
struct LeastTurn {
  S turn, next;
  Complex<S> w1, w2;
};
template <class S>
[[gnu::always_inline]] inline LeastTurn<S> least_turn(const HermiteSolutions<S>& found) {
  LeastTurn<S> best{found.turn[0], S(7.0), found.w1[0], found.w2};  // no turn exceeds 2π
  for (std::size_t k = 1; k < 4; ++k) {
    const Complex<S> w2 = k < 2 ? found.w2 : -found.w2;
    const auto better = found.turn[k] < best.turn;
    const S larger = select(better, best.turn, found.turn[k]);
    best.next = select(larger < best.next, larger, best.next);
    best.turn = select(better, found.turn[k], best.turn);
    best.w1 = {select(better, found.w1[k].re, best.w1.re),
               select(better, found.w1[k].im, best.w1.im)};
    best.w2 = {select(better, w2.re, best.w2.re), select(better, w2.im, best.w2.im)};
  }
  return best;
}

}  // namespace hodograph::planar_detail
