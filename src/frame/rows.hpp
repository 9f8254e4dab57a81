// SPDX-License-Identifier: MIT
// Bernstein polynomials on [0, 1] whose degree is known when the program runs, over doubles,
// complex numbers or enclosures: what rolls and their twist are made of.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "hodograph/algebra/complex.hpp"
#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/foundation/enclosure.hpp"

namespace hodograph::frame_detail {

/// Coefficients c_0, ..., c_n, n ≥ 0.
template <class V>
using Row = std::vector<V>;

inline double middle(double x) { return x; }
inline double middle(const Enclosure& x) { return x.middle(); }
inline double lower(double x) { return x; }
inline double lower(const Enclosure& x) { return x.lower(); }
inline double magnitude(double x) { return std::abs(x); }
inline double magnitude(const Enclosure& x) { return x.magnitude(); }

/// x as an enclosure of every number within `error` of it; x itself among doubles.
template <class S>
S about(double x, double error) {
  if constexpr (std::same_as<S, double>) {
    return x;
  } else {
    return {Enclosure::down(x - error), Enclosure::up(x + error)};
  }
}

/// C(m,i) C(n,j)/C(m+n,i+j).
template <class S>
S product_weight(std::size_t m, std::size_t i, std::size_t n, std::size_t j) {
  const auto choose = [](std::size_t top, std::size_t k) {
    double value = 1.0;
    for (std::size_t r = 1; r <= std::min(k, top - k); ++r) {
      value = value * static_cast<double>(top - r + 1) / static_cast<double>(r);
    }
    return value;
  };
  const double weight = choose(m, i) * choose(n, j) / choose(m + n, i + j);
  // Up to row 51 no product above reaches 2^53, and binomials are exact: two roundings are left.
  // Beyond it every factor of the three takes two more.
  constexpr std::size_t last_exact_row = 51;
  const double roundings =
      2.0 + (m + n <= last_exact_row ? 0.0 : 2.0 * static_cast<double>(2 * (m + n)));
  return about<S>(weight, weight * roundings * epsilon<double>());
}

/// The weights of a product of given degrees, once.
template <class S>
class ProductTable {
 public:
  ProductTable(std::size_t m, std::size_t n) : m_(m), n_(n) {
    weights_.reserve((m + 1) * (n + 1));
    for (std::size_t i = 0; i <= m; ++i) {
      for (std::size_t j = 0; j <= n; ++j) weights_.push_back(product_weight<S>(m, i, n, j));
    }
  }
  /// Σ weight form(f_i, g_j).
  template <class V, class W, class Form>
  auto product(std::span<const V> f, std::span<const W> g, const Form& form) const {
    Row<decltype(form(f[0], g[0]))> h(m_ + n_ + 1);
    for (std::size_t i = 0; i <= m_; ++i) {
      for (std::size_t j = 0; j <= n_; ++j) {
        h[i + j] = h[i + j] + weights_[i * (n_ + 1) + j] * form(f[i], g[j]);
      }
    }
    return h;
  }

 private:
  std::size_t m_, n_;
  std::vector<S> weights_;
};

template <class V, class W, class Form>
auto product(const Row<V>& f, const Row<W>& g, const Form& form) {
  using S = scalar_of_t<V>;
  return ProductTable<S>(f.size() - 1, g.size() - 1)
      .product(std::span<const V>(f), std::span<const W>(g), form);
}
template <class S>
Row<S> product(const Row<S>& f, const Row<S>& g) {
  return product(f, g, [](const S& a, const S& b) { return a * b; });
}

/// form(f, f')/n for a form that vanishes on the diagonal, ' = d/du: with f = (1 - u) L + u R it is
/// form(L, R), of degree 2n - 2, without the cancellation of its leading terms. 0 for a constant.
template <class V, class Form>
auto turning(const Row<V>& f, const Form& form) {
  if (f.size() < 2) return Row<decltype(form(f[0], f[0]))>(1);
  return product(Row<V>(f.begin(), f.end() - 1), Row<V>(f.begin() + 1, f.end()), form);
}

/// The sum of two polynomials, the shorter one elevated.
template <class S>
Row<S> sum(Row<S> f, Row<S> g) {
  if (f.size() < g.size()) std::swap(f, g);
  if (g.size() < f.size()) g = product(g, Row<S>(f.size() - g.size() + 1, S(1.0)));
  for (std::size_t i = 0; i < f.size(); ++i) f[i] = f[i] + g[i];
  return f;
}
template <class S, class V>
Row<V> scaled(const S& factor, Row<V> f) {
  for (V& c : f) c = factor * c;
  return f;
}

/// f(u) by de Casteljau's algorithm.
template <class V>
V value(const Row<V>& f, double u) {
  using S = scalar_of_t<V>;
  Row<V> point = f;
  const S right(u), left = S(1.0) - right;
  for (std::size_t r = f.size() - 1; r > 0; --r) {
    for (std::size_t i = 0; i < r; ++i) point[i] = left * point[i] + right * point[i + 1];
  }
  return point[0];
}

/// f(u), f'(u), ..., f^(K)(u), K + 1 = result.size(), by u.
inline void jet(const Row<double>& f, double u, std::span<double> result) {
  constexpr std::size_t most = 128;
  double point[most];
  const std::size_t n = f.size() - 1, steps = std::min(n, result.size() - 1);
  std::copy(f.begin(), f.end(), point);
  for (std::size_t r = n; r > steps; --r) {
    for (std::size_t i = 0; i < r; ++i) point[i] = (1.0 - u) * point[i] + u * point[i + 1];
  }
  std::fill(result.begin(), result.end(), 0.0);
  for (std::size_t order = steps + 1; order-- > 0;) {
    double difference[most];
    std::copy(point, point + order + 1, difference);
    double factor = 1.0;
    for (std::size_t j = 0; j < order; ++j) {
      factor *= static_cast<double>(n - j);
      for (std::size_t i = 0; i + j < order; ++i) difference[i] = difference[i + 1] - difference[i];
    }
    result[order] = factor * difference[0];
    for (std::size_t i = 0; i < order; ++i) point[i] = (1.0 - u) * point[i] + u * point[i + 1];
  }
}

/// f on [a, b], 0 ≤ a ≤ b ≤ 1, again on [0, 1].
template <class V>
Row<V> restricted(Row<V> f, double a, double b) {
  using S = scalar_of_t<V>;
  const std::size_t n = f.size() - 1;
  if (b < 1.0) {
    const S right(b), left = S(1.0) - right;
    for (std::size_t r = 1; r <= n; ++r) {
      for (std::size_t i = n; i >= r; --i) f[i] = left * f[i - 1] + right * f[i];
    }
  }
  if (a > 0.0) {
    const S right = b < 1.0 ? S(a) / S(b) : S(a), left = S(1.0) - right;
    for (std::size_t r = 1; r <= n; ++r) {
      for (std::size_t i = 0; i + r <= n; ++i) f[i] = left * f[i] + right * f[i + 1];
    }
  }
  return f;
}

}  // namespace hodograph::frame_detail
