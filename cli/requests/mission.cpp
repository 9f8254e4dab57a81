// SPDX-License-Identifier: MIT
// The request "mission".
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/exports.hpp"
#include "cli/requests/handlers.hpp"
#include "hodograph/io/file.hpp"
#include "hodograph/io/mission.hpp"

namespace hodograph::cli {

Answer answer_mission(Members& request) {
  const PathDocument document = request.document();
  const std::string format = request.word("format", {"qgroundcontrol", "wpl"}, "qgroundcontrol");
  const std::vector<double> datum = request.numbers("datum");
  if (datum.size() != 2 && datum.size() != 3) {
    request.refuse("datum", "the datum is [latitude, longitude] or [latitude, longitude, height]");
  }
  const double chord = request.number("chord");
  Flight flight;
  flight.speed = request.maybe_number("speed");
  flight.acceleration = request.maybe_number("acceleration");
  flight.lateral_acceleration = request.maybe_number("lateral_acceleration");
  flight.altitude = request.maybe_number("altitude");
  const double radius = request.number("acceptance_radius", 0.0);
  const std::string out = request.text("out", "");
  request.require_all_known();
  if (out == "-") request.refuse("out", "standard output has the results; name a file");

  const TimedMotion motion = motion_of(document.path, flight);
  Mission planned =
      mission(waypoints_of(document.path, motion, flight, chord), *datum_of(datum)).value();
  planned.acceptance_radius = radius;
  std::string text =
      format == "wpl" ? to_waypoint_file(planned).value() : to_qgroundcontrol_plan(planned).value();
  Answer answer;
  answer.result["format"] = format;
  answer.result["waypoints"] = planned.waypoints.size();
  answer.result["chord"] = chord;
  if (out.empty()) {
    answer.result["mission"] = std::move(text);
  } else {
    if (const auto fault = write_file(out, text)) throw Error(*fault);
    answer.result["out"] = {{"file", out}, {"format", format}};
  }
  return answer;
}

}  // namespace hodograph::cli
