// SPDX-License-Identifier: MIT
// Binomial coefficients, and the integrals of Bernstein polynomials they give.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hodograph/foundation/scalar.hpp"

namespace hodograph {

/// n over k, exact for n ≤ 61.
constexpr std::int64_t binomial(std::size_t n, std::size_t k) {
  if (k > n) return 0;
  if (k > n - k) k = n - k;
  std::int64_t result = 1;
  for (std::size_t j = 1; j <= k; ++j) {
    result = result * static_cast<std::int64_t>(n - k + j) / static_cast<std::int64_t>(j);
  }
  return result;
}

/// ∫₀¹ B_i^m B_j^n du = C(m,i) C(n,j) / (C(m+n,i+j) (m+n+1)), correctly rounded.
/// Source: B_i^m B_j^n is a multiple of B_{i+j}^{m+n}, whose integral is 1/(m+n+1).
template <class S>
constexpr S bernstein_gram(std::size_t m, std::size_t i, std::size_t n, std::size_t j) {
  return ratio<S>(binomial(m, i) * binomial(n, j),
                  binomial(m + n, i + j) * static_cast<std::int64_t>(m + n + 1));
}

/// ∫₀¹ (B_i^n)' B_j^n du, exact up to the rounding of one sum.
/// Source: (B_i^n)' = n (B_{i-1}^{n-1} - B_i^{n-1}).
template <class S>
constexpr S bernstein_derivative_gram(std::size_t n, std::size_t i, std::size_t j) {
  const S degree(static_cast<double>(n));
  const S left = i > 0 ? bernstein_gram<S>(n - 1, i - 1, n, j) : S(0);
  const S right = i < n ? bernstein_gram<S>(n - 1, i, n, j) : S(0);
  return degree * (left - right);
}

/// Holds a compile-time table (see constant_table).
template <class Make>
struct TableHolder {
  static constexpr auto value = Make{}();
};

template <class Make>
const auto& table_at_first_use() {
  static const auto table = Make{}();
  return table;
}

/// A table that is computed once: at compile time for the built-in types, at first use for others.
/// Make must be an empty function object returning the table.
template <class S, class Make>
constexpr const auto& constant_table() {
  if constexpr (std::is_floating_point_v<S>) {
    return TableHolder<Make>::value;
  } else {
    return table_at_first_use<Make>();
  }
}

/// The row C(n, 0), ..., C(n, n) as reals of the scalar.
template <class R, std::size_t n>
struct BinomialRow {
  constexpr std::array<R, n + 1> operator()() const {
    std::array<R, n + 1> row{};
    for (std::size_t i = 0; i <= n; ++i) row[i] = R(static_cast<double>(binomial(n, i)));
    return row;
  }
};

/// The row 1/C(n, 0), ..., 1/C(n, n).
template <class R, std::size_t n>
struct ReciprocalBinomials {
  constexpr std::array<R, n + 1> operator()() const {
    std::array<R, n + 1> row{};
    for (std::size_t i = 0; i <= n; ++i) row[i] = ratio<R>(1, binomial(n, i));
    return row;
  }
};

/// The weights C(m,i) C(n,j) / C(m+n,i+j) of a product of Bernstein polynomials.
template <class R, std::size_t m, std::size_t n>
struct ProductWeights {
  constexpr std::array<std::array<R, n + 1>, m + 1> operator()() const {
    std::array<std::array<R, n + 1>, m + 1> weights{};
    for (std::size_t i = 0; i <= m; ++i) {
      for (std::size_t j = 0; j <= n; ++j) {
        weights[i][j] = ratio<R>(binomial(m, i) * binomial(n, j), binomial(m + n, i + j));
      }
    }
    return weights;
  }
};

}  // namespace hodograph
