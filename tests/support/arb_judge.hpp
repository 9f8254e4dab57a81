// SPDX-License-Identifier: MIT
// Ball arithmetic as the judge of enclosures: a real number known to 200 bits or exactly.
#pragma once

#if HODOGRAPH_TEST_HAS_ARB

#include <arb.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "hodograph/foundation/enclosure.hpp"

namespace hodograph::test {

/// A real number as an Arb ball of 200 bits. Satisfies RingScalar and Scalar, so that polynomials
/// and curves can be evaluated with it.
class Judge {
 public:
  static constexpr slong bits = 200;

  Judge() { arb_init(x_); }
  Judge(double x) : Judge() { arb_set_d(x_, x); }
  Judge(const Judge& other) : Judge() { arb_set(x_, other.x_); }
  Judge(Judge&& other) noexcept : Judge() { arb_swap(x_, other.x_); }
  Judge& operator=(const Judge& other) {
    arb_set(x_, other.x_);
    return *this;
  }
  Judge& operator=(Judge&& other) noexcept {
    arb_swap(x_, other.x_);
    return *this;
  }
  ~Judge() { arb_clear(x_); }

  static Judge from(const arb_t x) {
    Judge result;
    arb_set(result.x_, x);
    return result;
  }

  friend Judge operator+(const Judge& a, const Judge& b) { return made(arb_add, a, b); }
  friend Judge operator-(const Judge& a, const Judge& b) { return made(arb_sub, a, b); }
  friend Judge operator*(const Judge& a, const Judge& b) { return made(arb_mul, a, b); }
  friend Judge operator/(const Judge& a, const Judge& b) { return made(arb_div, a, b); }
  friend Judge operator-(const Judge& a) {
    Judge result;
    arb_neg(result.x_, a.x_);
    return result;
  }
  friend Judge sqrt(const Judge& a) {
    Judge result;
    arb_sqrtpos(result.x_, a.x_, bits);
    return result;
  }
  friend Judge abs(const Judge& a) {
    Judge result;
    arb_abs(result.x_, a.x_);
    return result;
  }
  /// Certainly less.
  friend bool operator<(const Judge& a, const Judge& b) { return arb_lt(a.x_, b.x_) != 0; }

  /// Certainly in [low, high].
  bool certainly_in(double low, double high) const {
    return arb_ge(x_, Judge(low).x_) != 0 && arb_le(x_, Judge(high).x_) != 0;
  }

  double approximately() const { return arf_get_d(arb_midref(x_), ARF_RND_NEAR); }
  std::string text() const {
    char* digits = arb_get_str(x_, 40, 0);
    std::string result(digits);
    flint_free(digits);
    return result;
  }

 private:
  template <class Operation>
  static Judge made(const Operation& operation, const Judge& a, const Judge& b) {
    Judge result;
    operation(result.x_, a.x_, b.x_, bits);
    return result;
  }
  arb_t x_;
};

/// Whether the true value may lie in the enclosure: false only where it certainly does not.
inline ::testing::AssertionResult encloses(const Enclosure& enclosure, const Judge& truth) {
  const bool below = std::isfinite(enclosure.lower()) && truth < Judge(enclosure.lower());
  const bool above = std::isfinite(enclosure.upper()) && Judge(enclosure.upper()) < truth;
  if (!below && !above) return ::testing::AssertionSuccess();
  std::ostringstream text;
  text.precision(17);
  text << "[" << enclosure.lower() << ", " << enclosure.upper() << "] does not contain "
       << truth.text();
  return ::testing::AssertionFailure() << text.str();
}

}  // namespace hodograph::test

#endif  // HODOGRAPH_TEST_HAS_ARB
