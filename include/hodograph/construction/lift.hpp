// SPDX-License-Identifier: MIT
// Planar PH paths lifted into space: the path above a plan that climbs at a constant angle.
//
// With the plan's preimage w = a + b i and the slope m = tan θ, |θ| < π/2,
//   A = (a + b k)(c + d j),   c = √((1 + √(1 + m²))/2),   d = -m/(2c),
// gives A i A* = (Re w², Im w², m |w|²): the lifting (x, y, z_s + s tan θ) of "Helical polynomial
// curves interpolating G1 data with prescribed axes and pitch angles", (15). It is the paper's
// preimage (24) of r' = A k A* times (1 - j)/√2, which turns k into i: f a + f b k + (a j - b
// i)/(2f) = (a + b k)(f + j/(2f)), and (f + j/(2f))(1 - j)/√2 = c + d j, with c² - d² = 1, c² + d²
// = sec θ, and no cancellation for any θ. Its frame is the one of level wings: e₂ is level, to the
// left.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "hodograph/path/path.hpp"

namespace hodograph {

/// c + d j, which pitches a level preimage up to a slope. Domain: |slope| ≤ 1e300.
struct Pitch {
  double c = 1.0, d = 0.0;

  static Pitch of_slope(double slope) {
    constexpr double steep = 0x1.0p+60;  // from where on √(1 + m²) = |m|
    const double size = std::abs(slope);
    const double c = std::sqrt(0.5 * (1.0 + (size < steep ? std::sqrt(1.0 + size * size) : size)));
    return {c, -0.5 * slope / c};
  }
};

/// (a + b k)(c + d j).
inline Quaternion<double> lifted(const Complex<double>& w, const Pitch& pitch) {
  return {w.re * pitch.c, -(w.im * pitch.d), w.re * pitch.d, w.im * pitch.c};
}

/// The preimage U* (a + b k)(c + d j) of the curve above a plan, with U = `upright`; see
/// turn_upright. Domain of the slope as above.
template <std::size_t n>
BernsteinPolynomial<Quaternion<double>, n> lifted(
    const BernsteinPolynomial<Complex<double>, n>& plan, double slope,
    const Quaternion<double>& upright = {1.0, 0.0, 0.0, 0.0}) {
  const Pitch pitch = Pitch::of_slope(slope);
  BernsteinPolynomial<Quaternion<double>, n> preimage;
  for (std::size_t i = 0; i <= n; ++i) preimage[i] = lifted(plan[i], pitch);
  if (upright == Quaternion<double>{1.0, 0.0, 0.0, 0.0}) return preimage;
  for (std::size_t i = 0; i <= n; ++i) preimage[i] = conjugate(upright) * preimage[i];
  return preimage;
}

/// The curve above a plan with the given slope = tan θ, from `start` on (whose x and y may differ
/// from the plan's: it is the shape that is lifted). With `upright` = U the plan is one of the
/// frame in which the axis is vertical.
/// Exact up to rounding: length sec θ times the plan's, curvature cos² θ, torsion sin θ cos θ times
/// the plan's signed curvature.
template <std::size_t n>
SpatialPhCurve<n> lifted(const PlanarPhCurve<n>& plan, const Vector3<double>& start, double slope,
                         const Quaternion<double>& upright = {1.0, 0.0, 0.0, 0.0}) {
  return {start, lifted(plan.preimage(), slope, upright), plan.parameter_step()};
}

/// The path above a plan, on its knots, from an altitude on, with one slope for every segment. C0,
/// each segment from the end of the one before, and as smooth as the plan where neighbours have the
/// same slope.
/// Faults: mismatched_size (slopes ≠ segments), not_finite (a slope, with its index), those of
/// Path::create. A closed plan gives an open path unless the altitude returns.
template <std::size_t n>
Result<SpatialPath<n>> lifted(const PlanarPath<n>& plan, double altitude,
                              std::span<const double> slopes) {
  if (slopes.size() != plan.segment_count()) {
    return Fault{FaultCode::mismatched_size,
                 std::to_string(plan.segment_count()) + " segments need as many slopes; got " +
                     std::to_string(slopes.size()),
                 std::nullopt,
                 "slopes",
                 static_cast<double>(slopes.size()),
                 static_cast<double>(plan.segment_count())};
  }
  std::vector<SpatialPhCurve<n>> segments;
  segments.reserve(plan.segment_count());
  for (std::size_t k = 0; k < plan.segment_count(); ++k) {
    if (!is_finite(slopes[k])) {
      return Fault{FaultCode::not_finite,
                   "slope " + std::to_string(k) + " is not finite",
                   k,
                   "slope",
                   slopes[k],
                   std::nullopt};
    }
    const Vector2<double>& first = plan.segment(0).start();
    const auto start = k == 0 ? Vector3<double>{first.x, first.y, altitude} : segments.back().end();
    segments.push_back(lifted(plan.segment(k), start, slopes[k]));
  }
  const bool returns = plan.is_closed() && segments.back().end().z == altitude;
  return SpatialPath<n>::create(plan.knots(), std::move(segments), returns);
}

/// The same with one slope for all.
template <std::size_t n>
Result<SpatialPath<n>> lifted(const PlanarPath<n>& plan, double altitude, double slope) {
  return lifted(plan, altitude, std::vector<double>(plan.segment_count(), slope));
}

}  // namespace hodograph
