// SPDX-License-Identifier: MIT
// Climbs that a vehicle can fly: its climb and descent angles and its turn radius kept, by the
// choice among solutions, by more length over ground, by more spans or by whole turns; and helical
// splines through waypoints.
//
// A path that climbs by Δz at the angle θ covers S = Δz cot θ over ground
// (construction/climb.hpp), so a climb is a plan of a given length (construction/turn_limited.hpp),
// lifted (construction/lift.hpp). Its curvature is cos² θ times the plan's: the plan keeps the
// radius, as a coordinated turn seen from above does, and so does the path.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hodograph/construction/climb.hpp"
#include "hodograph/construction/turn_limited.hpp"
#include "hodograph/construction/waypoint_tangents.hpp"

namespace hodograph {

/// What a vehicle can do. Angles in radians, both ≥ 0 and below π/2; 0: it cannot climb (descend).
struct ClimbLimits {
  double climb_angle = 0.0;    ///< the steepest climb
  double descent_angle = 0.0;  ///< the steepest descent, as a positive number
  double turn_radius = 0.0;    ///< the least, seen from above; 0: none
};

/// One climb.
struct ClimbPath {
  SpatialPath<2> path;         ///< C1, |dr/dξ| = sec θ at every knot: unit speed over ground
  double climb_angle = 0.0;    ///< θ, negative in descent
  double ground_length = 0.0;  ///< S
  TurnLimitedShape shape = TurnLimitedShape::one_span;
  std::size_t whole_turns = 0;
  double arc_radius = 0.0;             ///< of its arcs; 0 for one span
  double most_ground_curvature = 0.0;  ///< certified bound of the plan's |κ|, at most 1/turn_radius
};

/// The climb of exactly the angle θ that keeps the turn radius (0: none), by turn_limited_path.
/// Faults: those of climb_curve; outside_domain (the radius); no_interpolant: the altitude changes
/// too little for the angle and the radius, with the change (`bound`) that is met, or lies between
/// those that are met without and with whole turns, with the change from which on all are.
Result<ClimbPath> climb_path(const HeadedPoint& begin, const HeadedPoint& end, double climb_angle,
                             double turn_radius);

/// A climb within the limits, of an angle that is found: the length over ground is the one of the
/// steepest angle allowed where a path of that length keeps the radius and is not shorter than the
/// distance, else as little more as shortest_turn_limited_path finds. Level where the altitudes
/// agree. Faults: not_finite, outside_domain (limits; a zero heading), no_interpolant (a vehicle
/// that cannot climb, or descend, with the angle that the straight line has; without a radius,
/// points that coincide).
Result<ClimbPath> climb_path(const HeadedPoint& begin, const HeadedPoint& end,
                             const ClimbLimits& limits, double most_detour = 0.25);

/// The climb of a given length over ground that keeps the turn radius: its angle is atan(Δz/S), and
/// level flight is one of 0. Faults: not_finite, and those of turn_limited_path.
Result<ClimbPath> climb_path_of_ground_length(const HeadedPoint& begin, const HeadedPoint& end,
                                              double ground_length, double turn_radius);

/// A waypoint of a helical spline. Without a heading it gets the one of a rule for waypoints
/// (construction/waypoint_tangents.hpp, by the places over ground); without a climb angle that of
/// the span that begins here is the one of its length over ground, or found within the limits.
struct ClimbWaypoint {
  Vector3<double> position{};
  std::optional<Vector2<double>> heading{};
  std::optional<double> climb_angle{};    ///< not with a length; 0: level
  std::optional<double> ground_length{};  ///< over ground, of the span that begins here
};

struct ClimbRouteOptions {
  ClimbLimits limits{};
  TangentRule headings = TangentRule::t1;
  double most_detour = 0.25;
};

/// One span of a route, between two waypoints.
struct ClimbSpan {
  std::size_t first = 0, last = 0;  ///< segments of the path
  double climb_angle = 0.0, ground_length = 0.0;
  TurnLimitedShape shape = TurnLimitedShape::one_span;
  std::size_t whole_turns = 0;
  double most_ground_curvature = 0.0;
};

/// What is continuous where two spans meet.
struct ClimbJoint {
  std::size_t waypoint = 0, knot = 0;
  double pitch_change = 0.0;  ///< of the climb angle, radians: 0 where the tangent is continuous
  int position = 0, preimage = 0, frame = 0, angular_velocity = 0;  ///< orders; -1: it jumps
};

struct ClimbRoute {
  SpatialPath<2> path;
  std::vector<Vector2<double>> headings;  ///< at the waypoints
  std::vector<ClimbSpan> spans;
  std::vector<ClimbJoint> joints;  ///< at the inner waypoints
};

/// The helical spline through waypoints: a climb on each span, at its own angle. The ground track
/// is C1; so is the path, with a continuous frame, where neighbours have the same angle, and
/// elsewhere it is C0 with a corner in pitch. Faults: too_few (two waypoints), those of
/// waypoint_tangents where a heading is missing, and those of climb_path, with the index of the
/// span (or waypoint).
Result<ClimbRoute> climb_route(std::span<const ClimbWaypoint> waypoints,
                               const ClimbRouteOptions& options);

}  // namespace hodograph
