// SPDX-License-Identifier: MIT
// Linear programs over ℚ, solved exactly: a basis from a solver in floating point (Clp), then
// rational arithmetic decides whether it is optimal, and goes on from it where it is not.
#pragma once

#include <cstddef>
#include <vector>

#include "flint.hpp"

namespace hodograph::rational_detail {

/// Minimise c · w where M w = b, w ≥ 0. The rows of M are independent.
struct LinearProgram {
  LinearProgram(std::size_t rows, std::size_t columns)
      : matrix(rows, columns), right(rows), cost(columns) {}

  RationalMatrix matrix;        ///< M
  std::vector<Rational> right;  ///< b
  std::vector<Rational> cost;   ///< c
  /// M and b once more in double, row by row, after row operations of the caller's choice, which
  /// condition the problem for the solver in floating point; b after all of M.
  std::vector<double> numeric;
  /// Columns of which the first independent ones are a basis whose weights are not negative.
  std::vector<std::size_t> start;

  Rational entry(std::size_t i, std::size_t j) const {
    Rational x;
    fmpq_set(raw(x), matrix.at(i, j));
    return x;
  }
  void set(std::size_t i, std::size_t j, const Rational& x) { fmpq_set(matrix.at(i, j), raw(x)); }
};

/// The optimum, with its proof: c - Mᵀ multipliers ≥ 0, and 0 where a weight is positive.
struct LinearOptimum {
  Rational value;
  std::vector<Rational> weights;      ///< w
  std::vector<Rational> multipliers;  ///< one a row
};

/// The exact optimum of a program that is bounded from below (contract).
LinearOptimum exact_optimum(const LinearProgram& program);

/// The columns that a solver in floating point holds basic at the optimum of the numeric program;
/// fewer than there are rows, or the wrong ones, where rounding misleads it.
std::vector<std::size_t> numeric_basis(const LinearProgram& program);

/// The rows of M (all of one length) as doubles after they have been made orthonormal, the work
/// done with enough digits for rows that are nearly dependent.
std::vector<std::vector<double>> orthonormal(std::vector<std::vector<Rational>> rows);

/// x rounded to a multiple of 2^-bits.
Rational rounded(const Rational& x, long bits);

}  // namespace hodograph::rational_detail
