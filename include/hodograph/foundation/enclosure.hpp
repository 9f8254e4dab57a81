// SPDX-License-Identifier: MIT
// A bound: an interval [lower, upper] of doubles that contains the true value, rounding included.
//
// Arithmetic on enclosures rounds outwards, so an Enclosure is also a scalar: a polynomial with
// Enclosure coefficients evaluates to a rigorous bound. The outward step is one ulp wider than
// correct rounding would need; it works under the default rounding mode and sets none.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hodograph/foundation/scalar.hpp"

namespace hodograph {

/// The set of reals between two doubles, both included. An operation without a finite answer gives
/// the whole line.
class Enclosure {
 public:
  constexpr Enclosure() = default;
  /// The point x; the whole line where x is not a number.
  constexpr Enclosure(double x) : Enclosure(x, x) {}
  /// The interval [lower, upper]; the whole line where that is not an interval.
  constexpr Enclosure(double lower, double upper) : lower_(lower), upper_(upper) {
    if (!(lower <= upper)) *this = whole_line();
  }

  static constexpr Enclosure whole_line() {
    Enclosure e;
    e.lower_ = -std::numeric_limits<double>::infinity();
    e.upper_ = std::numeric_limits<double>::infinity();
    return e;
  }

  constexpr double lower() const { return lower_; }
  constexpr double upper() const { return upper_; }
  /// Half-way between the ends (rounded).
  constexpr double middle() const { return 0.5 * lower_ + 0.5 * upper_; }
  /// An upper bound of upper - lower.
  constexpr double width() const { return up(upper_ - lower_); }
  /// An upper bound of the absolute value.
  constexpr double magnitude() const { return std::max(-lower_, upper_); }
  /// A lower bound of the absolute value: 0 where the enclosure contains 0.
  constexpr double mignitude() const { return std::max(0.0, std::max(lower_, -upper_)); }
  constexpr bool contains(double x) const { return lower_ <= x && x <= upper_; }
  constexpr bool is_bounded() const { return upper_ - lower_ < infinity; }

  /// The smallest enclosure of both.
  static constexpr Enclosure hull(const Enclosure& a, const Enclosure& b) {
    return {std::min(a.lower_, b.lower_), std::max(a.upper_, b.upper_)};
  }

  friend constexpr Enclosure operator+(const Enclosure& a, const Enclosure& b) {
    return outward(a.lower_ + b.lower_, a.upper_ + b.upper_);
  }
  friend constexpr Enclosure operator-(const Enclosure& a, const Enclosure& b) {
    return outward(a.lower_ - b.upper_, a.upper_ - b.lower_);
  }
  friend constexpr Enclosure operator-(const Enclosure& a) { return {-a.upper_, -a.lower_}; }
  friend constexpr Enclosure operator*(const Enclosure& a, const Enclosure& b) {
    const double p = a.lower_ * b.lower_, q = a.lower_ * b.upper_;
    const double r = a.upper_ * b.lower_, s = a.upper_ * b.upper_;
    if (!(std::abs(p) + std::abs(q) + std::abs(r) + std::abs(s) < infinity)) {
      return whole_line();
    }
    return outward(std::min(std::min(p, q), std::min(r, s)),
                   std::max(std::max(p, q), std::max(r, s)));
  }
  friend constexpr Enclosure operator/(const Enclosure& a, const Enclosure& b) {
    if (b.contains(0.0) || !b.is_bounded() || !a.is_bounded()) return whole_line();
    const double p = a.lower_ / b.lower_, q = a.lower_ / b.upper_;
    const double r = a.upper_ / b.lower_, s = a.upper_ / b.upper_;
    return outward(std::min(std::min(p, q), std::min(r, s)),
                   std::max(std::max(p, q), std::max(r, s)));
  }
  constexpr Enclosure& operator+=(const Enclosure& b) { return *this = *this + b; }
  constexpr Enclosure& operator-=(const Enclosure& b) { return *this = *this - b; }
  constexpr Enclosure& operator*=(const Enclosure& b) { return *this = *this * b; }

  /// Certainly less: every member of a is less than every member of b.
  friend constexpr bool operator<(const Enclosure& a, const Enclosure& b) {
    return a.upper_ < b.lower_;
  }
  /// The same interval (not: the same number).
  friend constexpr bool operator==(const Enclosure&, const Enclosure&) = default;

  /// The next double below (above) x, or one further: a lower (upper) bound of any real number
  /// whose correctly rounded value is x.
  static constexpr double down(double x) { return x - outward_step(x); }
  static constexpr double up(double x) { return x + outward_step(x); }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // Half an ulp of x is at most |x| 2^-53, or 2^-1075 for subnormal results. |x| 2^-52 plus the
  // smallest subnormal exceeds that by enough that the rounded difference is still outside.
  static constexpr double outward_step(double x) {
    return (x < 0 ? -x : x) * 0x1.0p-52 + std::numeric_limits<double>::denorm_min();
  }
  static constexpr Enclosure outward(double lower, double upper) {
    const double l = down(lower), u = up(upper);
    return l <= u ? Enclosure(l, u) : whole_line();
  }

  double lower_ = 0.0, upper_ = 0.0;
};

/// The square: tighter than a * a where a contains 0.
constexpr Enclosure square(const Enclosure& a) {
  const Enclosure size(a.mignitude(), a.magnitude());
  const Enclosure product = size * size;
  return {std::max(0.0, product.lower()), product.upper()};
}

/// The square root of the non-negative part; the whole line where there is none.
inline Enclosure sqrt(const Enclosure& a) {
  if (!(a.upper() >= 0.0) || !a.is_bounded()) return Enclosure::whole_line();
  const double lower = a.lower() > 0.0 ? Enclosure::down(std::sqrt(a.lower())) : 0.0;
  return {std::max(0.0, lower), Enclosure::up(std::sqrt(a.upper()))};
}

inline Enclosure abs(const Enclosure& a) { return {a.mignitude(), a.magnitude()}; }

inline bool is_finite(const Enclosure& a) { return a.is_bounded(); }

}  // namespace hodograph
