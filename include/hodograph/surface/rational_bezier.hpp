// SPDX-License-Identifier: MIT
// Rational Bézier patches as lists of control points and weights, of any degree.
#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/bernstein/dynamic_polynomial.hpp"
#include "hodograph/bernstein/rational_curve.hpp"

namespace hodograph {

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
