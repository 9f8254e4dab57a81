// SPDX-License-Identifier: MIT
// hodograph_form and speed_form side by side, their products left in pairs: a sum of many forms is
// accumulated in pairs and combined once. 12 multiplications for quaternions, where the two forms
// apart take 16, and every one of them is half of a pair.
#pragma once

#include "hodograph/algebra/paired_quaternion.hpp"
#include "hodograph/curve/curve_integral.hpp"
#include "hodograph/foundation/pair.hpp"

namespace hodograph::curve_detail {

/// A CurveIntegral in pairs: the tangential part of the displacement with the arc length, and the
/// rest of the displacement; in the plane the displacement, and the arc length alone.
template <class A, class P>
struct PairedIntegral;
template <class S, class P>
struct PairedIntegral<Quaternion<S>, P> {
  using Scalar = S;
  P along = P::both(S(0)), across = along;
  constexpr CurveIntegral<Quaternion<S>> value() const {
    return {{along.first(), across.first(), across.second()}, along.second()};
  }
  friend constexpr PairedIntegral operator+(const PairedIntegral& a, const PairedIntegral& b) {
    return {a.along + b.along, a.across + b.across};
  }
  friend constexpr PairedIntegral operator*(const S& s, const PairedIntegral& a) {
    return {P::both(s) * a.along, P::both(s) * a.across};
  }
};
template <class S, class P>
struct PairedIntegral<Complex<S>, P> {
  using Scalar = S;
  P displacement = P::both(S(0));
  S arc_length{0};
  constexpr CurveIntegral<Complex<S>> value() const {
    return {{displacement.first(), displacement.second()}, arc_length};
  }
  friend constexpr PairedIntegral operator+(const PairedIntegral& a, const PairedIntegral& b) {
    return {a.displacement + b.displacement, a.arc_length + b.arc_length};
  }
  friend constexpr PairedIntegral operator*(const S& s, const PairedIntegral& a) {
    return {P::both(s) * a.displacement, s * a.arc_length};
  }
};

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
  /// The forms themselves.
  constexpr PairedIntegral<Quaternion<Scalar>, P> value() const {
    const P sums = P::firsts(leading, trailing) + P::seconds(leading, trailing);
    return {P::minus_plus(sums.first_twice(), sums.second_twice()),
            P::plus_minus(with_z, with_y.swapped())};
  }
};

template <class P, class S>
constexpr QuaternionIntegrand<P> integrand_form(const Quaternion<S>& a, const Quaternion<S>& b) {
  const P a_front = P::template load<0>(a), b_front = P::template load<0>(b);
  return {a_front * b_front, P::template load<2>(a) * P::template load<2>(b),
          a_front * P::both(b.y) + b_front * P::both(a.y),
          a_front * P::both(b.z) + b_front * P::both(a.z)};
}

/// The form of a with itself.
template <class P>
constexpr QuaternionIntegrand<P> integrand_square(const PairedQuaternion<P>& a) {
  const P twice = a.front + a.front;
  return {a.front * a.front, a.back * a.back, twice * a.back.first_twice(),
          twice * a.back.second_twice()};
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
  constexpr PairedIntegral<Complex<Scalar>, P> value() const {
    return {P::minus_plus(P::firsts(straight, crossed), P::seconds(straight, crossed)),
            straight.first() + straight.second()};
  }
};

template <class P, class S>
constexpr ComplexIntegrand<P> integrand_form(const Complex<S>& a, const Complex<S>& b) {
  const P front = P::template load<0>(a), back = P::template load<0>(b);
  return {front * back, front * back.swapped()};
}

/// h ∫ (hodograph_form(A, A), speed_form(A, A)) of a preimage, of degree 2n + 1.
template <class P, class A, std::size_t n>
constexpr BernsteinPolynomial<CurveIntegral<A>, 2 * n + 1> curve_integral(
    const BernsteinPolynomial<A, n>& preimage, const typename A::Scalar& h) {
  const auto integrand = symmetric_square(
      preimage, [](const A& a, const A& b) { return integrand_form<P>(a, b); },
      [](const auto& form) { return form.value(); });
  return integrand.antiderivative(h).mapped([](const auto& value) { return value.value(); });
}

}  // namespace hodograph::curve_detail
