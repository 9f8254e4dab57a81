// SPDX-License-Identifier: MIT
// The largest norm of a polynomial on [0, 1], by branch and bound on its control points, rigorous
// in double precision. Component-major, so that a split is a few vector operations.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "hodograph/foundation/enclosure.hpp"

namespace hodograph {

/// An enclosure of the largest norm of a polynomial on [0, 1], and where its lower end is met.
struct NormBound {
  Enclosure norm{};
  double at = 0.0;
};

namespace error_detail {

/// A bound of |computed - exact| relative to the sum of the sizes of the terms, where every term
/// passes at most `count` < 2^20 correctly rounded operations: (1 + ε/2)^count - 1.
inline Enclosure roundings(std::size_t count) {
  const double plain = static_cast<double>(count) * (0.5 * std::numeric_limits<double>::epsilon());
  // (1 + x)^m - 1 ≤ m x (1 + m x) for m x ≤ 1.
  return Enclosure((Enclosure(plain) * (Enclosure(1.0) + Enclosure(plain))).upper());
}

/// Lets `largest` be at least `size`; infinite, and so for good, where that is not a number.
inline void raise_to(double& largest, double size) {
  if (!(size <= largest)) {
    largest = size < std::numeric_limits<double>::infinity()
                  ? size
                  : std::numeric_limits<double>::infinity();
  }
}

/// Coefficients of the components of a vector polynomial.
template <std::size_t dimension, std::size_t d>
using Components = std::array<std::array<double, d + 1>, dimension>;

/// The halves of a polynomial: `f` becomes the part on [0, 1/2] and `right` the one on [1/2, 1].
/// Each coefficient passes at most d roundings of convex combinations (halving is exact).
template <std::size_t dimension, std::size_t d>
void halve(Components<dimension, d>& f, Components<dimension, d>& right) {
  for (std::size_t c = 0; c < dimension; ++c) {
    auto& point = f[c];
    std::array<double, d + 1> left{};
    for (std::size_t r = 0; r < d; ++r) {
      left[r] = point[0];
      right[c][d - r] = point[d - r];
      for (std::size_t i = 0; i + r < d; ++i) point[i] = 0.5 * point[i] + 0.5 * point[i + 1];
    }
    left[d] = right[c][0] = point[0];
    point = left;
  }
}

template <std::size_t dimension, std::size_t d>
class LargestNorm {
 public:
  using Polynomial = Components<dimension, d>;

  /// A piece is divided no further once its bound exceeds the largest value seen by less than this
  /// fraction; the gap shrinks by four with each division, so this costs few.
  static constexpr double sharpness = 1.0 / 64.0;
  /// Never more than 2^6 pieces.
  static constexpr int depth_limit = 6;

  /// `slack`: differences of this size do not matter.
  explicit LargestNorm(double slack) : slack_(slack) {}

  void run(Polynomial f) {
    see(value_at(f, 0), 0.0);
    see(value_at(f, d), 1.0);
    visit(f, 0.0, 1.0, 0);
  }

  double seen_square() const { return seen_; }
  double bound_square() const { return bound_; }
  double at() const { return at_; }

 private:
  static double value_at(const Polynomial& f, std::size_t j) {
    double sum = 0.0;
    for (std::size_t c = 0; c < dimension; ++c) sum += f[c][j] * f[c][j];
    return sum;
  }
  void see(double square, double at) {
    if (square > seen_) {
      seen_ = square;
      at_ = at;
    }
    const double enough = (1.0 + sharpness) * std::sqrt(seen_) + slack_;
    enough_ = enough * enough;
  }
  void visit(Polynomial& f, double begin, double width, int depth) {
    double bound = 0.0;
    for (std::size_t j = 0; j <= d; ++j) bound = std::max(bound, value_at(f, j));
    if (bound <= enough_ || depth == depth_limit) {
      bound_ = std::max(bound_, bound);
      return;
    }
    Polynomial right;
    halve<dimension, d>(f, right);
    see(value_at(f, d), begin + 0.5 * width);
    visit(f, begin, 0.5 * width, depth + 1);
    visit(right, begin + 0.5 * width, 0.5 * width, depth + 1);
  }

  double slack_;
  double seen_ = 0.0, bound_ = 0.0, enough_ = 0.0, at_ = 0.0;
};

/// See hodograph::largest_norm.
template <std::size_t dimension, std::size_t d>
NormBound largest_norm(const Components<dimension, d>& f, double radius) {
  double largest = 0.0;
  for (const auto& component : f) {
    for (const double c : component) raise_to(largest, std::abs(c));
  }
  const double infinity = std::numeric_limits<double>::infinity();
  if (!(largest < infinity) || !(radius < infinity)) return {Enclosure(0.0, infinity), 0.0};
  if (largest == 0.0) return {Enclosure(0.0, radius), 0.0};

  // Scaled by a power of two so that no square overflows, and none that matters underflows.
  int exponent = 0;
  std::frexp(largest, &exponent);
  Components<dimension, d> scaled = f;
  for (auto& component : scaled) {
    for (double& c : component) c = std::ldexp(c, -exponent);
  }
  LargestNorm<dimension, d> search(LargestNorm<dimension, d>::sharpness *
                                   std::min(1.0, std::ldexp(radius, -exponent)));
  search.run(scaled);

  // In the scaled polynomial the largest component is in [1/2, 1]. Splitting adds at most
  // depth_limit d roundings to a component, the squares and their sum dimension + 1 to the norm;
  // what scaling or squaring lost to underflow is below one rounding of 1/2.
  const std::size_t count = LargestNorm<dimension, d>::depth_limit * d + dimension + 4;
  const Enclosure noise = roundings(count) * Enclosure(2.0);  // √3 < 2 components of size ≤ 1
  const Enclosure seen = sqrt(Enclosure(search.seen_square())) - noise;
  const Enclosure bound = sqrt(Enclosure(search.bound_square())) + noise;
  const Enclosure unit(std::ldexp(1.0, exponent - 1));  // 2^exponent may overflow
  const Enclosure two(2.0), wide(radius);
  const double lower = (unit * (two * seen) - wide).lower();
  const double upper = (unit * (two * bound) + wide).upper();
  return {Enclosure(std::max(0.0, lower), upper), search.at()};
}

}  // namespace error_detail
}  // namespace hodograph
