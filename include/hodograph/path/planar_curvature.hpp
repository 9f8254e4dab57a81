// SPDX-License-Identifier: MIT
// Where the curvature of a planar path is stationary, where it vanishes, and whether it keeps a
// limit.
//
// The curvature is that of the exact curve of the stored numbers (see path/bounds.hpp), signed,
// positive to the left: κ = h/σ² with h = 2 Im(w* w'), κ' = f/σ³ with f = σ h' - 2 h σ', ' = d/dξ
// ("Path planning with Pythagorean-hodograph curves for unmanned or autonomous vehicles", section
// 6, with the conjugate of the first factor of (14)). For a preimage of degree n, h has degree 2n -
// 2 and f degree 4n - 3.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "hodograph/bernstein/roots.hpp"
#include "hodograph/foundation/answer.hpp"
#include "hodograph/path/bounds.hpp"
#include "hodograph/path/detail/distance_search.hpp"
#include "hodograph/path/detail/enclosed_curve.hpp"
#include "hodograph/path/detail/quick_curvature.hpp"
#include "hodograph/path/detail/turning_polynomial.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// What the signed curvature does at a stationary point, by the signs of f on both sides.
enum class CurvatureExtremeKind {
  minimum,    ///< it falls before and rises after
  maximum,    ///< it rises before and falls after
  undecided,  ///< within rounding, anything: a multiple zero of f, several, none; also a zero whose
              ///< enclosure reaches the end of its segment, and a point of zero speed
};

/// A zero of f. `xi` lies in `xi_range`, which contains the true parameter.
struct CurvatureStationaryPoint {
  double xi = 0.0;
  Enclosure xi_range;
  Enclosure curvature;  ///< of every κ on xi_range; the whole line where the speed may vanish
  CurvatureExtremeKind kind = CurvatureExtremeKind::undecided;
};

/// A zero of h: the curvature changes its sign there if `kind` is simple.
struct Inflection {
  double xi = 0.0;
  Enclosure xi_range;
  RootKind kind = RootKind::cluster;
};

namespace path_detail {

/// The roots in [0, 1] of a polynomial that says where something happens: none where it is exactly
/// zero, so that nothing happens anywhere; all of [0, 1], undecided, out of the range of numbers.
template <std::size_t m>
std::vector<IsolatedRoot> places(const BernsteinPolynomial<Enclosure, m>& f) {
  auto found = isolated_roots(f);
  if (found) return std::move(found).value();
  if (found.fault().code == FaultCode::outside_domain) return {};
  return {{Enclosure(0.0, 1.0), RootKind::cluster, 0, 0}};
}

/// Where the local parameters u of segment k lie: their range, and a parameter inside it.
template <class Place, std::size_t n>
Place place_of(const PlanarPath<n>& path, std::size_t k, const Enclosure& u) {
  Place place;
  place.xi_range = xi_range(path, k, u);
  place.xi =
      std::clamp(path.xi_of({k, u.middle()}), place.xi_range.lower(), place.xi_range.upper());
  return place;
}

/// The coefficients of a polynomial on the part u of [0, 1], in one enclosure.
template <std::size_t m>
Enclosure hull_on(const BernsteinPolynomial<Enclosure, m>& f, const Enclosure& u) {
  if (u.lower() == u.upper()) return f.value(Enclosure(u.lower()));
  return coefficient_hull(f.restricted(Enclosure(u.lower()), Enclosure(u.upper())));
}

/// τ, σ and f of a segment, in units in which they do not leave the range of numbers.
template <std::size_t n>
struct CurvaturePolynomials {
  explicit CurvaturePolynomials(const EnclosedCurve<Complex<double>, n>& exact)
      : turning(turning_polynomial(exact.preimage())),
        speed(planar_speed(exact.preimage())),
        slope(curvature_slope(turning, speed)) {
    const Enclosure size = power_of_two(-exact.exponent());
    factor = ((Enclosure(2.0 * static_cast<double>(n)) / exact.step()) * size) * size;
  }

  /// Whether the curvature is exactly zero.
  bool is_straight() const {
    return std::all_of(turning.coefficients().begin(), turning.coefficients().end(),
                       [](const Enclosure& c) { return c.is_zero(); });
  }

  /// κ on the part u: κ(m) + κ'(v)(u - m), m its middle and v between.
  Enclosure curvature_on(const Enclosure& u) const {
    const Enclosure s = hull_on(speed, u);
    if (!(s.lower() > 0.0)) return Enclosure::whole_line();
    const Enclosure middle(u.middle());
    const Enclosure here = speed.value(middle);
    if (!(here.lower() > 0.0)) return Enclosure::whole_line();
    const Enclosure rate = ((hull_on(slope, u) / s) / s) / s;
    return factor * ((turning.value(middle) / here) / here + rate * (u - middle));
  }

  BernsteinPolynomial<Enclosure, turning_degree(n)> turning;
  BernsteinPolynomial<Enclosure, 2 * n> speed;
  BernsteinPolynomial<Enclosure, curvature_slope_degree(n)> slope;
  Enclosure factor;
};

}  // namespace path_detail

/// The zeros of κ' on a planar path, ascending; segment by segment, so that at a knot a zero of
/// either side counts. (At knots and ends the curvature may also have extremes that are not
/// stationary; curvature_extremes accounts for them.) Every zero lies in one of the `xi_range`s
/// (theorem, rounding included; up to the rounding of ξ = ξ_k + h u), and an entry that is not
/// undecided holds exactly one. A segment of exactly zero curvature has no entry.
/// Cost: one root isolation of degree 4n - 3 a segment.
template <std::size_t n>
std::vector<CurvatureStationaryPoint> curvature_stationary_points(const PlanarPath<n>& path) {
  std::vector<CurvatureStationaryPoint> points;
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const path_detail::CurvaturePolynomials<n> polynomials(
        path_detail::EnclosedCurve<Complex<double>, n>(path.segment(k)));
    if (polynomials.is_straight()) continue;
    for (const IsolatedRoot& root : path_detail::places(polynomials.slope)) {
      auto point = path_detail::place_of<CurvatureStationaryPoint>(path, k, root.u);
      point.curvature = polynomials.curvature_on(root.u);
      if (root.sign_before * root.sign_after < 0 && point.curvature.is_bounded()) {
        point.kind =
            root.sign_before > 0 ? CurvatureExtremeKind::maximum : CurvatureExtremeKind::minimum;
      }
      points.push_back(point);
    }
  }
  return points;
}

/// The zeros of h on a planar path, ascending, segment by segment, with the same promise; none on a
/// segment that is exactly straight. A jump of the curvature at a knot from one sign to the other
/// is no zero. Cost: one root isolation of degree 2n - 2 a segment.
template <std::size_t n>
std::vector<Inflection> inflections(const PlanarPath<n>& path) {
  std::vector<Inflection> points;
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const path_detail::EnclosedCurve<Complex<double>, n> exact(path.segment(k));
    for (const IsolatedRoot& root :
         path_detail::places(path_detail::turning_polynomial(exact.preimage()))) {
      auto point = path_detail::place_of<Inflection>(path, k, root.u);
      point.kind = root.kind;
      points.push_back(point);
    }
  }
  return points;
}

/// curvature_extremes (path/bounds.hpp) of one planar curve. Its plain double-precision way needs
/// no memory beyond the stack.
template <std::size_t n>
Extremes curvature_extremes(const PhCurve<Complex<double>, n>& curve, const RangeGoal& goal) {
  if constexpr (n > 0) {
    const auto found = path_detail::QuickCurvature<n>(curve).extremes();
    if (found && path_detail::reaches(*found, goal)) return *found;
  }
  auto path = PlanarPath<n>::create({0.0, curve.parameter_step()}, {curve}, false);
  if (!path) return {Enclosure::whole_line(), Enclosure::whole_line()};
  return curvature_extremes(*path, goal);
}

/// Whether |κ| ≤ limit on the whole curve: yes and no are certain, rounding included. It is
/// undecided only where the largest |κ| is within rounding of the limit, or where the speed may
/// vanish. A limit that is negative or not a number is kept by nothing (no).
///
/// Method: the signs of the Bernstein coefficients of limit σ² - |h|, of degree 4n, in double
/// precision with known bounds of the rounding, subdivided where they differ; then the extremes.
template <std::size_t n>
Answer curvature_stays_within(const PhCurve<Complex<double>, n>& curve, double limit) {
  if (!(limit >= 0.0)) return Answer::no;
  if constexpr (n > 0) {
    const Answer answer = path_detail::QuickCurvature<n>(curve).stays_within(limit);
    if (answer != Answer::undecided) return answer;
  }
  const auto decide = [limit](const Extremes& found) {
    const Enclosure range = found.range();
    if (range.magnitude() <= limit) return Answer::yes;
    if (found.maximum.lower() > limit || found.minimum.upper() < -limit) return Answer::no;
    return Answer::undecided;
  };
  constexpr RangeGoal finest{0.0};
  if constexpr (n > 0) {
    if (const auto found = path_detail::QuickCurvature<n>(curve).extremes()) {
      if (const Answer answer = decide(*found); answer != Answer::undecided) return answer;
    }
  }
  return decide(curvature_extremes(curve, finest));
}

/// The same for a path: no where one segment certainly does not keep the limit.
template <std::size_t n>
Answer curvature_stays_within(const PlanarPath<n>& path, double limit) {
  Answer all = Answer::yes;
  for (const auto& curve : path.segments()) {
    const Answer answer = curvature_stays_within(curve, limit);
    if (answer == Answer::no) return Answer::no;
    if (answer == Answer::undecided) all = answer;
  }
  return all;
}

}  // namespace hodograph
