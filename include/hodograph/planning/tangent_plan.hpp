// SPDX-License-Identifier: MIT
// The alternatives to rounded corners: paths through the corners of a plan's polyline themselves,
// with tangents there by the rules T1 and T2; what they keep is found out afterwards.
//
// Source: "Path planning with Pythagorean-hodograph curves for unmanned or autonomous vehicles",
// section 7, Figures 10 to 13: such paths are G¹, so their curvature jumps at the corners, and they
// leave the polyline's clearance to luck.
#pragma once

#include "hodograph/construction/waypoint_tangents.hpp"
#include "hodograph/foundation/answer.hpp"
#include "hodograph/planning/plan.hpp"

namespace hodograph {

/// A path through the points of a polyline, with what is certain of it.
struct TangentPlan {
  TangentRule rule = TangentRule::t1;
  PlanarPath<2> path;
  PlanCertificate certificate;
  /// The largest |κ(after) - κ(before)| at a point where two pieces meet, to rounding; 0 without
  /// such a point.
  double curvature_jump = 0.0;

  /// Whether the largest |κ| is at most 1/radius (rounded), certified either way; undecided within
  /// rounding.
  Answer keeps_radius(double radius) const;
  /// Whether every obstacle and the bounds are at least `distance` away, likewise.
  Answer keeps_distance(double distance) const;
};

/// The path of a rule through the points of a polyline, and its certificate as that of a plan;
/// obstacles further than `reach` are not listed. Units: those of the world. Accuracy: enclosures.
/// Faults: those of waypoint_path (rule t1 gives no direction where the polyline turns straight
/// back with equal legs) and of certify_plan.
Result<TangentPlan> tangent_plan(const Polyline& polyline, TangentRule rule,
                                 const ClearanceIndex& index, double reach);

}  // namespace hodograph
