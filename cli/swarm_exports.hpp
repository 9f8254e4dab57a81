// SPDX-License-Identifier: MIT
// A swarm's paths as other programs want them: lines, samples in time, a mission for each vehicle.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/swarms.hpp"

namespace hodograph::cli {

/// The files that options name.
struct SwarmExportFlags {
  std::string geojson, samples, qgroundcontrol, waypoints;  ///< files, the last two folders
  std::vector<double> datum;
  double chord = 0.0;
  std::size_t sample_count = 1001;

  void add_to(Command& command);
  /// Refuses what excludes each other; to be called before the work. Throws Error.
  void check() const;
  /// Writes what is named and returns lines that say so. Throws Error.
  std::string write(const SwarmFacts& facts) const;

 private:
  bool chord_given() const;
  std::shared_ptr<Option> chord_option_;
};

}  // namespace hodograph::cli
