// SPDX-License-Identifier: MIT
// Gauss-Jordan elimination on FLINT matrices.
#include "linear_algebra.hpp"

#include "flint.hpp"

namespace hodograph::rational_detail {

namespace {

/// The reduced row echelon form of [rows | identity] and the columns of its pivots.
struct Echelon {
  RationalMatrix matrix;
  std::vector<std::size_t> pivots;
};
Echelon echelon(RationalMatrix matrix) {
  const auto rank = static_cast<std::size_t>(fmpq_mat_rref(matrix.get(), matrix.get()));
  Echelon result{std::move(matrix), {}};
  for (std::size_t j = 0; j < result.matrix.columns() && result.pivots.size() < rank; ++j) {
    if (fmpq_is_zero(result.matrix.at(result.pivots.size(), j)) == 0) result.pivots.push_back(j);
  }
  return result;
}

Rational entry(const RationalMatrix& m, std::size_t i, std::size_t j) {
  Rational x;
  fmpq_set(raw(x), m.at(i, j));
  return x;
}

}  // namespace

AffineSolution affine_solution(const std::vector<std::vector<Rational>>& system,
                               std::size_t unknowns) {
  RationalMatrix matrix(system.size(), unknowns + 1);
  for (std::size_t j = 0; j < system.size(); ++j) {
    for (std::size_t i = 0; i <= unknowns; ++i) fmpq_set(matrix.at(j, i), raw(system[j][i]));
  }
  const Echelon solved = echelon(matrix);
  AffineSolution result;
  if (!solved.pivots.empty() && solved.pivots.back() == unknowns) {
    // y solves the transposed system with the right side (0, ..., 0, 1), which has a solution.
    std::vector<std::vector<Rational>> transposed(unknowns + 1);
    for (std::size_t i = 0; i <= unknowns; ++i) {
      for (const auto& row : system) transposed[i].push_back(row[i]);
      transposed[i].emplace_back(i == unknowns ? 1 : 0);
    }
    result.contradiction = affine_solution(transposed, system.size()).particular;
    return result;
  }
  result.particular.resize(unknowns);
  std::size_t row = 0;
  for (std::size_t i = 0; i < unknowns; ++i) {
    if (row < solved.pivots.size() && solved.pivots[row] == i) {
      result.particular[i] = entry(solved.matrix, row, unknowns);
      ++row;
      continue;
    }
    std::vector<Rational> direction(unknowns);
    direction[i] = 1;
    for (std::size_t p = 0; p < solved.pivots.size(); ++p) {
      direction[solved.pivots[p]] = -entry(solved.matrix, p, i);
    }
    result.directions.push_back(std::move(direction));
  }
  return result;
}

}  // namespace hodograph::rational_detail
