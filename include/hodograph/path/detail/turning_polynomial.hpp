// SPDX-License-Identifier: MIT
// The polynomials behind the curvature of a PH curve, over doubles or enclosures.
#pragma once

#include <cmath>
#include <cstddef>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/foundation/enclosure.hpp"

namespace hodograph::path_detail {

/// The degree 2n - 2 of the turning polynomial (0 for a constant preimage).
constexpr std::size_t turning_degree(std::size_t n) { return n > 0 ? 2 * n - 2 : 0; }
/// The degree 4n - 3 of the slope of the curvature (0 for a constant preimage).
constexpr std::size_t curvature_slope_degree(std::size_t n) { return n > 0 ? 4 * n - 3 : 0; }

/// Im(a* b).
template <class S>
constexpr S cross(const Complex<S>& a, const Complex<S>& b) {
  return a.re * b.im - a.im * b.re;
}

/// The same, to a few roundings of itself where a and b are single numbers: nearly parallel ones
/// keep their digits, parallel ones give exactly 0. The rounding error of a product is a double
/// itself, unless the product is below 2^-969.
inline Enclosure cross(const Complex<Enclosure>& a, const Complex<Enclosure>& b) {
  const auto is_point = [](const Enclosure& x) { return x.lower() == x.upper(); };
  if (is_point(a.re) && is_point(a.im) && is_point(b.re) && is_point(b.im)) {
    constexpr double least = 0x1.0p-960;  // above 2^-969
    const double p = a.re.lower() * b.im.lower(), q = a.im.lower() * b.re.lower();
    const auto exact = [](double x, double y, double product) {
      return std::abs(product) >= least ? std::isfinite(product) : x == 0.0 || y == 0.0;
    };
    if (exact(a.re.lower(), b.im.lower(), p) && exact(a.im.lower(), b.re.lower(), q)) {
      const double p_rest = std::fma(a.re.lower(), b.im.lower(), -p);
      const double q_rest = std::fma(a.im.lower(), b.re.lower(), -q);
      if (p == q) return Enclosure(p_rest) - Enclosure(q_rest);
      return (Enclosure(p) - Enclosure(q)) + (Enclosure(p_rest) - Enclosure(q_rest));
    }
  }
  return a.re * b.im - a.im * b.re;
}

/// τ with Im(w* w') = n τ, ' = d/du. With w = (1 - u) L + u R, L and R of the coefficients w_0 ...
/// w_{n-1} and w_1 ... w_n, w' = n (R - L), so that τ = Im(L* R): two degrees less than the product
/// of w* and w' shows, and no cancellation of leading terms. The curvature is 2nτ/(hσ²).
template <class S, std::size_t n>
constexpr auto turning_polynomial(const BernsteinPolynomial<Complex<S>, n>& w) {
  if constexpr (n == 0) {
    return BernsteinPolynomial<S, 0>();
  } else {
    BernsteinPolynomial<Complex<S>, n - 1> left, right;
    for (std::size_t i = 0; i < n; ++i) {
      left[i] = w[i];
      right[i] = w[i + 1];
    }
    return product(left, right,
                   [](const Complex<S>& a, const Complex<S>& b) { return cross(a, b); });
  }
}

/// In space: v with vec(A* A') = n v, that is vec(L* R). Its first component turns the frame about
/// the tangent; the others bend the curve, κ = 2n |(v₂, v₃)|/(hσ²).
template <class S, std::size_t n>
  requires(n >= 1)
constexpr auto turning_polynomial(const BernsteinPolynomial<Quaternion<S>, n>& a) {
  BernsteinPolynomial<Quaternion<S>, n - 1> left, right;
  for (std::size_t i = 0; i < n; ++i) {
    left[i] = a[i];
    right[i] = a[i + 1];
  }
  return product(left, right, [](const Quaternion<S>& l, const Quaternion<S>& r) {
    return body_rate_form(l, r);
  });
}

template <class S, std::size_t n>
constexpr BernsteinPolynomial<S, 2 * n> planar_speed(const BernsteinPolynomial<Complex<S>, n>& w) {
  return symmetric_square(w, [](const Complex<S>& a, const Complex<S>& b) { return dot(a, b); });
}

/// f = σ τ' - 2 τ σ', ' = d/du: dκ/du = (2n/h) f/σ³.
template <class S, std::size_t m, std::size_t k>
constexpr auto curvature_slope(const BernsteinPolynomial<S, m>& turning,
                               const BernsteinPolynomial<S, k>& speed) {
  const auto times = [](const S& a, const S& b) { return a * b; };
  if constexpr (k == 0) {
    return BernsteinPolynomial<S, 0>();
  } else if constexpr (m == 0) {
    return product(S(-2.0) * turning, speed.derivative(), times);
  } else {
    return product(speed, turning.derivative(), times) -
           S(2.0) * product(turning, speed.derivative(), times);
  }
}

}  // namespace hodograph::path_detail
