// SPDX-License-Identifier: MIT
// Polynomials of fixed degree in Bernstein form on [0, 1], with coefficients in any vector space:
// real numbers, points, complex numbers, quaternions, or any of these over enclosures.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <type_traits>

#include "hodograph/bernstein/weights.hpp"

namespace hodograph {

/// The scalar of a vector space: V::Scalar, or V itself when V is a number.
template <class V>
struct ScalarOf {
  using type = V;
};
template <class V>
  requires requires { typename V::Scalar; }
struct ScalarOf<V> {
  using type = typename V::Scalar;
};
template <class V>
using scalar_of_t = typename ScalarOf<V>::type;

/// body(0), ..., body(count - 1): written out for built-in numbers, whose operations are shorter
/// than the bookkeeping of a loop; a loop for every other scalar.
template <std::size_t count, class S, class Body>
[[gnu::always_inline]] constexpr void unrolled(const Body& body) {
  if constexpr (std::is_floating_point_v<S>) {
#pragma GCC unroll 64
    for (std::size_t i = 0; i < count; ++i) body(i);
  } else {
    for (std::size_t i = 0; i < count; ++i) body(i);
  }
}

/// f(u) = Σ_{i=0..n} c_i B_i^n(u), u in [0, 1].
///
/// Evaluation sums c_i B_i^n(u) directly: on [0, 1] every weight is non-negative and they sum to 1,
/// so the error is at most accuracy::evaluation_error(n) times the largest coefficient.
/// Evaluation outside [0, 1] is an error of the caller. The type is small and copied freely.
template <class V, std::size_t n>
class BernsteinPolynomial {
 public:
  using Value = V;
  using Scalar = scalar_of_t<V>;
  static constexpr std::size_t degree = n;

  /// The zero polynomial.
  constexpr BernsteinPolynomial() = default;
  constexpr explicit BernsteinPolynomial(const std::array<V, n + 1>& coefficients)
      : c_(coefficients) {}

  constexpr const std::array<V, n + 1>& coefficients() const& { return c_; }
  constexpr std::array<V, n + 1> coefficients() && { return c_; }
  constexpr const V& operator[](std::size_t i) const { return c_[i]; }
  constexpr V& operator[](std::size_t i) { return c_[i]; }

  /// f(u).
  constexpr V value(const Scalar& u) const { return weighted(bernstein_values<n>(u), 0); }
  /// Exactly c_0 and c_n.
  constexpr const V& front() const { return c_.front(); }
  constexpr const V& back() const { return c_.back(); }

  /// f(u), f'(u), ..., f^(K)(u). Derivatives above the degree are zero.
  /// Method: the last min(K, n) steps of de Casteljau's algorithm, whose points are n - K fold
  /// averages of consecutive coefficients with common weights.
  template <std::size_t K>
  constexpr std::array<V, K + 1> jet(const Scalar& u) const {
    constexpr std::size_t steps = std::min(K, n);
    const auto weights = bernstein_values<n - steps>(u);
    std::array<V, steps + 1> point;
    for (std::size_t i = 0; i <= steps; ++i) point[i] = weighted(weights, i);

    std::array<V, K + 1> result{};
    const Scalar v = Scalar(1) - u;
    Scalar factor(1);
    // Before step r the points are those of level n - steps + r; the differences of order
    // steps - r of them give the derivative of that order, so derivatives come out highest first.
    for (std::size_t order = 0; order < steps; ++order) {
      factor = factor * Scalar(static_cast<double>(n - order));
    }
    for (std::size_t order = steps + 1; order-- > 0;) {
      std::array<V, steps + 1> difference = point;
      for (std::size_t j = 0; j < order; ++j) {
        for (std::size_t i = 0; i + j < order; ++i)
          difference[i] = difference[i + 1] - difference[i];
      }
      result[order] = factor * difference[0];
      if (order > 0) {
        factor = factor / Scalar(static_cast<double>(n - order + 1));
        for (std::size_t i = 0; i < order; ++i) point[i] = v * point[i] + u * point[i + 1];
      }
    }
    return result;
  }

  /// f', of degree n - 1 (the zero polynomial of degree 0 for a constant).
  constexpr BernsteinPolynomial<V, (n > 0 ? n - 1 : 0)> derivative() const {
    BernsteinPolynomial<V, (n > 0 ? n - 1 : 0)> result;
    const Scalar factor(static_cast<double>(n));
    for (std::size_t i = 0; i < n; ++i) result[i] = factor * (c_[i + 1] - c_[i]);
    return result;
  }

  /// ∫₀ᵘ f, of degree n + 1.
  constexpr BernsteinPolynomial<V, n + 1> antiderivative() const {
    return running_sum(ratio<Scalar>(1, static_cast<std::int64_t>(n + 1)));
  }
  /// h ∫₀ᵘ f.
  constexpr BernsteinPolynomial<V, n + 1> antiderivative(const Scalar& h) const {
    return running_sum(h * ratio<Scalar>(1, static_cast<std::int64_t>(n + 1)));
  }

  /// ∫₀¹ f, the mean of the coefficients.
  constexpr V integral() const {
    V sum = c_[0];
    for (std::size_t i = 1; i <= n; ++i) sum = sum + c_[i];
    return ratio<Scalar>(1, static_cast<std::int64_t>(n + 1)) * sum;
  }

  /// The same polynomial written in degree m ≥ n.
  template <std::size_t m>
    requires(m >= n)
  constexpr BernsteinPolynomial<V, m> elevated() const {
    BernsteinPolynomial<V, m> result;
    for (std::size_t i = 0; i <= m; ++i) {
      for (std::size_t j = (i > m - n ? i - (m - n) : 0); j <= n && j <= i; ++j) {
        result[i] = result[i] +
                    ratio<Scalar>(binomial(n, j) * binomial(m - n, i - j), binomial(m, i)) * c_[j];
      }
    }
    return result;
  }

  /// v -> f(a + (b - a) v): the polynomial on [a, b], again on [0, 1]. By blossoming: two runs of
  /// de Casteljau's algorithm, convex combinations only when 0 ≤ a ≤ b ≤ 1.
  constexpr BernsteinPolynomial restricted(const Scalar& a, const Scalar& b) const {
    const BernsteinPolynomial left = b == Scalar(1) ? *this : split(b, true);
    if (a == Scalar(0)) return left;
    return left.split(b == Scalar(1) ? a : a / b, false);
  }

  /// u -> f(1 - u).
  constexpr BernsteinPolynomial reversed() const {
    BernsteinPolynomial result;
    for (std::size_t i = 0; i <= n; ++i) result[i] = c_[n - i];
    return result;
  }

  /// The image under a linear map of the coefficient space.
  template <class Map>
  constexpr auto mapped(const Map& map) const {
    BernsteinPolynomial<decltype(map(c_[0])), n> result;
    unrolled<n + 1, Scalar>([&](std::size_t i) { result[i] = map(c_[i]); });
    return result;
  }

  friend constexpr BernsteinPolynomial operator+(const BernsteinPolynomial& f,
                                                 const BernsteinPolynomial& g) {
    BernsteinPolynomial result;
    for (std::size_t i = 0; i <= n; ++i) result[i] = f[i] + g[i];
    return result;
  }
  friend constexpr BernsteinPolynomial operator-(const BernsteinPolynomial& f,
                                                 const BernsteinPolynomial& g) {
    BernsteinPolynomial result;
    for (std::size_t i = 0; i <= n; ++i) result[i] = f[i] - g[i];
    return result;
  }
  friend constexpr BernsteinPolynomial operator*(const Scalar& s, const BernsteinPolynomial& f) {
    return f.mapped([&](const V& c) { return s * c; });
  }
  friend constexpr bool operator==(const BernsteinPolynomial&,
                                   const BernsteinPolynomial&) = default;

 private:
  // The order of weighted_sum in weights.hpp: both halves from the ends inwards, terms two by two,
  // their sum, and the middle term of an even degree.
  template <std::size_t size>
  constexpr V weighted(const std::array<Scalar, size>& weights, std::size_t first) const {
    if constexpr (size == 1) {
      return c_[first];
    } else {
      constexpr std::size_t m = size - 1, half = size / 2;
      const auto term = [&](std::size_t i) { return weights[i] * c_[first + i]; };
      V front = term(0), back = term(m);
      if constexpr (half % 2 == 0) {
        front = front + term(1);
        back = back + term(m - 1);
      }
      for (std::size_t i = 2 - half % 2; i < half; i += 2) {
        front = front + (term(i) + term(i + 1));
        back = back + (term(m - i) + term(m - i - 1));
      }
      V sum = front + back;
      if constexpr (m % 2 == 0) sum = sum + term(m / 2);
      return sum;
    }
  }

  // De Casteljau at u: the part on [0, u] (left) or on [u, 1].
  constexpr BernsteinPolynomial split(const Scalar& u, bool left) const {
    const Scalar v = Scalar(1) - u;
    BernsteinPolynomial result = *this;
    std::array<V, n + 1> point = c_;
    for (std::size_t r = 1; r <= n; ++r) {
      for (std::size_t i = 0; i + r <= n; ++i) point[i] = v * point[i] + u * point[i + 1];
      if (left) {
        result[r] = point[0];
      } else {
        result[n - r] = point[n - r];
      }
    }
    return result;
  }

  /// Coefficients 0, factor c_0, factor (c_0 + c_1), ...
  constexpr BernsteinPolynomial<V, n + 1> running_sum(const Scalar& factor) const {
    BernsteinPolynomial<V, n + 1> result;
    V sum{};
    unrolled<n + 1, Scalar>([&](std::size_t i) {
      sum = i == 0 ? c_[0] : sum + c_[i];
      result[i + 1] = factor * sum;
    });
    return result;
  }

  std::array<V, n + 1> c_{};
};

/// The product of two polynomials under a bilinear form of their coefficients, of degree m + n:
///   h_k = Σ_{i+j=k} C(m,i) C(n,j) / C(m+n,k) form(f_i, g_j).
template <class V, class W, std::size_t m, std::size_t n, class Form>
constexpr auto product(const BernsteinPolynomial<V, m>& f, const BernsteinPolynomial<W, n>& g,
                       const Form& form) {
  using S = scalar_of_t<V>;
  using R = real_of_t<S>;
  const auto& weights = constant_table<R, ProductWeights<R, m, n>>();
  BernsteinPolynomial<decltype(form(f[0], g[0])), m + n> h;
  for (std::size_t i = 0; i <= m; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      h[i + j] = h[i + j] + S(weights[i][j]) * form(f[i], g[j]);
    }
  }
  return h;
}

/// Σ form(f_i, f_j) over i + j = k, equal terms taken once and doubled.
template <std::size_t n, class V, class Form>
[[gnu::always_inline]] constexpr auto symmetric_sum(const std::array<V, n + 1>& f, std::size_t k,
                                                    const Form& form) {
  std::size_t i = k > n ? k - n : 0;
  auto sum = form(f[i], f[k - i]);
  if (2 * i == k) return sum;
  for (++i; 2 * i < k; ++i) sum = sum + form(f[i], f[k - i]);
  sum = sum + sum;
  return 2 * i == k ? sum + form(f[i], f[i]) : sum;
}

/// The product of f with itself under a symmetric bilinear form: half the work of product(f, f).
///   C(2n,k) h_k = Σ_{i+j=k} form(C(n,i) f_i, C(n,j) f_j)
/// A form may return a value that is only summed and scaled, from which finish makes the result.
template <class V, std::size_t n, class Form, class Finish = std::identity>
constexpr auto symmetric_square(const BernsteinPolynomial<V, n>& f, const Form& form,
                                const Finish& finish = {}) {
  using S = scalar_of_t<V>;
  using R = real_of_t<S>;
  const auto& row = constant_table<R, BinomialRow<R, n>>();
  const auto& reciprocals = constant_table<R, ReciprocalBinomials<R, 2 * n>>();
  std::array<V, n + 1> scaled;
  unrolled<n + 1, S>(
      [&, &row = row](std::size_t i) { scaled[i] = i == 0 || i == n ? f[i] : S(row[i]) * f[i]; });
  BernsteinPolynomial<std::remove_cvref_t<decltype(finish(form(f[0], f[0])))>, 2 * n> h;
  unrolled<2 * n + 1, S>([&, &reciprocals = reciprocals](std::size_t k) {
    const auto sum = symmetric_sum<n>(scaled, k, form);
    h[k] = k == 0 || k == 2 * n ? finish(sum) : finish(S(reciprocals[k]) * sum);
  });
  return h;
}

}  // namespace hodograph
