// SPDX-License-Identifier: MIT
// Angles of complex numbers: one arc tangent for single values and for lanes (the same bits), and a
// rigorous one.
#pragma once

#include <cmath>
#include <limits>

#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/scalar.hpp"

namespace hodograph::path_detail {

/// Multiples of π, each as a double and what is left of it.
inline constexpr double pi = 0x1.921fb54442d18p+1, pi_rest = 0x1.1a62633145c07p-53;

/// The angle of x + i y in [-π, π], 0 for x = y = 0, without a branch: S is a number or a pack of
/// lanes. Within 2 ε of the angle's size. Domain: finite, |x| + |y| does not overflow.
///
/// Method: |y| and |x| are exchanged above π/4 and turned back by π/4 above π/8, so that |t| ≤
/// tan(π/8), where atan t = t + t³ P(t²) with P of degree 10, the best uniform approximation up to
/// a factor near 1 (error 2.3e-18, found in 50 digits).
template <class S>
[[gnu::always_inline]] inline S angle_of(const S& y, const S& x) {
  using std::abs;
  constexpr double tangent_of_eighth = 0x1.a827999fcef32p-2;
  const S zero(0.0), width = abs(x), height = abs(y);
  const auto steep = width < height;
  const S large = select(steep, height, width), small = select(steep, width, height);
  const auto wide = S(tangent_of_eighth) * large < small;
  const S numerator = select(wide, small - large, small);
  const S denominator = select(wide, small + large, large);
  const S t = numerator / select(zero < denominator, denominator, S(1.0));
  const S z = t * t, z2 = z * z, z4 = z2 * z2;
  const S p01 = S(-0x1.5555555555555p-2) + S(0x1.999999999934cp-3) * z;
  const S p23 = S(-0x1.2492492436201p-3) + S(0x1.c71c71853d7c8p-4) * z;
  const S p45 = S(-0x1.745d0b28a7649p-4) + S(0x1.3b12630643e8ap-4) * z;
  const S p67 = S(-0x1.10fa77b104ae8p-4) + S(0x1.dfe6497394f40p-5) * z;
  const S p89 = S(-0x1.a0999c2994d42p-5) + S(0x1.4162bf84bf0bfp-5) * z;
  const S low = p01 + z2 * p23, middle = p45 + z2 * p67;
  const S high = p89 + z2 * S(-0x1.3a31b0297d745p-6);
  const S p = low + z4 * (middle + z4 * high);
  const S small_angle = t + (t * z) * p;
  const S first = select(wide, S(0.25 * pi) + (small_angle + S(0.25 * pi_rest)), small_angle);
  const S upright = select(steep, S(0.5 * pi) - (first - S(0.5 * pi_rest)), first);
  const S above = select(x < zero, S(pi) - (upright - S(pi_rest)), upright);
  return select(y < zero, -above, above);
}

/// π, enclosed.
inline Enclosure pi_enclosure() { return {pi, Enclosure::up(pi)}; }

/// The arc tangent of a number, enclosed to a few ε. Method: 1/t above 1, three times
/// t/(1 + √(1 + t²)), which halves the angle, and the alternating series; what follows its last
/// term is between 0 and the next.
inline Enclosure arc_tangent_of_point(double t) {
  if (t < 0.0) return -arc_tangent_of_point(-t);
  if (t == 0.0) return t;
  const bool inverted = t > 1.0;
  Enclosure x = inverted ? Enclosure(1.0) / Enclosure(t) : Enclosure(t);
  constexpr int halvings = 3;
  for (int i = 0; i < halvings; ++i) x = x / (Enclosure(1.0) + sqrt(Enclosure(1.0) + square(x)));
  constexpr int terms = 9;  // x ≤ tan(π/32): x^18/19 < 2^-64
  const Enclosure z = square(x);
  Enclosure sum = Enclosure(1.0) / Enclosure(2.0 * terms + 1.0);
  sum = Enclosure(0.0, sum.upper());  // the series from this term on, over z^terms, up to its sign
  for (int k = terms; k-- > 0;) sum = Enclosure(1.0) / Enclosure(2.0 * k + 1.0) - z * sum;
  const Enclosure angle = Enclosure(8.0) * (x * sum);
  return inverted ? Enclosure(0.5) * pi_enclosure() - angle : angle;
}
inline Enclosure arc_tangent(const Enclosure& t) {
  const double largest = std::numeric_limits<double>::max();
  const Enclosure half = Enclosure(0.5) * pi_enclosure();
  const double low = t.lower() < -largest ? -half.upper() : arc_tangent_of_point(t.lower()).lower();
  const double high = t.upper() > largest ? half.upper() : arc_tangent_of_point(t.upper()).upper();
  return {low, high};
}

}  // namespace hodograph::path_detail
