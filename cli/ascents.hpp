// SPDX-License-Identifier: MIT
// Ascents from the Moon to its orbit: what the subcommand `ascend` and the request "ascend" have in
// common.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/json.hpp"
#include "hodograph/control/powered_ascent.hpp"
#include "hodograph/control/tracking_ascent.hpp"
#include "hodograph/io/report.hpp"

namespace hodograph::cli {

/// tracking: (25) as published; figure: the setting of its figure; energy, time: with gravity.
inline const std::vector<std::string> ascent_problems = {"tracking", "figure", "energy", "time"};
/// What the problems with gravity may be solved in: r, or progress along the orbit's path and
/// offset.
inline const std::vector<std::string> ascent_coordinates = {"rectangular", "path"};

/// What all problems take; each uses its own.
struct AscentOptions {
  TrackingOptions tracking{};
  PoweredOptions powered{};
  bool along_path = false;  ///< with gravity: in the coordinates of the orbit's path
};

/// One problem, solved from some starts; one of the lists is empty.
struct AscentSet {
  std::string problem;
  std::vector<TrackingAscent> tracking{};
  std::vector<PoweredAscent> powered{};
  bool along_path = false;
};

/// Called while it works with a line to show; false stops.
using AscentWatch = std::function<bool(const std::string& line)>;

/// Solves a problem from the named starts. Throws Error, the start's name in the sentence.
AscentSet solved_ascents(const AscentReference& reference, const std::string& problem,
                         const std::vector<std::string>& starts, const AscentOptions& options,
                         const AscentWatch& watch = {});

/// The facts; with `nodes` also the lists along the way.
Json json_of(const TrackingAscent& ascent, bool nodes);
Json json_of(const PoweredAscent& ascent, bool nodes);
/// {"problem", "ascents"}.
Json json_of(const AscentSet& set, bool nodes);

/// The table that people read.
std::string text_of(const AscentSet& set);

/// One row for every node of every ascent.
std::string csv_of(const AscentSet& set);

/// The report of one problem: trajectories with the Moon and the orbit in three views, errors of
/// position and orientation, speed, and thrust or gimbal angles.
ReportData report_of(const AscentReference& reference, const AscentSet& set);

}  // namespace hodograph::cli
