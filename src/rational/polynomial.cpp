// SPDX-License-Identifier: MIT
// Polynomials over the rationals on FLINT's fmpq_poly, and the factorisations they have.
#include "hodograph/rational/polynomial.hpp"

#include <fmpz_poly_factor.h>

#include <algorithm>
#include <cassert>

#include "flint.hpp"

namespace hodograph {

using rational_detail::FlintAccess;
using rational_detail::IntegerPolynomial;
using rational_detail::raw;
using rational_detail::signed_size;

RationalPolynomial::RationalPolynomial() noexcept {
  fmpq_poly_init(new (FlintAccess::storage(*this)) fmpq_poly_struct);
}
RationalPolynomial::RationalPolynomial(const Rational& constant) : RationalPolynomial() {
  fmpq_poly_set_fmpq(raw(*this), raw(constant));
}
RationalPolynomial::RationalPolynomial(std::initializer_list<Rational> coefficients)
    : RationalPolynomial(std::span<const Rational>(coefficients.begin(), coefficients.size())) {}
RationalPolynomial::RationalPolynomial(std::span<const Rational> coefficients)
    : RationalPolynomial() {
  for (std::size_t k = coefficients.size(); k-- > 0;) {
    fmpq_poly_set_coeff_fmpq(raw(*this), signed_size(k), raw(coefficients[k]));
  }
}
RationalPolynomial::RationalPolynomial(const RationalPolynomial& other) : RationalPolynomial() {
  fmpq_poly_set(raw(*this), raw(other));
}
RationalPolynomial::RationalPolynomial(RationalPolynomial&& other) noexcept : RationalPolynomial() {
  fmpq_poly_swap(raw(*this), raw(other));
}
RationalPolynomial& RationalPolynomial::operator=(const RationalPolynomial& other) {
  if (this != &other) fmpq_poly_set(raw(*this), raw(other));
  return *this;
}
RationalPolynomial& RationalPolynomial::operator=(RationalPolynomial&& other) noexcept {
  fmpq_poly_swap(raw(*this), raw(other));
  return *this;
}
RationalPolynomial::~RationalPolynomial() { fmpq_poly_clear(raw(*this)); }

RationalPolynomial RationalPolynomial::monomial(const Rational& c, std::size_t k) {
  RationalPolynomial result;
  fmpq_poly_set_coeff_fmpq(raw(result), signed_size(k), raw(c));
  return result;
}

int RationalPolynomial::degree() const { return static_cast<int>(fmpq_poly_degree(raw(*this))); }
bool RationalPolynomial::is_one() const { return fmpq_poly_is_one(raw(*this)) != 0; }

Rational RationalPolynomial::coefficient(std::size_t k) const {
  Rational result;
  fmpq_poly_get_coeff_fmpq(raw(result), raw(*this), signed_size(k));
  return result;
}
std::vector<Rational> RationalPolynomial::coefficients() const {
  std::vector<Rational> result;
  for (int k = 0; k <= degree(); ++k) result.push_back(coefficient(static_cast<std::size_t>(k)));
  return result;
}
Rational RationalPolynomial::leading() const {
  return is_zero() ? Rational() : coefficient(static_cast<std::size_t>(degree()));
}
std::size_t RationalPolynomial::bits() const {
  std::size_t result = 0;
  for (const Rational& c : coefficients()) result = std::max(result, c.bits());
  return result;
}

Rational RationalPolynomial::value(const Rational& t) const {
  Rational result;
  fmpq_poly_evaluate_fmpq(raw(result), raw(*this), raw(t));
  return result;
}
RationalPolynomial RationalPolynomial::derivative() const {
  RationalPolynomial result;
  fmpq_poly_derivative(raw(result), raw(*this));
  return result;
}
RationalPolynomial RationalPolynomial::taylor_coefficient(std::size_t k) const {
  RationalPolynomial result;
  if (k >= static_cast<std::size_t>(fmpq_poly_length(raw(*this)))) return result;  // spare k!
  fmpq_poly_nth_derivative(raw(result), raw(*this), static_cast<ulong>(k));
  fmpz_t factorial;
  fmpz_init(factorial);
  fmpz_fac_ui(factorial, static_cast<ulong>(k));
  fmpq_poly_scalar_div_fmpz(raw(result), raw(result), factorial);
  fmpz_clear(factorial);
  return result;
}
RationalPolynomial RationalPolynomial::integral() const {
  RationalPolynomial result;
  fmpq_poly_integral(raw(result), raw(*this));
  return result;
}
RationalPolynomial RationalPolynomial::monic() const {
  RationalPolynomial result;
  if (!is_zero()) fmpq_poly_make_monic(raw(result), raw(*this));
  return result;
}
RationalPolynomial RationalPolynomial::shifted(const Rational& c) const {
  RationalPolynomial result;
  fmpq_poly_compose(raw(result), raw(*this), raw(RationalPolynomial{c, Rational(1)}));
  return result;
}
RationalPolynomial RationalPolynomial::times_power(std::size_t k) const {
  RationalPolynomial result;
  fmpq_poly_shift_left(raw(result), raw(*this), signed_size(k));
  return result;
}
RationalPolynomial RationalPolynomial::power(std::size_t k) const {
  RationalPolynomial result;
  fmpq_poly_pow(raw(result), raw(*this), static_cast<ulong>(k));
  return result;
}

RationalPolynomial& RationalPolynomial::operator+=(const RationalPolynomial& b) {
  fmpq_poly_add(raw(*this), raw(*this), raw(b));
  return *this;
}
RationalPolynomial& RationalPolynomial::operator-=(const RationalPolynomial& b) {
  fmpq_poly_sub(raw(*this), raw(*this), raw(b));
  return *this;
}
RationalPolynomial& RationalPolynomial::operator*=(const RationalPolynomial& b) {
  fmpq_poly_mul(raw(*this), raw(*this), raw(b));
  return *this;
}
RationalPolynomial operator*(const RationalPolynomial& a, const RationalPolynomial& b) {
  RationalPolynomial result;
  fmpq_poly_mul(raw(result), raw(a), raw(b));
  return result;
}
RationalPolynomial operator-(const RationalPolynomial& a) {
  RationalPolynomial result;
  fmpq_poly_neg(raw(result), raw(a));
  return result;
}
RationalPolynomial operator/(const RationalPolynomial& a, const RationalPolynomial& b) {
  if (b.is_zero()) rational_detail::throw_division_by_zero();
  RationalPolynomial result;
  fmpq_poly_div(raw(result), raw(a), raw(b));
  return result;
}
RationalPolynomial operator%(const RationalPolynomial& a, const RationalPolynomial& b) {
  if (b.is_zero()) rational_detail::throw_division_by_zero();
  RationalPolynomial result;
  fmpq_poly_rem(raw(result), raw(a), raw(b));
  return result;
}
bool RationalPolynomial::equals(const RationalPolynomial& b) const {
  return fmpq_poly_equal(raw(*this), raw(b)) != 0;
}

RationalPolynomial gcd(const RationalPolynomial& a, const RationalPolynomial& b) {
  RationalPolynomial result;
  fmpq_poly_gcd(raw(result), raw(a), raw(b));
  return result;
}
bool divides(const RationalPolynomial& b, const RationalPolynomial& a) {
  return a.is_zero() || (!b.is_zero() && (a % b).is_zero());
}

namespace {

template <class Factorise>
std::vector<PolynomialFactor> factors(const RationalPolynomial& p, const Factorise& factorise) {
  std::vector<PolynomialFactor> result;
  if (p.is_constant()) return result;
  const IntegerPolynomial whole(p);
  fmpz_poly_factor_t found;
  fmpz_poly_factor_init(found);
  factorise(found, whole.get());
  for (slong i = 0; i < found->num; ++i) {
    RationalPolynomial q;
    fmpq_poly_set_fmpz_poly(raw(q), found->p + i);
    if (q.is_constant()) continue;
    result.push_back({q.monic(), static_cast<std::size_t>(found->exp[i])});
  }
  fmpz_poly_factor_clear(found);
  return result;
}

}  // namespace

std::vector<PolynomialFactor> square_free_factors(const RationalPolynomial& p) {
  auto result = factors(p, [](fmpz_poly_factor_struct* found, const fmpz_poly_struct* whole) {
    fmpz_poly_factor_squarefree(found, whole);
  });
  std::sort(result.begin(), result.end(),
            [](const auto& a, const auto& b) { return a.multiplicity < b.multiplicity; });
  // A power of t may come as a factor of its own.
  std::vector<PolynomialFactor> merged;
  for (PolynomialFactor& f : result) {
    if (!merged.empty() && merged.back().multiplicity == f.multiplicity) {
      merged.back().factor *= f.factor;
    } else {
      merged.push_back(std::move(f));
    }
  }
  return merged;
}

std::vector<PolynomialFactor> irreducible_factors(const RationalPolynomial& p) {
  auto result = factors(p, [](fmpz_poly_factor_struct* found, const fmpz_poly_struct* whole) {
    fmpz_poly_factor(found, whole);
  });
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    if (a.factor.degree() != b.factor.degree()) return a.factor.degree() < b.factor.degree();
    if (a.multiplicity != b.multiplicity) return a.multiplicity < b.multiplicity;
    return fmpq_poly_cmp(raw(a.factor), raw(b.factor)) > 0;
  });
  return result;
}

RationalPolynomial radical(const RationalPolynomial& p) {
  assert(!p.is_zero());
  return (p / gcd(p, p.derivative())).monic();
}

std::string to_text(const RationalPolynomial& p, std::string_view variable) {
  if (p.is_zero()) return "0";
  std::string text;
  for (int k = p.degree(); k >= 0; --k) {
    const Rational c = p.coefficient(static_cast<std::size_t>(k));
    if (c.is_zero()) continue;
    const bool negative = c.sign() < 0;
    if (text.empty()) {
      if (negative) text += "-";
    } else {
      text += negative ? " - " : " + ";
    }
    const Rational size = negative ? -c : c;
    const bool one = size == Rational(1);
    if (!one || k == 0) text += to_text(size);
    if (k == 0) continue;
    if (!one) text += "*";
    text += variable;
    if (k > 1) text += "^" + std::to_string(k);
  }
  return text;
}

RationalPolynomial determinant(const VectorPolynomial& a, const VectorPolynomial& b,
                               const VectorPolynomial& c) {
  return dot(a, cross(b, c));
}
RationalVector value(const VectorPolynomial& a, const Rational& t) {
  return {a.x.value(t), a.y.value(t), a.z.value(t)};
}
VectorPolynomial derivative(const VectorPolynomial& a) {
  return {a.x.derivative(), a.y.derivative(), a.z.derivative()};
}
QuaternionPolynomial derivative(const QuaternionPolynomial& a) {
  return {a.w.derivative(), a.x.derivative(), a.y.derivative(), a.z.derivative()};
}
VectorPolynomial taylor_coefficient(const VectorPolynomial& a, std::size_t k) {
  return {a.x.taylor_coefficient(k), a.y.taylor_coefficient(k), a.z.taylor_coefficient(k)};
}
RationalPolynomial content(const VectorPolynomial& a) { return gcd(gcd(a.x, a.y), a.z); }
RationalPolynomial content(const QuaternionPolynomial& a) {
  return gcd(gcd(a.w, a.x), gcd(a.y, a.z));
}
int degree(const VectorPolynomial& a) {
  return std::max({a.x.degree(), a.y.degree(), a.z.degree()});
}
int degree(const QuaternionPolynomial& a) {
  return std::max({a.w.degree(), a.x.degree(), a.y.degree(), a.z.degree()});
}
VectorPolynomial divided(const VectorPolynomial& a, const RationalPolynomial& b) {
  assert(divides(b, content(a)));
  return {a.x / b, a.y / b, a.z / b};
}
QuaternionPolynomial divided(const QuaternionPolynomial& a, const RationalPolynomial& b) {
  assert(divides(b, content(a)));
  return {a.w / b, a.x / b, a.y / b, a.z / b};
}

}  // namespace hodograph
