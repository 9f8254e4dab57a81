// SPDX-License-Identifier: MIT
// By how much a quadratic complex polynomial turns on [0, 1], in closed form and without a branch:
// S is a number or a pack of lanes.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "hodograph/algebra/complex.hpp"
#include "hodograph/foundation/scalar.hpp"
#include "hodograph/path/detail/angle.hpp"

namespace hodograph::path_detail {

/// On a piece where arg w is monotone: the turn, between 0 and 2π, as a complex number of that
/// argument and as the middle of its quadrant, in quarter turns, and whether it is to the left.
template <class S>
struct MonotoneTurn {
  Complex<S> direction;
  S quarters, sign;
};

/// Source: let A, B, C be the Bernstein coefficients of w on a piece where Im(w* w') keeps its
/// sign. Its coefficients Im(A* B), Im(A* C)/2, Im(B* C) then have that sign (or vanish), so the
/// angles from A to B and from B to C lie in [0, π] that way round, and their sum, in [0, 2π], is
/// the turn of w: both equal arg(A* C) modulo 2π, both depend continuously on A, B, C, and they
/// agree where these are nearly equal. So the turn exceeds π where arg(A* C) is negative that way
/// round; except that a turn near 0 (both angles below π/2) and one near 2π (both above) are told
/// apart by Re(A* B) and Re(B* C), since rounding may give Im(A* C) either sign. Between two
/// inflections B = 0 up to rounding; then Im(A* C) has the sign of the piece.
template <class S>
[[gnu::always_inline]] inline MonotoneTurn<S> monotone_turn(Complex<S> a, const Complex<S>& b,
                                                            Complex<S> c) {
  using std::abs;
  const S zero(0.0), one(1.0);
  // Where w vanishes at an end, its direction there is that of B.
  const auto a_zero = abs(a.re) + abs(a.im) <= zero;
  const auto c_zero = abs(c.re) + abs(c.im) <= zero;
  a = {select(a_zero, b.re, a.re), select(a_zero, b.im, a.im)};
  c = {select(c_zero, b.re, c.re), select(c_zero, b.im, c.im)};
  const S along = a.re * c.re + a.im * c.im, across = a.re * c.im - a.im * c.re;
  const S first = a.re * b.re + a.im * b.im, second = b.re * c.re + b.im * c.im;
  const S rate = (a.re * b.im - a.im * b.re) + (b.re * c.im - b.im * c.re) + S(0.5) * across;
  const S sign = select(rate < zero, -one, one);
  const S left = sign * across;
  constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();
  const auto beyond = ((first < zero || second < zero) && left < zero) ||
                      (first < zero && second < zero && left <= S(rounding) * along);
  const auto nothing = abs(along) + abs(across) <= zero;
  const S x = select(nothing, one, along), y = abs(across);
  const S quarters = select(x < zero, S(1.5), S(0.5));
  return {{x, select(beyond, -y, y)}, select(beyond, S(4.0) - quarters, quarters), sign};
}

/// The pieces of [0, 1] on which arg w is monotone; empty ones turn by 0.
template <class S>
[[gnu::always_inline]] inline std::array<MonotoneTurn<S>, 3> monotone_turns(const Complex<S>& w0,
                                                                            const Complex<S>& w1,
                                                                            const Complex<S>& w2) {
  using std::abs;
  using std::sqrt;
  const S zero(0.0), one(1.0);
  // Im(w* w') = 2 (h0 (1-u)² + 2 h1 u (1-u) + h2 u²); its roots as ratios u : 1 - u.
  const S h0 = w0.re * w1.im - w0.im * w1.re, h2 = w1.re * w2.im - w1.im * w2.re;
  const S h1 = S(0.5) * (w0.re * w2.im - w0.im * w2.re);
  const S discriminant = h1 * h1 - h0 * h2;
  const S root = sqrt(select(zero < discriminant, discriminant, zero));
  const S q = select(h1 < zero, root - h1, -(root + h1));
  const auto real = zero < discriminant;
  const auto q_positive = zero < q, q_negative = q < zero;
  const auto inside_1 = real && ((q_positive && zero < h2) || (q_negative && h2 < zero));
  const auto inside_2 = real && ((q_positive && zero < h0) || (q_negative && h0 < zero));
  const S u1 = select(inside_1, q / select(inside_1, q + h2, one), zero);
  const S u2 = select(inside_2, h0 / select(inside_2, h0 + q, one), zero);
  const S a = select(u1 < u2, u1, u2), b = select(u1 < u2, u2, u1);
  // De Casteljau's points for a and b; (1-b) left + b right of a is the blossom w(a, b).
  const auto between = [&](const S& u, const Complex<S>& from, const Complex<S>& to) {
    const S v = one - u;
    return Complex<S>{v * from.re + u * to.re, v * from.im + u * to.im};
  };
  const Complex<S> left_a = between(a, w0, w1), right_a = between(a, w1, w2);
  const Complex<S> left_b = between(b, w0, w1), right_b = between(b, w1, w2);
  const Complex<S> at_a = between(a, left_a, right_a), at_b = between(b, left_b, right_b);
  return {monotone_turn(w0, left_a, at_a), monotone_turn(at_a, between(b, left_a, right_a), at_b),
          monotone_turn(at_b, right_b, w2)};
}

/// The turns in sequence: one arc tangent gives their sum modulo 2π; the sum of the middles of
/// their quadrants, wrong by at most 3/4 π, the multiple.
template <class S>
[[gnu::always_inline]] inline S sum_of_turns(const std::array<MonotoneTurn<S>, 3>& turns,
                                             bool left_positive) {
  const S one(1.0);
  Complex<S> product{one, S(0.0)};
  S rough(0.0);
  for (const MonotoneTurn<S>& turn : turns) {
    const S sign = left_positive ? turn.sign : one;
    product = product * Complex<S>{turn.direction.re, sign * turn.direction.im};
    rough = rough + sign * turn.quarters;
  }
  const S angle = angle_of(product.im, product.re);
  const S gap = S(0.5 * pi) * rough - angle;
  const S full(2.0 * pi);
  return select(S(pi) < gap, angle + full, select(gap < S(-pi), angle - full, angle));
}

/// Whether Im(a* b) is 0 within the rounding of a and b (an ulp each) and of its two products.
template <class S>
[[gnu::always_inline]] inline auto is_parallel(const Complex<S>& a, const Complex<S>& b) {
  using std::abs;
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  const S p = a.re * b.im, q = a.im * b.re;
  return abs(p - q) <= S(rounding) * (abs(p) + abs(q));
}

/// The sum of the turns of w, both ways round counted positive, between 0 and 2π; 0 where the w_i
/// are parallel within rounding, whether w changes its sign or not. Within 16 ε where w is well
/// away from zero. Domain: the components that are not 0 are between 2^-150 and 2^150 in size.
template <class S>
[[gnu::always_inline]] inline S absolute_turn(const Complex<S>& w0, const Complex<S>& w1,
                                              const Complex<S>& w2) {
  const S turn = sum_of_turns(monotone_turns(w0, w1, w2), false);
  const auto flat = is_parallel(w0, w1) && is_parallel(w1, w2) && is_parallel(w0, w2);
  const S bounded = select(S(2.0 * pi) < turn, S(2.0 * pi), turn);
  return select(flat || turn < S(0.0), S(0.0), bounded);
}

}  // namespace hodograph::path_detail
