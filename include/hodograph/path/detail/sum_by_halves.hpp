// SPDX-License-Identifier: MIT
// A sum whose rounding grows with the logarithm of the number of terms.
#pragma once

#include <cstddef>
#include <vector>

namespace hodograph::path_detail {

/// The sum of the numbers, 0 for none: neighbours two by two, then their sums.
template <class S>
S sum_by_halves(std::vector<S> numbers) {
  for (std::size_t stride = 1; stride < numbers.size(); stride *= 2) {
    for (std::size_t k = 0; k + stride < numbers.size(); k += 2 * stride) {
      numbers[k] = numbers[k] + numbers[k + stride];
    }
  }
  return numbers.empty() ? S(0.0) : numbers[0];
}

}  // namespace hodograph::path_detail
