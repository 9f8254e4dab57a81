// SPDX-License-Identifier: MIT
// A number known to lie in a ball: Arb's arb_t as a scalar, so that a function template evaluated
// at a Ball returns an enclosure of its values, and at a Taylor<Ball, K> one of its derivatives.
#pragma once

#include <arb.h>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <stdexcept>

#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/scalar.hpp"

namespace hodograph {

/// A comparison of two balls whose answer depends on which of their members are meant. Thrown, not
/// answered: a function that branches on it would be enclosed on one branch only.
class UndecidedComparison : public std::domain_error {
 public:
  UndecidedComparison() : std::domain_error("a comparison of two overlapping balls is undecided") {}
};

/// The real numbers within a radius of a midpoint. Every operation returns a ball that contains the
/// result of all members of its operands; where some member has no result (a square root of a
/// negative number, a quotient by zero, an angle on both sides of its jump) nothing finite is known
/// and is_finite() says so.
///
/// Midpoints carry `precision` bits and live in the object: no operation here allocates for numbers
/// of ordinary exponent. Source of the bounds: Arb.
class Ball {
 public:
  static constexpr slong precision = 64;

  Ball() noexcept { arb_init(value_); }
  /// Exactly x.
  Ball(double x) : Ball() { arb_set_d(value_, x); }
  template <std::integral T>
  Ball(T x) : Ball() {
    if constexpr (std::is_signed_v<T>) {
      arb_set_si(value_, static_cast<slong>(x));
    } else {
      arb_set_ui(value_, static_cast<ulong>(x));
    }
  }
  template <std::same_as<long double> T>
  Ball(T) = delete;  // would round
  /// All numbers of an enclosure.
  explicit Ball(const Enclosure& x);

  Ball(const Ball& other) : Ball() { arb_set(value_, other.value_); }
  Ball(Ball&& other) noexcept : Ball() { arb_swap(value_, other.value_); }
  Ball& operator=(const Ball& other) {
    arb_set(value_, other.value_);
    return *this;
  }
  Ball& operator=(Ball&& other) noexcept {
    arb_swap(value_, other.value_);
    return *this;
  }
  ~Ball() {
    if (owns_memory()) arb_clear(value_);
  }

  /// All numbers within `radius` ≥ 0 of the ball's members.
  Ball widened(const Ball& radius) const {
    Ball r(*this);
    arb_add_error(r.value_, radius.value_);
    return r;
  }

  /// The double nearest to the midpoint.
  double midpoint() const {
    const arf_struct& m = *arb_midref(value_);
    if (m.size >> 1 == 1 && ordinary_exponent < m.exp && m.exp < -ordinary_exponent) {
      // One limb: the conversion rounds to nearest, the scaling is exact.
      const double size =
          std::ldexp(static_cast<double>(m.d.noptr.d[0]), static_cast<int>(m.exp) - FLINT_BITS);
      return (m.size & 1) != 0 ? -size : size;
    }
    return arf_get_d(&m, ARF_RND_NEAR);
  }
  /// An upper bound of |x - midpoint()| for all members x; infinite where the ball is.
  double radius() const;
  /// An enclosure of all members; the whole line where the ball is not finite.
  Enclosure enclosure() const { return Enclosure(midpoint()) + Enclosure(-radius(), radius()); }

  arb_ptr get() { return value_; }
  arb_srcptr get() const { return value_; }

  /// True for the number 0 itself.
  bool is_zero() const {
    const arf_struct& m = *arb_midref(value_);
    return m.size == 0 && m.exp == 0 && arb_radref(value_)->man == 0 &&
           arb_radref(value_)->exp == 0;
  }

  friend Ball operator+(const Ball& a, const Ball& b) {
    Ball r;
    arb_add(r.value_, a.value_, b.value_, precision);
    return r;
  }
  friend Ball operator-(const Ball& a, const Ball& b) {
    Ball r;
    arb_sub(r.value_, a.value_, b.value_, precision);
    return r;
  }
  friend Ball operator-(const Ball& a) {
    Ball r;
    arb_neg(r.value_, a.value_);
    return r;
  }
  friend Ball operator*(const Ball& a, const Ball& b) {
    Ball r;
    arb_mul(r.value_, a.value_, b.value_, precision);
    return r;
  }
  friend Ball operator/(const Ball& a, const Ball& b) {
    Ball r;
    arb_div(r.value_, a.value_, b.value_, precision);
    return r;
  }
  Ball& operator+=(const Ball& b) { return *this = *this + b; }
  Ball& operator-=(const Ball& b) { return *this = *this - b; }
  Ball& operator*=(const Ball& b) { return *this = *this * b; }
  Ball& operator/=(const Ball& b) { return *this = *this / b; }

  /// True for all members, or false for all members; else throws UndecidedComparison.
  friend bool operator<(const Ball& a, const Ball& b) {
    if (arb_lt(a.value_, b.value_)) return true;
    if (arb_ge(a.value_, b.value_)) return false;
    throw UndecidedComparison();
  }
  friend bool operator>(const Ball& a, const Ball& b) { return b < a; }
  friend bool operator<=(const Ball& a, const Ball& b) { return !(b < a); }
  friend bool operator>=(const Ball& a, const Ball& b) { return !(a < b); }
  friend bool operator==(const Ball& a, const Ball& b) {
    if (arb_eq(a.value_, b.value_)) return true;
    if (arb_ne(a.value_, b.value_)) return false;
    throw UndecidedComparison();
  }

 private:
  // Exponents of midpoints that need no care on their way to double.
  static constexpr slong ordinary_exponent = -1000;

  bool owns_memory() const {
    const arf_struct& m = *arb_midref(value_);
    return ARF_HAS_PTR(&m) || COEFF_IS_MPZ(m.exp) || COEFF_IS_MPZ(arb_radref(value_)->exp);
  }

  arb_t value_;
};

inline bool is_finite(const Ball& a) { return arb_is_finite(a.get()) != 0; }

// ---- elementary functions
// ------------------------------------------------------------------------

Ball sqrt(const Ball& a);
Ball exp(const Ball& a);
Ball log(const Ball& a);
Ball sin(const Ball& a);
Ball cos(const Ball& a);
Ball tan(const Ball& a);
Ball sinh(const Ball& a);
Ball cosh(const Ball& a);
Ball tanh(const Ball& a);
Ball atan(const Ball& a);
Ball asin(const Ball& a);
Ball acos(const Ball& a);
/// The angle of (x, y) in (-π, π); not finite where the ball of (x, y) touches the cut x ≤ 0, y =
/// 0.
Ball atan2(const Ball& y, const Ball& x);
Ball abs(const Ball& a);
Ball pow(const Ball& a, int exponent);
/// a^exponent for a positive base.
Ball pow(const Ball& a, const Ball& exponent);

/// Σ_{j=first..last} a_j b_{k-j} with one rounding: the sum that Taylor arithmetic consists of.
Ball convolution(const Ball* a, const Ball* b, std::size_t k, std::size_t first, std::size_t last);

/// a / count, for small counts by multiplying with an enclosure of the reciprocal.
Ball divided_by_count(const Ball& a, std::size_t count);

}  // namespace hodograph
