// SPDX-License-Identifier: MIT
#include "hodograph/surface/rational_bezier.hpp"

#include <algorithm>

namespace hodograph {
namespace {

/// A homogeneous point and sums of such.
struct Homogeneous {
  using Scalar = double;
  Vector3<double> weighted{};
  double weight = 0.0;
  friend Homogeneous operator+(const Homogeneous& a, const Homogeneous& b) {
    return {a.weighted + b.weighted, a.weight + b.weight};
  }
  friend Homogeneous operator-(const Homogeneous& a, const Homogeneous& b) {
    return {a.weighted - b.weighted, a.weight - b.weight};
  }
  friend Homogeneous operator*(double s, const Homogeneous& a) {
    return {s * a.weighted, s * a.weight};
  }
};

/// The curve u -> (W P, W)(v, u) at one v, and its derivative by v.
struct Rows {
  DynamicPolynomial<Homogeneous> value, derivative;
};

DynamicPolynomial<Homogeneous> column(const RationalPatch& patch, std::size_t j) {
  std::vector<Homogeneous> coefficients(patch.degree_v + 1);
  for (std::size_t i = 0; i <= patch.degree_v; ++i) {
    coefficients[i] = {patch.weighted[patch.index(i, j)], patch.weights[patch.index(i, j)]};
  }
  return DynamicPolynomial<Homogeneous>(std::move(coefficients));
}

Rows rows_at(const RationalPatch& patch, double v) {
  std::vector<Homogeneous> value(patch.degree_u + 1), derivative(patch.degree_u + 1);
  for (std::size_t j = 0; j <= patch.degree_u; ++j) {
    const auto along = column(patch, j);
    value[j] = along.value(v);
    derivative[j] = along.derivative().value(v);
  }
  return {DynamicPolynomial<Homogeneous>(std::move(value)),
          DynamicPolynomial<Homogeneous>(std::move(derivative))};
}

/// (X/W)' from X, W and their derivatives.
Vector3<double> quotient_derivative(const Homogeneous& f, const Homogeneous& rate) {
  const double reciprocal = 1.0 / f.weight;
  return reciprocal * (rate.weighted - (rate.weight * reciprocal) * f.weighted);
}

}  // namespace

std::vector<Vector3<double>> RationalPatch::control_points() const {
  std::vector<Vector3<double>> points(weighted.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = (1.0 / weights[i]) * weighted[i];
  return points;
}

bool RationalPatch::weights_are_positive() const {
  return std::all_of(weights.begin(), weights.end(), [](double w) { return w > 0.0; });
}

Vector3<double> RationalPatch::position(double v, double u) const {
  return derivatives(v, u).position;
}

RationalPatch::Derivatives RationalPatch::derivatives(double v, double u) const {
  const Rows rows = rows_at(*this, v);
  const Homogeneous f = rows.value.value(u);
  return {(1.0 / f.weight) * f.weighted, quotient_derivative(f, rows.derivative.value(u)),
          quotient_derivative(f, rows.value.derivative().value(u))};
}

Vector3<double> RationalPatch::normal(double v, double u) const {
  const Derivatives d = derivatives(v, u);
  const Vector3<double> across = cross(d.along_u, d.along_v);
  const double size = norm(across);
  return size > 0.0 ? (1.0 / size) * across : Vector3<double>{};
}

RationalPatch RationalPatch::restricted_u(double a, double b) const {
  RationalPatch part = *this;
  part.begin_u = begin_u + a * (end_u - begin_u);
  part.end_u = begin_u + b * (end_u - begin_u);
  std::vector<Homogeneous> row(degree_u + 1);
  for (std::size_t i = 0; i <= degree_v; ++i) {
    for (std::size_t j = 0; j <= degree_u; ++j) {
      row[j] = {weighted[index(i, j)], weights[index(i, j)]};
    }
    const auto along = DynamicPolynomial<Homogeneous>(row).restricted(a, b);
    for (std::size_t j = 0; j <= degree_u; ++j) {
      part.weighted[index(i, j)] = along[j].weighted;
      part.weights[index(i, j)] = along[j].weight;
    }
  }
  return part;
}

RationalPatch RationalPatch::restricted_v(double a, double b) const {
  RationalPatch part = *this;
  part.begin_v = begin_v + a * (end_v - begin_v);
  part.end_v = begin_v + b * (end_v - begin_v);
  for (std::size_t j = 0; j <= degree_u; ++j) {
    const auto along = column(*this, j).restricted(a, b);
    for (std::size_t i = 0; i <= degree_v; ++i) {
      part.weighted[index(i, j)] = along[i].weighted;
      part.weights[index(i, j)] = along[i].weight;
    }
  }
  return part;
}

}  // namespace hodograph
