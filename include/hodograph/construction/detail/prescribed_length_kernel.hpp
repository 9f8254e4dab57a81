// SPDX-License-Identifier: MIT
// The arithmetic of prescribed_length.hpp in canonical position (the chord along the real axis),
// without a branch: it runs on numbers and on packs of lanes.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "hodograph/algebra/complex.hpp"
#include "hodograph/construction/detail/planar_hermite_kernel.hpp"

namespace hodograph::planar_detail {

/// The square root of a number of size 1, to a few ε.
template <class S>
[[gnu::always_inline]] inline Complex<S> root_of_unit(const Complex<S>& z) {
  using std::abs;
  using std::sqrt;
  const S main = sqrt(S(0.5) * (S(1.0) + abs(z.re)));
  const S other = S(0.5) * abs(z.im) / main;
  const auto backward = z.re < S(0.0);
  const S im = select(backward, main, other);
  return {select(backward, other, main), select(z.im < S(0.0), -im, im)};
}

/// The data in canonical position: exp(i φ/2) at the ends, and the square root of the chord's
/// direction (1 where there is no chord), by which a preimage is turned back.
template <class S>
struct CanonicalEnds {
  Complex<S> s, e, turn;
  S chord;
};
template <class S>
[[gnu::always_inline]] inline CanonicalEnds<S> canonical_ends(const Complex<S>& begin,
                                                              const Complex<S>& end,
                                                              const Complex<S>& chord) {
  using std::abs;
  using std::sqrt;
  const S zero(0.0), one(1.0), width = abs(chord.re), height = abs(chord.im);
  const auto steep = width < height;
  const S large = select(steep, height, width), small = select(steep, width, height);
  constexpr double least_chord = std::numeric_limits<double>::min();
  const auto apart = S(least_chord) <= large;
  const S reciprocal = one / select(apart, large, one), ratio = small * reciprocal;
  const S stretch = sqrt(one + ratio * ratio), unit = reciprocal / stretch;
  const Complex<S> along{select(apart, chord.re * unit, one), select(apart, chord.im * unit, zero)};
  const auto half_angle = [&](const Complex<S>& direction) {
    const S size = sqrt(direction.re * direction.re + direction.im * direction.im);
    return root_of_unit(((one / size) * direction) * Complex<S>{along.re, -along.im});
  };
  return {half_angle(begin), half_angle(end), root_of_unit(along), large * stretch};
}

/// a² as a sum of two numbers (Dekker). Domain: |a| < 2^500.
template <class S>
struct Twofold {
  S high, low;
};
template <class S>
[[gnu::always_inline]] inline Twofold<S> exact_square(const S& a) {
  constexpr double splitter = 134217729.0;  // 2^27 + 1
  const S c = S(splitter) * a, high = c - (c - a), low = a - high, square = a * a;
  return {square, ((high * high - square) + S(2.0) * (high * low)) + low * low};
}

/// S - X, X the length of the chord, x its rounded value: where they are close, with the square of
/// x corrected, so that the rounding of X costs no digits.
template <class S>
[[gnu::always_inline]] inline S excess_of(const S& length, const Complex<S>& chord, const S& x) {
  constexpr double close = 0.0625;
  const S plain = length - x;
  const Twofold<S> a = exact_square(chord.re), b = exact_square(chord.im), c = exact_square(x);
  const auto wide = b.high < a.high;
  const S first = select(wide, a.high, b.high), second = select(wide, b.high, a.high);
  const S rest = ((first - c.high) + second) + ((a.low + b.low) - c.low);
  const auto corrected = plain < S(close) * x;
  return plain - select(corrected, rest / (S(2.0) * select(corrected, x, S(1.0))), S(0.0));
}

/// w0, w2 and the two w1, with their turns (half of the rotation index).
template <class S>
struct LengthRoots {
  Complex<S> w0, w2;
  std::array<Complex<S>, 2> w1;
  std::array<S, 2> turn;
};

/// The turns of the two.
struct PlainPairTurns {
  template <class S>
  [[gnu::always_inline]] void operator()(LengthRoots<S>& found) const {
    for (std::size_t k = 0; k < 2; ++k) {
      found.turn[k] = path_detail::absolute_turn(found.w0, found.w1[k], found.w2);
    }
  }
};

/// s, e: exp(i φ/2) at the ends; sum = S + X, excess = S - X > 0; `turns` as PlainPairTurns.
template <class S, class Turns = PlainPairTurns>
[[gnu::always_inline]] inline LengthRoots<S> solve_length(const Complex<S>& s, const Complex<S>& e,
                                                          const S& sum, const S& excess,
                                                          const Turns& turns = {}) {
  using std::abs;
  using std::sqrt;
  const S zero(0.0), one(1.0), two(2.0), three(3.0);
  const S p = three * (s.re * s.re + e.re * e.re) - two * (s.re * e.re);
  const S q = three * (s.im * s.im + e.im * e.im) - two * (s.im * e.im);
  const S g = (s.re * e.im + e.re * s.im) * (one - three * (s.re * e.re + s.im * e.im));
  const S long_part = sum * q, short_part = excess * p;
  const S a = long_part + short_part, b = long_part - short_part;
  const S product = sum * excess;
  const S cross = S(4.0) * product * (g * g);
  const S h = sqrt(b * b + cross);
  // H + B and H - B: their product is `cross`, so the smaller one follows from the larger.
  const S larger = h + abs(b);
  const S smaller = cross / select(zero < larger, larger, one);
  const auto falling = b < zero;
  const S reciprocal = one / (a + h);
  const S w = sqrt(S(24.0) * product * reciprocal);
  const S root_p = sqrt(S(60.0) * sum * select(falling, smaller, larger) * reciprocal);
  const S root_q = sqrt(S(60.0) * excess * select(falling, larger, smaller) * reciprocal);
  const S signed_q = select(g < zero, -root_q, root_q);
  const S mean_u = S(-3.0) * (s.re + e.re) * w, mean_v = S(-3.0) * (s.im + e.im) * w;
  LengthRoots<S> found;
  found.w0 = w * s;
  found.w2 = w * e;
  found.w1[0] = {S(0.25) * (mean_u + root_p), S(0.25) * (mean_v + signed_q)};
  found.w1[1] = {S(0.25) * (mean_u - root_p), S(0.25) * (mean_v - signed_q)};
  turns(found);
  return found;
}

}  // namespace hodograph::planar_detail
