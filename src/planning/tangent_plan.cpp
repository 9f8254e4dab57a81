// SPDX-License-Identifier: MIT
#include "hodograph/planning/tangent_plan.hpp"

#include <algorithm>
#include <cmath>

#include "hodograph/curve/preimage_jet.hpp"

namespace hodograph {
namespace {

double end_curvature(const PlanarPhCurve<2>& curve, double u) {
  return curvature(curve.preimage_jet<1>(u));
}

}  // namespace

Answer TangentPlan::keeps_radius(double radius) const {
  const double limit = 1.0 / radius;
  if (certificate.curvature.upper() <= limit) return Answer::yes;
  return certificate.curvature.lower() > limit ? Answer::no : Answer::undecided;
}

Answer TangentPlan::keeps_distance(double distance) const {
  const Enclosure least = certificate.clearance.least();
  if (least.lower() >= distance) return Answer::yes;
  return least.upper() < distance ? Answer::no : Answer::undecided;
}

Result<TangentPlan> tangent_plan(const Polyline& polyline, TangentRule rule,
                                 const ClearanceIndex& index, double reach) {
  WaypointOptions options;
  options.rule = rule;
  auto path = waypoint_path(polyline.points, options);
  if (!path) return path.fault();
  auto certificate = certify_plan(*path, index, reach);
  if (!certificate) return certificate.fault();
  double jump = 0.0;
  for (std::size_t k = 0; k + 1 < path->segment_count(); ++k) {
    jump = std::max(jump, std::abs(end_curvature(path->segment(k + 1), 0.0) -
                                   end_curvature(path->segment(k), 1.0)));
  }
  return TangentPlan{rule, *std::move(path), *std::move(certificate), jump};
}

}  // namespace hodograph
