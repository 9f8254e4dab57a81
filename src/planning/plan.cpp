// SPDX-License-Identifier: MIT
#include "hodograph/planning/plan.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "hodograph/path/bounds.hpp"
#include "hodograph/path/planar_curvature.hpp"
#include "plan_search.hpp"

namespace hodograph {

using planning_detail::limit_fault;

namespace {

/// Of the largest curvature: far below what the search spares of the turn radius.
constexpr double curvature_width = 0x1p-40;
constexpr RangeGoal curvature_goal{curvature_width};

std::optional<Fault> limits_fault(const VehicleLimits& limits) {
  if (!std::isfinite(limits.turn_radius) || !(limits.turn_radius > 0.0)) {
    return limit_fault("turn_radius", limits.turn_radius,
                       "the turn radius must be positive (a vehicle that turns on the spot follows "
                       "the shortest polyline itself)");
  }
  if (!std::isfinite(limits.clearance) || limits.clearance < 0.0) {
    return limit_fault("clearance", limits.clearance,
                       "the clearance must be a number and not negative");
  }
  if (!std::isfinite(limits.width) || limits.width < 0.0) {
    return limit_fault("width", limits.width, "the width must be a number and not negative");
  }
  return std::nullopt;
}

}  // namespace

bool PlanCertificate::proves(const VehicleLimits& limits, double largest) const {
  return curvature.upper() * limits.turn_radius <= 1.0 &&
         clearance.least().lower() >= limits.distance() - planning_tolerance * largest;
}

Enclosure largest_curvature(const PlanarPath<2>& path) {
  const Extremes found = curvature_extremes(path, curvature_goal);
  const double least = std::max(found.maximum.lower(), -found.minimum.upper());
  return {std::max(0.0, least), found.range().magnitude()};
}

Result<PlanCertificate> certify_plan(const PlanarPath<2>& path, const ClearanceIndex& index,
                                     double reach) {
  auto clearance = index.clearance(path, reach);
  if (!clearance) return clearance.fault();
  return PlanCertificate{arc_length_enclosure(path), largest_curvature(path),
                         *std::move(clearance)};
}

struct Planner::Indexes {
  VehicleLimits limits;
  MitredWorld mitred;  // grown by the distance and twice the tolerance
  ClearanceIndex clearance;
  double tolerance = 0.0;
};

Result<Planner> Planner::create(World world, const VehicleLimits& limits) {
  if (auto fault = limits_fault(limits)) return *std::move(fault);
  double largest = 0.0;
  if (world.box()) {
    largest =
        std::max(largest_component(world.box()->lower), largest_component(world.box()->upper));
  }
  const double tolerance = planning_tolerance * largest;
  auto mitred = MitredWorld::create(world, limits.distance() + 2.0 * tolerance);
  if (!mitred) return mitred.fault();
  return Planner(std::make_shared<const Indexes>(
      Indexes{limits, *std::move(mitred), ClearanceIndex(std::move(world)), tolerance}));
}

const World& Planner::world() const { return indexes_->clearance.world(); }
const VehicleLimits& Planner::limits() const { return indexes_->limits; }

Result<Plan> Planner::plan(const PlanRequest& request) const {
  const Indexes& here = *indexes_;
  // A start or goal exactly at the clearance is allowed: then nothing is to spare.
  const double hair = 4.0 * here.tolerance;
  for (const Vector2<double>& end : {request.start, request.goal}) {
    if (!is_finite(end)) continue;  // refused below
    const WorldPosition position = here.mitred.locate(end);
    if (position.kind != WorldPosition::Kind::in_band || position.missing > hair) continue;
    auto exact = MitredWorld::create(world(), here.limits.distance());
    if (!exact) return exact.fault();
    return planning_detail::search_plan(*exact, here.clearance, here.limits, request);
  }
  return planning_detail::search_plan(here.mitred, here.clearance, here.limits, request);
}

}  // namespace hodograph
