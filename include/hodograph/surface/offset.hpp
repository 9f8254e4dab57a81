// SPDX-License-Identifier: MIT
// Offset curves of planar paths: exactly rational, in Bézier form; their cusps, and the distances
// without any.
//
// The offset at the signed distance d is r + d n, n = i w²/σ the normal to the left: positive
// distances lie to the left. With the tangent direction of r it has the derivative (1 - dκ) σ: it
// has a cusp where 1 - dκ = 0, and runs backwards where that is negative. On a segment of preimage
// degree n it is the rational curve (σ r + d i w²)/σ, of degree 4n + 1 (9 for a quintic).
//
// A path's offset is the sequence of its segments' offsets. They meet at a knot where the direction
// of the tangent is continuous (G¹). At a corner of angle α they are 2 |d| sin(α/2) apart on one
// side and cross on the other: they are neither joined nor trimmed here, as they are not where the
// offset crosses itself.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/bernstein/roots.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/bounds.hpp"
#include "hodograph/path/planar_curvature.hpp"

namespace hodograph {

/// A rational Bézier curve Σ (w P)_i B_i / Σ w_i B_i in the plane, of degree m.
template <std::size_t m>
struct RationalCurve {
  static constexpr std::size_t degree = m;
  BernsteinPolynomial<Vector2<double>, m> weighted;  ///< (X, Y) of the homogeneous control points
  BernsteinPolynomial<double, m> weight;             ///< W of the homogeneous control points

  /// Domain: u in [0, 1], a weight that is not 0 there.
  Vector2<double> position(double u) const { return (1.0 / weight.value(u)) * weighted.value(u); }
  /// The control points (X, Y)/W. Domain: no weight is 0.
  std::array<Vector2<double>, m + 1> control_points() const {
    std::array<Vector2<double>, m + 1> points;
    for (std::size_t i = 0; i <= m; ++i) points[i] = (1.0 / weight[i]) * weighted[i];
    return points;
  }
};

/// The degree 4n + 1 of the offset of a curve of preimage degree n.
constexpr std::size_t offset_degree(std::size_t preimage_degree) { return 4 * preimage_degree + 1; }

/// A piece of a path's offset, all of whose weights are positive.
template <std::size_t n>
struct OffsetPiece {
  std::size_t segment;      ///< of the path
  double xi_begin, xi_end;  ///< the parameters it covers
  RationalCurve<offset_degree(n)> curve;
};

/// A zero of 1 - dκ, as IsolatedRoot tells of it: where the kind is simple, a cusp.
struct OffsetCusp {
  double xi = 0.0;
  Enclosure xi_range;  ///< contains the true parameter
  RootKind kind = RootKind::cluster;
};

/// 1 - dκ > 0 everywhere, so that the offset has no cusp and runs forward, exactly for distances d
/// in
/// (-ρ_right, ρ_left). Any number between the ends of an enclosure may be the limit; its lower end
/// is safe.
struct CuspFreeOffsets {
  Enclosure right;  ///< ρ_right = 1/max(-κ); without upper end where the path never turns right
  Enclosure left;   ///< ρ_left = 1/max κ; without upper end where the path never turns left
};

/// r(u) + d n(u), to evaluation accuracy. Throws Error (zero_speed) where w(u) = 0.
template <std::size_t n>
Vector2<double> offset_position(const PhCurve<Complex<double>, n>& curve, double u,
                                double distance) {
  const Complex<double> w = curve.preimage().value(u);
  const double size = std::hypot(w.re, w.im);
  if (!(size > 0.0)) {
    throw Error(Fault{FaultCode::zero_speed,
                      "the speed is zero at u = " + to_text(u) + ", where a curve has no normal",
                      std::nullopt, "speed", 0.0, std::nullopt});
  }
  const double c = w.re / size, s = w.im / size;  // of half the tangent's angle
  return curve.position(u) + distance * Vector2<double>{-2.0 * c * s, c * c - s * s};
}
/// The same at ξ of a path; at a knot that of the later segment. Throws Error as well where ξ is
/// outside the knots.
template <std::size_t n>
Vector2<double> offset_position(const PlanarPath<n>& path, double xi, double distance) {
  const auto at = path.locate(xi);
  return offset_position(path.segment(at.segment), at.u, distance);
}

/// The offset of one curve: W = σ, (X, Y) = σ r + d i w², each coefficient to a few roundings of
/// the largest product it is made of. (Relative to a far origin they lose what coordinates lose.)
/// σ is elevated by 2n + 1 degrees; weights of a curve whose speed varies much may be negative.
template <std::size_t n>
RationalCurve<offset_degree(n)> rational_offset(const PhCurve<Complex<double>, n>& curve,
                                                double distance) {
  constexpr std::size_t m = offset_degree(n);
  const auto speed = curve.speed_polynomial();
  const auto position =
      curve.displacement().mapped([&](const Vector2<double>& d) { return curve.start() + d; });
  const auto normal = curve.hodograph().mapped([distance](const Vector2<double>& h) {
    return Vector2<double>{-distance * h.y, distance * h.x};
  });
  RationalCurve<m> offset;
  offset.weight = speed.template elevated<m>();
  offset.weighted =
      product(position, speed, [](const Vector2<double>& r, double sigma) { return sigma * r; }) +
      normal.template elevated<m>();
  return offset;
}

/// The offset of a path as rational Bézier pieces with positive weights, in sequence: one a segment
/// where its weights are positive, halves of it where they are not.
/// Faults: not_finite (the distance), zero_speed (a segment, by index, whose speed comes to zero
/// within rounding: there is no normal).
template <std::size_t n>
Result<std::vector<OffsetPiece<n>>> rational_offset(const PlanarPath<n>& path, double distance) {
  if (!std::isfinite(distance)) {
    return Fault{
        FaultCode::not_finite, "the offset distance is infinite or not a number; it must be finite",
        std::nullopt,          "distance",
        std::nullopt,          std::nullopt};
  }
  constexpr double shortest = 0x1.0p-24;  // of a segment: there the speed is 2^-48 of its size
  struct Part {
    double a, b;
  };
  std::vector<OffsetPiece<n>> pieces;
  std::vector<Part> open;
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    open.push_back({0.0, 1.0});
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      const auto part = a == 0.0 && b == 1.0 ? path.segment(k) : path.segment(k).restricted(a, b);
      auto offset = rational_offset(part, distance);
      const auto& weights = offset.weight.coefficients();
      if (std::all_of(weights.begin(), weights.end(), [](double w) { return w > 0.0; })) {
        pieces.push_back({k, path.xi_of({k, a}), path.xi_of({k, b}), offset});
        continue;
      }
      if (b - a <= shortest) {
        return Fault{FaultCode::zero_speed,
                     "the speed of segment " + std::to_string(k) + " comes to zero at xi = " +
                         to_text(path.xi_of({k, a})) + ", where an offset has no normal",
                     k,
                     "speed",
                     0.0,
                     std::nullopt};
      }
      const double middle = 0.5 * (a + b);
      open.push_back({middle, b});
      open.push_back({a, middle});
    }
  }
  return pieces;
}

/// The zeros of 1 - dκ, ascending, segment by segment: the isolated roots of hσ² - 2ndτ of degree
/// 4n (κ = 2nτ/(hσ²), h the parameter step). Every cusp of the exact curve lies in one of the
/// `xi_range`s, rounding included; a point of zero speed is one, too. d = 0 gives only those.
/// Domain: d finite.
template <std::size_t n>
std::vector<OffsetCusp> offset_cusps(const PlanarPath<n>& path, double distance) {
  std::vector<OffsetCusp> cusps;
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const path_detail::EnclosedCurve<Complex<double>, n> exact(path.segment(k));
    const Enclosure unit = path_detail::power_of_two(exact.exponent());
    const Enclosure scale = (exact.step() * unit) * unit;
    const Enclosure turn = Enclosure(-2.0 * static_cast<double>(n)) * Enclosure(distance);
    const auto square = symmetric_square(
        exact.speed(), [](const Enclosure& a, const Enclosure& b) { return a * b; });
    const auto turning = path_detail::turning_polynomial(exact.preimage());
    const auto f = scale * square + turn * turning.template elevated<4 * n>();
    for (const IsolatedRoot& root : path_detail::places(f)) {
      auto cusp = path_detail::place_of<OffsetCusp>(path, k, root.u);
      cusp.kind = root.kind;
      cusps.push_back(cusp);
    }
  }
  return cusps;
}

/// The largest distances to either side up to which offsets have no cusp, from the extremes of the
/// signed curvature (curvature_extremes): certain, rounding included. Both are 0 at most where the
/// speed may vanish.
inline CuspFreeOffsets cusp_free_offsets(const Extremes& curvature) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double largest = std::numeric_limits<double>::max();
  // 1/κ for the largest curvature to one side.
  const auto radius = [largest](double least, double most) {
    const Enclosure one(1.0);
    const double low = most <= 0.0        ? largest
                       : most == infinity ? 0.0
                                          : std::min(largest, (one / Enclosure(most)).lower());
    const double high = least <= 0.0 ? infinity : (one / Enclosure(least)).upper();
    return Enclosure(low, high);
  };
  return {radius(-curvature.minimum.upper(), -curvature.minimum.lower()),
          radius(curvature.maximum.lower(), curvature.maximum.upper())};
}
/// The same of a path, whose extremes are refined as the goal asks.
template <std::size_t n>
CuspFreeOffsets cusp_free_offsets(const PlanarPath<n>& path, const RangeGoal& goal) {
  return cusp_free_offsets(curvature_extremes(path, goal));
}

}  // namespace hodograph
