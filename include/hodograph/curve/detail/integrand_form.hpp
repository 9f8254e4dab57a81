// SPDX-License-Identifier: MIT
// hodograph_form and speed_form side by side, their products left in pairs: a sum of many forms is
// accumulated in pairs and combined once. 12 multiplications for quaternions, where the two forms
// apart take 16, and every one of them is half of a pair.
#pragma once

#include "hodograph/curve/curve_integral.hpp"
#include "hodograph/foundation/pair.hpp"

namespace hodograph::curve_detail {

/// With a = (w, x, y, z): leading = (aw bw, ax bx), trailing = (ay by, az bz), and the crossed
/// products of (w, x) with y and with z. P is a pair of scalars.
template <class P>
struct QuaternionIntegrand {
  using Scalar = typename P::Scalar;
  P leading = P::both(Scalar(0)), trailing = leading, with_y = leading, with_z = leading;

  friend constexpr QuaternionIntegrand operator+(const QuaternionIntegrand& a,
                                                 const QuaternionIntegrand& b) {
    return {a.leading + b.leading, a.trailing + b.trailing, a.with_y + b.with_y,
            a.with_z + b.with_z};
  }
  friend constexpr QuaternionIntegrand operator*(const Scalar& s, const QuaternionIntegrand& a) {
    const P factor = P::both(s);
    return {factor * a.leading, factor * a.trailing, factor * a.with_y, factor * a.with_z};
  }
  constexpr CurveIntegral<Quaternion<Scalar>> value() const {
    const Scalar front = leading.first() + leading.second();
    const Scalar back = trailing.first() + trailing.second();
    return {{front - back, with_z.first() + with_y.second(), with_z.second() - with_y.first()},
            front + back};
  }
};

template <class P, class S>
constexpr QuaternionIntegrand<P> integrand_form(const Quaternion<S>& a, const Quaternion<S>& b) {
  const P a_front = P::template load<0>(a), b_front = P::template load<0>(b);
  return {a_front * b_front, P::template load<2>(a) * P::template load<2>(b),
          a_front * P::both(b.y) + b_front * P::both(a.y),
          a_front * P::both(b.z) + b_front * P::both(a.z)};
}

/// With a = (re, im): straight = (a_re b_re, a_im b_im), crossed = (a_re b_im, a_im b_re).
template <class P>
struct ComplexIntegrand {
  using Scalar = typename P::Scalar;
  P straight = P::both(Scalar(0)), crossed = straight;

  friend constexpr ComplexIntegrand operator+(const ComplexIntegrand& a,
                                              const ComplexIntegrand& b) {
    return {a.straight + b.straight, a.crossed + b.crossed};
  }
  friend constexpr ComplexIntegrand operator*(const Scalar& s, const ComplexIntegrand& a) {
    const P factor = P::both(s);
    return {factor * a.straight, factor * a.crossed};
  }
  constexpr CurveIntegral<Complex<Scalar>> value() const {
    return {{straight.first() - straight.second(), crossed.first() + crossed.second()},
            straight.first() + straight.second()};
  }
};

template <class P, class S>
constexpr ComplexIntegrand<P> integrand_form(const Complex<S>& a, const Complex<S>& b) {
  const P front = P::template load<0>(a), back = P::template load<0>(b);
  return {front * back, front * back.swapped()};
}

/// (hodograph_form(A, A), speed_form(A, A)) of a preimage, of degree 2n.
template <class P, class A, std::size_t n>
constexpr BernsteinPolynomial<CurveIntegral<A>, 2 * n> integrand(
    const BernsteinPolynomial<A, n>& preimage) {
  return symmetric_square(
      preimage, [](const A& a, const A& b) { return integrand_form<P>(a, b); },
      [](const auto& form) { return form.value(); });
}

}  // namespace hodograph::curve_detail
