// SPDX-License-Identifier: MIT
// Elimination over the rationals.
#include "flint.hpp"

#include <vector>

namespace hodograph::rational_detail {

std::size_t RationalMatrix::reduce() {
  return static_cast<std::size_t>(fmpq_mat_rref(value_, value_));
}

RationalMatrix RationalMatrix::null_space() const {
  RationalMatrix echelon(*this);
  const std::size_t rank = echelon.reduce();
  std::vector<std::size_t> pivots, others;
  for (std::size_t j = 0; j < columns(); ++j) {
    const std::size_t i = pivots.size();
    if (i < rank && !fmpq_is_zero(echelon.at(i, j))) {
      pivots.push_back(j);
    } else {
      others.push_back(j);
    }
  }
  RationalMatrix result(others.size(), columns());
  for (std::size_t k = 0; k < others.size(); ++k) {
    fmpq_one(result.at(k, others[k]));
    for (std::size_t i = 0; i < pivots.size(); ++i) {
      fmpq_neg(result.at(k, pivots[i]), echelon.at(i, others[k]));
    }
  }
  return result;
}

}  // namespace hodograph::rational_detail
