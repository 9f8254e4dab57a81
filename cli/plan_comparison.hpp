// SPDX-License-Identifier: MIT
// A plan beside the paths through its polyline by the rules T1 and T2, and what a plan's picture
// shows besides: what the subcommand `plan` and the request "plan" have in common.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/json.hpp"
#include "cli/made_path.hpp"
#include "hodograph/io/report.hpp"
#include "hodograph/planning/tangent_plan.hpp"

namespace hodograph::cli {

/// The path of one rule, or why there is none.
struct ComparedPlan {
  std::string name;  ///< "T1", "T2"
  std::optional<TangentPlan> plan{};
  std::optional<Fault> fault{};
};

/// The paths of both rules through the plan's polyline. Cost: the world is indexed once more.
std::vector<ComparedPlan> compared_plans(const Plan& plan, const World& world);

/// Per rule: length, largest curvature, its largest jump, continuity, clearance, and whether the
/// limits are kept; with its document if asked for.
Json json_of(const std::vector<ComparedPlan>& compared, const VehicleLimits& limits,
             const std::string& world_name, bool with_documents);

/// The document of such a path, with all its promises.
MadePath made_comparison(const ComparedPlan& compared, const std::string& world_name);

/// A row for each rule, after one for the plan itself.
std::vector<std::pair<std::string, std::string>> rows_of(const std::vector<ComparedPlan>& compared,
                                                         const Plan& plan, const World& world,
                                                         const VehicleLimits& limits);

/// Adds the paths to the picture of the plan, and a picture of all curvatures by arc length.
void draw(ReportData& report, const std::vector<ComparedPlan>& compared, const Plan& plan,
          const VehicleLimits& limits);

/// The polyline that was rounded, and the outlines of the obstacles and bounds grown by `distance`
/// with mitred corners, as far as they bound the union; the latter only of worlds of up to
/// most_grown_vertices.
std::vector<Series> grown_outlines(const World& world, double distance);
inline constexpr std::size_t most_grown_vertices = 4096;
Series polyline_series(const Polyline& polyline);

}  // namespace hodograph::cli
