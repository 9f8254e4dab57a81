// SPDX-License-Identifier: MIT
// Rational numbers on FLINT's fmpq.
#include "hodograph/rational/rational.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "flint.hpp"

namespace hodograph {

using rational_detail::FlintAccess;
using rational_detail::raw;

namespace rational_detail {
void throw_division_by_zero() { throw std::domain_error("division by zero in exact arithmetic"); }
}  // namespace rational_detail

Rational::Rational(std::int64_t whole, Whole) noexcept {
  fmpq* x = new (FlintAccess::storage(*this)) fmpq;
  fmpq_init(x);
  fmpz_set_si(&x->num, static_cast<slong>(whole));
}

Rational::Rational(std::int64_t numerator, std::int64_t denominator) : Rational(numerator) {
  *this /= Rational(denominator);
}

Rational::Rational(const Rational& other) : Rational() { fmpq_set(raw(*this), raw(other)); }
Rational::Rational(Rational&& other) noexcept : Rational() { fmpq_swap(raw(*this), raw(other)); }
Rational& Rational::operator=(const Rational& other) {
  if (this != &other) fmpq_set(raw(*this), raw(other));
  return *this;
}
Rational& Rational::operator=(Rational&& other) noexcept {
  fmpq_swap(raw(*this), raw(other));
  return *this;
}
Rational::~Rational() { fmpq_clear(raw(*this)); }

Result<Rational> Rational::parse(std::string_view text) {
  const auto refused = [&] {
    return Fault{FaultCode::malformed_document, "\"" + std::string(text) +
                                                    "\" is not a rational number; right would be "
                                                    "3, -3/4 or 0.75"};
  };
  const auto digits_end = [&](std::size_t from) {
    while (from < text.size() && '0' <= text[from] && text[from] <= '9') ++from;
    return from;
  };
  const std::size_t begin = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  std::size_t end = digits_end(begin);
  if (end == begin) return refused();
  std::string numerator(text.substr(begin, end - begin));
  std::string denominator = "1";
  if (end < text.size()) {
    const char mark = text[end];
    const std::size_t second = end + 1;
    const std::size_t second_end = digits_end(second);
    if ((mark != '/' && mark != '.') || second_end == second || second_end != text.size()) {
      return refused();
    }
    const std::string tail(text.substr(second));
    if (mark == '/') {
      denominator = tail;
    } else {
      numerator += tail;
      denominator.append(tail.size(), '0');
    }
  }
  if (denominator.find_first_not_of('0') == std::string::npos) return refused();
  Rational result;
  fmpz_set_str(&raw(result)->num, numerator.c_str(), 10);
  fmpz_set_str(&raw(result)->den, denominator.c_str(), 10);
  fmpq_canonicalise(raw(result));
  if (text[0] == '-') return -result;
  return result;
}

Result<Rational> Rational::exactly(double x) {
  if (!std::isfinite(x)) {
    return Fault{FaultCode::not_finite, "only a finite number is rational; got " + to_text(x),
                 std::nullopt, "x", x};
  }
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  constexpr int digits = std::numeric_limits<double>::digits;
  Rational result(static_cast<std::int64_t>(std::ldexp(fraction, digits)));
  exponent -= digits;
  if (exponent >= 0) {
    fmpq_mul_2exp(raw(result), raw(result), static_cast<ulong>(exponent));
  } else {
    fmpq_div_2exp(raw(result), raw(result), static_cast<ulong>(-exponent));
  }
  return result;
}

int Rational::sign() const { return fmpq_sgn(raw(*this)); }
bool Rational::is_integer() const { return fmpz_is_one(&raw(*this)->den) != 0; }

double Rational::to_double() const {
  if (is_zero()) return 0.0;
  // The quotient |x| 2^shift, of 63 or 64 bits; its last bit is set where something follows, so
  // that the conversion rounds |x| itself.
  const auto top = static_cast<slong>(fmpz_bits(&raw(*this)->num));
  const auto bottom = static_cast<slong>(fmpz_bits(&raw(*this)->den));
  const slong shift = 63 - (top - bottom);
  fmpz_t n, d, rest;
  fmpz_init(n);
  fmpz_init(d);
  fmpz_init(rest);
  fmpz_abs(n, &raw(*this)->num);
  fmpz_set(d, &raw(*this)->den);
  if (shift > 0) fmpz_mul_2exp(n, n, static_cast<ulong>(shift));
  if (shift < 0) fmpz_mul_2exp(d, d, static_cast<ulong>(-shift));
  fmpz_fdiv_qr(n, rest, n, d);
  ulong quotient = fmpz_get_ui(n);
  if (!fmpz_is_zero(rest)) quotient |= 1;
  fmpz_clear(n);
  fmpz_clear(d);
  fmpz_clear(rest);
  constexpr slong beyond = 4096;  // far above and below every exponent of a double
  const auto scale = static_cast<int>(std::clamp<slong>(-shift, -beyond, beyond));
  const double size = std::ldexp(static_cast<double>(quotient), scale);
  return sign() < 0 ? -size : size;
}

std::size_t Rational::bits() const {
  return static_cast<std::size_t>(
      std::max(fmpz_bits(&raw(*this)->num), fmpz_bits(&raw(*this)->den)));
}

Rational& Rational::operator+=(const Rational& b) {
  fmpq_add(raw(*this), raw(*this), raw(b));
  return *this;
}
Rational& Rational::operator-=(const Rational& b) {
  fmpq_sub(raw(*this), raw(*this), raw(b));
  return *this;
}
Rational& Rational::operator*=(const Rational& b) {
  fmpq_mul(raw(*this), raw(*this), raw(b));
  return *this;
}
Rational& Rational::operator/=(const Rational& b) {
  if (b.is_zero()) rational_detail::throw_division_by_zero();
  fmpq_div(raw(*this), raw(*this), raw(b));
  return *this;
}
Rational operator-(const Rational& a) {
  Rational result;
  fmpq_neg(raw(result), raw(a));
  return result;
}
bool Rational::equals(const Rational& b) const { return fmpq_equal(raw(*this), raw(b)) != 0; }
std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
  return fmpq_cmp(raw(a), raw(b)) <=> 0;
}

std::string to_text(const Rational& x) {
  char* text = fmpq_get_str(nullptr, 10, raw(x));
  std::string result(text);
  flint_free(text);
  return result;
}

}  // namespace hodograph
