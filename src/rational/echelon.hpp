// SPDX-License-Identifier: MIT
// Reduced row echelon forms of matrices whose rows are nearly in echelon form, over the integers.
#pragma once

#include <cstddef>
#include <vector>

#include "flint.hpp"

namespace hodograph::rational_detail {

/// The reduced row echelon form of a matrix over ℚ: row i is rows(i, ·) / rows(i, pivots[i]).
struct Echelon {
  IntegerMatrix rows;               ///< primitive rows with positive pivots; the last may be zero
  std::vector<std::size_t> pivots;  ///< increasing, one a row that is not zero
};

/// The echelon form of a matrix over ℤ. Rows with leading entries in different columns are not
/// touched on the way down, and on the way up every row is combined once with those below it in
/// whose pivot columns it has an entry: banded matrices stay cheap.
Echelon reduced_echelon(IntegerMatrix matrix);

}  // namespace hodograph::rational_detail
