// SPDX-License-Identifier: MIT
// The smallest and the largest value of a Bernstein polynomial on [0, 1], of the norm of a vector
// polynomial, and of quotients of these: enclosed rigorously and refined to a requested width.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/foundation/enclosure.hpp"

namespace hodograph {

/// Where a function's smallest value and where its largest value lie.
struct Extremes {
  Enclosure minimum, maximum;

  /// The range that no value leaves.
  Enclosure range() const { return {minimum.lower(), maximum.upper()}; }
  friend bool operator==(const Extremes&, const Extremes&) = default;
};

/// How far to refine: until upper - lower ≤ relative_width · max(|lower|, |upper|), for the minimum
/// and the maximum each. Refinement ends earlier at rounding noise and after `subdivisions`
/// subdivisions; the enclosures are rigorous all the same, only wider.
struct RangeGoal {
  double relative_width;
  std::size_t subdivisions = 4096;
};

/// A quotient f = factor · v/g on [0, 1] of a vector polynomial v and a polynomial g of the same
/// degree; where g is absent it is 1. The factor is positive.
class BernsteinQuotient {
 public:
  /// v/1.
  template <class V, std::size_t n>
  static BernsteinQuotient of(const BernsteinPolynomial<V, n>& v) {
    BernsteinQuotient quotient;
    quotient.degree_ = n;
    quotient.add_components(v);
    return quotient;
  }
  /// v/g; v is elevated to the degree of g.
  template <class V, class S, std::size_t m, std::size_t n>
    requires(m <= n)
  static BernsteinQuotient of(const BernsteinPolynomial<V, m>& v,
                              const BernsteinPolynomial<S, n>& g) {
    BernsteinQuotient quotient = of(v.template elevated<n>());
    quotient.has_denominator_ = true;
    for (std::size_t i = 0; i <= n; ++i) quotient.coefficients_.push_back(Enclosure(g[i]));
    return quotient;
  }

  /// The same quotient times a positive number.
  BernsteinQuotient times(const Enclosure& positive) && {
    factor_ = factor_ * positive;
    return std::move(*this);
  }

  std::size_t degree() const { return degree_; }
  std::size_t dimension() const { return dimension_; }
  bool has_denominator() const { return has_denominator_; }
  const Enclosure& factor() const { return factor_; }
  /// The coefficients of component i of v, or of g for i = dimension().
  std::span<const Enclosure> row(std::size_t i) const {
    return std::span<const Enclosure>(coefficients_).subspan(i * (degree_ + 1), degree_ + 1);
  }

 private:
  template <class V, std::size_t n>
  void add_components(const BernsteinPolynomial<V, n>& v) {
    if constexpr (requires { V::dimension; }) {
      dimension_ = V::dimension;
      for (std::size_t j = 0; j < V::dimension; ++j) {
        for (std::size_t i = 0; i <= n; ++i) coefficients_.push_back(Enclosure(v[i][j]));
      }
    } else {
      for (std::size_t i = 0; i <= n; ++i) coefficients_.push_back(Enclosure(v[i]));
    }
  }

  std::size_t degree_ = 0, dimension_ = 1;
  bool has_denominator_ = false;
  Enclosure factor_{1.0};
  std::vector<Enclosure> coefficients_;
};

/// What is bounded of a quotient: its value (of the first component), or the norm of the vector.
enum class RangeMeasure { value, norm };

/// The extremes over `count` quotients together, quotient(0) ... quotient(count - 1), such as the
/// segments of a path. Coefficients are enclosures: the result holds for any numbers within them.
/// An upper (lower) end is infinite where g may vanish, which includes touching zero within
/// rounding; never NaN.
///
/// Method: best-first subdivision. On a piece where all g_i > 0, min_i v_i/g_i ≤ v/g ≤ max_i
/// v_i/g_i, since v - M g has coefficients v_i - M g_i ≤ 0 for M = max_i v_i/g_i; and |v|/g ≤ max_i
/// |v_i|/g_i, |v|/g ≥ min_i (v_i·d)/g_i for every unit vector d. The gap to the values at the ends
/// of the piece shrinks with the square of its length. Domain: count ≥ 1 (the whole line for 0).
Extremes extremes(std::size_t count, const std::function<BernsteinQuotient(std::size_t)>& quotient,
                  RangeMeasure measure, const RangeGoal& goal);

/// The extremes of f on [0, 1], coefficients double or Enclosure.
template <class S, std::size_t n>
  requires(std::convertible_to<S, Enclosure>)
Extremes extremes(const BernsteinPolynomial<S, n>& f, const RangeGoal& goal) {
  return extremes(
      1, [&](std::size_t) { return BernsteinQuotient::of(f); }, RangeMeasure::value, goal);
}

/// The extremes of |v| on [0, 1], components double or Enclosure.
template <class V, std::size_t n>
  requires requires { V::dimension; }
Extremes norm_extremes(const BernsteinPolynomial<V, n>& v, const RangeGoal& goal) {
  return extremes(
      1, [&](std::size_t) { return BernsteinQuotient::of(v); }, RangeMeasure::norm, goal);
}

/// A bound of f on [0, 1] at no cost: the hull of its coefficients.
template <class S, std::size_t n>
  requires(std::convertible_to<S, Enclosure>)
Enclosure coefficient_hull(const BernsteinPolynomial<S, n>& f) {
  Enclosure hull(f[0]);
  for (std::size_t i = 1; i <= n; ++i) hull = Enclosure::hull(hull, Enclosure(f[i]));
  return hull;
}

}  // namespace hodograph
