// SPDX-License-Identifier: MIT
// A bound: an interval [lower, upper] of doubles that contains the true value, rounding included.
//
// Arithmetic on enclosures rounds outwards, so an Enclosure is also a scalar: a polynomial with
// Enclosure coefficients evaluates to a rigorous bound. An end moves outwards by one or two ulps,
// where correct rounding would move it by at most one; adding 0, multiplying by 0 and changing the
// sign are exact, and no product or sum crosses zero by its outward step. It works under the
// default rounding mode with gradual underflow (no flush to zero), and sets neither.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hodograph/foundation/scalar.hpp"

namespace hodograph {

/// The set of reals between two doubles, both included; an end that is infinite means that there is
/// no bound on that side. An operation without a finite answer gives the whole line.
class Enclosure {
 public:
  constexpr Enclosure() = default;
  /// The point x; the whole line where x is not a finite number.
  constexpr Enclosure(double x) : Enclosure(x, x) {}
  /// The interval [lower, upper]; the whole line where that contains no real number.
  constexpr Enclosure(double lower, double upper) : lower_(lower), upper_(upper) {
    if (!(lower <= upper && lower < infinity && -infinity < upper)) *this = whole_line();
  }

  static constexpr Enclosure whole_line() {
    Enclosure e;
    e.lower_ = -infinity;
    e.upper_ = infinity;
    return e;
  }

  constexpr double lower() const { return lower_; }
  constexpr double upper() const { return upper_; }
  /// Half-way between the ends (rounded), finite and between them also where an end is infinite.
  constexpr double middle() const {
    const double l = std::max(lower_, -largest), u = std::min(upper_, largest);
    return std::min(std::max(0.5 * l + 0.5 * u, l), u);
  }
  /// An upper bound of upper - lower.
  constexpr double width() const { return outward_sum(0.0, upper_ - lower_).upper_; }
  /// An upper bound of the absolute value.
  constexpr double magnitude() const { return std::max(-lower_, upper_); }
  /// A lower bound of the absolute value: 0 where the enclosure contains 0.
  constexpr double mignitude() const { return std::max(0.0, std::max(lower_, -upper_)); }
  constexpr bool contains(double x) const { return lower_ <= x && x <= upper_; }
  constexpr bool is_bounded() const { return -infinity < lower_ && upper_ < infinity; }
  /// True for the single number 0.
  constexpr bool is_zero() const { return lower_ == 0.0 && upper_ == 0.0; }

  /// The smallest enclosure of both.
  static constexpr Enclosure hull(const Enclosure& a, const Enclosure& b) {
    return {std::min(a.lower_, b.lower_), std::max(a.upper_, b.upper_)};
  }

  friend constexpr Enclosure operator+(const Enclosure& a, const Enclosure& b) {
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    return outward_sum(a.lower_ + b.lower_, a.upper_ + b.upper_);
  }
  friend constexpr Enclosure operator-(const Enclosure& a, const Enclosure& b) {
    if (a.is_zero()) return -b;
    if (b.is_zero()) return a;
    return outward_sum(a.lower_ - b.upper_, a.upper_ - b.lower_);
  }
  friend constexpr Enclosure operator-(const Enclosure& a) { return {-a.upper_, -a.lower_}; }
  friend constexpr Enclosure operator*(const Enclosure& a, const Enclosure& b) {
    const double p = a.lower_ * b.lower_, q = a.lower_ * b.upper_;
    const double r = a.upper_ * b.lower_, s = a.upper_ * b.upper_;
    const double low = std::min(std::min(p, q), std::min(r, s));
    const double high = std::max(std::max(p, q), std::max(r, s));
    if (!a.is_bounded() || !b.is_bounded()) return whole_line();
    if (low == high && (a.is_zero() || b.is_zero())) return Enclosure(0.0);
    return with_sign(outward(low, high), a, b);
  }
  friend constexpr Enclosure operator/(const Enclosure& a, const Enclosure& b) {
    if (b.contains(0.0) || !b.is_bounded() || !a.is_bounded()) return whole_line();
    const double p = a.lower_ / b.lower_, q = a.lower_ / b.upper_;
    const double r = a.upper_ / b.lower_, s = a.upper_ / b.upper_;
    return with_sign(
        outward(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s))),
        a, b);
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
  /// whose correctly rounded value is x. An overflowed value bounds by the largest finite double.
  static constexpr double down(double x) {
    return x == infinity ? largest : x - (size(x) * relative_step + smallest);
  }
  static constexpr double up(double x) {
    return x == -infinity ? -largest : x + (size(x) * relative_step + smallest);
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double largest = std::numeric_limits<double>::max();

  // The correctly rounded x of a real number is at most half an ulp from it. For 2^e ≤ |x| <
  // 2^(e+1), e ≥ -1022, one ulp is 2^(e-52) ≤ |x| 2^-52; below, it is 2^-1074. An ulp is a double
  // and rounding is monotone, so the computed |x| 2^-52 + 2^-1074 is at least one ulp, and x plus
  // or minus it is the neighbour of x or beyond.
  static constexpr double relative_step = 0x1.0p-52;
  static constexpr double smallest = std::numeric_limits<double>::denorm_min();

  static constexpr double size(double x) { return x < 0 ? -x : x; }
  static constexpr Enclosure outward(double lower, double upper) {
    return {down(lower), up(upper)};
  }
  // Sums below 2^-1022 are exact, since every double is a multiple of 2^-1074; above, the computed
  // |x| 2^-52 is at least one ulp. So a sum needs no absolute step, and an exact 0 stays 0.
  static constexpr Enclosure outward_sum(double lower, double upper) {
    return {lower == infinity ? largest : lower - size(lower) * relative_step,
            upper == -infinity ? -largest : upper + size(upper) * relative_step};
  }
  // The sign that a product or quotient has whatever the members is not lost to the outward step.
  static constexpr Enclosure with_sign(const Enclosure& e, const Enclosure& a, const Enclosure& b) {
    const bool not_negative = (a.lower_ >= 0 && b.lower_ >= 0) || (a.upper_ <= 0 && b.upper_ <= 0);
    const bool not_positive = (a.lower_ >= 0 && b.upper_ <= 0) || (a.upper_ <= 0 && b.lower_ >= 0);
    return {not_negative ? std::max(e.lower_, 0.0) : e.lower_,
            not_positive ? std::min(e.upper_, 0.0) : e.upper_};
  }

  double lower_ = 0.0, upper_ = 0.0;
};

/// The square: tighter than a * a where a contains 0.
constexpr Enclosure square(const Enclosure& a) {
  const Enclosure size(a.mignitude(), a.magnitude());
  if (size.is_bounded()) return size * size;
  const double least = Enclosure::down(size.lower() * size.lower());
  return {std::max(least, 0.0), size.upper()};
}

/// The square root of the non-negative part; the whole line where there is none.
inline Enclosure sqrt(const Enclosure& a) {
  if (a.upper() < 0.0) return Enclosure::whole_line();
  const double lower = a.lower() > 0.0 ? Enclosure::down(std::sqrt(a.lower())) : 0.0;
  const double upper = a.upper() > 0.0 ? Enclosure::up(std::sqrt(a.upper())) : 0.0;
  return {std::max(0.0, lower), upper};
}

inline Enclosure abs(const Enclosure& a) { return {a.mignitude(), a.magnitude()}; }

inline bool is_finite(const Enclosure& a) { return a.is_bounded(); }

}  // namespace hodograph
