// SPDX-License-Identifier: MIT
// Linear equations over ℚ, solved or refuted.
#pragma once

#include <cstddef>
#include <vector>

#include "hodograph/rational/rational.hpp"

namespace hodograph::rational_detail {

/// All solutions of a system: particular + Σ x_k directions[k]; or the proof that there is none.
struct AffineSolution {
  std::vector<Rational> particular;
  std::vector<std::vector<Rational>> directions;
  /// Where there is none: y with Σ y_j row_j = (0, ..., 0 | 1).
  std::vector<Rational> contradiction;
};

/// The solutions of Σ_i system[j][i] c_i = system[j][unknowns] for every j. The particular solution
/// has 0 where a direction has its own 1.
AffineSolution affine_solution(const std::vector<std::vector<Rational>>& system,
                               std::size_t unknowns);

}  // namespace hodograph::rational_detail
