// SPDX-License-Identifier: MIT
// A path of any degree and dimension as what a check of separations asks of it: the point at an
// arc length, with a proof of how far it may be off.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "hodograph/foundation/accuracy.hpp"
#include "hodograph/path/curvature_parts.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph::planning_detail {

/// A point of a path. Points of the plane have the altitude they are flown at, z.
struct Place {
  Vector3<double> point{};
  double error = 0.0;       ///< a bound of the distance from the exact path's point at arc_length
  double arc_length = 0.0;  ///< s
  double parameter = 0.0;   ///< u within the segment
  double rate = 0.0;        ///< du/ds there, a guess
  std::uint32_t segment = 0;
};

/// How much the bounds of the parts and of the joins between two places allow.
struct Bend {
  double curvature;  ///< the largest bound; infinite where it is not looked up
  double turn;       ///< the sum of |difference of the unit tangents| at the joins
  double gap;        ///< the sum of the distances between the ends that should meet
};

/// The exact path is the sequence of the exact curves of the stored numbers, s its exact arc
/// length.
class PathPlaces {
 public:
  virtual ~PathPlaces() = default;
  /// The place at arc length s, 0 ≤ s ≤ length().
  virtual Place at(double s) const = 0;
  /// The same, a little faster between two places that are known, a before b.
  virtual Place between(double s, const Place& a, const Place& b) const = 0;

  /// Whether the other path has the same segments but for where they start, number by number: a
  /// number that differs where the paths do (seldom where not), and the comparison.
  std::uint64_t shape() const { return shape_; }
  virtual bool has_shape_of(const PathPlaces& other) const = 0;
  virtual std::size_t segment_count() const = 0;
  virtual Vector3<double> start_of(std::size_t segment) const = 0;

  double length() const { return parts_.arc_lengths.back(); }
  bool is_planar() const { return planar_; }
  /// A bound of every place's error.
  double rounding() const { return rounding_; }
  double largest_gap() const { return largest_gap_; }
  const CurvatureParts& parts() const { return parts_; }

  /// What lies between two places, a before b.
  Bend bend(const Place& a, const Place& b) const {
    Bend result{std::numeric_limits<double>::infinity(), 0.0, 0.0};
    if (a.segment != b.segment) {
      result.turn = joins_[b.segment].turn - joins_[a.segment].turn;
      result.gap = joins_[b.segment].gap - joins_[a.segment].gap;
    }
    const std::size_t first = part_of(a), last = part_of(b);
    constexpr std::size_t most = 8;  // more parts are looked at when the stretch is shorter
    if (last - first < most) {
      result.curvature = parts_.most_curvature[first];
      for (std::size_t i = first + 1; i <= last; ++i) {
        result.curvature = std::max(result.curvature, parts_.most_curvature[i]);
      }
    }
    return result;
  }

 protected:
  struct Join {
    double turn, gap;  ///< sums from the path's begin to the segment's, rounded up
  };

  std::size_t part_of(const Place& place) const {
    const auto part =
        static_cast<std::size_t>(place.parameter * static_cast<double>(parts_.per_segment));
    return place.segment * parts_.per_segment + std::min(part, parts_.per_segment - 1);
  }

  CurvatureParts parts_;
  std::vector<Join> joins_;  // one a segment
  double rounding_ = 0.0, largest_gap_ = 0.0;
  std::uint64_t shape_ = 0;
  bool planar_ = false;
};

/// A point of the plane at an altitude, or of space.
inline Vector3<double> in_space(const Vector2<double>& v, double altitude) {
  return {v.x, v.y, altitude};
}
inline const Vector3<double>& in_space(const Vector3<double>& v, double) { return v; }

/// The places of a path of static type.
///
/// From the point at u, with rest = s - s(u), a step du and r, s as Taylor polynomials of degree
/// two give a place that is off by at most
///   |rest - s' du - s'' du²/2| + 2 h C |du|³/6 + rounding,   C ≥ |r'''|/h, |s'''|/h on the
///   segment,
/// since a path is a function of arc length that nowhere changes faster than arc length does. The
/// first two terms are computed, and the search goes on until they are below the rounding:
///   |A|² and A i A* at u: (9n + 15) ε/2 of M = h max|A_i|² a component (accuracy.hpp), at most
///   (16n + 48) ε M together with the step; 8 ε of the largest coordinate; the rounding of arc
///   length.
template <class A, std::size_t n>
class PlacesOf final : public PathPlaces {
 public:
  /// The altitude is of a path in the plane; 0 in space.
  PlacesOf(Path<A, n> path, double altitude) : path_(std::move(path)), altitude_(altitude) {
    constexpr double eps = std::numeric_limits<double>::epsilon();
    constexpr std::size_t few = 16;  // parts of a short path
    planar_ = A::dimension == 2;
    const std::size_t count = path_.segment_count();
    parts_ = curvature_parts(path_, std::max<std::size_t>(1, (few + count - 1) / count));
    double size = 0.0, coordinate = std::abs(altitude);
    cubic_.reserve(count);
    joins_.reserve(count);
    Join sum{0.0, 0.0};
    for (std::size_t k = 0; k < count; ++k) {
      const auto& curve = path_.segment(k);
      const double reach = curve.parameter_step() * curve.speed_bound();
      size = std::max(size, reach);
      coordinate = std::max({coordinate, largest_component(curve.start()) + reach,
                             largest_component(curve.end()) + reach});
      cubic_.push_back(third_derivative_bound(curve) / 3.0);
      add_to_shape(curve);
      if (k > 0) add_join(path_.segment(k - 1), curve, sum);
      joins_.push_back(sum);
    }
    rounding_ = eps * (static_cast<double>(16 * n + 48) * size + 8.0 * coordinate) +
                parts_.arc_length_error;
  }

  bool has_shape_of(const PathPlaces& other) const override {
    const auto* same_type = dynamic_cast<const PlacesOf*>(&other);
    if (same_type == nullptr || segment_count() != same_type->segment_count()) return false;
    for (std::size_t k = 0; k < segment_count(); ++k) {
      const auto &a = path_.segment(k), &b = same_type->path_.segment(k);
      if (!(a.parameter_step() == b.parameter_step() && a.preimage() == b.preimage())) return false;
    }
    return true;
  }
  std::size_t segment_count() const override { return path_.segment_count(); }
  Vector3<double> start_of(std::size_t k) const override {
    return in_space(path_.segment(k).start(), altitude_);
  }

  Place at(double s) const override {
    const std::size_t k = path_.segment_at_arc_length(s);
    const double target = s - path_.knot_arc_lengths()[k];
    return search(s, k, target, target > 0.0 ? path_.arc_length_table(k).guess(target) : 0.0);
  }

  Place between(double s, const Place& a, const Place& b) const override {
    const double span = b.arc_length - a.arc_length;
    if (a.segment != b.segment || !(span > 0.0)) return at(s);
    // The cubic with the places' u and du/ds.
    const double x = (s - a.arc_length) / span, y = 1.0 - x;
    const double rise = b.parameter - a.parameter;
    const double guess =
        a.parameter + x * x * (3.0 - 2.0 * x) * rise + span * x * y * (y * a.rate - x * b.rate);
    const bool inside = a.parameter <= guess && guess <= b.parameter;
    const double target = s - path_.knot_arc_lengths()[a.segment];
    return search(s, a.segment, target, inside ? guess : a.parameter + x * rise);
  }

 private:
  void add_to_shape(const PhCurve<A, n>& curve) {
    const auto add = [&](double x) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &x, sizeof bits);
      shape_ = (shape_ ^ bits) * 1099511628211ULL;  // as FNV-1a does
      shape_ ^= shape_ >> 32;
    };
    add(curve.parameter_step());
    for (const A& a : curve.preimage().coefficients()) {
      for (std::size_t j = 0; j < A::dimension; ++j) add(a[j] + 0.0);  // -0 is 0
    }
  }

  /// h C.
  static double third_derivative_bound(const PhCurve<A, n>& curve) {
    double value = 0.0, first = 0.0, second = 0.0;
    const auto& a = curve.preimage().coefficients();
    for (std::size_t i = 0; i <= n; ++i) value = std::max(value, norm(a[i]));
    for (std::size_t i = 0; i + 1 <= n; ++i) first = std::max(first, norm(a[i + 1] - a[i]));
    for (std::size_t i = 0; i + 2 <= n; ++i) {
      second = std::max(second, norm((a[i + 2] - a[i + 1]) - (a[i + 1] - a[i])));
    }
    constexpr double m = static_cast<double>(n),
                     rounded_up = 1.0 + 0x1.0p-40;  // not a tolerance: far more than the roundings
    return rounded_up * (curve.parameter_step() *
                         (2.0 * (m * m * first * first + m * (m - 1.0) * value * second)));
  }

  void add_join(const PhCurve<A, n>& before, const PhCurve<A, n>& after, Join& sum) {
    constexpr double eps = std::numeric_limits<double>::epsilon();
    const auto tangent = [](const A& a) {
      const auto t = hodograph_form(a, a);
      const double size = norm(t);
      return size > 0.0 ? (1.0 / size) * t : decltype(t){};
    };
    const auto leaving = tangent(before.preimage().back());
    const auto entering = tangent(after.preimage().front());
    const bool known = dot(leaving, leaving) > 0.0 && dot(entering, entering) > 0.0;
    const double turn = known ? norm(entering - leaving) + 16.0 * eps : 2.0;
    const double reach = before.parameter_step() * before.speed_bound();
    const double gap = norm(after.start() - before.end()) +
                       eps * (static_cast<double>(8 * n + 32) * reach + 2.0 * norm(after.start()));
    constexpr double rounded_up = 1.0 + 4.0 * eps;
    sum = {(sum.turn + turn) * rounded_up, (sum.gap + gap) * rounded_up};
    largest_gap_ = std::max(largest_gap_, gap);
  }

  Place search(double s, std::size_t k, double target, double u) const {
    const auto& curve = path_.segment(k);
    const double h = curve.parameter_step();
    double low = 0.0, high = 1.0;
    constexpr int most_steps = 96;  // Halley's steps settle in one or two; bisection in 53
    for (int step = 0;; ++step) {
      const auto at = curve.evaluate(u);
      const double rest = target - at.integral.arc_length;
      const double speed = speed_form(at.preimage, at.preimage);
      const double turn = speed_form(at.preimage, at.preimage_rate);
      const double reciprocal = 1.0 / speed, newton = rest * reciprocal / h;
      const double bend = turn * reciprocal;
      const double du = std::clamp(u + (newton - newton * newton * bend), 0.0, 1.0) - u;
      const double left = rest - h * (du * (speed + du * turn));
      const double doubt = std::abs(left) + cubic_[k] * (du * du * std::abs(du));
      if (doubt <= rounding_) {
        const auto first = hodograph_form(at.preimage, at.preimage);
        const auto second = hodograph_form(at.preimage, at.preimage_rate);
        const auto point =
            curve.start() + (at.integral.displacement + (h * du) * (first + du * second));
        return {in_space(point, altitude_),   rounding_ + doubt, s, u + du, reciprocal / h,
                static_cast<std::uint32_t>(k)};
      }
      // A point of zero speed, or too many steps: the point itself, off by what is left.
      if (std::abs(rest) <= rounding_ || step >= most_steps) {
        return {in_space(curve.start() + at.integral.displacement, altitude_),
                rounding_ + std::abs(rest),
                s,
                u,
                0.0,
                static_cast<std::uint32_t>(k)};
      }
      (rest > 0.0 ? low : high) = u;
      const double trial = u + newton / (1.0 + newton * bend);
      u = low < trial && trial < high ? trial : 0.5 * (low + high);
    }
  }

  Path<A, n> path_;
  double altitude_;
  std::vector<double> cubic_;  // h C/3
};

}  // namespace hodograph::planning_detail
