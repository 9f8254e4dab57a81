// SPDX-License-Identifier: MIT
// A vehicle's path among obstacles: from the request to its document and picture. What the
// subcommand `plan` and the request "plan" have in common, and what `check` compares.
#pragma once

#include <string>

#include "cli/json.hpp"
#include "cli/made_path.hpp"
#include "hodograph/io/svg.hpp"
#include "hodograph/planning/plan.hpp"

namespace hodograph::cli {

/// The words for CornerAim, as options and requests spell them.
inline constexpr const char* corner_words[] = {"smallest", "largest", "shortest", "gentlest"};
/// Domain: one of corner_words.
CornerAim corner_aim(const std::string& word);

/// The document of a plan, with all its promises; `world` names the file of the world (it may be
/// empty).
MadePath made_plan(const Plan& plan, const VehicleLimits& limits, CornerAim aim,
                   const std::string& world);

/// The largest |κ| of any path, enclosed as a plan's is. Throws Error (unsupported) in space, as
/// the next.
Enclosure largest_curvature(const AnyPath& path);
PathClearance clearance_of(const AnyPath& path, const ClearanceIndex& index, double reach);

/// The clearance as a document promises it.
ClearancePromise promise_of(const PathClearance& clearance, const std::string& world);

/// Polyline, corners, certificate and what was given up.
Json json_of(const Plan& plan, const World& world);

/// The rows of the short table: what was planned and what is proven.
std::vector<std::pair<std::string, std::string>> rows_of(const Plan& plan, const World& world);

/// The outlines of obstacles and bounds, to be drawn under a path.
std::vector<Series> outlines(const World& world);

}  // namespace hodograph::cli
