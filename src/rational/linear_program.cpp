// SPDX-License-Identifier: MIT
// The simplex method over ℚ from a basis that floating point proposes.
#include "linear_program.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace hodograph::rational_detail {

namespace {

Rational entry(const RationalMatrix& m, std::size_t i, std::size_t j) {
  Rational x;
  fmpq_set(raw(x), m.at(i, j));
  return x;
}

/// The first of some columns that are independent, in their order, as many as there are rows.
std::vector<std::size_t> independent(const LinearProgram& program,
                                     const std::vector<std::size_t>& columns) {
  const std::size_t rows = program.matrix.rows();
  RationalMatrix chosen(rows, columns.size());
  for (std::size_t j = 0; j < columns.size(); ++j) {
    for (std::size_t i = 0; i < rows; ++i) {
      fmpq_set(chosen.at(i, j), program.matrix.at(i, columns[j]));
    }
  }
  fmpq_mat_rref(chosen.get(), chosen.get());
  std::vector<std::size_t> result;
  for (std::size_t j = 0; j < columns.size() && result.size() < rows; ++j) {
    if (fmpq_is_zero(chosen.at(result.size(), j)) == 0) result.push_back(columns[j]);
  }
  return result;
}

/// The columns of a basis as a matrix.
RationalMatrix columns_of(const LinearProgram& program, const std::vector<std::size_t>& basis) {
  const std::size_t rows = program.matrix.rows();
  RationalMatrix b(rows, basis.size());
  for (std::size_t j = 0; j < basis.size(); ++j) {
    for (std::size_t i = 0; i < rows; ++i) fmpq_set(b.at(i, j), program.matrix.at(i, basis[j]));
  }
  return b;
}

/// The solution X of B X = Y for a regular B.
RationalMatrix solved(const RationalMatrix& b, const RationalMatrix& y) {
  RationalMatrix x(b.columns(), y.columns());
  [[maybe_unused]] const int regular = fmpq_mat_solve(x.get(), b.get(), y.get());
  assert(regular != 0);
  return x;
}

RationalMatrix column(const std::vector<Rational>& entries) {
  RationalMatrix m(entries.size(), 1);
  for (std::size_t i = 0; i < entries.size(); ++i) fmpq_set(m.at(i, 0), raw(entries[i]));
  return m;
}

/// What a basis says: its weights, its multipliers, and where it fails to be optimal.
struct BasicSolution {
  std::vector<Rational> weights;      // of the basic columns
  std::vector<Rational> multipliers;  // one a row
  bool feasible = true, optimal = true;
};
BasicSolution basic_solution(const LinearProgram& program, const std::vector<std::size_t>& basis) {
  const RationalMatrix b = columns_of(program, basis);
  const std::size_t rows = program.matrix.rows();
  BasicSolution result;
  const RationalMatrix w = solved(b, column(program.right));
  for (std::size_t i = 0; i < rows; ++i) {
    result.weights.push_back(entry(w, i, 0));
    if (result.weights.back().sign() < 0) result.feasible = false;
  }
  RationalMatrix transposed(rows, rows);
  fmpq_mat_transpose(transposed.get(), b.get());
  std::vector<Rational> cost;
  for (const std::size_t j : basis) cost.push_back(program.cost[j]);
  const RationalMatrix y = solved(transposed, column(cost));
  for (std::size_t i = 0; i < rows; ++i) result.multipliers.push_back(entry(y, i, 0));
  for (std::size_t j = 0; j < program.cost.size() && result.optimal; ++j) {
    Rational reduced = program.cost[j];
    for (std::size_t i = 0; i < rows; ++i) {
      reduced -= result.multipliers[i] * program.entry(i, j);
    }
    if (reduced.sign() < 0) result.optimal = false;
  }
  return result;
}

/// The simplex tableau of a feasible basis: B^-1 [M | b] and the reduced costs below.
class Tableau {
 public:
  Tableau(const LinearProgram& program, std::vector<std::size_t> basis)
      : basis_(std::move(basis)), columns_(program.cost.size()) {
    const std::size_t rows = program.matrix.rows();
    RationalMatrix whole(rows, columns_ + 1);
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns_; ++j) {
        fmpq_set(whole.at(i, j), program.matrix.at(i, j));
      }
      fmpq_set(whole.at(i, columns_), raw(program.right[i]));
    }
    const RationalMatrix x = solved(columns_of(program, basis_), whole);
    for (std::size_t i = 0; i < rows; ++i) {
      rows_.emplace_back();
      for (std::size_t j = 0; j <= columns_; ++j) rows_.back().push_back(entry(x, i, j));
    }
    std::vector<Rational> reduced = program.cost;
    reduced.emplace_back();
    for (std::size_t i = 0; i < rows; ++i) {
      const Rational& cost = program.cost[basis_[i]];
      for (std::size_t j = 0; j <= columns_; ++j) reduced[j] -= cost * rows_[i][j];
    }
    rows_.push_back(std::move(reduced));
  }

  /// Pivots until no reduced cost is negative. The most negative one enters; after a step that
  /// gained nothing the first one does (Bland's rule, which cannot cycle).
  const std::vector<std::size_t>& optimise() {
    bool gained = true;
    while (const auto enter = entering(gained)) {
      const std::size_t leave = leaving(*enter);
      gained = rows_[leave][columns_].sign() > 0;
      pivot(leave, *enter);
    }
    return basis_;
  }

 private:
  std::optional<std::size_t> entering(bool steepest) const {
    std::optional<std::size_t> best;
    const auto& reduced = rows_.back();
    for (std::size_t j = 0; j < columns_; ++j) {
      if (reduced[j].sign() >= 0) continue;
      if (!best || reduced[j] < reduced[*best]) best = j;
      if (!steepest) break;
    }
    return best;
  }
  std::size_t leaving(std::size_t enter) const {
    std::optional<std::size_t> best;
    Rational least;
    for (std::size_t i = 0; i + 1 < rows_.size(); ++i) {
      if (rows_[i][enter].sign() <= 0) continue;
      const Rational ratio = rows_[i][columns_] / rows_[i][enter];
      if (!best || ratio < least || (ratio == least && basis_[i] < basis_[*best])) {
        best = i;
        least = ratio;
      }
    }
    assert(best.has_value());  // else the program is unbounded
    return *best;
  }
  void pivot(std::size_t leave, std::size_t enter) {
    const Rational scale = Rational(1) / rows_[leave][enter];
    for (Rational& x : rows_[leave]) x *= scale;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (i == leave || rows_[i][enter].is_zero()) continue;
      const Rational factor = rows_[i][enter];
      for (std::size_t j = 0; j <= columns_; ++j) rows_[i][j] -= factor * rows_[leave][j];
    }
    basis_[leave] = enter;
  }

  std::vector<std::size_t> basis_;
  std::size_t columns_;
  std::vector<std::vector<Rational>> rows_;
};

}  // namespace

LinearOptimum exact_optimum(const LinearProgram& program) {
  const std::size_t rows = program.right.size();
  std::vector<std::size_t> basis = independent(program, numeric_basis(program));
  if (basis.size() < rows) {
    basis.insert(basis.end(), program.start.begin(), program.start.end());
    basis = independent(program, basis);
  }
  BasicSolution solution = basic_solution(program, basis);
  if (!solution.feasible) {
    basis = independent(program, program.start);
    solution = basic_solution(program, basis);
    assert(solution.feasible);
  }
  if (!solution.optimal) {
    basis = Tableau(program, basis).optimise();
    solution = basic_solution(program, basis);
    assert(solution.feasible && solution.optimal);
  }
  LinearOptimum result;
  result.weights.resize(program.cost.size());
  for (std::size_t i = 0; i < basis.size(); ++i) {
    result.value += solution.weights[i] * program.cost[basis[i]];
    result.weights[basis[i]] = std::move(solution.weights[i]);
  }
  result.multipliers = std::move(solution.multipliers);
  return result;
}

Rational rounded(const Rational& x, long bits) {
  Rational result;
  fmpq_mul_2exp(raw(result), raw(x), 0);
  if (bits >= 0) {
    fmpq_mul_2exp(raw(result), raw(x), static_cast<ulong>(bits));
  } else {
    fmpq_div_2exp(raw(result), raw(x), static_cast<ulong>(-bits));
  }
  result += Rational(1, 2);
  fmpz_fdiv_q(&raw(result)->num, &raw(result)->num, &raw(result)->den);
  fmpz_one(&raw(result)->den);
  if (bits >= 0) {
    fmpq_div_2exp(raw(result), raw(result), static_cast<ulong>(bits));
  } else {
    fmpq_mul_2exp(raw(result), raw(result), static_cast<ulong>(-bits));
  }
  return result;
}

std::vector<std::vector<double>> orthonormal(std::vector<std::vector<Rational>> rows) {
  // Fixed point. Monomials up to t^n on an interval lose about five bits a degree; this keeps the
  // digits of a double and more for bases that are half as bad again.
  const auto working_bits = static_cast<long>(128 + 8 * rows.size());
  const auto product = [](const std::vector<Rational>& a, const std::vector<Rational>& b) {
    Rational sum;
    for (std::size_t j = 0; j < a.size(); ++j) sum += a[j] * b[j];
    return sum;
  };
  const auto normalise = [working_bits](std::vector<Rational>& row) {
    Rational largest;
    for (const Rational& x : row) largest = std::max(largest, x.sign() < 0 ? -x : x);
    if (largest.is_zero()) return;
    for (Rational& x : row) x = rounded(x / largest, working_bits);
  };
  std::vector<std::vector<double>> result;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    normalise(rows[i]);
    for (std::size_t k = 0; k < i; ++k) {
      const Rational size = product(rows[k], rows[k]);
      if (size.is_zero()) continue;
      const Rational factor = rounded(product(rows[i], rows[k]) / size, working_bits);
      for (std::size_t j = 0; j < rows[i].size(); ++j) rows[i][j] -= factor * rows[k][j];
    }
    normalise(rows[i]);
    const double size = std::sqrt(product(rows[i], rows[i]).to_double());
    result.emplace_back();
    for (const Rational& x : rows[i])
      result.back().push_back(x.to_double() / (size > 0 ? size : 1));
  }
  return result;
}

}  // namespace hodograph::rational_detail
