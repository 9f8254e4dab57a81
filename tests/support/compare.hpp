// SPDX-License-Identifier: MIT
// The one comparator of the tests: a difference, counted in epsilons of the scalar, of a stated
// scale.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <sstream>
#include <type_traits>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/foundation/scalar.hpp"
#include "hodograph/foundation/taylor.hpp"

namespace hodograph::test {

namespace compare_detail {

/// Calls visit(a_i, e_i) for every pair of real numbers in two values of the same shape: numbers,
/// Taylor series (every coefficient), vectors, complex numbers, quaternions, frames, arrays.
/// Returns false where the shapes differ in size.
template <class A, class E, class Visit>
bool for_each_number(const A& actual, const E& expected, const Visit& visit) {
  if constexpr (requires { A::dimension; }) {
    static_assert(A::dimension == E::dimension);
    for (std::size_t i = 0; i < A::dimension; ++i) {
      if (!for_each_number(actual[i], expected[i], visit)) return false;
    }
    return true;
  } else if constexpr (requires { A::order; }) {
    static_assert(A::order == E::order);
    for (std::size_t i = 0; i <= A::order; ++i) {
      if (!for_each_number(actual[i], expected[i], visit)) return false;
    }
    return true;
  } else if constexpr (requires { actual.e3; }) {
    return for_each_number(actual.e1, expected.e1, visit) &&
           for_each_number(actual.e2, expected.e2, visit) &&
           for_each_number(actual.e3, expected.e3, visit);
  } else if constexpr (requires { actual.e2; }) {
    return for_each_number(actual.e1, expected.e1, visit) &&
           for_each_number(actual.e2, expected.e2, visit);
  } else if constexpr (requires {
                         actual.size();
                         actual[0];
                       }) {
    if (actual.size() != expected.size()) return false;
    for (std::size_t i = 0; i < actual.size(); ++i) {
      if (!for_each_number(actual[i], expected[i], visit)) return false;
    }
    return true;
  } else {
    visit(actual, expected);
    return true;
  }
}

}  // namespace compare_detail

/// Whether every number of `actual` is within tolerance_in_eps · ε · scale of its counterpart in
/// `expected`, where ε is the epsilon of actual's scalar. The difference is taken in expected's
/// scalar, which may be wider. A NaN or an infinity is close to nothing. There is no default
/// tolerance: it is derived where it is used, and the scale is the size of the terms that were
/// rounded.
template <class A, class E, class Scale>
::testing::AssertionResult is_close(const char* actual_text, const char* expected_text, const char*,
                                    const char*, const A& actual, const E& expected,
                                    double tolerance_in_eps, const Scale& scale) {
  std::ostringstream problems;
  std::size_t position = 0, wrong = 0;
  const bool same_size =
      compare_detail::for_each_number(actual, expected, [&](const auto& a, const auto& e) {
        using Wide = std::remove_cvref_t<decltype(e)>;
        using Narrow = real_of_t<std::remove_cvref_t<decltype(a)>>;
        using std::abs;
        // Integers are exact: compare in the actual number's scalar.
        using Difference = std::conditional_t<std::is_integral_v<Wide>, Narrow, Wide>;
        const Difference difference = abs(Difference(Difference(a) - Difference(e)));
        const Difference unit =
            Difference(epsilon<Narrow>()) * Difference(abs(Difference(value_of(scale))));
        if (!(difference <= Difference(tolerance_in_eps) * unit)) {
          if (++wrong <= 8) {
            problems.precision(21);
            problems << "\n  number " << position << ": actual " << a << ", expected " << e
                     << ", difference " << difference;
            if (unit > Difference(0)) {
              problems << " = " << static_cast<double>(Difference(difference / unit))
                       << " eps of the scale";
            }
          }
        }
        ++position;
      });
  if (!same_size) {
    return ::testing::AssertionFailure()
           << actual_text << " and " << expected_text << " differ in size";
  }
  if (wrong == 0) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << actual_text << " is not within " << tolerance_in_eps << " eps of " << expected_text
         << " (" << wrong << " of " << position << " numbers):" << problems.str();
}

/// 2^r n!/(n-r)!: what derivative r on [0, 1] of a polynomial of degree n makes of an error of its
/// Bernstein coefficients.
inline double growth(std::size_t n, std::size_t r) {
  double factor = 1.0;
  for (std::size_t j = 0; j < r; ++j) factor *= 2.0 * static_cast<double>(n - j);
  return factor;
}

}  // namespace hodograph::test

/// EXPECT_CLOSE(actual, expected, tolerance_in_eps, scale); see hodograph::test::is_close.
#define EXPECT_CLOSE(actual, expected, tolerance_in_eps, scale) \
  EXPECT_PRED_FORMAT4(::hodograph::test::is_close, actual, expected, tolerance_in_eps, scale)
#define ASSERT_CLOSE(actual, expected, tolerance_in_eps, scale) \
  ASSERT_PRED_FORMAT4(::hodograph::test::is_close, actual, expected, tolerance_in_eps, scale)
