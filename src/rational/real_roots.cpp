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

/// (1 + x)^n p((a + b x) / (1 + x)): what p is on (a, b), this is on (0, ∞).
RationalPolynomial on_half_line(const RationalPolynomial& p, const Rational& a, const Rational& b) {
  // q(x) = p(b + (a - b) x); its reverse x^n q(1/x) at x + 1, from the other end.
  RationalPolynomial q, reversed;
  fmpq_poly_compose(raw(q), raw(p), raw(RationalPolynomial{b, a - b}));
  fmpq_poly_reverse(raw(reversed), raw(q), static_cast<slong>(p.degree() + 1));
  return reversed.shifted(1);
}

/// Sign changes of the coefficients of p, as many as it has positive roots, or an even number more.
std::size_t variations(const RationalPolynomial& p) {
  std::size_t changes = 0;
  int last = 0;
  for (int k = 0; k <= p.degree(); ++k) {
    const int sign = p.coefficient(static_cast<std::size_t>(k)).sign();
    if (sign == 0) continue;
    if (last != 0 && sign != last) ++changes;
    last = sign;
  }
  return changes;
}

Rational power_of_two(ulong bits) {
  Rational power(1);
  fmpz_mul_2exp(fmpq_numref(raw(power)), fmpq_numref(raw(power)), bits);
  return power;
}

/// What p is on an interval, moved to (0, 1): an integer polynomial with p's signs there. Whole
/// numbers without their common powers of two need no division, which is what fractions spend
/// nearly all their time on.
class Piece {
 public:
  /// p on (-2^k, 2^k).
  Piece(const RationalPolynomial& p, ulong k) : q_(p) {
    fmpz_poly_struct* q = q_.get();
    scale([k](slong j) { return k * static_cast<ulong>(j); });
    fmpz minus_one = -1;
    fmpz_poly_taylor_shift(q, q, &minus_one);
    scale([](slong j) { return static_cast<ulong>(j); });
  }

  /// p on the left half of the interval; right(): of the piece that left() gave, on the other.
  Piece left() const {
    Piece half = *this;
    const slong n = fmpz_poly_degree(q_.get());
    half.scale([n](slong j) { return static_cast<ulong>(n - j); });
    return half;
  }
  Piece right_of_left() const {
    Piece other = *this;
    fmpz one = 1;
    fmpz_poly_taylor_shift(other.q_.get(), other.q_.get(), &one);
    return other;
  }

  /// Sign changes of the coefficients of (1 + x)^n q(1 / (1 + x)): as many as p has roots in the
  /// interval, or an even number more.
  std::size_t variations() const {
    rational_detail::IntegerPolynomial open = q_;
    fmpz_poly_reverse(open.get(), open.get(), fmpz_poly_length(open.get()));
    fmpz one = 1;
    fmpz_poly_taylor_shift(open.get(), open.get(), &one);
    std::size_t changes = 0;
    int last = 0;
    for (slong j = 0; j < fmpz_poly_length(open.get()); ++j) {
      const int sign = fmpz_sgn(fmpz_poly_get_coeff_ptr(open.get(), j));
      if (sign != 0 && last != 0 && sign != last) ++changes;
      if (sign != 0) last = sign;
    }
    return changes;
  }

 private:
  /// The coefficient of x^j times 2^bits(j), all without their common power of two.
  template <class Bits>
  void scale(const Bits& bits) {
    fmpz_poly_struct* q = q_.get();
    for (slong j = 0; j < fmpz_poly_length(q); ++j) {
      fmpz* c = fmpz_poly_get_coeff_ptr(q, j);
      fmpz_mul_2exp(c, c, bits(j));
    }
    _fmpz_poly_remove_content_2exp(q->coeffs, q->length);
  }

  rational_detail::IntegerPolynomial q_;
};

/// Every real root of an irreducible p of degree 2 or more within (a, b): no midpoint is a root.
void isolate(const PolynomialFactor& p, const Piece& piece, const Rational& a, const Rational& b,
             std::vector<RealRoot>& found) {
  const std::size_t changes = piece.variations();
  if (changes == 0) return;
  if (changes == 1) {
    found.emplace_back(p.factor, p.multiplicity, a, b);
    return;
  }
  const Rational m = middle(a, b);
  const Piece left = piece.left();
  isolate(p, left, a, m, found);
  isolate(p, left.right_of_left(), m, b, found);
}

/// k such that 2^k is above the size of every root of p (Fujiwara's bound).
ulong root_bound_bits(const RationalPolynomial& p) {
  const rational_detail::IntegerPolynomial whole(p);
  fmpz_t bound;
  fmpz_init(bound);
  fmpz_poly_bound_roots(bound, whole.get());
  const ulong bits = fmpz_bits(bound);  // 2^bits > bound
  fmpz_clear(bound);
  return bits;
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
      const ulong bits = root_bound_bits(q.factor);
      const Rational bound = power_of_two(bits);
      isolate(q, Piece(q.factor, bits), -bound, bound, roots);
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
  if (p.is_constant() || b < a) return 0;
  std::size_t count = 0;
  for (const Rational* end : {&a, &b}) {
    if (p.value(*end).is_zero() && (end == &a || a != b)) ++count;
  }
  if (b <= a) return count;
  RationalPolynomial open = on_half_line(p, a, b);
  // Roots at the ends have gone to 0 and ∞.
  while (open.coefficient(0).is_zero()) open = open / RationalPolynomial::monomial(1, 1);
  if (variations(open) <= 1) return count + variations(open);
  const rational_detail::IntegerPolynomial whole(open / gcd(open, open.derivative()));
  slong negative = 0, positive = 0;
  _fmpz_poly_num_real_roots_sturm(&negative, &positive, whole.get()->coeffs, whole.get()->length);
  return count + static_cast<std::size_t>(positive);
}

bool is_positive(const RationalPolynomial& p, const Rational& a, const Rational& b) {
  return p.value(a).sign() > 0 && count_real_roots(p, a, b) == 0;
}

bool is_nonnegative(const RationalPolynomial& p, const Rational& a, const Rational& b) {
  if (p.value(a).sign() < 0 || p.value(b).sign() < 0) return false;
  if (p.is_zero() || a == b) return true;
  // Only roots of odd multiplicity within (a, b) change the sign.
  RationalPolynomial changes(p.leading());
  for (const PolynomialFactor& s : square_free_factors(p)) {
    if (s.multiplicity % 2 != 0) changes *= s.factor;
  }
  const RationalPolynomial open = on_half_line(changes, a, b);
  if (variations(open) == 0) return open.leading().sign() > 0;
  const std::size_t ends =
      (changes.value(a).is_zero() ? 1u : 0u) + (changes.value(b).is_zero() ? 1u : 0u);
  return count_real_roots(changes, a, b) == ends && open.leading().sign() > 0;
}

}  // namespace hodograph
