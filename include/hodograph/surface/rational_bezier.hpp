// SPDX-License-Identifier: MIT
// Rational Bézier curves and patches as lists of control points and weights, of any degree.
#pragma once

#include <cassert>
#include <cstddef>
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

/// The homogeneous coefficients of a curve in space: (w P_i, w_i).
struct HomogeneousCurve {
  DynamicPolynomial<Vector3<double>> weighted;
  DynamicPolynomial<double> weight;
};

/// A rational tensor-product Bézier patch over [begin_v, end_v] × [begin_u, end_u]:
///   S(v, u) = Σ_ij W_ij P_ij B_i(v) B_j(u) / Σ_ij W_ij B_i(v) B_j(u),
/// stored as the homogeneous control points (W_ij P_ij, W_ij), row i for v, one after the other.
struct RationalPatch {
  std::size_t degree_v = 0, degree_u = 0;
  double begin_v = 0.0, end_v = 1.0, begin_u = 0.0, end_u = 1.0;
  std::vector<Vector3<double>> weighted{};  ///< (degree_v + 1) (degree_u + 1), W_ij P_ij
  std::vector<double> weights{};            ///< as many, W_ij

  std::size_t index(std::size_t i, std::size_t j) const { return i * (degree_u + 1) + j; }
  /// The control points P_ij. Domain: no weight is 0.
  std::vector<Vector3<double>> control_points() const;
  bool weights_are_positive() const;

  /// S at local parameters v, u in [0, 1], where the weight is not 0. Accuracy: evaluation_error of
  /// both degrees of the largest coefficients, over the weight.
  Vector3<double> position(double v, double u) const;
  /// S and its first derivatives with respect to the local parameters.
  struct Derivatives {
    Vector3<double> position, along_v, along_u;
  };
  Derivatives derivatives(double v, double u) const;
  /// The unit normal S_u × S_v / |S_u × S_v|: outwards on a sweep of a closed profile. The zero
  /// vector where it does not exist.
  Vector3<double> normal(double v, double u) const;

  /// The part on [a, b] of v, all of u.
  RationalPatch restricted_v(double a, double b) const;
  /// The part on [a, b] of u, all of v.
  RationalPatch restricted_u(double a, double b) const;
  friend bool operator==(const RationalPatch&, const RationalPatch&) = default;
};

}  // namespace hodograph
