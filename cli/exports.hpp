// SPDX-License-Identifier: MIT
// Paths as other programs want them: lines on maps, waypoints for drones, samples in time. What
// subcommands that make a path for a vehicle have in common.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/motions.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/io/geojson_scene.hpp"
#include "hodograph/io/mission.hpp"

namespace hodograph::cli {

/// The datum that --datum gives; nothing without it.
std::optional<GeodeticPoint> datum_of(const std::vector<double>& numbers);

/// What the options of one path and of a swarm have in common: --samples and --datum, what is
/// refused (missions without a datum, a distance of chords that is none), and writing, all texts
/// being made. Throw Error.
void add_sample_count(Command& command, std::size_t& count, const std::string& help);
void add_datum(Command& command, std::vector<double>& datum);
void check_places(bool missions, const std::vector<double>& datum, std::optional<double> chord);
void write_files(const std::vector<std::pair<std::string, std::string>>& texts_of_files);

/// Waypoints along a path, every point of it within `chord` of the polyline through them. A planar
/// path is flown at the altitude of its flight. Speeds: that of the flight where it is constant and
/// given, the mean between two waypoints where it changes, none where nothing is said of it.
std::vector<LocalWaypoint> waypoints_of(const AnyPath& path, const TimedMotion& motion,
                                        const Flight& flight, double chord);

/// The path as a line that follows it within `chord`.
GeoJsonPath line_of(const PathDocument& document, double chord);

/// `count` samples, evenly spaced in time: time, arc length, position, speed, and in the plane the
/// heading (radians from the x axis, continuous) and the curvature.
std::string samples_csv(const AnyPath& path, const TimedMotion& motion, std::size_t count);

/// The files that the options of one path name.
struct ExportFlags {
  std::string geojson, samples, crazyswarm, qgroundcontrol, waypoints;
  std::vector<double> datum;
  double chord = 0.0, altitude = 0.0, speed = 0.0, acceleration = 0.0, lateral = 0.0;
  double polynomial_tolerance = 0.0;
  std::size_t sample_count = 1001;

  /// Adds the options; `chord_default` is how the help calls the default chord.
  void add_to(Command& command, const std::string& chord_default);
  /// Refuses what excludes each other; to be called before the work. Throws Error.
  void check() const;
  /// The distance of the chords: the option's, or the default.
  double near(double default_chord) const;
  /// Whether a file is named.
  bool any() const;
  /// Writes the files that are named, the path first in the scene, and returns lines that say so,
  /// with what is certified. Throws Error.
  std::string write(const PathDocument& document, GeoJsonScene scene, double default_chord) const;

 private:
  Flight flight() const;
  struct Given;
  std::shared_ptr<Given> given_;
};

}  // namespace hodograph::cli
