// SPDX-License-Identifier: MIT
// The search behind Planner::plan: which polyline can be rounded, and with which offsets.
#pragma once

#include <string>

#include "hodograph/planning/plan.hpp"

namespace hodograph::planning_detail {

/// The fault of a limit or request that is no sensible number.
Fault limit_fault(const char* quantity, double value, const std::string& sentence);

/// The plan of one request in a world that was grown by the distance to keep, see Planner::plan.
Result<Plan> search_plan(const MitredWorld& mitred, const ClearanceIndex& clearance,
                         const VehicleLimits& limits, const PlanRequest& request);

}  // namespace hodograph::planning_detail
