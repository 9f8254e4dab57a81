// SPDX-License-Identifier: MIT
// The constant matrices of the Hermite constructions, for m matched derivatives: preimage degree
// n = 2m, of which the part fixed by the end data is a polynomial of degree N = 2m - 1.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "hodograph/bernstein/binomial.hpp"

namespace hodograph::hermite_detail {

template <class R, std::size_t m>
using Matrix = std::array<std::array<R, m>, m>;

template <class R, std::size_t m>
struct TableValues {
  /// Coefficient i of degree N (n) from derivative j: C(i,j) (N-j)!/N!.
  Matrix<R, m> low{}, high{};
  /// ∫ (B_i^N)' B_{N-j}^N: rates of the start part against the end part.
  Matrix<R, m> cross{};
  /// ∫ (B_i' B_j - B_j' B_i), degree N: twist of the start part with itself (i < j used).
  Matrix<R, m> self{};
  /// ∫ B_i^N B_m^n.
  std::array<R, m> moment{};
  /// Rows l_k and weights d_k with Σ_k d_k (l_k·x)² = xᵀ (G_ij ± G_{i,N-j})/2 x: the Gram
  /// matrix of degree N on sums (+) and differences (-) of mirrored coefficients.
  Matrix<R, m> sum_rows{}, difference_rows{};
  std::array<R, m> sum_weights{}, difference_weights{};
  /// ∫ B_i^n B_m^n; the middle one is the Gram entry of the free coefficient.
  std::array<R, 2 * m + 1> full_moment{};
  constexpr const R& middle() const { return full_moment[m]; }
};

/// Factors xᵀ M x = Σ_k d_k (l_k·x)², l_k unit upper triangular; M is positive definite.
template <class W, class R, std::size_t m>
constexpr void factor(Matrix<W, m> matrix, Matrix<R, m>& rows, std::array<R, m>& weights) {
  for (std::size_t k = 0; k < m; ++k) {
    weights[k] = R(matrix[k][k]);
    for (std::size_t j = k; j < m; ++j) rows[k][j] = R(matrix[k][j] / matrix[k][k]);
    for (std::size_t i = k + 1; i < m; ++i) {
      const W ratio_ik = matrix[k][i] / matrix[k][k];
      for (std::size_t j = i; j < m; ++j) matrix[i][j] = matrix[i][j] - ratio_ik * matrix[k][j];
    }
  }
}

/// Computes the tables: in long double for the built-in types, so that the entries are correctly
/// rounded, and in the type itself for others.
template <class R, std::size_t m>
struct MakeTables {
  constexpr TableValues<R, m> operator()() const {
    using W = std::conditional_t<std::is_floating_point_v<R>, long double, R>;
    constexpr std::size_t n = 2 * m, N = 2 * m - 1;
    TableValues<R, m> t;
    Matrix<W, m> sums{}, differences{};
    std::int64_t falling_low = 1, falling_high = 1;  // N (N-1) ... and n (n-1) ..., j factors
    for (std::size_t j = 0; j < m; ++j) {
      for (std::size_t i = j; i < m; ++i) {
        t.low[i][j] = ratio<R>(binomial(i, j), falling_low);
        t.high[i][j] = ratio<R>(binomial(i, j), falling_high);
      }
      falling_low *= static_cast<std::int64_t>(N - j);
      falling_high *= static_cast<std::int64_t>(n - j);
    }
    const W half = ratio<W>(1, 2);
    for (std::size_t i = 0; i < m; ++i) {
      t.moment[i] = R(bernstein_gram<W>(N, i, n, m));
      for (std::size_t j = 0; j < m; ++j) {
        t.cross[i][j] = R(bernstein_derivative_gram<W>(N, i, N - j));
        t.self[i][j] =
            R(bernstein_derivative_gram<W>(N, i, j) - bernstein_derivative_gram<W>(N, j, i));
        const W same = bernstein_gram<W>(N, i, N, j), mirrored = bernstein_gram<W>(N, i, N, N - j);
        sums[i][j] = half * (same + mirrored);
        differences[i][j] = half * (same - mirrored);
      }
    }
    factor(sums, t.sum_rows, t.sum_weights);
    factor(differences, t.difference_rows, t.difference_weights);
    for (std::size_t i = 0; i <= n; ++i) t.full_moment[i] = R(bernstein_gram<W>(n, i, n, m));
    return t;
  }
};

template <class S, std::size_t m>
constexpr const TableValues<real_of_t<S>, m>& tables() {
  return constant_table<real_of_t<S>, MakeTables<real_of_t<S>, m>>();
}

}  // namespace hodograph::hermite_detail
