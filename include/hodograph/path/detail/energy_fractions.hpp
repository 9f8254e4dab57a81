// SPDX-License-Identifier: MIT
// The integral of κ² along a planar PH cubic or quintic in closed form, by partial fractions over
// the roots of w; where these lose digits it says nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "hodograph/algebra/complex.hpp"
#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/foundation/scalar.hpp"
#include "hodograph/path/detail/turning_polynomial.hpp"

namespace hodograph::path_detail {

/// Arithmetic of complex numbers whose squares are in range.
inline Complex<double> reciprocal(const Complex<double>& z) {
  const double r = 1.0 / dot(z, z);
  return {r * z.re, -r * z.im};
}
inline Complex<double> logarithm(const Complex<double>& z) {
  return {0.5 * std::log(dot(z, z)), std::atan2(z.im, z.re)};
}
inline Complex<double> square_root(const Complex<double>& z) {
  const double size = std::sqrt(0.5 * (std::hypot(z.re, z.im) + std::abs(z.re)));
  if (size == 0.0) return {};
  const double other = 0.5 * z.im / size;
  return z.re >= 0.0 ? Complex<double>{size, other}
                     : Complex<double>{std::abs(other), std::copysign(size, z.im)};
}

/// The share of one simple root of w in ∫₀¹ 4 Im(w'/w)²/|w|² du, and the size of its terms.
///
/// With w = (u - a) L, L linear, w̄ the polynomial with conjugate coefficients and z = u - a, the
/// integrand -(w'/w - w̄'/w̄)²/(w w̄) is -E²/(z³ L w̄), E = 1 + z (L'/L - w̄'/w̄). Its Laurent
/// coefficients at a are those of -E²/(L w̄) to the order z²; the roots of w̄ give the conjugates.
struct EnergyShare {
  double value = 0.0, size = 0.0;

  /// w(u) = c₀ + c₁ u + c₂ u²; L(a) and L' = c₂ for n = 2, L = c₁ and L' = 0 for n = 1.
  EnergyShare(const Complex<double>& a, const Complex<double>& l, const Complex<double>& l_rate,
              const Complex<double>& c0, const Complex<double>& c1, const Complex<double>& c2) {
    const Complex<double> one{1.0, 0.0}, bar2 = conjugate(c2);
    const Complex<double> w = conjugate(c0) + a * (conjugate(c1) + a * bar2);
    const Complex<double> w1 = conjugate(c1) + 2.0 * (a * bar2);
    const Complex<double> inverse_l = reciprocal(l), inverse_w = reciprocal(w);
    const Complex<double> p = l_rate * inverse_l, q = w1 * inverse_w, q2 = bar2 * inverse_w;
    // 1/(L w̄) = r0 (1 - d1 z + d2 z²), E² = 1 + e1 z + e2 z².
    const Complex<double> r0 = inverse_l * inverse_w, d1 = p + q;
    const Complex<double> d2 = p * p + p * q + q * q - q2;
    const Complex<double> difference = p - q, e1 = 2.0 * difference;
    const Complex<double> e2 = difference * difference + 2.0 * (q * q - p * p) - 4.0 * q2;
    const Complex<double> g1 = e1 - d1, g2 = e2 - e1 * d1 + d2;
    const Complex<double> s = reciprocal(one - a), t = reciprocal(a);
    const Complex<double> log = logarithm((one - a) * (-t));
    const Complex<double> first = 0.5 * (s * s - t * t), second = g1 * (s + t), third = g2 * log;
    value = 2.0 * (r0 * (first + second - third)).re;
    const auto magnitude = [](const Complex<double>& x) { return std::abs(x.re) + std::abs(x.im); };
    const double details = magnitude(e2) + magnitude(e1 * d1) + magnitude(d2);
    // a is known to a few roundings of the terms of w(a) over |w'(a)|, and everything depends on
    // its distance from the real line, in the power -5.
    const double terms =
        magnitude(c0) + magnitude(a) * (magnitude(c1) + magnitude(a) * magnitude(c2));
    constexpr double power = 5.0;
    const double condition = 1.0 + power * terms / (magnitude(l) * std::abs(a.im));
    size = 2.0 * condition * magnitude(r0) *
           (magnitude(s * s) + magnitude(t * t) + magnitude(g1) * (magnitude(s) + magnitude(t)) +
            details * magnitude(log));
  }
};

/// Whether a root is so far from [0, 1] that its terms are bound to cancel, and the quadrature is
/// quick.
inline bool is_far(const Complex<double>& a) {
  const double beyond = a.re - std::clamp(a.re, 0.0, 1.0);
  return !(beyond * beyond + a.im * a.im < 0.5);
}

/// ∫₀¹ τ²/σ³ du to within 2^-42 of itself, by an estimate from above: the sizes of what is added,
/// and the condition of the roots. Nothing where that is not reached, as near a double root, a root
/// near the conjugate of the other, or a root far away.
template <std::size_t n>
  requires(n == 1 || n == 2)
std::optional<double> energy_by_fractions(const BernsteinPolynomial<Complex<double>, n>& w) {
  constexpr double most_loss = 1024.0;  // of 2^-52; estimates exceed what is lost, tenfold mostly
  double value = 0.0, size = 0.0;
  if constexpr (n == 1) {
    const Complex<double> c1 = w[1] - w[0], a = -(w[0] * reciprocal(c1));
    if (is_far(a)) return std::nullopt;
    const EnergyShare share(a, c1, {}, w[0], c1, {});
    value = share.value;
    size = share.size;
  } else {
    const Complex<double> half = w[1] - w[0], c2 = (w[2] - w[1]) - half, c1 = 2.0 * half;
    const Complex<double> squares = w[1] * w[1], ends = w[0] * w[2];
    const Complex<double> discriminant = squares - ends;
    Complex<double> root = square_root(discriminant);
    const double condition =
        std::sqrt((dot(squares, squares) + dot(ends, ends)) / dot(discriminant, discriminant));
    if (!(condition <= most_loss)) return std::nullopt;
    if (dot(half, root) < 0.0) root = -root;
    const Complex<double> q = -(half + root);
    // Roots q/c₂ and w₀/q; c₂ (a - b) is twice the square root of the discriminant.
    const Complex<double> a = w[0] * reciprocal(q), b = q * reciprocal(c2);
    if (is_far(a) && is_far(b)) return std::nullopt;
    const EnergyShare first(a, 2.0 * root, c2, w[0], c1, c2);
    const EnergyShare second(b, -2.0 * root, c2, w[0], c1, c2);
    value = first.value + second.value;
    size = (first.size + second.size) * std::max(1.0, condition);
  }
  if (!(size <= most_loss * value)) return std::nullopt;
  return value / (4.0 * static_cast<double>(n * n));
}

}  // namespace hodograph::path_detail
