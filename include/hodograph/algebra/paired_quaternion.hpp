// SPDX-License-Identifier: MIT
// A quaternion in two pairs, (w, x) and (y, z): with α = w + x i and β = y + z i it is α + β j, and
// sums, rolls and products are done two components at a time. Every operation has the bits of the
// same one on Quaternion.
#pragma once

#include "hodograph/algebra/quaternion.hpp"
#include "hodograph/foundation/pair.hpp"

namespace hodograph {

/// P is a pair of scalars.
template <class P>
struct PairedQuaternion {
  using Scalar = typename P::Scalar;
  P front, back;

  PairedQuaternion() = default;
  constexpr PairedQuaternion(const P& wx, const P& yz) : front(wx), back(yz) {}
  explicit constexpr PairedQuaternion(const Quaternion<Scalar>& a)
      : front(P::template load<0>(a)), back(P::template load<2>(a)) {}
  constexpr Quaternion<Scalar> value() const {
    return {front.first(), front.second(), back.first(), back.second()};
  }

  friend constexpr PairedQuaternion operator+(const PairedQuaternion& a,
                                              const PairedQuaternion& b) {
    return {a.front + b.front, a.back + b.back};
  }
  friend constexpr PairedQuaternion operator-(const PairedQuaternion& a,
                                              const PairedQuaternion& b) {
    return {a.front - b.front, a.back - b.back};
  }
  friend constexpr PairedQuaternion operator*(const Scalar& s, const PairedQuaternion& a) {
    const P factor = P::both(s);
    return {factor * a.front, factor * a.back};
  }
  friend constexpr PairedQuaternion operator*(const PairedQuaternion& a, const Roll<Scalar>& q) {
    const P cosine = P::both(q.cosine), sine = P::both(q.sine);
    return {P::minus_plus(a.front * cosine, a.front.swapped() * sine),
            P::plus_minus(a.back * cosine, a.back.swapped() * sine)};
  }

  /// (x, w, z, y).
  constexpr PairedQuaternion swapped() const { return {front.swapped(), back.swapped()}; }
};

/// The products of like components: a dot product or a twist form before it is summed.
template <class P>
constexpr PairedQuaternion<P> componentwise(const PairedQuaternion<P>& a,
                                            const PairedQuaternion<P>& b) {
  return {a.front * b.front, a.back * b.back};
}
/// dot(a, b) from componentwise(a, b): (w + y) + (x + z).
template <class P>
constexpr typename P::Scalar dot_sum(const PairedQuaternion<P>& products) {
  const P sum = products.front + products.back;
  return sum.first() + sum.second();
}
/// twist_form(a, b) from componentwise(a.swapped(), b): (x - z) - (w - y).
template <class P>
constexpr typename P::Scalar twist_sum(const PairedQuaternion<P>& products) {
  const P difference = products.front - products.back;
  return difference.second() - difference.first();
}

}  // namespace hodograph
