// SPDX-License-Identifier: MIT
// What is refused at the door of everything that takes A and α.
#pragma once

#include <cstddef>
#include <optional>

#include "hodograph/rational/polynomial.hpp"

namespace hodograph::rational_detail {

/// The fault of a degree above its bound.
Fault degree_fault(const char* what, std::size_t degree, std::size_t bound);
/// The fault of A = 0, α = 0, or a degree of one above largest_input_degree, if there is one.
std::optional<Fault> input_fault(const QuaternionPolynomial& a, const RationalPolynomial& alpha);

}  // namespace hodograph::rational_detail
