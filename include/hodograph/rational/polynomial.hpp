// SPDX-License-Identifier: MIT
// Polynomials in t with rational coefficients, exactly, in power form.
#pragma once

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hodograph/algebra/quaternion.hpp"
#include "hodograph/algebra/vector.hpp"
#include "hodograph/rational/rational.hpp"

namespace hodograph {

/// A polynomial Σ c_k t^k over ℚ. Arithmetic is exact. Divisions by the zero polynomial throw
/// std::domain_error. Source of the arithmetic: FLINT (fmpq_poly).
class RationalPolynomial {
 public:
  RationalPolynomial() noexcept;
  template <std::signed_integral T>
  RationalPolynomial(T constant) : RationalPolynomial(Rational(constant)) {}
  RationalPolynomial(const Rational& constant);
  /// The coefficients c_0, c_1, ...
  RationalPolynomial(std::initializer_list<Rational> coefficients);
  explicit RationalPolynomial(std::span<const Rational> coefficients);
  RationalPolynomial(const RationalPolynomial& other);
  RationalPolynomial(RationalPolynomial&& other) noexcept;
  RationalPolynomial& operator=(const RationalPolynomial& other);
  RationalPolynomial& operator=(RationalPolynomial&& other) noexcept;
  ~RationalPolynomial();

  /// c t^k.
  static RationalPolynomial monomial(const Rational& c, std::size_t k);

  bool equals(const RationalPolynomial& b) const;
  /// The degree; -1 for the zero polynomial.
  int degree() const;
  bool is_zero() const { return degree() < 0; }
  /// True for 1.
  bool is_one() const;
  /// True for constants, zero among them.
  bool is_constant() const { return degree() <= 0; }
  /// c_k; 0 above the degree.
  Rational coefficient(std::size_t k) const;
  std::vector<Rational> coefficients() const;
  /// The coefficient of t^degree; 0 for the zero polynomial.
  Rational leading() const;
  /// The largest number of bits of a numerator or denominator of a coefficient.
  std::size_t bits() const;

  /// p(t).
  Rational value(const Rational& t) const;
  /// p'.
  RationalPolynomial derivative() const;
  /// p^(k) / k!, the coefficient of s^k in p(t + s).
  RationalPolynomial taylor_coefficient(std::size_t k) const;
  /// The antiderivative without constant term.
  RationalPolynomial integral() const;
  /// p / leading(); the zero polynomial as it is.
  RationalPolynomial monic() const;
  /// p(t + c).
  RationalPolynomial shifted(const Rational& c) const;
  /// t^k p, k ≥ 0.
  RationalPolynomial times_power(std::size_t k) const;
  /// p^k.
  RationalPolynomial power(std::size_t k) const;

  RationalPolynomial& operator+=(const RationalPolynomial& b);
  RationalPolynomial& operator-=(const RationalPolynomial& b);
  RationalPolynomial& operator*=(const RationalPolynomial& b);
  friend RationalPolynomial operator+(RationalPolynomial a, const RationalPolynomial& b) {
    return a += b;
  }
  friend RationalPolynomial operator-(RationalPolynomial a, const RationalPolynomial& b) {
    return a -= b;
  }
  friend RationalPolynomial operator*(const RationalPolynomial& a, const RationalPolynomial& b);
  friend RationalPolynomial operator-(const RationalPolynomial& a);
  /// The quotient of the division with remainder: a = (a / b) b + a % b, deg(a % b) < deg b.
  friend RationalPolynomial operator/(const RationalPolynomial& a, const RationalPolynomial& b);
  friend RationalPolynomial operator%(const RationalPolynomial& a, const RationalPolynomial& b);
  friend constexpr bool operator==(const RationalPolynomial& a, const RationalPolynomial& b) {
    return &a == &b || a.equals(b);
  }

 private:
  friend struct rational_detail::FlintAccess;
  alignas(void*) std::byte storage_[4 * sizeof(void*)];
};

/// The monic greatest common divisor; 0 where both are 0.
RationalPolynomial gcd(const RationalPolynomial& a, const RationalPolynomial& b);
/// True when b divides a; only 0 is divided by 0.
bool divides(const RationalPolynomial& b, const RationalPolynomial& a);

/// One factor q^multiplicity of a polynomial, q monic.
struct PolynomialFactor {
  RationalPolynomial factor;
  std::size_t multiplicity = 1;
  friend bool operator==(const PolynomialFactor&, const PolynomialFactor&) = default;
};
/// p = leading() Π q_n^n with square-free, pairwise coprime, monic q_n ≠ 1, by increasing n (Yun).
/// Empty for constants.
std::vector<PolynomialFactor> square_free_factors(const RationalPolynomial& p);
/// The same with factors irreducible over ℚ, by degree, then multiplicity, then coefficients.
std::vector<PolynomialFactor> irreducible_factors(const RationalPolynomial& p);
/// The monic product of the distinct irreducible factors of p ≠ 0.
RationalPolynomial radical(const RationalPolynomial& p);

/// "t^3 - 2*t + 1/2", highest power first; "0" for the zero polynomial.
std::string to_text(const RationalPolynomial& p, std::string_view variable = "t");

/// A point of space over ℚ, a vector of polynomials, and a quaternion polynomial Σ a_k t^k, whose
/// variable commutes with the coefficients.
using RationalVector = Vector3<Rational>;
using VectorPolynomial = Vector3<RationalPolynomial>;
using QuaternionPolynomial = Quaternion<RationalPolynomial>;

/// det(a, b, c) = a · (b × c).
RationalPolynomial determinant(const VectorPolynomial& a, const VectorPolynomial& b,
                               const VectorPolynomial& c);
/// The value, derivative and Taylor coefficient of every component.
RationalVector value(const VectorPolynomial& a, const Rational& t);
VectorPolynomial derivative(const VectorPolynomial& a);
QuaternionPolynomial derivative(const QuaternionPolynomial& a);
VectorPolynomial taylor_coefficient(const VectorPolynomial& a, std::size_t k);
/// The monic greatest common divisor of the components; 0 for the zero vector.
RationalPolynomial content(const VectorPolynomial& a);
RationalPolynomial content(const QuaternionPolynomial& a);
/// The largest degree of a component; -1 for zero.
int degree(const VectorPolynomial& a);
int degree(const QuaternionPolynomial& a);
/// Every component divided by b, which divides it (contract).
VectorPolynomial divided(const VectorPolynomial& a, const RationalPolynomial& b);
QuaternionPolynomial divided(const QuaternionPolynomial& a, const RationalPolynomial& b);

}  // namespace hodograph
