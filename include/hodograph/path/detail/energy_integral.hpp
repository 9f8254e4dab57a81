// SPDX-License-Identifier: MIT
// The integral of κ² along a PH curve by Gauss-Legendre quadrature on pieces chosen by the
// distance of the integrand's poles: in doubles, or in enclosures with a bound of the remainder.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/curve/ph_curve.hpp"
#include "hodograph/path/detail/enclosed_curve.hpp"
#include "hodograph/path/detail/turning_polynomial.hpp"

namespace hodograph::path_detail {

/// The positive nodes and the weights of the Gauss-Legendre rule with 16 nodes on [-1, 1]: each the
/// double next to the true number.
inline constexpr std::array<std::array<double, 2>, 8> gauss_rule{{
    {{0.09501250983763744, 0.1894506104550685}},
    {{0.2816035507792589, 0.18260341504492358}},
    {{0.45801677765722737, 0.16915651939500254}},
    {{0.6178762444026438, 0.14959598881657674}},
    {{0.755404408355003, 0.12462897125553388}},
    {{0.8656312023878318, 0.09515851168249279}},
    {{0.9445750230732326, 0.062253523938647894}},
    {{0.9894009349916499, 0.027152459411754096}},
}};

/// Number types of the quadrature: x as an enclosure of a number within half an ulp of x.
template <class S>
S rounded_constant(double x) {
  if constexpr (std::same_as<S, double>) {
    return x;
  } else {
    return {S::down(x), S::up(x)};
  }
}
inline double upper_size(const Complex<double>& z) { return std::sqrt(dot(z, z)); }
inline double lower_size(const Complex<double>& z) { return upper_size(z); }
inline double upper_size(const Complex<Enclosure>& z) {
  return sqrt(square(z.re) + square(z.im)).upper();
}
inline double lower_size(const Complex<Enclosure>& z) {
  return sqrt(square(z.re) + square(z.im)).lower();
}
/// Of quaternions and vectors.
template <class V>
  requires(V::dimension > 1 && std::same_as<typename V::Scalar, double>)
double upper_size(const V& v) {
  return std::sqrt(dot(v, v));
}
template <class V>
  requires(V::dimension > 1 && std::same_as<typename V::Scalar, Enclosure>)
double upper_size(const V& v) {
  Enclosure sum(0.0);
  for (std::size_t j = 0; j < V::dimension; ++j) sum += square(v[j]);
  return sqrt(sum).upper();
}
inline double lower_size(const Quaternion<double>& a) { return std::sqrt(dot(a, a)); }
inline double lower_size(const Quaternion<Enclosure>& a) {
  return sqrt((square(a.w) + square(a.x)) + (square(a.y) + square(a.z))).lower();
}
inline double upper_size(double x) { return std::abs(x); }
inline double upper_size(const Enclosure& x) { return x.magnitude(); }

/// What bends the curve: τ of turning_polynomial in the plane, (v₂, v₃) in space.
template <class S, std::size_t n>
auto bending_polynomial(const BernsteinPolynomial<Complex<S>, n>& w) {
  return turning_polynomial(w);
}
template <class S, std::size_t n>
auto bending_polynomial(const BernsteinPolynomial<Quaternion<S>, n>& a) {
  return turning_polynomial(a).mapped([](const Vector3<S>& v) { return Vector2<S>{v.y, v.z}; });
}

/// ∫₀¹ |τ|²/σ³ du, where τ and σ belong to a preimage w whose largest component lies between 1/2
/// and 1.
///
/// On a piece with middle c and half length r, let x be the parameter in [-1, 1]. In the disc |x| ≤
/// R, |w| ≥ |w(c)| - Σ_{k>0} |w_k| R^k = m with the Taylor coefficients w_k; σ(x) = w(x) w(x*)* for
/// complex x, so that |σ| ≥ m² and |τ²/σ³| ≤ (Σ |τ_k| R^k)²/m^6 = M. The ellipse with foci ±1 and
/// semi-axes that sum to ρ lies in the disc of radius R = (ρ + 1/ρ)/2. There the integrand's k-th
/// Chebyshev coefficient is at most 2 M ρ^-k; the rule with N nodes is exact for k < 2N and, like
/// the integral, at most 2 in size for every other Chebyshev polynomial, 0 for odd k. Hence the
/// remainder is at most Σ_{k = 2N, 2N+2, ...} 8 M ρ^-k = 8 M ρ^-2N/(1 - ρ^-2).
///
/// In space σ = A·A (continued to complex x) with A = A(c) + δ, |δ| ≤ Σ_{k>0} |A_k| R^k = e, so
/// that |σ| ≥ |A(c)|² - 2 |A(c)| e - e² = m², and |τ·τ| ≤ (Σ |τ_k| R^k)² as before.
template <class A, std::size_t n>
  requires(n > 0)
class EnergyIntegral {
 public:
  using S = typename A::Scalar;
  using Preimage = BernsteinPolynomial<A, n>;
  using Turning = decltype(bending_polynomial(Preimage{}));

  explicit EnergyIntegral(const Preimage& preimage)
      : preimage_(preimage), turning_(bending_polynomial(preimage)) {}

  /// Nothing where w comes so close to zero that the integral may be infinite.
  std::optional<S> value() const {
    struct Part {
      double a, b;
    };
    if (std::all_of(turning_.coefficients().begin(), turning_.coefficients().end(),
                    [](const auto& c) { return upper_size(c) == 0.0; })) {
      return S(0.0);
    }
    constexpr std::size_t deepest = 60;
    std::array<Part, deepest + 1> stack;
    stack[0] = {0.0, 1.0};
    std::size_t count = 1;
    S sum(0.0);
    // Next to a zero of w the pieces shrink in geometric progression; n zeros need n such rows.
    constexpr std::size_t most_pieces = 8 * deepest * (n + 1);
    for (std::size_t pieces = 0; count > 0; ++pieces) {
      const Part part = stack[count - 1];
      if (const auto share = share_of(part.a, part.b, sum)) {
        sum = sum + *share;
        --count;
        continue;
      }
      if (count == deepest || pieces >= most_pieces) return std::nullopt;
      const double middle = 0.5 * (part.a + part.b);
      stack[count - 1] = {middle, part.b};
      stack[count++] = {part.a, middle};
    }
    return sum;
  }

 private:
  static constexpr bool rigorous = std::same_as<S, Enclosure>;

  /// The integral over [a, b], or nothing where the remainder is not below the rounding of it.
  std::optional<S> share_of(double a, double b, const S& sum) const {
    const Preimage w = preimage_.restricted(S(a), S(b));
    const Turning turning = turning_.restricted(S(a), S(b));
    const std::optional<Remainder> bound = remainder_bound(w, turning);
    const double length_bound = 0.5 * (b - a);
    const auto allows = [&](double size) {
      return length_bound * bound->remainder <= epsilon<double>() * (size + upper_size(sum));
    };
    // The rule's weights sum to 2: a value that cannot be enough is not worth the evaluation.
    constexpr double most_weight = 2.5;
    if (!bound || !allows(length_bound * most_weight * bound->most)) return std::nullopt;
    S total(0.0);
    for (const auto& [node, weight] : gauss_rule) {
      const S x = S(0.5) * rounded_constant<S>(node);
      total = total + rounded_constant<S>(weight) *
                          (integrand(w, turning, S(0.5) - x) + integrand(w, turning, S(0.5) + x));
    }
    const S length = S(b) - S(a), half = S(0.5) * length;
    if (!allows(upper_size(half * total))) return std::nullopt;
    if constexpr (rigorous) total = total + Enclosure(-bound->remainder, bound->remainder);
    return half * total;
  }

  struct Remainder {
    double remainder;
    double most;  ///< a bound of the integrand on the piece
  };
  /// 8 M ρ^-32/(1 - ρ^-2) for the best of a few ρ; nothing where the disc may reach a zero of w.
  static std::optional<Remainder> remainder_bound(const Preimage& w, const Turning& turning) {
    const auto w_sizes = taylor_sizes(w);
    const auto turning_sizes = taylor_sizes(turning);
    const double least = lower_middle(w);
    std::optional<Remainder> best;
    double on_piece = 0.0;
    for (const double size : turning_sizes) on_piece += size;
    double nearest = least;
    for (std::size_t k = 1; k <= n; ++k) nearest -= w_sizes[k];
    if (!(nearest > margin * least)) return std::nullopt;
    const double top_quotient = on_piece / (nearest * nearest * nearest);
    const double most = (1.0 + margin) * top_quotient * top_quotient;
    for (const double rho : {3.0, 4.0, 6.0}) {
      const double radius = 0.5 * (rho + 1.0 / rho);
      double reach = 0.0, top = 0.0;
      for (std::size_t k = n; k > 0; --k) reach = (reach + w_sizes[k]) * radius;
      for (std::size_t k = turning_sizes.size(); k-- > 0;) top = top * radius + turning_sizes[k];
      const double m = least_root(least, reach);
      if (!(m > margin * least)) break;
      // Everything since the sizes, here and in the sums above, is a few dozen roundings.
      const double cube = m * m * m, quotient = top / cube;
      const double bound = (1.0 + margin) * 8.0 * quotient * quotient /
                           (std::pow(rho, 32.0) * (1.0 - 1.0 / (rho * rho)));
      if (!best || bound < best->remainder) best = Remainder{bound, most};
    }
    return best && std::isfinite(best->remainder) ? best : std::nullopt;
  }
  /// m above: |σ| ≥ m² where |w(c)| ≥ least and the rest is at most `reach`; not positive where
  /// nothing follows.
  static double least_root(double least, double reach) {
    if constexpr (A::dimension == 2) {
      return least - reach;
    } else {
      const double square = least * least - reach * (2.0 * least + reach);
      return square > 0.0 ? (1.0 - margin) * std::sqrt(square) : 0.0;
    }
  }
  /// What rounding of a few dozen operations stays far below.
  static constexpr double margin = 0x1.0p-16;

  /// Upper bounds of |f_k|, f(c + r x) = Σ f_k x^k.
  template <class V, std::size_t m>
  static std::array<double, m + 1> taylor_sizes(const BernsteinPolynomial<V, m>& f) {
    const auto jet = f.template jet<m>(S(0.5));
    std::array<double, m + 1> sizes;
    double scale = 1.0;
    for (std::size_t k = 0; k <= m; ++k) {
      sizes[k] = (1.0 + margin) * scale * upper_size(jet[k]);
      scale /= 2.0 * static_cast<double>(k + 1);
    }
    return sizes;
  }
  static double lower_middle(const Preimage& w) {
    return (1.0 - margin) * lower_size(w.value(S(0.5)));
  }

  static S integrand(const Preimage& w, const Turning& turning, const S& t) {
    const A value = w.value(t);
    const auto rate = turning.value(t);
    if constexpr (A::dimension > 2) {
      const S y = rate.x, z = rate.y;  // (v₂, v₃)
      if constexpr (rigorous) {
        const S speed = (square(value.w) + square(value.x)) + (square(value.y) + square(value.z));
        return (square(y / speed) + square(z / speed)) / speed;
      } else {
        const S speed = dot(value, value), p = y / speed, q = z / speed;
        return (p * p + q * q) / speed;
      }
    } else if constexpr (rigorous) {
      const S speed = square(value.re) + square(value.im);
      const S quotient = rate / speed;
      return square(quotient) / speed;
    } else {
      const S speed = dot(value, value), quotient = rate / speed;
      return quotient * quotient / speed;
    }
  }

  Preimage preimage_;
  Turning turning_;
};

}  // namespace hodograph::path_detail
