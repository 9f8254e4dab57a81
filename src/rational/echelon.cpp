// SPDX-License-Identifier: MIT
// Elimination with primitive rows.
#include "echelon.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "hodograph/foundation/interruption.hpp"

namespace hodograph::rational_detail {

namespace {

/// An integer of FLINT that cleans up.
class Integer {
 public:
  Integer() { fmpz_init(value_); }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  ~Integer() { fmpz_clear(value_); }
  fmpz* get() { return value_; }

 private:
  fmpz_t value_;
};

/// Divides a row by the common divisor of its entries, and makes the entry `pivot` positive.
void make_primitive(fmpz* row, std::size_t columns, std::size_t pivot) {
  Integer content;
  _fmpz_vec_content(content.get(), row, signed_size(columns));
  if (fmpz_is_zero(content.get())) return;
  if (fmpz_sgn(row + pivot) < 0) fmpz_neg(content.get(), content.get());
  if (!fmpz_is_one(content.get())) {
    _fmpz_vec_scalar_divexact_fmpz(row, row, signed_size(columns), content.get());
  }
}

std::size_t leading(const fmpz* row, std::size_t columns) {
  std::size_t j = 0;
  while (j < columns && fmpz_is_zero(row + j)) ++j;
  return j;
}

}  // namespace

Echelon reduced_echelon(IntegerMatrix matrix) {
  const std::size_t columns = matrix.columns();
  const auto count = signed_size(columns);
  Integer a, b, common;
  // Down: the row that leads with each column.
  std::map<std::size_t, std::size_t> leads;
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    check_interruption();
    fmpz* row = matrix.at(i, 0);
    for (;;) {
      const std::size_t j = leading(row, columns);
      if (j == columns) break;
      make_primitive(row, columns, j);
      const auto known = leads.find(j);
      if (known == leads.end()) {
        leads.emplace(j, i);
        break;
      }
      const fmpz* other = matrix.at(known->second, 0);
      fmpz_gcd(common.get(), row + j, other + j);
      fmpz_divexact(a.get(), other + j, common.get());
      fmpz_divexact(b.get(), row + j, common.get());
      _fmpz_vec_scalar_mul_fmpz(row, row, count, a.get());
      _fmpz_vec_scalar_submul_fmpz(row, other, count, b.get());
    }
  }
  Echelon result{IntegerMatrix(matrix.rows(), columns), {}};
  for (const auto& [column, row] : leads) {
    _fmpz_vec_swap(result.rows.at(result.pivots.size(), 0), matrix.at(row, 0), count);
    result.pivots.push_back(column);
  }
  // Up: what is below is reduced already, so that the entries in its pivot columns say at once what
  // is to be subtracted.
  IntegerMatrix& rows = result.rows;
  for (std::size_t i = result.pivots.size(); i-- > 0;) {
    check_interruption();
    fmpz* row = rows.at(i, 0);
    std::vector<std::size_t> used;
    fmpz_one(common.get());
    for (std::size_t k = i + 1; k < result.pivots.size(); ++k) {
      if (fmpz_is_zero(row + result.pivots[k])) continue;
      used.push_back(k);
      fmpz_lcm(common.get(), common.get(), rows.at(k, result.pivots[k]));
    }
    if (used.empty()) continue;
    IntegerMatrix entries(1, used.size());
    for (std::size_t u = 0; u < used.size(); ++u) {
      fmpz_set(entries.at(0, u), row + result.pivots[used[u]]);
    }
    _fmpz_vec_scalar_mul_fmpz(row, row, count, common.get());
    for (std::size_t u = 0; u < used.size(); ++u) {
      const std::size_t pivot = result.pivots[used[u]];
      fmpz_divexact(a.get(), common.get(), rows.at(used[u], pivot));
      fmpz_mul(a.get(), a.get(), entries.at(0, u));
      _fmpz_vec_scalar_submul_fmpz(row + pivot, rows.at(used[u], pivot),
                                   signed_size(columns - pivot), a.get());
    }
    make_primitive(row, columns, result.pivots[i]);
  }
  return result;
}

}  // namespace hodograph::rational_detail
