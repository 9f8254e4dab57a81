// SPDX-License-Identifier: MIT
// The arithmetic of the closed loops of degree 7 in canonical position (start at the origin,
// tangent i, principal normal j, length 1), on any scalar. Whoever calls it has checked the data.
//
// Notation of the paper: c, s = cos ψ, sin ψ; c0 = 4 - 3c; ξ = x/y in homogeneous form, y = 0 the
// limit members. With w = W y nothing depends on y alone in a denominator:
//   W = 2 √(15 c0)/√((260 - 144 c + 4 c²) y² + 9 x²),  λ = √(35/(3 c0)).
#pragma once

#include <array>
#include <cstddef>

#include "hodograph/algebra/complex.hpp"
#include "hodograph/algebra/quaternion.hpp"
#include "hodograph/bernstein/polynomial.hpp"

namespace hodograph::loop_detail {

/// A member of the family: ξ = x/y with y ≥ 0, and the cosine and sine of ψ.
/// Domain: (x, y) ≠ 0, largest component of order 1.
template <class S>
struct Member {
  S x, y, cosine, sine;

  S c0() const { return S(4) - S(3) * cosine; }
  S lambda() const {
    using std::sqrt;
    return sqrt(S(S(35) / (S(3) * c0())));
  }
  /// W above; the w of the paper is W y.
  S size() const {
    using std::sqrt;
    const S square = S(260) - S(144) * cosine + S(4) * cosine * cosine;
    return S(2) * sqrt(S(S(15) * c0())) / sqrt(S(square * y * y + S(9) * x * x));
  }
};

/// A = α + k β, α = Σ α_i B_i³, β = Σ β_i B_i³ with (29), (30) at ψ0 = 0:
///   α = w (1, a1, a2 e^{iψ}, e^{iψ}),  β = λ (0, 1, -e^{iψ}, 0),
///   a1 = ((12 - 9 e^{iψ})(2 + ξ i) - 8 s i)/(6 c0),  a2 = ((12 - 9 e^{-iψ})(2 + ξ i) + 8 s i)/(6
///   c0)
template <class S>
BernsteinPolynomial<Quaternion<S>, 3> canonical_preimage(const Member<S>& member) {
  using C = Complex<S>;
  const S w = member.size(), lambda = member.lambda();
  const S third = S(1) / (S(6) * member.c0());
  const C turn{member.cosine, member.sine};
  const C arm{S(2) * member.y, member.x};  // y (2 + ξ i)
  const C lift{S(0), S(8) * member.sine * member.y};
  const C front = C{S(12) - S(9) * turn.re, -(S(9) * turn.im)};
  const C a1 = third * (front * arm - lift);
  const C a2 = third * (conjugate(front) * arm + lift);
  const C end = a2 * turn;
  const C alpha[4] = {C{w * member.y, S(0)}, w * a1, w * end, (w * member.y) * turn};
  const C beta[4] = {C{}, C{lambda, S(0)}, -(lambda * turn), C{}};
  BernsteinPolynomial<Quaternion<S>, 3> preimage;
  for (std::size_t i = 0; i < 4; ++i) {
    preimage[i] = {alpha[i].re, alpha[i].im, beta[i].im, beta[i].re};
  }
  return preimage;
}

/// The control points (32) in closed form.
template <class S>
std::array<Vector3<S>, 8> canonical_control_points(const Member<S>& member) {
  using std::sqrt;
  const S c = member.cosine, s = member.sine, c0 = member.c0();
  const S scale = member.size();
  const S w = scale * member.y, w_xi = scale * member.x;  // w and w ξ
  const S seventh = S(1) / S(7);
  const S c1 = S(4) * (S(78) - S(8) * c * c * c + S(45) * c * c - S(170) * c);
  const S c2 = S(18) * (S(3) - S(4) * c);
  const S double_cosine = S(2) * c * c - S(1), double_sine = S(2) * s * c;

  const S slant = S(3) * w * w_xi * s / (S(2) * c0);
  const S height = seventh * sqrt(S(S(35) / (S(3) * c0))) * w;
  const S factor = S(1) / (sqrt(S(105)) * c0 * sqrt(c0));
  const S along = factor * sqrt(S(S(3) / (S(35) * c0))) / S(4);
  const S odd = along * (c1 * w * w + c2 * w_xi * w_xi);
  const S even = along * (-(S(2) * c0 * w * w_xi * s));
  const S y_even = factor * w * (S(47) - S(41) * c + S(3) * double_cosine);
  const S y_odd = factor * S(9) * w_xi * s;
  const S z_even = factor * S(3) * c0 * w_xi;
  const S z_odd = factor * w * (S(18) * s + S(3) * double_sine);

  std::array<Vector3<S>, 8> p{};
  p[1] = {seventh * w * w, S(0), S(0)};
  p[2] = {seventh * (S(2) * w * w + slant), height, S(0)};
  p[3] = {even + odd, y_even + y_odd, z_even - z_odd};
  p[4] = {even - odd, y_even - y_odd, z_even + z_odd};
  p[5] = {seventh * (slant - S(2) * w * w), height, S(0)};
  p[6] = {-(seventh * w * w), S(0), S(0)};
  return p;
}

}  // namespace hodograph::loop_detail
