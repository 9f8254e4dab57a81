// SPDX-License-Identifier: MIT
// Euclid's algorithm over the Gaussian rationals.
#include "hodograph/rational/reduction.hpp"

#include <algorithm>
#include <utility>

#include "hodograph/rational/motion_polynomial.hpp"

namespace hodograph {

namespace {

/// re + im i in ℚ(i)[t].
struct GaussianPolynomial {
  RationalPolynomial re, im;

  int degree() const { return std::max(re.degree(), im.degree()); }
  GaussianPolynomial times(const Rational& x, const Rational& y) const {
    const RationalPolynomial a(x), b(y);
    return {a * re - b * im, a * im + b * re};
  }
  /// Divided by the leading coefficient.
  GaussianPolynomial monic() const {
    const auto n = static_cast<std::size_t>(degree());
    const Rational x = re.coefficient(n), y = im.coefficient(n);
    const Rational size = x * x + y * y;
    return times(x / size, -y / size);
  }
};

/// a modulo a monic b.
GaussianPolynomial remainder(GaussianPolynomial a, const GaussianPolynomial& b) {
  while (a.degree() >= b.degree()) {
    const auto n = static_cast<std::size_t>(a.degree());
    const GaussianPolynomial part = b.times(a.re.coefficient(n), a.im.coefficient(n));
    const std::size_t k = n - static_cast<std::size_t>(b.degree());
    a.re -= part.re.times_power(k);
    a.im -= part.im.times_power(k);
  }
  return a;
}

/// The monic greatest common divisor of a and b, not both 0.
GaussianPolynomial common_divisor(GaussianPolynomial a, GaussianPolynomial b) {
  while (b.degree() >= 0) {
    b = b.monic();
    a = remainder(std::move(a), b);
    std::swap(a, b);
  }
  return a.monic();
}

}  // namespace

Result<Reduction> reduction(const QuaternionPolynomial& a) {
  if (degree(a) < 0) {
    return Fault{FaultCode::outside_domain,
                 "the quaternion polynomial A is 0, so A i A* has no direction; right would be any "
                 "A other than 0",
                 std::nullopt, "A", 0.0};
  }
  if (content(indicatrix(a)).is_one()) return Reduction{a, RationalPolynomial(1), {}};
  const GaussianPolynomial divisor = common_divisor({a.w, a.x}, {a.y, -a.z});
  Reduction result{{}, divisor.re, divisor.im};
  const QuaternionPolynomial conjugate_divisor{divisor.re, -divisor.im, {}, {}};
  result.reduced = divided(a * conjugate_divisor, result.content());
  return result;
}

}  // namespace hodograph
