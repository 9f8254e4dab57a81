// SPDX-License-Identifier: MIT
// How much exact work is taken on at once: what the program and the Python package refuse.
#pragma once

#include <optional>

#include "hodograph/foundation/fault.hpp"
#include "hodograph/rational/polynomial.hpp"

namespace hodograph {

/// Degree times bits of the numbers of A and of α, together: twice what degrees 64 with numbers of
/// a word have, half a minute's work.
inline constexpr double largest_input_size = 0x1p14;
/// Real zeros are isolated while root_work, degree² · bits of the numbers, is at most this: about a
/// second.
inline constexpr double largest_root_work = 0x1p27;

/// max(1, deg A) · bits of A's numbers + max(1, deg α) · bits of α's. Exact as a whole number.
double input_size(const QuaternionPolynomial& a, const RationalPolynomial& alpha);
/// deg² · bits of p's numbers. Exact as a whole number.
double root_work(const RationalPolynomial& p);

/// Fault unsupported (`value`, `bound`) where input_size is above largest_input_size.
std::optional<Fault> input_size_fault(const QuaternionPolynomial& a,
                                      const RationalPolynomial& alpha);
/// Fault unsupported where root_work is above largest_root_work.
std::optional<Fault> root_work_fault(const RationalPolynomial& p);

}  // namespace hodograph
