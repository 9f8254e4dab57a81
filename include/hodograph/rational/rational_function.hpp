// SPDX-License-Identifier: MIT
// Rational functions of t over ℚ, scalar and vectorial, in lowest terms, and their integrals.
#pragma once

#include <utility>

#include "hodograph/rational/polynomial.hpp"

namespace hodograph {

/// p / q in lowest terms with monic q. Arithmetic is exact; divisions by zero throw
/// std::domain_error.
class RationalFunction {
 public:
  RationalFunction() : denominator_(1) {}
  RationalFunction(RationalPolynomial p) : numerator_(std::move(p)), denominator_(1) {}
  /// p / q, q ≠ 0.
  RationalFunction(const RationalPolynomial& p, const RationalPolynomial& q);

  const RationalPolynomial& numerator() const { return numerator_; }
  const RationalPolynomial& denominator() const { return denominator_; }
  bool is_zero() const { return numerator_.is_zero(); }
  bool is_polynomial() const { return denominator_.is_one(); }
  /// The value at t, which is no pole.
  Rational value(const Rational& t) const { return numerator_.value(t) / denominator_.value(t); }
  RationalFunction derivative() const;

  friend RationalFunction operator+(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator-(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator*(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator/(const RationalFunction& a, const RationalFunction& b);
  friend bool operator==(const RationalFunction&, const RationalFunction&) = default;

 private:
  RationalPolynomial numerator_, denominator_;
};

/// "p", or "(p)/(q)".
std::string to_text(const RationalFunction& f);

/// (p_1, p_2, p_3) / q in lowest terms with monic q: a rational curve in space.
class VectorFunction {
 public:
  VectorFunction() : denominator_(1) {}
  /// p / q, q ≠ 0.
  VectorFunction(const VectorPolynomial& p, const RationalPolynomial& q);

  const VectorPolynomial& numerator() const { return numerator_; }
  const RationalPolynomial& denominator() const { return denominator_; }
  bool is_polynomial() const { return denominator_.is_one(); }
  /// True where the derivative vanishes identically.
  bool is_constant() const { return is_polynomial() && degree(numerator_) <= 0; }
  /// The value at t, which is no pole.
  RationalVector value(const Rational& t) const;
  VectorFunction derivative() const;

  friend VectorFunction operator+(const VectorFunction& a, const VectorFunction& b);
  friend VectorFunction operator-(const VectorFunction& a, const VectorFunction& b);
  friend VectorFunction operator*(const RationalFunction& f, const VectorFunction& a);
  friend bool operator==(const VectorFunction&, const VectorFunction&) = default;

 private:
  VectorPolynomial numerator_;
  RationalPolynomial denominator_;
};
/// a · b.
RationalFunction dot(const VectorFunction& a, const VectorFunction& b);

/// ∫ f = rational + ∫ obstruction, the obstruction with simple poles alone and of negative degree;
/// it is 0 exactly when f has a rational antiderivative. The rational part is the one whose proper
/// part vanishes at infinity and whose polynomial part has no constant term.
struct RationalIntegral {
  RationalFunction rational, obstruction;
};
/// The integral of f. Source: Hermite's reduction.
RationalIntegral integral(const RationalFunction& f);

/// f split over coprime denominators: a polynomial and one proper fraction a_i / q_i^n_i for every
/// irreducible factor of the denominator, in the order of irreducible_factors.
struct PartialFractions {
  RationalPolynomial polynomial;
  struct Part {
    RationalPolynomial pole;  ///< q_i
    RationalFunction value;   ///< a_i / q_i^n_i
  };
  std::vector<Part> parts;
};
PartialFractions partial_fractions(const RationalFunction& f);

}  // namespace hodograph
