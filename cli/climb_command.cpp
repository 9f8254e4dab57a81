// SPDX-License-Identifier: MIT
// hodograph climb: constant-climb paths through waypoints, within a vehicle's limits.
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>

#include "cli/climbs.hpp"
#include "cli/commands.hpp"
#include "cli/exports.hpp"
#include "cli/fitting.hpp"
#include "cli/options.hpp"
#include "cli/refuse.hpp"
#include "cli/terminal.hpp"

namespace hodograph::cli {
namespace {

constexpr double in_radians = std::numbers::pi / 180.0;

struct ClimbFlags {
  std::string waypoints, headings = heading_words[0];
  std::vector<double> begin, end;
  double begin_degrees = 0.0, end_degrees = 0.0, climb_degrees = 0.0, ground_length = 0.0;
  double most_climb_degrees = 0.0, most_descent_degrees = 0.0, turn_radius = 0.0;
  bool climb_given = false, length_given = false, most_climb_given = false;
  bool most_descent_given = false, begin_heading_given = false, end_heading_given = false;
  bool geographic = false;
  ExportFlags exports;
  OutputFlags output;
};

std::vector<ClimbWaypoint> waypoints_of(const ClimbFlags& flags) {
  if (flags.waypoints.empty() == flags.begin.empty() || flags.begin.empty() != flags.end.empty()) {
    refuse(
        "give the waypoints as a file, or two of them by --begin X,Y,Z and "
        "--end X,Y,Z",
        "waypoints");
  }
  std::vector<ClimbWaypoint> waypoints;
  if (flags.waypoints.empty()) {
    const auto point = [](const std::vector<double>& p) {
      return Vector3<double>{p[0], p[1], p[2]};
    };
    waypoints = {{point(flags.begin), {}, {}, {}}, {point(flags.end), {}, {}, {}}};
  } else {
    if (flags.geographic && flags.exports.datum.empty()) {
      refuse("longitudes and latitudes need --datum LAT,LON,ALT", "datum");
    }
    waypoints = read_waypoints(flags.waypoints,
                               flags.geographic ? datum_of(flags.exports.datum) : std::nullopt);
  }
  if (flags.begin_heading_given && !waypoints.empty()) {
    waypoints.front().heading = direction_of_angle(in_radians * flags.begin_degrees);
  }
  if (flags.end_heading_given && !waypoints.empty()) {
    waypoints.back().heading = direction_of_angle(in_radians * flags.end_degrees);
  }
  bool level = true;
  for (const ClimbWaypoint& w : waypoints) {
    level = level && w.position.z == waypoints.front().position.z;
  }
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i) {
    ClimbWaypoint& from = waypoints[i];
    if (from.climb_angle || from.ground_length) continue;
    if (flags.length_given) from.ground_length = flags.ground_length;
    if (flags.climb_given) {
      const double rise = waypoints[i + 1].position.z - from.position.z;
      const double angle = in_radians * flags.climb_degrees;
      // Down where the way goes down; level where it is level, but not all along: that is refused.
      from.climb_angle = rise == 0.0 && !level ? 0.0 : rise < 0.0 && angle > 0.0 ? -angle : angle;
    }
  }
  return waypoints;
}

void run(ClimbFlags flags) {
  if (flags.output.document.empty()) flags.output.document = "climb.json";
  flags.exports.check();
  if (flags.length_given && flags.climb_given) {
    refuse(
        "a climb angle and a length over ground exclude each other; give "
        "one of them",
        "ground_length");
  }
  ClimbRouteOptions options;
  const double most = flags.most_climb_given ? flags.most_climb_degrees : flags.climb_degrees;
  options.limits = {in_radians * most,
                    in_radians * (flags.most_descent_given ? flags.most_descent_degrees : most),
                    flags.turn_radius};
  options.headings = flags.headings == heading_words[0] ? TangentRule::t1 : TangentRule::t2;
  const std::vector<ClimbWaypoint> waypoints = waypoints_of(flags);
  if (!flags.climb_given && !flags.most_climb_given && !flags.most_descent_given) {
    for (std::size_t i = 0; i + 1 < waypoints.size(); ++i) {
      const ClimbWaypoint& w = waypoints[i];
      if (!w.climb_angle && !w.ground_length && w.position.z != waypoints[i + 1].position.z) {
        refuse("span " + std::to_string(i) +
                   " is not level: give its angle by --climb-deg, or the steepest that the vehicle "
                   "climbs and descends by --max-climb-deg and --max-descent-deg",
               "climb_angle");
      }
    }
  }
  ClimbRoute route = climb_route(waypoints, options).value();
  const auto rows = rows_of(route);
  const std::string source =
      flags.waypoints.empty() ? "" : "waypoints: " + input_name(flags.waypoints);
  const MadePath made = made_climb(AnyPath(std::move(route.path)), source, "constant climb",
                                   flags.climb_given ? "angle given" : "within limits");
  ReportData report = report_of(made.document, made.facts,
                                flags.output.document == "-" ? "" : flags.output.document);
  report.title = "A climb";
  report.more.insert(report.more.end(), rows.begin(), rows.end());
  if (flags.turn_radius > 0.0) report.curvature_limit = 1.0 / flags.turn_radius;
  write_files(made.document, report, flags.output);
  constexpr double share = 0.01;  // of the turn radius, or of a hundredth of the length
  const double chord = share * (flags.turn_radius > 0.0 ? flags.turn_radius
                                                        : share * made.document.path.arc_length());
  const std::string written = flags.exports.write(made.document, {}, chord);
  if (flags.output.document == "-" || flags.output.report == "-") {
    std::fputs(written.c_str(), stderr);
  } else {
    print(written);
  }
}

}  // namespace

std::unique_ptr<Command> climb_command(CLI::App& program) {
  auto flags = std::make_shared<ClimbFlags>();
  auto command = std::make_unique<Command>(program, "climb",
                                           "Climb at constant angles through waypoints, "
                                           "within a vehicle's angles and turn radius.");
  command->positional("waypoints", flags->waypoints, "[FILE]",
                      "CSV of x, y, z; JSON list of [x, y, z]; or GeoJSON with altitudes ('-': "
                      "standard input)");
  command->group("From where to where, instead of a file");
  command->option("--begin", flags->begin, "X,Y,Z", "the first point").list(3, 3);
  command->option("--end", flags->end, "X,Y,Z", "the last point").list(3, 3);
  command->group("Headings and places");
  const Option begin_heading =
      command->option("--begin-deg", flags->begin_degrees, "A",
                      "the heading at the first point, degrees from the x axis to the left");
  const Option end_heading =
      command->option("--end-deg", flags->end_degrees, "A", "the heading at the last point");
  command
      ->option("--headings", flags->headings, "RULE",
               "where none are given: t1 (default; weighted chords) or t2 (of "
               "the C2 spline)")
      .one_of({std::begin(heading_words), std::end(heading_words)});
  command->flag("--geographic", flags->geographic,
                "the file has longitude, latitude, altitude; they become "
                "metres about --datum");
  command->group("The climb");
  const Option climb = command->option("--climb-deg", flags->climb_degrees, "A",
                                       "every span climbs (or descends) at just this angle "
                                       "(level ones stay level); else the angle is found");
  const Option length = command->option("--ground-length", flags->ground_length, "S",
                                        "every span covers just this length over ground");
  const Option most_climb =
      command->option("--max-climb-deg", flags->most_climb_degrees, "A", "the steepest climb");
  const Option most_descent = command->option("--max-descent-deg", flags->most_descent_degrees, "A",
                                              "the steepest descent (default: as the climb)");
  command->option("--turn-radius", flags->turn_radius, "R",
                  "the least turn radius, seen from above (default 0: none)");
  flags->output.add_to(*command, "the path document (default climb.json; '-': standard output)",
                       "an HTML report with pictures");
  flags->exports.add_to(*command, "1 % of the turn radius, or 1e-4 of the length");
  command->examples(
      {"hodograph climb --begin 0,0,0 --begin-deg 45 --end 1,0,1.12 --end-deg 60 --climb-deg 45",
       "hodograph climb ridge.csv --max-climb-deg 8 --max-descent-deg 12 --turn-radius 60",
       "hodograph climb ridge.csv --max-climb-deg 8 --speed 20 --acceleration 2 --csv times.csv",
       "hodograph climb ridge.csv --max-climb-deg 8 --datum 46.5,8,600 --qgroundcontrol "
       "ridge.plan"});
  command->note(
      "A file may give each waypoint's heading and the climb angle "
      "of the span that begins there:\n"
      "columns heading (in_radians) or heading_deg, climb_angle or "
      "climb_deg; in JSON the members\n"
      "heading, climb_angle and ground_length. Where one quintic "
      "cannot keep the turn radius, arcs,\n"
      "swerves and whole turns are flown; what cannot be met is "
      "refused with the climb that can.");
  command->run([=] {
    flags->begin_heading_given = begin_heading.given();
    flags->end_heading_given = end_heading.given();
    flags->climb_given = climb.given();
    flags->length_given = length.given();
    flags->most_climb_given = most_climb.given();
    flags->most_descent_given = most_descent.given();
    run(*flags);
  });
  return command;
}

}  // namespace hodograph::cli
