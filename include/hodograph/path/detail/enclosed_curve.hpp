// SPDX-License-Identifier: MIT
// The exact curve of the numbers that a PhCurve stores, as polynomials whose coefficients are
// enclosures.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <vector>

#include "hodograph/curve/ph_curve.hpp"
#include "hodograph/foundation/enclosure.hpp"

namespace hodograph::path_detail {

template <class A>
struct Enclosed;
template <>
struct Enclosed<Complex<double>> {
  using type = Complex<Enclosure>;
};
template <>
struct Enclosed<Quaternion<double>> {
  using type = Quaternion<Enclosure>;
};
template <>
struct Enclosed<Vector2<double>> {
  using type = Vector2<Enclosure>;
};
template <>
struct Enclosed<Vector3<double>> {
  using type = Vector3<Enclosure>;
};

/// The same numbers as enclosures.
template <class V>
typename Enclosed<V>::type enclosed(const V& v) {
  typename Enclosed<V>::type result;
  for (std::size_t i = 0; i < V::dimension; ++i) result[i] = Enclosure(v[i]);
  return result;
}

/// 2^exponent, enclosed also where it is not a double.
inline Enclosure power_of_two(int exponent) {
  const double power = std::ldexp(1.0, exponent);
  if (power == 0.0) return {0.0, std::numeric_limits<double>::denorm_min()};
  if (!std::isfinite(power)) {
    return {std::numeric_limits<double>::max(), std::numeric_limits<double>::infinity()};
  }
  return power;
}

/// The exponent e with 2^(e-1) ≤ x < 2^e; 0 for 0. Domain: finite.
inline int exponent_of(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return x == 0.0 ? 0 : exponent;
}

/// The polynomials of one segment, written with the preimage B = 2^-exponent A, whose largest
/// component lies between 1/2 and 1, so that squares and quotients stay in range for every scale.
template <class A, std::size_t n>
class EnclosedCurve {
 public:
  using Algebra = typename Enclosed<A>::type;
  using Point = point_t<Algebra>;

  explicit EnclosedCurve(const PhCurve<A, n>& curve) : step_(curve.parameter_step()) {
    double size = 0.0;
    for (const A& a : curve.preimage().coefficients()) size = std::max(size, largest_component(a));
    exponent_ = exponent_of(size);
    for (std::size_t i = 0; i <= n; ++i) {
      for (std::size_t j = 0; j < A::dimension; ++j) {
        const double x = curve.preimage()[i][j], b = std::ldexp(x, -exponent_);
        // Inexact only where it is subnormal.
        const bool exact = std::ldexp(b, exponent_) == x;
        preimage_[i][j] = exact ? Enclosure(b) : Enclosure(Enclosure::down(b), Enclosure::up(b));
      }
    }
  }

  /// The part on [a, b] of the local parameter, 0 ≤ a < b ≤ 1, without its place in space.
  EnclosedCurve restricted(double a, double b) const {
    EnclosedCurve part = *this;
    if (a == 0.0 && b == 1.0) return part;
    part.preimage_ = preimage_.restricted(Enclosure(a), Enclosure(b));
    part.step_ = step_ * (Enclosure(b) - Enclosure(a));
    return part;
  }

  const BernsteinPolynomial<Algebra, n>& preimage() const { return preimage_; }
  int exponent() const { return exponent_; }
  const Enclosure& step() const { return step_; }

  /// form(B, B) for a symmetric form.
  template <class Form>
  auto square(const Form& form) const {
    return symmetric_square(preimage_, form);
  }
  BernsteinPolynomial<Enclosure, 2 * n> speed() const {
    return square([](const Algebra& a, const Algebra& b) { return speed_form(a, b); });
  }
  BernsteinPolynomial<Point, 2 * n> hodograph() const {
    return square([](const Algebra& a, const Algebra& b) { return hodograph_form(a, b); });
  }
  /// vec(B* B') with ' = d/du: half of σ times the body rate, times 4^-exponent.
  auto body_rate() const {
    return product(preimage_, preimage_.derivative(),
                   [](const Algebra& a, const Algebra& b) { return body_rate_form(a, b); });
  }

 private:
  Enclosure step_;
  int exponent_ = 0;
  BernsteinPolynomial<Algebra, n> preimage_;
};

/// A part of a segment, by its local parameter.
struct SegmentPart {
  std::size_t segment;
  double a, b;
};

/// The segments of a path, divided so that on each part the speed varies by a bounded factor: where
/// it comes close to zero, squares and quotients formed from the part's own preimage keep digits
/// that those of the whole segment lose. Next to a zero the division ends at a depth.
template <class PathType>
void add_evenly_fast_parts(const PathType& path, std::size_t k, std::vector<SegmentPart>& parts) {
  constexpr double most_variation = 256.0;  // in σ: 16 bits of σ²
  constexpr double least_part = 0x1.0p-24;  // a zero of A: |A| there is 2^-24 of its size, σ² 2^-96
  const EnclosedCurve exact(path.segment(k));
  std::vector<SegmentPart> open{{k, 0.0, 1.0}};
  while (!open.empty()) {
    const SegmentPart part = open.back();
    open.pop_back();
    const auto speed = exact.restricted(part.a, part.b).speed();
    double least = speed[0].lower(), most = 0.0;
    for (const Enclosure& c : speed.coefficients()) {
      least = std::min(least, c.lower());
      most = std::max(most, c.upper());
    }
    if (most <= most_variation * least || part.b - part.a <= least_part) {
      parts.push_back(part);
    } else {
      const double middle = 0.5 * (part.a + part.b);
      open.push_back({k, middle, part.b});
      open.push_back({k, part.a, middle});
    }
  }
}

/// Those of all segments.
template <class PathType>
std::vector<SegmentPart> evenly_fast_parts(const PathType& path) {
  std::vector<SegmentPart> parts;
  for (std::size_t k = 0; k < path.segment_count(); ++k) add_evenly_fast_parts(path, k, parts);
  return parts;
}

}  // namespace hodograph::path_detail
