// SPDX-License-Identifier: MIT
// Elimination over the rationals.
#include "flint.hpp"

#include <vector>

namespace hodograph::rational_detail {

RationalMatrix RationalMatrix::null_space() const {
  IntegerMatrix whole(rows(), columns());
  fmpq_mat_get_fmpz_mat_rowwise(whole.get(), nullptr, value_);
  return whole.null_space();
}

RationalMatrix IntegerMatrix::null_space() {
  // Pivots modulo a prime, then one p-adic solution for the other columns, which are few here.
  fmpz_t denominator;
  fmpz_init(denominator);
  const slong rank = fmpz_mat_is_zero(value_) ? 0 : fmpz_mat_rref_mul(value_, denominator, value_);
  const auto columns = static_cast<std::size_t>(fmpz_mat_ncols(value_));
  std::vector<std::size_t> pivots, others;
  for (std::size_t j = 0; j < columns; ++j) {
    const std::size_t i = pivots.size();
    if (i < static_cast<std::size_t>(rank) && !fmpz_is_zero(at(i, j))) {
      pivots.push_back(j);
    } else {
      others.push_back(j);
    }
  }
  RationalMatrix result(others.size(), columns);
  for (std::size_t k = 0; k < others.size(); ++k) {
    fmpq_one(result.at(k, others[k]));
    for (std::size_t i = 0; i < pivots.size(); ++i) {
      fmpq* entry = result.at(k, pivots[i]);
      fmpq_set_fmpz_frac(entry, at(i, others[k]), denominator);
      fmpq_neg(entry, entry);
    }
  }
  fmpz_clear(denominator);
  return result;
}

}  // namespace hodograph::rational_detail
