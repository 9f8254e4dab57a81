// SPDX-License-Identifier: MIT
// Rational numbers, exactly: the scalar of everything in rational/.
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "hodograph/foundation/result.hpp"

namespace hodograph {

namespace rational_detail {
struct FlintAccess;  // src/rational/flint.hpp: the FLINT values inside
/// Throws std::domain_error: a division by zero, a broken assumption of the caller.
[[noreturn]] void throw_division_by_zero();
}  // namespace rational_detail

/// A rational number in lowest terms, of any size. Arithmetic is exact; a division by zero throws
/// std::domain_error. Source of the arithmetic: FLINT (fmpq).
class Rational {
 public:
  Rational() noexcept : Rational(std::int64_t{0}, Whole{}) {}
  template <std::signed_integral T>
  Rational(T whole) noexcept : Rational(static_cast<std::int64_t>(whole), Whole{}) {}
  /// numerator / denominator in lowest terms; denominator ≠ 0 (contract).
  Rational(std::int64_t numerator, std::int64_t denominator);
  Rational(const Rational& other);
  Rational(Rational&& other) noexcept;
  Rational& operator=(const Rational& other);
  Rational& operator=(Rational&& other) noexcept;
  ~Rational();

  /// The number that a text spells: an optional sign, digits, and "/digits" or ".digits" after
  /// them. Faults: malformed_document with the text, for anything else and for a denominator of 0.
  static Result<Rational> parse(std::string_view text);
  /// Exactly x. Faults: not_finite.
  static Result<Rational> exactly(double x);

  bool equals(const Rational& b) const;
  /// -1, 0 or 1.
  int sign() const;
  bool is_zero() const { return sign() == 0; }
  bool is_integer() const;
  /// The nearest double (within one unit in the last place among subnormal numbers); infinite, or
  /// 0, where the number is outside the range of doubles.
  double to_double() const;
  /// Bits of the numerator and of the denominator, the larger of the two.
  std::size_t bits() const;

  Rational& operator+=(const Rational& b);
  Rational& operator-=(const Rational& b);
  Rational& operator*=(const Rational& b);
  Rational& operator/=(const Rational& b);
  friend Rational operator+(Rational a, const Rational& b) { return a += b; }
  friend Rational operator-(Rational a, const Rational& b) { return a -= b; }
  friend Rational operator*(Rational a, const Rational& b) { return a *= b; }
  friend Rational operator/(Rational a, const Rational& b) { return a /= b; }
  friend Rational operator-(const Rational& a);
  friend constexpr bool operator==(const Rational& a, const Rational& b) {
    return &a == &b || a.equals(b);
  }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b);

 private:
  friend struct rational_detail::FlintAccess;
  struct Whole {};
  Rational(std::int64_t whole, Whole) noexcept;
  alignas(void*) std::byte storage_[2 * sizeof(void*)];
};

/// "p" or "p/q" in lowest terms, q > 0.
std::string to_text(const Rational& x);

}  // namespace hodograph
