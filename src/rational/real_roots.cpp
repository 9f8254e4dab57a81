// SPDX-License-Identifier: MIT
// Isolation of real roots by Descartes' rule and bisection.
#include "hodograph/rational/real_roots.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "flint.hpp"

namespace hodograph {

using rational_detail::raw;

namespace {

Rational middle(const Rational& a, const Rational& b) { return (a + b) * Rational(1, 2); }

/// Sign changes of the coefficients of (1 + x)^n p((a + b x) / (1 + x)): as many as p has roots in
/// (a, b), or an even number more.
std::size_t variations(const RationalPolynomial& p, const Rational& a, const Rational& b) {
  // q(x) = p(a + (b - a) x); its reverse x^n q(1/x), at x + 1.
  RationalPolynomial q, reversed;
  fmpq_poly_compose(raw(q), raw(p), raw(RationalPolynomial{a, b - a}));
  fmpq_poly_reverse(raw(reversed), raw(q), static_cast<slong>(p.degree() + 1));
  const RationalPolynomial moved = reversed.shifted(1);
  std::size_t changes = 0;
  int last = 0;
  for (int k = 0; k <= moved.degree(); ++k) {
    const int sign = moved.coefficient(static_cast<std::size_t>(k)).sign();
    if (sign == 0) continue;
    if (last != 0 && sign != last) ++changes;
    last = sign;
  }
  return changes;
}

/// Every real root of an irreducible p of degree 2 or more: no midpoint is a root.
void isolate(const PolynomialFactor& p, const Rational& a, const Rational& b,
             std::vector<RealRoot>& found) {
  const std::size_t changes = variations(p.factor, a, b);
  if (changes == 0) return;
  if (changes == 1) {
    found.emplace_back(p.factor, p.multiplicity, a, b);
    return;
  }
  const Rational m = middle(a, b);
  isolate(p, a, m, found);
  isolate(p, m, b, found);
}

/// A power of two above the size of every root of a monic p (Cauchy's bound).
Rational root_bound(const RationalPolynomial& p) {
  Rational largest(1);
  for (const Rational& c : p.coefficients()) {
    const Rational size = c.sign() < 0 ? -c : c;
    if (largest < size) largest = size;
  }
  Rational bound(2);
  while (bound <= largest + Rational(1)) bound *= Rational(2);
  return bound;
}

}  // namespace

RealRoot::RealRoot(RationalPolynomial factor, std::size_t multiplicity, Rational lower,
                   Rational upper)
    : factor_(std::move(factor)),
      multiplicity_(multiplicity),
      lower_(std::move(lower)),
      upper_(std::move(upper)) {}

int RealRoot::compare(const Rational& x) const {
  if (is_rational()) return (lower_ - x).sign();
  if (x <= lower_) return 1;
  if (upper_ <= x) return -1;
  // The factor changes its sign at the root alone within the interval.
  return factor_.value(x).sign() == factor_.value(lower_).sign() ? 1 : -1;
}

RealRoot RealRoot::halved() const {
  if (is_rational()) return *this;
  const Rational m = middle(lower_, upper_);
  return compare(m) > 0 ? RealRoot(factor_, multiplicity_, m, upper_)
                        : RealRoot(factor_, multiplicity_, lower_, m);
}

double RealRoot::to_double() const {
  RealRoot root = *this;
  for (;;) {
    const double a = root.lower().to_double(), b = root.upper().to_double();
    if (a == b) return a;
    if (std::nextafter(a, b) == b) {
      const Rational m = middle(*Rational::exactly(a), *Rational::exactly(b));
      return root.compare(m) <= 0 ? a : b;
    }
    root = root.halved();
  }
}

std::vector<RealRoot> real_roots(const RationalPolynomial& p) {
  std::vector<RealRoot> roots;
  for (const PolynomialFactor& q : irreducible_factors(p)) {
    if (q.factor.degree() == 1) {
      const Rational root = -q.factor.coefficient(0);
      roots.emplace_back(q.factor, q.multiplicity, root, root);
    } else {
      const Rational bound = root_bound(q.factor);
      isolate(q, -bound, bound, roots);
    }
  }
  const auto before = [](const RealRoot& a, const RealRoot& b) { return a.upper() < b.lower(); };
  for (std::size_t i = 0; i < roots.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      while (!before(roots[i], roots[j]) && !before(roots[j], roots[i])) {
        roots[i] = roots[i].halved();
        roots[j] = roots[j].halved();
      }
    }
  }
  std::sort(roots.begin(), roots.end(), before);
  return roots;
}

std::size_t count_real_roots(const RationalPolynomial& p, const Rational& a, const Rational& b) {
  const auto roots = real_roots(p);
  return static_cast<std::size_t>(std::count_if(roots.begin(), roots.end(), [&](const auto& root) {
    return root.compare(a) >= 0 && root.compare(b) <= 0;
  }));
}

}  // namespace hodograph
