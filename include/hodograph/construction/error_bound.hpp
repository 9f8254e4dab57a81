// SPDX-License-Identifier: MIT
// How far a curve is from what it approximates: rigorous bounds of a difference of polynomials, and
// of what rounding adds to it. The parts that need no interval library; certify/ adds the rest.
#pragma once

#include <array>
#include <cstddef>

#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/construction/detail/largest_norm.hpp"
#include "hodograph/curve/ph_curve.hpp"
#include "hodograph/foundation/accuracy.hpp"
#include "hodograph/foundation/enclosure.hpp"

namespace hodograph {

/// The largest distance |γ(ξ) - p(ξ)| of a fitted path p from the given curve γ over a range of ξ.
struct ErrorBound {
  /// certified: contains the largest distance over all real ξ, where p is the exact curve of the
  /// stored numbers; the upper end also holds for every position computed from them in double
  /// precision, and the lower end is reduced by the same allowance.
  /// Not certified: an estimate, the largest distance seen at sampled parameters (both ends equal
  /// up to the sampling), or [lower, ∞) where a certificate was asked for and none exists.
  Enclosure error{};
  bool certified = false;
  /// A parameter where the distance is at least the lower end (up to rounding of ξ).
  double at_xi = 0.0;
};

/// The bound over two ranges together.
inline ErrorBound larger_error(const ErrorBound& a, const ErrorBound& b) {
  const bool from_a = a.error.lower() >= b.error.lower();
  return {Enclosure(from_a ? a.error.lower() : b.error.lower(),
                    a.error.upper() >= b.error.upper() ? a.error.upper() : b.error.upper()),
          a.certified && b.certified, from_a ? a.at_xi : b.at_xi};
}

/// An upper bound of h max|A_i|², and so of |dr/du| and of the arc length of a curve.
template <PreimageAlgebra A, std::size_t n>
double largest_rate(const PhCurve<A, n>& curve) {
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  double largest = 0.0;
  for (const A& a : curve.preimage().coefficients()) {
    error_detail::raise_to(largest, dot(a, a));  // at most 4 roundings, or underflows
  }
  const Enclosure square = (Enclosure(1.0) + error_detail::roundings(4)) * Enclosure(largest) +
                           Enclosure(8.0 * smallest);
  return (square * Enclosure(curve.parameter_step())).upper();
}

/// An upper bound of |d(u) - r(u) + start| for all u in [0, 1], d the stored displacement
/// polynomial and r the exact curve of the stored start, preimage and parameter step.
///
/// Derivation: a coefficient of d is h/(2n+1) times a sum of weighted products of components of A_i
/// and A_j. No product passes more than 3n + 8 roundings (form 3, weight 2, sum over i + j = k at
/// most n, running sum 2n, factors 3), and the products, signs removed, sum to at most largest_rate
/// by Cauchy's inequality. The last term covers products that underflow: fewer than 16 (n + 1) for
/// each coefficient of the hodograph, each wrong by less than the smallest number.
template <PreimageAlgebra A, std::size_t n>
double displacement_error(const PhCurve<A, n>& curve) {
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  const Enclosure per_component =
      error_detail::roundings(3 * n + 8) * Enclosure(largest_rate(curve)) +
      Enclosure(16.0 * static_cast<double>(n + 1) * smallest) *
          (Enclosure(1.0) + Enclosure(curve.parameter_step()));
  return (sqrt(Enclosure(static_cast<double>(point_t<A>::dimension))) * per_component).upper();
}

/// An upper bound of the distance between the exact point r(u) and the position computed in double
/// precision, u = (ξ - ξ_k)/h computed too. Terms: displacement_error and
/// accuracy::evaluation_error of the displacement, the rounding of the sum with start, and the two
/// roundings of u times the largest rate.
template <PreimageAlgebra A, std::size_t n>
double position_error(const PhCurve<A, n>& curve) {
  using V = point_t<A>;
  constexpr double eps = epsilon<double>();
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  const auto displacement = curve.displacement();
  Enclosure sum(0.0);
  for (std::size_t i = 0; i < V::dimension; ++i) {
    double size = 0.0;
    for (const V& c : displacement.coefficients()) {
      error_detail::raise_to(size, std::abs(c[i]));
    }
    const Enclosure largest(size);
    const Enclosure evaluation =
        Enclosure(accuracy::evaluation_error<double>(PhCurve<A, n>::degree)) * largest;
    const Enclosure addition = Enclosure(eps) * (Enclosure(std::abs(curve.start()[i])) + largest) +
                               Enclosure(16.0 * static_cast<double>(n + 1) * smallest);
    sum += square(evaluation + addition);
  }
  const Enclosure computed = sqrt(sum) + Enclosure(2.0 * eps) * Enclosure(largest_rate(curve));
  return (computed + Enclosure(displacement_error(curve))).upper();
}

/// An enclosure of max |f(u) + g(u)| over u in [0, 1], where nothing is known of g but
/// |g(u)| ≤ radius; and a u where |f| is at least the lower end plus radius. Sharp to about one
/// part in 64 of |f| where |f| exceeds radius.
template <class V, std::size_t d>
NormBound largest_norm(const BernsteinPolynomial<V, d>& f, double radius = 0.0) {
  error_detail::Components<V::dimension, d> components;
  for (std::size_t i = 0; i < V::dimension; ++i) {
    for (std::size_t j = 0; j <= d; ++j) components[i][j] = f[j][i];
  }
  return error_detail::largest_norm<V::dimension, d>(components, radius);
}

}  // namespace hodograph
