// SPDX-License-Identifier: MIT
// The real roots of polynomials over ℚ, isolated exactly.
#pragma once

#include <cstddef>
#include <vector>

#include "hodograph/rational/polynomial.hpp"

namespace hodograph {

/// One real root of a polynomial: the only root of an irreducible factor within (lower, upper), or
/// lower = upper where it is rational.
class RealRoot {
 public:
  /// The only root of an irreducible `factor` in (lower, upper); or its root lower = upper
  /// (contract).
  RealRoot(RationalPolynomial factor, std::size_t multiplicity, Rational lower, Rational upper);

  const RationalPolynomial& factor() const { return factor_; }
  std::size_t multiplicity() const { return multiplicity_; }
  const Rational& lower() const { return lower_; }
  const Rational& upper() const { return upper_; }
  bool is_rational() const { return lower_ == upper_; }

  /// The sign of the root minus x, exactly: -1, 0 or 1.
  int compare(const Rational& x) const;
  /// The same root in an interval half as wide.
  RealRoot halved() const;
  /// The double nearest to the root. Domain: the root is within the range of doubles.
  double to_double() const;

 private:
  RationalPolynomial factor_;
  std::size_t multiplicity_;
  Rational lower_, upper_;
};

/// The distinct real roots of p ≠ 0, increasing, in disjoint intervals that do not touch.
/// Method: irreducible factors; Descartes' rule with bisection.
std::vector<RealRoot> real_roots(const RationalPolynomial& p);
/// The number of distinct real roots of p ≠ 0 in [a, b], a ≤ b, exactly. Method: Sturm's sequence,
/// after Descartes' rule where that decides.
std::size_t count_real_roots(const RationalPolynomial& p, const Rational& a, const Rational& b);
/// True when p > 0 everywhere in [a, b], a ≤ b: exact, by count_real_roots. Domain: p ≠ 0.
bool is_positive(const RationalPolynomial& p, const Rational& a, const Rational& b);
/// True when p ≥ 0 everywhere in [a, b], a ≤ b: exact, by the roots of odd multiplicity. Any p.
bool is_nonnegative(const RationalPolynomial& p, const Rational& a, const Rational& b);

}  // namespace hodograph
