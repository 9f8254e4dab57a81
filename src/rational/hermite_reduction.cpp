// SPDX-License-Identifier: MIT
// Hermite's reduction with everything that does not depend on the numerator in advance.
#include "hermite_reduction.hpp"

#include <cassert>

#include "flint.hpp"

namespace hodograph::rational_detail {

namespace {

/// b with a b = 1 modulo m, a and m coprime.
RationalPolynomial inverse_modulo(const RationalPolynomial& a, const RationalPolynomial& m) {
  RationalPolynomial g, s, t;
  fmpq_poly_xgcd(raw(g), raw(s), raw(t), raw(a % m), raw(m));
  assert(g.is_one());
  return s % m;
}

}  // namespace

HermiteReduction::HermiteReduction(const RationalPolynomial& alpha)
    : alpha_(alpha), radical_(hodograph::radical(alpha)), denominator_(alpha_ * radical_) {
  for (RationalPolynomial g = alpha_; g.degree() > 0;) {
    const RationalPolynomial next = gcd(g, g.derivative());
    Stage stage;
    stage.squares = (g / next).monic();
    // rad α g' / g is a polynomial: every root of g is one of rad α.
    stage.slope = -((radical_ * g.derivative()) / g);
    stage.inverse = inverse_modulo(stage.slope, stage.squares);
    stage.rest = radical_ / stage.squares;
    stage.cofactor = (alpha_ / g).monic();
    stages_.push_back(std::move(stage));
    g = next;
  }
}

HermiteReduction::Parts HermiteReduction::reduce(RationalPolynomial p) const {
  assert(p.degree() < denominator_.degree() || p.is_zero());
  Parts parts;
  const Rational scale = alpha_.leading();
  for (const Stage& stage : stages_) {
    const RationalPolynomial b = ((p % stage.squares) * stage.inverse) % stage.squares;
    p = (p - b * stage.slope) / stage.squares - b.derivative() * stage.rest;
    parts.rational += b * stage.cofactor;
  }
  parts.logarithmic = RationalPolynomial(Rational(1) / scale) * p;
  return parts;
}

}  // namespace hodograph::rational_detail
