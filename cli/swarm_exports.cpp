// SPDX-License-Identifier: MIT
#include "cli/swarm_exports.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

#include "cli/exports.hpp"
#include "cli/made_path.hpp"
#include "hodograph/io/table.hpp"

namespace hodograph::cli {
namespace {

using NamedText = std::pair<std::string, std::string>;

/// The fault of one vehicle's file names it.
template <class T>
T of_vehicle(Result<T> result, const std::string& id) {
  if (result) return *std::move(result);
  Fault fault = result.fault();
  fault.sentence = "'" + id + "': " + fault.sentence;
  throw Error(fault);
}

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) return;
  throw Error(Fault{FaultCode::not_written,
                    "the folder '" + folder + "' cannot be made: " + error.message(), std::nullopt,
                    "file", std::nullopt, std::nullopt});
}

/// Time, and every vehicle's place at that time; nothing where it is not there.
std::string all_samples(const SwarmFacts& facts, std::size_t count) {
  std::vector<std::string> names = {"time"};
  double begin = facts.vehicles[0].motion.start_time(), end = facts.vehicles[0].motion.end_time();
  for (const Vehicle& vehicle : facts.vehicles) {
    begin = std::min(begin, vehicle.motion.start_time());
    end = std::max(end, vehicle.motion.end_time());
    for (const char* const axis : {".x", ".y", ".z"}) names.push_back(vehicle.id + axis);
  }
  std::string text;
  append_csv_header(text, names);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const double time = std::clamp(begin * (1.0 - share) + end * share, begin, end);
    text += to_text(time);
    for (const Vehicle& vehicle : facts.vehicles) {
      const TimedMotion& motion = vehicle.motion;
      const Presence& presence = motion.presence();
      const bool there = (time >= motion.start_time() || presence.before_start) &&
                         (time <= motion.end_time() || presence.after_arrival);
      const Vector3<double> place = motion.position(time);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        text += ',';
        if (there) text += to_text(place[axis]);
      }
    }
    text += '\n';
  }
  return text;
}

}  // namespace

void SwarmExportFlags::add_to(Command& command) {
  command.group("For other programs");
  command.option("--geojson", geojson, "FILE", "all paths, as lines with what they promise");
  command.option("--csv", samples, "FILE",
                 "where all vehicles are at times evenly spaced: a column for x, y and z of each");
  add_sample_count(command, sample_count, "how many times");
  command.option("--qgroundcontrol", qgroundcontrol, "FOLDER",
                 "a plan of QGroundControl for every vehicle (.plan); metres, needs --datum");
  command.option("--wpl", waypoints, "FOLDER",
                 "a file 'QGC WPL 110' for every vehicle (.waypoints); metres, needs --datum");
  chord_option_ = std::make_shared<Option>(command.option(
      "--chord", chord, "E",
      "how near the lines between points stay to the paths, certified (default: 1e-3 of the "
      "longest path)"));
  add_datum(command, datum);
}

bool SwarmExportFlags::chord_given() const { return chord_option_->given(); }

void SwarmExportFlags::check() const {
  check_places(!(qgroundcontrol.empty() && waypoints.empty()), datum,
               chord_given() ? std::optional(chord) : std::nullopt);
}

std::string SwarmExportFlags::write(const SwarmFacts& facts) const {
  constexpr double share = 1e-3;  // not a tolerance: the default, of the longest path
  double longest = 0.0;
  for (const Vehicle& vehicle : facts.vehicles) {
    longest = std::max(longest, vehicle.motion.length());
  }
  const double within = chord_given() ? chord : share * longest;
  const std::string near = "within " + to_six_digits(within) + " of the paths, certified";
  std::string written;
  std::vector<NamedText> files;
  if (!geojson.empty()) {
    GeoJsonScene scene;
    scene.datum = datum_of(datum);
    for (std::size_t i = 0; i < facts.vehicles.size(); ++i) {
      GeoJsonPath line = line_of(facts.documents[i], within);
      line.name = facts.vehicles[i].id;
      if (!line.spatial) {
        line.spatial = true;
        for (auto& point : line.points) point.z = facts.flights[i].altitude.value_or(0.0);
      }
      scene.paths.push_back(std::move(line));
    }
    files.emplace_back(geojson, to_geojson(scene).value());
    written += "wrote " + geojson + ": lines " + near + "\n";
  }
  if (!samples.empty()) {
    files.emplace_back(samples, all_samples(facts, sample_count));
    written += "wrote " + samples + ": " + std::to_string(sample_count) + " times\n";
  }
  if (!(qgroundcontrol.empty() && waypoints.empty())) {
    for (std::size_t i = 0; i < facts.vehicles.size(); ++i) {
      const Vehicle& vehicle = facts.vehicles[i];
      const auto points =
          waypoints_of(facts.documents[i].path, vehicle.motion, facts.flights[i], within);
      const Mission planned = of_vehicle(mission(points, *datum_of(datum)), vehicle.id);
      const auto add = [&](const std::string& folder, const char* suffix,
                           Result<std::string> text) {
        if (folder.empty()) return;
        files.emplace_back((std::filesystem::path(folder) / (vehicle.id + suffix)).string(),
                           of_vehicle(std::move(text), vehicle.id));
      };
      add(qgroundcontrol, ".plan", to_qgroundcontrol_plan(planned));
      add(waypoints, ".waypoints", to_waypoint_file(planned));
    }
    for (const std::string& folder : {qgroundcontrol, waypoints}) {
      if (folder.empty()) continue;
      make_folder(folder);
      written.append("wrote ").append(std::to_string(facts.vehicles.size()));
      written.append(" missions to ").append(folder);
      written.append(": lines between waypoints ").append(near).append("\n");
    }
  }
  write_files(files);
  return written;
}

}  // namespace hodograph::cli
