// SPDX-License-Identifier: MIT
// The G² corner: a planar PH quintic that rounds the corner of two lines, meeting both with zero
// curvature.
//
// Source: "Path planning with Pythagorean-hodograph curves for unmanned or autonomous vehicles",
// section 7, (15)-(21). With θ the turning angle, c = cos(θ/2), s = |sin(θ/2)| and L the distance
// from either end to the corner point, in the direction of the incoming line,
//   w0 = λ √L,  w1 = 0,  w2 = λ √L exp(iθ/2),  λ² = 30 c/(6c + 1),
//   peak curvature κ = 32 (6c+1) s/(15 L c (c+1)²), at the middle,
//   arc length 2L (6+c) c/(6c+1),  deviation δ = (3c+8) s L/(8 (6c+1)), at the middle.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hodograph/construction/planar_hermite.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// Three points of a corner: the lines run from `before` to `corner` and from there to `after`.
struct Corner {
  Vector2<double> before{}, corner{}, after{};
};

/// The numbers of a corner of turning angle θ for L = 1. Lengths grow with L, the curvature with
/// 1/L.
struct CornerShape {
  double turning_angle = 0.0;   ///< θ in (-π, π), positive to the left
  double peak_curvature = 0.0;  ///< |κ| at the middle, the largest
  double arc_length = 0.0;
  double deviation = 0.0;  ///< distance of the middle from the corner point: the largest distance
                           ///< of the corner point's side that is cut off
};

/// The shape of a corner, to a few ε also for θ near 0 and ±π. Faults: not_finite (with the index
/// of the point), outside_domain (a line without length; a line that turns back: |θ| = π within
/// accuracy::join_error).
Result<CornerShape> corner_shape(const Corner& corner);

/// The rounded corner over a parameter interval h > 0; θ = 0 (the points on a line within
/// rounding) gives the straight piece of length 2L.
struct RoundedCorner {
  PlanarPhCurve<2> curve;
  double leg = 0.0;   ///< L
  CornerShape shape;  ///< the corner's own, for this L
};

/// From L, the distance of its ends from the corner point. Neither line needs to be that long: only
/// their directions count. Faults: those of corner_shape, outside_domain (L or h not positive).
Result<RoundedCorner> corner_of_leg(const Corner& corner, double leg, double h = 1.0);

/// The smallest corner whose curvature is at most κ (20): L = 32 (6c+1) s/(15 κ c (c+1)²). Faults:
/// also no_interpolant (θ = 0: every L serves; L longer than one of the lines, with both numbers).
Result<RoundedCorner> corner_of_curvature(const Corner& corner, double most_curvature,
                                          double h = 1.0);

/// The largest corner that deviates by at most δ from the corner point (18). Faults as above.
Result<RoundedCorner> corner_of_deviation(const Corner& corner, double most_deviation,
                                          double h = 1.0);

/// The largest corner that the lines have room for: L = min(|corner - before|, |after - corner|).
Result<RoundedCorner> corner_of_room(const Corner& corner, double h = 1.0);

/// The clearance from an obstacle's vertex, over the smallest turning radius, that a corner of
/// turning angle θ needs (21): 4 (3c+8)(1-c)/(15 (1+c)), the factor of r_min, between 0 and 32/15;
/// to a few ε, without cancellation for small θ. Domain: any θ in [-π, π].
double corner_clearance_factor(double turning_angle);

/// How a polyline's corners are rounded.
struct CornerRule {
  /// Each corner as small as this curvature allows (20); absent: as large as there is room, at most
  /// half of each line.
  std::optional<double> most_curvature{};
  /// No corner deviates by more.
  std::optional<double> most_deviation{};
  /// The last point joins the first, and that corner is rounded, too.
  bool closed = false;
};

/// The polyline with every corner rounded: lines (uniform speed) and corners in turn, knots at the
/// arc length. The path is G²: tangent and curvature (zero at every joint) are continuous; the
/// parametric speed is not: 1 on lines, and at the ends of corners λ²L over their length. The
/// preimage is continuous up to a positive factor. A point on the line of its neighbours is passed
/// straight.
///
/// Faults: too_few (two points; three if closed), not_finite and outside_domain (with the index of
/// the point: coinciding neighbours, a turn back, a bound that is not positive), no_interpolant
/// (two corners that overlap on a line, with the index of the line, the length they need and the
/// line's; a curvature and a deviation bound that exclude each other).
Result<PlanarPath<2>> rounded_polyline(std::span<const Vector2<double>> points,
                                       const CornerRule& rule);

/// The same with the leg L of every corner given: the first at point 1 (closed: the last at point
/// 0). A leg is not looked at where the line passes straight. Faults: also mismatched_size (not one
/// leg a corner), outside_domain (index of the point: a leg that is not positive).
Result<PlanarPath<2>> rounded_polyline_of_legs(std::span<const Vector2<double>> points,
                                               std::span<const double> legs, bool closed = false);

}  // namespace hodograph
