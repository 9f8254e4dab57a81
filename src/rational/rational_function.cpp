// SPDX-License-Identifier: MIT
// Rational functions in lowest terms; Hermite's reduction; partial fractions.
#include "hodograph/rational/rational_function.hpp"

#include "flint.hpp"
#include "hermite_reduction.hpp"

namespace hodograph {

using rational_detail::raw;

namespace {

/// p / q for q ≠ 0 in lowest terms with a monic denominator: of polynomials and of their vectors.
RationalPolynomial divided(const RationalPolynomial& p, const RationalPolynomial& common) {
  return p / common;
}
const RationalPolynomial& content(const RationalPolynomial& p) { return p; }
template <class Numerator>
void reduce(const Numerator& p, const RationalPolynomial& q, Numerator& numerator,
            RationalPolynomial& denominator) {
  if (q.is_zero()) rational_detail::throw_division_by_zero();
  const RationalPolynomial common = gcd(content(p), q);
  const RationalPolynomial scale(Rational(1) / q.leading());
  numerator = scale * divided(p, common);
  denominator = (q / common).monic();
}

}  // namespace

RationalFunction::RationalFunction(const RationalPolynomial& p, const RationalPolynomial& q) {
  reduce(p, q, numerator_, denominator_);
}

RationalFunction RationalFunction::derivative() const {
  return {numerator_.derivative() * denominator_ - numerator_ * denominator_.derivative(),
          denominator_ * denominator_};
}

RationalFunction operator+(const RationalFunction& a, const RationalFunction& b) {
  return {a.numerator_ * b.denominator_ + b.numerator_ * a.denominator_,
          a.denominator_ * b.denominator_};
}
RationalFunction operator-(const RationalFunction& a, const RationalFunction& b) {
  return {a.numerator_ * b.denominator_ - b.numerator_ * a.denominator_,
          a.denominator_ * b.denominator_};
}
RationalFunction operator*(const RationalFunction& a, const RationalFunction& b) {
  return {a.numerator_ * b.numerator_, a.denominator_ * b.denominator_};
}
RationalFunction operator/(const RationalFunction& a, const RationalFunction& b) {
  return {a.numerator_ * b.denominator_, a.denominator_ * b.numerator_};
}

std::string to_text(const RationalFunction& f) {
  if (f.is_polynomial()) return to_text(f.numerator());
  return "(" + to_text(f.numerator()) + ")/(" + to_text(f.denominator()) + ")";
}

VectorFunction::VectorFunction(const VectorPolynomial& p, const RationalPolynomial& q) {
  reduce(p, q, numerator_, denominator_);
}

RationalVector VectorFunction::value(const Rational& t) const {
  const Rational scale = Rational(1) / denominator_.value(t);
  return scale * hodograph::value(numerator_, t);
}
VectorFunction VectorFunction::derivative() const {
  return {denominator_ * hodograph::derivative(numerator_) - denominator_.derivative() * numerator_,
          denominator_ * denominator_};
}
VectorFunction operator+(const VectorFunction& a, const VectorFunction& b) {
  return {b.denominator_ * a.numerator_ + a.denominator_ * b.numerator_,
          a.denominator_ * b.denominator_};
}
VectorFunction operator-(const VectorFunction& a, const VectorFunction& b) {
  return {b.denominator_ * a.numerator_ - a.denominator_ * b.numerator_,
          a.denominator_ * b.denominator_};
}
VectorFunction operator*(const RationalFunction& f, const VectorFunction& a) {
  return {f.numerator() * a.numerator_, f.denominator() * a.denominator_};
}
RationalFunction dot(const VectorFunction& a, const VectorFunction& b) {
  return {dot(a.numerator(), b.numerator()), a.denominator() * b.denominator()};
}

RationalIntegral integral(const RationalFunction& f) {
  // p / q = p rad q / (q rad q) + a polynomial.
  const RationalPolynomial& q = f.denominator();
  const RationalPolynomial whole = f.numerator() / q;
  const rational_detail::HermiteReduction reduction(q);
  const auto parts = reduction.reduce((f.numerator() % q) * reduction.radical());
  return {RationalFunction(parts.rational, q) + RationalFunction(whole.integral()),
          RationalFunction(parts.logarithmic, reduction.radical())};
}

PartialFractions partial_fractions(const RationalFunction& f) {
  PartialFractions result;
  const RationalPolynomial& q = f.denominator();
  result.polynomial = f.numerator() / q;
  const RationalPolynomial proper = f.numerator() % q;
  for (const PolynomialFactor& factor : irreducible_factors(q)) {
    const RationalPolynomial power = factor.factor.power(factor.multiplicity);
    const RationalPolynomial others = q / power;
    RationalPolynomial g, s, t;  // s others + t power = 1
    fmpq_poly_xgcd(raw(g), raw(s), raw(t), raw(others), raw(power));
    result.parts.push_back({factor.factor, RationalFunction((proper * s) % power, power)});
  }
  return result;
}

}  // namespace hodograph
