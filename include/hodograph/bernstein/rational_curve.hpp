// SPDX-License-Identifier: MIT
// Rational Bézier curves as lists of control points and weights, of any degree.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/bernstein/dynamic_polynomial.hpp"

namespace hodograph {

/// A rational Bézier curve Σ w_i P_i B_i / Σ w_i B_i over [begin, end], of degree
/// control_points.size() - 1, in the plane or in space.
template <class Point>
struct RationalBezierCurve {
  double begin = 0.0, end = 1.0;
  std::vector<Point> control_points{};  ///< P_i
  std::vector<double> weights{};        ///< w_i, as many, positive

  std::size_t degree() const { return control_points.size() - 1; }
  /// Σ w_i P_i B_i.
  DynamicPolynomial<Point> weighted() const {
    std::vector<Point> points(control_points.size());
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = weights[i] * control_points[i];
    return DynamicPolynomial<Point>(std::move(points));
  }
  /// Σ w_i B_i.
  DynamicPolynomial<double> weight() const { return DynamicPolynomial<double>(weights); }
  /// The point at u in [0, 1] of the piece (the parameter is begin + u (end - begin)).
  Point position(double u) const { return (1.0 / weight().value(u)) * weighted().value(u); }
  friend bool operator==(const RationalBezierCurve&, const RationalBezierCurve&) = default;
};
using RationalBezier = RationalBezierCurve<Vector2<double>>;
using SpatialRationalBezier = RationalBezierCurve<Vector3<double>>;

}  // namespace hodograph
