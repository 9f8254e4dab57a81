// SPDX-License-Identifier: MIT
// The error of a Hermite interpolant from a bound on one derivative of the curve it interpolates:
// the certificate for curves that come with such a bound and cannot be evaluated on intervals.
#pragma once

#include <array>
#include <cstddef>

#include "hodograph/construction/error_bound.hpp"
#include "hodograph/construction/hermite_data.hpp"

namespace hodograph {

/// Interpolation at two points, m + 1 values each. The function
///   H_r(u) = u^r/r! (1-u)^{m+1} Σ_{j=0..m-r} C(m+j, j) u^j
/// has r-th derivative 1 at u = 0 and all others up to order m zero at both ends; a curve with end
/// derivatives δ_r(0), δ_r(1) differs from one that vanishes to order m at both ends by at most
/// Σ_r c_r (|δ_r(0)| + |δ_r(1)|), c_r = max |H_r| on [0, 1]. Rounded up in the last digit.
template <std::size_t m>
struct HermiteConstants;
template <>
struct HermiteConstants<1> {
  static constexpr std::array<double, 2> end_weight{1.0, 0.14814814815};
};
template <>
struct HermiteConstants<2> {
  static constexpr std::array<double, 3> end_weight{1.0, 0.19753086421, 0.01728000001};
};
template <>
struct HermiteConstants<4> {
  static constexpr std::array<double, 5> end_weight{1.0, 0.24739561854, 0.033611027288,
                                                    0.0025131208351, 0.000086039159724};
};

/// 1/((2m+2)! 2^{2m+2}), rounded up: a function that vanishes to order m at both ends of [0, 1] is
/// at most this times its largest derivative of order 2m + 2, as (u (1-u))^{m+1} ≤ 2^{-2m-2}.
template <std::size_t m>
inline Enclosure hermite_remainder_factor() {
  double denominator = 1.0;  // exact: 10! 2^10 is a small whole number
  for (std::size_t k = 1; k <= 2 * m + 2; ++k) denominator *= 2.0 * static_cast<double>(k);
  return Enclosure(1.0) / Enclosure(denominator);
}

/// An upper bound of |γ(ξ) - r(u)| for ξ = ξ_k + h u, 0 ≤ u ≤ 1, r the exact curve of the stored
/// numbers, from enclosures of γ and its first m derivatives with respect to ξ at ξ_k and ξ_k + h
/// and a bound of |γ^(2m+2)(ξ)| between:
///   (h^{2m+2} derivative_bound + max |r^(2m+2)|) / ((2m+2)! 2^{2m+2}) + Σ_r c_r (|δ_r(0)| +
///   |δ_r(1)|),
/// δ_r the differences of the r-th derivatives in u of γ and of the stored curve. Infinite where
/// an input is not finite. Evaluating the position adds position_error.
///
/// Accuracy: a few times the error until rounding of the coefficients, which derivatives of order
/// 2m + 2 enlarge by up to (4m+1)!/(2m-1)!/(2m+2)!, takes over: for m = 4 near 2e4 ε times the
/// length of the segment. Where γ can be evaluated on intervals, segment_error is sharper.
template <std::size_t m>
double hermite_error_bound(const SpatialPhCurve<2 * m>& curve,
                           const HermitePoint<m, Enclosure>& begin,
                           const HermitePoint<m, Enclosure>& end, double derivative_bound) {
  constexpr std::size_t degree = 4 * m + 1, order = 2 * m + 2;
  const Enclosure h(curve.parameter_step());
  const Enclosure noise(-displacement_error(curve), displacement_error(curve));
  // Differences of order r of the coefficients, times degree!/(degree - r)!: the derivatives of
  // order r in u, the first and the last of them at the ends.
  std::array<Vector3<Enclosure>, degree + 1> difference;
  const auto displacement = curve.displacement();
  for (std::size_t i = 0; i <= degree; ++i) {
    const Vector3<double>& c = displacement[i];
    difference[i] = {Enclosure(c.x) + noise, Enclosure(c.y) + noise, Enclosure(c.z) + noise};
  }
  const Vector3<Enclosure> start{Enclosure(curve.start().x), Enclosure(curve.start().y),
                                 Enclosure(curve.start().z)};
  Enclosure mismatch(0.0), factor(1.0), power(1.0);
  for (std::size_t r = 0; r <= order; ++r) {
    if (r <= m) {
      Vector3<Enclosure> at_begin = factor * difference[0];
      Vector3<Enclosure> at_end = factor * difference[degree - r];
      if (r == 0) {
        at_begin += start;
        at_end += start;
      }
      const Enclosure weight(HermiteConstants<m>::end_weight[r]);
      for (const auto& gap : {power * begin[r] - at_begin, power * end[r] - at_end}) {
        mismatch += weight * sqrt(square(gap.x) + square(gap.y) + square(gap.z));
      }
    }
    if (r == order) break;
    for (std::size_t i = 0; i + r < degree; ++i) difference[i] = difference[i + 1] - difference[i];
    factor *= Enclosure(static_cast<double>(degree - r));
    power *= h;
  }
  BernsteinPolynomial<Vector3<double>, degree - order> middle;
  double radius = 0.0;
  for (std::size_t i = 0; i + order <= degree; ++i) {
    Enclosure sum(0.0);
    for (std::size_t c = 0; c < 3; ++c) {
      const Enclosure exact = factor * difference[i][c];
      middle[i][c] = exact.middle();
      sum += square(exact - Enclosure(middle[i][c]));
    }
    error_detail::raise_to(radius, sqrt(sum).upper());
  }
  const Enclosure largest(largest_norm(middle, radius).norm.upper());
  const Enclosure remainder =
      (power * Enclosure(derivative_bound) + largest) * hermite_remainder_factor<m>();
  return (remainder + mismatch).upper();
}

}  // namespace hodograph
