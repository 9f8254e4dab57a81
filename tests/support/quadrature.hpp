// SPDX-License-Identifier: MIT
// Gauss-Legendre quadrature in any scalar: the plain way to an integral that the library has in
// closed form.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace hodograph::test {

/// Nodes and weights on [0, 1], exact for polynomials of degree 2 count - 1. R is a real type of at
/// most 60 digits: Newton's iteration starts from 3 digits and doubles them in each of its 6 steps.
template <class R, std::size_t count>
std::array<std::pair<R, R>, count> gauss_legendre() {
  std::array<std::pair<R, R>, count> rule;
  const R size(static_cast<double>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const double guess = std::cos(3.141592653589793 * (static_cast<double>(i) + 0.75) /
                                  (static_cast<double>(count) + 0.5));
    R x(guess), slope(0);
    for (int step = 0; step < 7; ++step) {
      R before(1), value = x;  // P_0 and P_1, then (j + 1) P_{j+1} = (2j + 1) x P_j - j P_{j-1}
      for (std::size_t j = 1; j < count; ++j) {
        const R index(static_cast<double>(j));
        const R next = ((R(2) * index + R(1)) * x * value - index * before) / (index + R(1));
        before = value;
        value = next;
      }
      slope = size * (x * value - before) / (x * x - R(1));
      x = x - value / slope;
    }
    rule[i] = {(R(1) + x) / R(2), R(1) / ((R(1) - x * x) * slope * slope)};
  }
  return rule;
}

}  // namespace hodograph::test
