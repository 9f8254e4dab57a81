// SPDX-License-Identifier: MIT
// Following a path: what the subcommand `follow` and the request "follow" have in common.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/json.hpp"
#include "hodograph/control/path_following.hpp"
#include "hodograph/control/receding_horizon.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/io/report.hpp"
#include "hodograph/planning/world.hpp"

namespace hodograph::cli {

struct FollowRequest {
  FollowLimits limits;
  FollowStart start;
  FollowOptions options;
};

/// How far a path may be left in a world: its certified clearance there, less what the vehicle
/// needs.
struct WorldRoom {
  double clearance = 0.0;  ///< of the path, a lower bound
  double needed = 0.0;     ///< clearance asked for, and half the width
  double offset() const { return clearance - needed; }
};

/// Throws Error: a path in space; no room.
WorldRoom room_in(const PathDocument& document, const World& world, double clearance, double width);

/// What is told of a following: name and text of each row.
std::vector<std::pair<std::string, std::string>> rows_of(const Following& found,
                                                         const FollowRequest& request,
                                                         const std::optional<WorldRoom>& room);
/// The facts; with `nodes` also every node.
Json json_of(const Following& found, const FollowRequest& request,
             const std::optional<WorldRoom>& room, bool nodes, std::size_t dimension);
/// One row for every node.
std::string csv_of(const Following& found, std::size_t dimension);
/// Path and way, offset, speed and accelerations in time.
ReportData report_of(const PathDocument& document, const Following& found,
                     const FollowRequest& request, const std::optional<WorldRoom>& room,
                     const World* world);

/// A receding horizon driven over the path, pushed about by random errors of the state.
struct HorizonDrive {
  double duration = 0.0, xi = 0.0, largest_offset = 0.0;
  std::size_t plans = 0, warm = 0, recovered = 0, unfinished = 0, iterations = 0;
  std::vector<double> latencies_s;  ///< in ascending order; the first, cold plan apart
  double cold_s = 0.0;
};
HorizonDrive driven(const AnyPath& path, const FollowRequest& request,
                    const HorizonOptions& options, double disturbance, std::size_t most_plans,
                    const std::function<bool(double fraction)>& watch);
std::vector<std::pair<std::string, std::string>> rows_of(const HorizonDrive& drive);
Json json_of(const HorizonDrive& drive);

}  // namespace hodograph::cli
