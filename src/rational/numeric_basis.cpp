// SPDX-License-Identifier: MIT
// The one place where Clp is called: linear programs in double.
#include <Clp_C_Interface.h>

#include <cmath>
#include <limits>
#include <memory>

#include "linear_program.hpp"

namespace hodograph::rational_detail {

namespace {
/// What the simplex method takes is a small multiple of the rows; a proposal that takes this many
/// steps is worth nothing.
constexpr std::size_t most_steps_a_column = 100;

/// How far Clp may be from feasible and optimal: rows have length 1, and what the simplex method
/// loses on them is some thousand roundings. Its own default stops a few exact pivots earlier.
constexpr double solver_tolerance = 0x1p12 * std::numeric_limits<double>::epsilon();
}  // namespace

std::vector<std::size_t> numeric_basis(const LinearProgram& program) {
  const std::size_t rows = program.right.size(), columns = program.cost.size();
  std::vector<CoinBigIndex> starts(columns + 1);
  std::vector<int> indices(rows * columns);
  std::vector<double> values(rows * columns), cost(columns), zero(columns, 0.0);
  std::vector<double> upper(columns, std::numeric_limits<double>::max()), right(rows);
  for (std::size_t j = 0; j < columns; ++j) {
    starts[j + 1] = static_cast<CoinBigIndex>((j + 1) * rows);
    cost[j] = program.cost[j].to_double();
    for (std::size_t i = 0; i < rows; ++i) {
      indices[j * rows + i] = static_cast<int>(i);
      values[j * rows + i] = program.numeric[i * columns + j];
    }
  }
  for (std::size_t i = 0; i < rows; ++i) right[i] = program.numeric[rows * columns + i];
  for (const auto* numbers : {&values, &cost, &right}) {
    for (const double x : *numbers) {
      if (!std::isfinite(x)) return {};
    }
  }
  const std::unique_ptr<Clp_Simplex, decltype(&Clp_deleteModel)> model(Clp_newModel(),
                                                                       &Clp_deleteModel);
  Clp_setLogLevel(model.get(), 0);
  Clp_setPrimalTolerance(model.get(), solver_tolerance);
  Clp_setDualTolerance(model.get(), solver_tolerance);
  // Exact arithmetic goes on from whatever was reached.
  Clp_setMaximumIterations(model.get(), static_cast<int>(most_steps_a_column * columns));
  Clp_loadProblem(model.get(), static_cast<int>(columns), static_cast<int>(rows), starts.data(),
                  indices.data(), values.data(), zero.data(), upper.data(), cost.data(),
                  right.data(), right.data());
  Clp_dual(model.get(), 0);
  Clp_primal(model.get(), 0);
  constexpr int basic = 1;
  std::vector<std::size_t> result;
  for (std::size_t j = 0; j < columns && result.size() < rows; ++j) {
    if (Clp_getColumnStatus(model.get(), static_cast<int>(j)) == basic) result.push_back(j);
  }
  return result;
}

}  // namespace hodograph::rational_detail
