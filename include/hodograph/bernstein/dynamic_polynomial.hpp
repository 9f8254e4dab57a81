// SPDX-License-Identifier: MIT
// Polynomials in Bernstein form on [0, 1] whose degree is known only when the program runs: for
// work that is compiled once, whatever the degree of the path. Where the degree is known when the
// program is compiled, BernsteinPolynomial is several times faster.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <vector>

#include "hodograph/bernstein/binomial.hpp"
#include "hodograph/bernstein/polynomial.hpp"

namespace hodograph {

/// f(u) = Σ_{i=0..n} c_i B_i^n(u), u in [0, 1], n = degree() ≥ 0; coefficients in any vector space.
/// Accuracy of a value: accuracy::evaluation_error(n) times the largest coefficient.
template <class V>
class DynamicPolynomial {
 public:
  using Value = V;
  using Scalar = scalar_of_t<V>;

  /// The zero polynomial of degree 0.
  DynamicPolynomial() : c_(1) {}
  /// Contract: at least one coefficient.
  explicit DynamicPolynomial(std::vector<V> coefficients) : c_(std::move(coefficients)) {
    assert(!c_.empty());
  }
  DynamicPolynomial(std::initializer_list<V> coefficients)
      : DynamicPolynomial(std::vector<V>(coefficients)) {}

  std::size_t degree() const { return c_.size() - 1; }
  const std::vector<V>& coefficients() const { return c_; }
  const V& operator[](std::size_t i) const { return c_[i]; }
  V& operator[](std::size_t i) { return c_[i]; }
  /// f(0) and f(1), exactly.
  const V& front() const { return c_.front(); }
  const V& back() const { return c_.back(); }

  /// f(u), by the sum of Horner's kind Σ C(n,i) c_i u^i (1-u)^(n-i).
  V value(const Scalar& u) const {
    const std::size_t n = degree();
    const Scalar v = Scalar(1) - u;
    V sum = c_[0];
    Scalar power(1);
    for (std::size_t i = 1; i <= n; ++i) {
      power = power * u;
      sum = v * sum + (Scalar(static_cast<double>(binomial(n, i))) * power) * c_[i];
    }
    return sum;
  }

  /// f', of degree n - 1 (0 for a constant).
  DynamicPolynomial derivative() const {
    const std::size_t n = degree();
    if (n == 0) return DynamicPolynomial(std::vector<V>{c_[0] - c_[0]});
    std::vector<V> result(n);
    const Scalar factor(static_cast<double>(n));
    for (std::size_t i = 0; i < n; ++i) result[i] = factor * (c_[i + 1] - c_[i]);
    return DynamicPolynomial(std::move(result));
  }

  /// ∫₀ᵘ f, of degree n + 1.
  DynamicPolynomial antiderivative() const {
    const std::size_t n = degree();
    std::vector<V> result(n + 2);
    const Scalar factor = ratio<Scalar>(1, static_cast<std::int64_t>(n + 1));
    V sum = c_[0];
    result[0] = Scalar(0) * sum;
    for (std::size_t i = 0; i <= n; ++i) {
      if (i > 0) sum = sum + c_[i];
      result[i + 1] = factor * sum;
    }
    return DynamicPolynomial(std::move(result));
  }

  /// The same polynomial written in degree m ≥ n.
  DynamicPolynomial elevated(std::size_t m) const {
    assert(degree() <= m);
    std::vector<V> c = c_;
    while (c.size() <= m) {
      const std::size_t n = c.size();  // the degree to come
      std::vector<V> next(n + 1);
      next[0] = c[0];
      next[n] = c[n - 1];
      for (std::size_t i = 1; i < n; ++i) {
        const Scalar share =
            ratio<Scalar>(static_cast<std::int64_t>(i), static_cast<std::int64_t>(n));
        next[i] = share * c[i - 1] + (Scalar(1) - share) * c[i];
      }
      c = std::move(next);
    }
    return DynamicPolynomial(std::move(c));
  }

  /// f(a + (b - a) u), by de Casteljau's algorithm. Domain: 0 ≤ a < b ≤ 1.
  DynamicPolynomial restricted(const Scalar& a, const Scalar& b) const {
    std::vector<V> c = c_;
    const std::size_t n = degree();
    if (!is_one(b)) {  // keep [0, b]
      const Scalar rest = Scalar(1) - b;
      for (std::size_t r = 1; r <= n; ++r) {
        for (std::size_t i = n; i >= r; --i) c[i] = rest * c[i - 1] + b * c[i];
      }
    }
    if (!is_zero(a)) {  // of that, keep [a/b, 1]
      const Scalar from = a / b, rest = Scalar(1) - from;
      for (std::size_t r = 1; r <= n; ++r) {
        for (std::size_t i = 0; i + r <= n; ++i) c[i] = rest * c[i] + from * c[i + 1];
      }
    }
    return DynamicPolynomial(std::move(c));
  }

  /// f with every coefficient mapped; `function` must be linear.
  template <class Function>
  auto mapped(const Function& function) const {
    using W = std::remove_cvref_t<decltype(function(c_[0]))>;
    std::vector<W> result;
    result.reserve(c_.size());
    for (const V& c : c_) result.push_back(function(c));
    return DynamicPolynomial<W>(std::move(result));
  }

  /// Sums and differences; the lower degree is elevated.
  friend DynamicPolynomial operator+(const DynamicPolynomial& f, const DynamicPolynomial& g) {
    return combined(f, g, [](const V& a, const V& b) { return a + b; });
  }
  friend DynamicPolynomial operator-(const DynamicPolynomial& f, const DynamicPolynomial& g) {
    return combined(f, g, [](const V& a, const V& b) { return a - b; });
  }
  friend DynamicPolynomial operator*(const Scalar& s, const DynamicPolynomial& f) {
    return f.mapped([&s](const V& c) { return s * c; });
  }
  friend bool operator==(const DynamicPolynomial&, const DynamicPolynomial&) = default;

 private:
  static bool is_zero(const Scalar& s) { return s == Scalar(0); }
  static bool is_one(const Scalar& s) { return s == Scalar(1); }

  template <class Operation>
  static DynamicPolynomial combined(const DynamicPolynomial& f, const DynamicPolynomial& g,
                                    const Operation& operation) {
    if (f.degree() < g.degree()) return combined(f.elevated(g.degree()), g, operation);
    if (g.degree() < f.degree()) return combined(f, g.elevated(f.degree()), operation);
    std::vector<V> result;
    result.reserve(f.c_.size());
    for (std::size_t i = 0; i < f.c_.size(); ++i) result.push_back(operation(f.c_[i], g.c_[i]));
    return DynamicPolynomial(std::move(result));
  }

  std::vector<V> c_;
};

/// The product under a bilinear form of the coefficients. Domain: m + n ≤ 56, where every binomial
/// coefficient is a double.
///   h_k = Σ_{i+j=k} C(m,i) C(n,j) / C(m+n,k) form(f_i, g_j).
template <class V, class W, class Form>
auto product(const DynamicPolynomial<V>& f, const DynamicPolynomial<W>& g, const Form& form) {
  using R = std::remove_cvref_t<decltype(form(f[0], g[0]))>;
  using S = scalar_of_t<V>;
  const std::size_t m = f.degree(), n = g.degree();
  std::vector<R> h;
  h.reserve(m + n + 1);
  for (std::size_t k = 0; k <= m + n; ++k) {
    const auto whole = static_cast<double>(binomial(m + n, k));
    bool first = true;
    R sum{};
    for (std::size_t i = k > n ? k - n : 0; i <= std::min(k, m); ++i) {
      const S weight =
          S(static_cast<double>(binomial(m, i)) * static_cast<double>(binomial(n, k - i))) /
          S(whole);
      const R term = weight * form(f[i], g[k - i]);
      sum = first ? term : sum + term;
      first = false;
    }
    h.push_back(sum);
  }
  return DynamicPolynomial<R>(std::move(h));
}
/// The product of a real polynomial with one in any vector space.
template <class S, class V>
  requires std::is_same_v<S, scalar_of_t<V>>
DynamicPolynomial<V> scaled_product(const DynamicPolynomial<S>& f, const DynamicPolynomial<V>& g) {
  return product(f, g, [](const S& a, const V& b) { return a * b; });
}

}  // namespace hodograph
