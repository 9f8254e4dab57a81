// SPDX-License-Identifier: MIT
// The distance of one segment from a point, as polynomials with enclosures as coefficients.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "hodograph/bernstein/roots.hpp"
#include "hodograph/foundation/accuracy.hpp"
#include "hodograph/path/detail/enclosed_curve.hpp"

namespace hodograph::path_detail {

/// |v|, without overflow where the result does not overflow.
template <class V>
double safe_norm(const V& v) {
  if constexpr (V::dimension == 2) {
    return std::hypot(v.x, v.y);
  } else {
    return std::hypot(v.x, v.y, v.z);
  }
}

inline int sign_of(const Enclosure& x) { return x.lower() > 0.0 ? 1 : x.upper() < 0.0 ? -1 : 0; }

/// In units of 2^exponent: D = r - q of degree 2n + 1, and f = D·B i B* (or D·w²), of degree 4n +
/// 1, which is (r - q)·r' up to a positive factor.
template <class A, std::size_t n>
class SegmentDistance {
 public:
  using Exact = EnclosedCurve<A, n>;
  using Point = typename Exact::Point;
  static constexpr std::size_t degree = 4 * n + 1;

  SegmentDistance(const PhCurve<A, n>& curve, const point_t<A>& q) {
    const Exact exact(curve);
    const Point offset = enclosed(curve.start()) - enclosed(q);
    // Everything is divided by the larger of the offset and the length, at least 2^-1000.
    constexpr int least_exponent = -1000;
    exponent_ =
        std::max(least_exponent, exponent_of(curve.parameter_step()) + 2 * exact.exponent() + 1);
    for (std::size_t j = 0; j < Point::dimension; ++j) {
      const double size = std::min(offset[j].magnitude(), std::numeric_limits<double>::max());
      exponent_ = std::max(exponent_, exponent_of(size));
    }
    factor_ = (exact.step() * power_of_two(exact.exponent())) *
              power_of_two(exact.exponent() - exponent_);
    const Enclosure unit = power_of_two(-exponent_);
    const auto hodograph = exact.hodograph();
    separation_ = hodograph.antiderivative().mapped(
        [&](const Point& d) { return unit * offset + factor_ * d; });
    slope_ =
        product(separation_, hodograph, [](const Point& a, const Point& b) { return dot(a, b); });
  }

  /// The signs of (r - q)·r' at u = 0 and u = 1; 0 where not known.
  int first_sign() const { return sign_of(slope_.front()); }
  int last_sign() const { return sign_of(slope_.back()); }

  /// The zeros of (r - q)·r'; the whole segment as one cluster where it vanishes identically or
  /// exceeds the range of numbers.
  std::vector<IsolatedRoot> roots() const {
    auto found = isolated_roots(slope_);
    if (!found) return {{Enclosure(0.0, 1.0), RootKind::cluster, 0, 0}};
    return std::move(found).value();
  }

  /// How far from u = 0 (or u = 1, `at_end`) a zero may be moved by the rounding of a join: 0 where
  /// (r - q)·r' at the end exceeds that rounding.
  double join_reach(bool at_end) const {
    double size = 0.0;
    for (const Enclosure& c : slope_.coefficients()) size = std::max(size, c.magnitude());
    const double noise = accuracy::join_error<double>() * size;
    const std::size_t i = at_end ? degree : 0, beside = at_end ? degree - 1 : 1;
    if (!(slope_[i].mignitude() <= noise)) return 0.0;
    constexpr double farthest =
        0x1.0p-10;  // not further, however flat it is: zeros there are distinct
    const double rise = static_cast<double>(degree) * (slope_[beside] - slope_[i]).magnitude();
    // Between the end, where it is at most the noise, and a zero there is at most twice the noise.
    return rise > 0.0 ? std::min(farthest, 4.0 * noise / rise) : farthest;
  }

  /// |r - q| at one point u of [0, 1].
  Enclosure distance(double u) const { return scaled_back(sqrt(squared(u))); }
  /// The least |r - q| over u: |D|² changes by 2 ∫ factor · f over the interval.
  Enclosure least_distance(const Enclosure& u) const {
    const Enclosure here = squared(u.middle());
    Enclosure slope(0.0);
    const auto part = u.width() == 0.0 ? slope_ : slope_.restricted(u.lower(), u.upper());
    for (const Enclosure& c : part.coefficients()) slope = Enclosure::hull(slope, c);
    const Enclosure change = Enclosure(2.0 * u.width()) * (factor_ * Enclosure(slope.magnitude()));
    const double least = std::max(0.0, (here - change).lower());
    return scaled_back({sqrt(Enclosure(least)).lower(), sqrt(here).upper()});
  }

 private:
  Enclosure squared(double u) const {
    const Point d = u == 0.0   ? separation_.front()
                    : u == 1.0 ? separation_.back()
                               : separation_.value(Enclosure(u));
    Enclosure sum(0.0);
    for (std::size_t j = 0; j < Point::dimension; ++j) sum += hodograph::square(d[j]);
    return sum;
  }
  Enclosure scaled_back(const Enclosure& x) const {
    const Enclosure result = x * power_of_two(exponent_);
    return {std::max(0.0, result.lower()), result.upper()};
  }

  int exponent_ = 0;
  Enclosure factor_;
  BernsteinPolynomial<Point, 2 * n + 1> separation_;
  BernsteinPolynomial<Enclosure, degree> slope_;
};

/// A lower bound of |r - q| on a segment for a handful of operations: with a, b its ends and L its
/// length, |a - q| + |b - q| ≤ |r - a| + |r - b| + 2 |r - q| ≤ L + 2 |r - q|.
template <class A, std::size_t n>
double quick_distance_bound(const PhCurve<A, n>& curve, const point_t<A>& q) {
  // The stored end and length are sums of 2n + 1 coefficients, each a sum of at most n + 1 products
  // of size at most 2 M, M the speed bound: (3n + 14) ε h M a component is more than their
  // rounding. Three such numbers enter, with factor 1/2; the rest are a few roundings of the
  // coordinates.
  const double size = curve.parameter_step() * curve.speed_bound() +
                      largest_component(curve.start()) + largest_component(q);
  const double margin = static_cast<double>(16 * n + 128) * epsilon<double>() * size;
  const double bound =
      0.5 * (safe_norm(curve.start() - q) + safe_norm(curve.end() - q) - curve.arc_length()) -
      margin;
  return bound > 0.0 ? bound : 0.0;
}

}  // namespace hodograph::path_detail
