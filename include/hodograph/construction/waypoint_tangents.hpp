// SPDX-License-Identifier: MIT
// Directions at waypoints, and the path through the waypoints with them.
//
// Source: "Path planning with Pythagorean-hodograph curves for unmanned or autonomous vehicles",
// section 7: the rules T1 and T2.
#pragma once

#include <span>
#include <vector>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/construction/planar_spline.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

enum class TangentRule {
  /// The unit vectors of the two chords that meet, each weighted by the other chord's length (the
  /// nearer neighbour counts more). At an end of an open path the neighbour's tangent mirrored in
  /// the chord: the direction of the circular arc that meets the neighbour with its tangent. With
  /// two points, the chord.
  t1,
  /// The tangents of the C² spline through the points, see planar_spline.
  t2,
};

struct WaypointOptions {
  TangentRule rule = TangentRule::t2;
  bool closed = false;  ///< the first point may be repeated at the end, or not
  /// |dr/dξ| at every waypoint of the path, where ξ grows by the chord's length from one to the
  /// next. Below 1 the curve turns more sharply at the waypoints, above 1 between them.
  double speed = 1.0;
  /// Rule t2: the spline's parameters, and how it is chosen; `closed` and `repeated` of these are
  /// not looked at.
  PlanarSplineOptions spline{};
};

/// The unit tangent at every waypoint. Closed: the repeated first point, if there, gets one, too.
/// Rule t1 is local: O(1) work a point, and a point moves three tangents (five near the ends).
/// Faults: too_few (fewer than 2 points, closed: 2 distinct ones), not_finite (index of the point),
/// outside_domain (index of a point equal to the one before it), zero_speed (index of a waypoint
/// where the rule gives no direction: t1, where the path turns straight back with equal chords; t2,
/// where the spline comes to rest); rule t2 also those of planar_spline.
Result<std::vector<Vector2<double>>> waypoint_tangents(std::span<const Vector2<double>> points,
                                                       const WaypointOptions& options = {});

/// The path through the waypoints with these tangents: C¹ Hermite quintics, each the best of its
/// four (see planar_hermite), the curvature in general discontinuous at the waypoints.
/// C¹ in ξ, hence G¹. Faults: as above; outside_domain (a speed that is not positive and finite);
/// those of planar_hermite_path.
Result<PlanarPath<2>> waypoint_path(std::span<const Vector2<double>> points,
                                    const WaypointOptions& options = {});

}  // namespace hodograph
