// SPDX-License-Identifier: MIT
// Whether a planar PH quintic meets itself.
//
// Source: r(m + d) - r(m - d) = 2d D(m, d²), D the mean of f = w² over [m - d, m + d]:
//   D = f(m) + f''(m) δ/6 + f'''' δ²/120, δ = d².
// After multiplication by the conjugate of f'''' the imaginary part I0 + I2 δ/6 is linear in δ; put
// into the real part R0 + R2 δ/6 + F δ²/5 it leaves a polynomial of degree 6 in m:
//   R0 I2² - R2 I0 I2 + 36/5 F I0² = 0.
#include <algorithm>
#include <cmath>
#include <limits>

#include "hodograph/bernstein/roots.hpp"
#include "hodograph/construction/prescribed_length.hpp"
#include "hodograph/path/rotation_index.hpp"

namespace hodograph {

namespace {

template <std::size_t n>
using Real = BernsteinPolynomial<double, n>;

template <std::size_t m, std::size_t n>
Real<m + n> times(const Real<m>& f, const Real<n>& g) {
  return product(f, g, [](double a, double b) { return a * b; });
}

}  // namespace

bool crosses_itself(const PlanarPhCurve<2>& curve) {
  using C = Complex<double>;
  if (absolute_rotation_index(curve) < path_detail::pi) return false;
  const auto& w = curve.preimage().coefficients();
  double size = 0.0;
  for (const C& c : w) size = std::max(size, largest_component(c));
  const double unit = 1.0 / size;
  const BernsteinPolynomial<C, 2> preimage({unit * w[0], unit * w[1], unit * w[2]});
  const auto f = symmetric_square(preimage, [](const C& a, const C& b) { return a * b; });
  const auto second = f.derivative().derivative();
  const C a = preimage[0] - preimage[1] - preimage[1] + preimage[2];
  const double leading = dot(a, a);
  const C turn = leading > 0.0 ? (1.0 / leading) * conjugate(a * a) : C{1.0, 0.0};
  const auto real = [&](const C& c) { return (turn * c).re; };
  const auto imaginary = [&](const C& c) { return (turn * c).im; };
  const Real<4> r0 = f.mapped(real), i0 = f.mapped(imaginary);
  const Real<2> r2 = second.mapped(real), i2 = second.mapped(imaginary);
  const Real<8> condition = times(times(r0, i2), i2) -
                            times(times(r2, i0), i2).template elevated<8>() +
                            (7.2 * leading) * times(i0, i0);
  const auto roots = isolated_roots(condition);
  if (!roots) return false;  // a straight line
  for (const IsolatedRoot& root : *roots) {
    const double m = root.u.middle(), most = std::min(m, 1.0 - m);
    const auto inside = [&](double delta) {
      return 0.0 < delta && delta <= most * most && delta < 0.25;
    };
    const double linear = i2.value(m) / 6.0, constant = i0.value(m);
    // Where both parts vanish, as on the axis of a symmetric curve, the real part alone decides;
    // such a root is double, and known to half of the digits.
    const double half_digits = std::sqrt(std::numeric_limits<double>::epsilon());
    if (std::abs(linear) > 64.0 * half_digits) {
      if (root.kind == RootKind::simple && inside(-constant / linear)) return true;
      if (root.kind == RootKind::simple) continue;
    }
    const double p = r2.value(m) / 6.0, q = r0.value(m), s = leading / 5.0;
    const double discriminant = p * p - 4.0 * s * q;
    if (discriminant < 0.0) continue;
    const double t = -0.5 * (p + std::copysign(std::sqrt(discriminant), p));
    for (const double delta : {s > 0.0 ? t / s : -1.0, t != 0.0 ? q / t : -1.0}) {
      if (inside(delta) && std::abs(constant + linear * delta) <= 1024.0 * half_digits) return true;
    }
  }
  return false;
}

}  // namespace hodograph
