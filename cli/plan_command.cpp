// SPDX-License-Identifier: MIT
// hodograph plan: a path among obstacles that keeps a turn radius and a clearance, with the proof.
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>

#include "cli/commands.hpp"
#include "cli/exports.hpp"
#include "cli/fitting.hpp"
#include "cli/options.hpp"
#include "cli/plan_comparison.hpp"
#include "cli/plans.hpp"
#include "cli/terminal.hpp"
#include "hodograph/io/geojson.hpp"

namespace hodograph::cli {
namespace {

struct PlanFlags {
  std::string world, corners = "smallest";
  std::vector<double> start, goal;
  VehicleLimits limits;
  std::optional<double> corner_offset;
  std::size_t most_attempts = PlanRequest{}.most_attempts;
  bool compare = false;
  ExportFlags exports;
  OutputFlags output;
};

Vector2<double> place(const std::vector<double>& given, const std::optional<Vector2<double>>& named,
                      const char* what, const std::string& world) {
  if (!given.empty()) return {given[0], given[1]};
  if (named) return *named;
  throw Error(Fault{FaultCode::malformed_document,
                    std::string("give --") + what + " X,Y; " + on_one_line(input_name(world)) +
                        " has no feature with the role '" + what + "'",
                    std::nullopt, what, std::nullopt, std::nullopt});
}

double default_chord(const PlanFlags& flags) {
  constexpr double share = 0.01;  // of the turn radius
  return share * flags.limits.turn_radius;
}

void run(const PlanFlags& flags) {
  flags.exports.check();
  const auto began = std::chrono::steady_clock::now();
  const WorldDocument document = load_world(flags.world).value();
  PlanRequest request;
  request.start = place(flags.start, document.start, "start", flags.world);
  request.goal = place(flags.goal, document.goal, "goal", flags.world);
  request.aim = corner_aim(flags.corners);
  request.corner_offset = flags.corner_offset;
  request.most_attempts = flags.most_attempts;
  const Planner planner = Planner::create(document.world, flags.limits).value();
  const Plan plan = planner.plan(request).value();
  const MadePath made =
      made_plan(plan, flags.limits, request.aim, flags.world == "-" ? "" : flags.world);
  ReportData report = report_of(made.document, made.facts,
                                flags.output.document == "-" ? "" : flags.output.document);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  report.more = rows_of(plan, planner.world());
  report.surroundings = outlines(planner.world());
  report.curvature_limit = 1.0 / flags.limits.turn_radius;
  report.title = "A path among obstacles";
  report.path.frames.clear();  // a map shows the path alone
  report.path.frame_origins.clear();
  if (!flags.output.report.empty()) {
    for (Series& series : grown_outlines(planner.world(), flags.limits.distance())) {
      report.surroundings.push_back(std::move(series));
    }
    report.surroundings.push_back(polyline_series(plan.polyline));
  }
  GeoJsonScene scene{planner.world(), request.start, request.goal};
  if (flags.compare) {
    const std::vector<ComparedPlan> compared = compared_plans(plan, planner.world());
    for (auto& row : rows_of(compared, plan, planner.world(), flags.limits)) {
      report.more.push_back(std::move(row));
    }
    draw(report, compared, plan, flags.limits);
    for (const ComparedPlan& one : compared) {
      if (!one.plan || flags.exports.geojson.empty()) continue;
      scene.paths.push_back(
          line_of(made_comparison(one, "").document, flags.exports.near(default_chord(flags))));
    }
  }
  write_files(made.document, report, flags.output);
  const std::string written =
      flags.exports.write(made.document, std::move(scene), default_chord(flags));
  if (flags.output.document == "-" || flags.output.report == "-") {
    std::fputs(written.c_str(), stderr);
  } else {
    print(written);
  }
}

}  // namespace

std::unique_ptr<Command> plan_command(CLI::App& program) {
  auto flags = std::make_shared<PlanFlags>();
  struct Numbers {
    double corner_offset = 0.0;
  };
  auto numbers = std::make_shared<Numbers>();
  auto command = std::make_unique<Command>(
      program, "plan",
      "Plan a path among obstacles that keeps a turn radius and a clearance at every point.");
  command
      ->positional("world", flags->world, "WORLD",
                   "the obstacles: a GeoJSON file of polygons ('-': standard input)")
      .required();
  command->group("From where to where (or features of the world with the role start, goal)");
  command->option("--start", flags->start, "X,Y", "where the path begins").list(2, 2);
  command->option("--goal", flags->goal, "X,Y", "where it ends").list(2, 2);
  command->group("The vehicle");
  command
      ->option("--turn-radius", flags->limits.turn_radius, "R",
               "the least radius of curvature that it can follow")
      .required();
  command->option("--clearance", flags->limits.clearance, "D",
                  "the least distance between the vehicle and an obstacle (default 0)");
  command->option("--width", flags->limits.width, "W", "of the vehicle (default 0)");
  command->group("How");
  command
      ->option("--corners", flags->corners, "SIZE",
               "smallest (default), largest, or of the sizes that make the path shortest or "
               "gentlest")
      .one_of({std::begin(corner_words), std::end(corner_words)});
  Option offset = command->option(
      "--corner-offset", numbers->corner_offset, "D",
      "grow all obstacles by this much more, so that corners have room to be larger");
  command
      ->option("--attempts", flags->most_attempts, "N",
               "how many polylines are tried where corners have no room (default 64)")
      .whole_number(1, 100000);
  command->flag("--compare", flags->compare,
                "beside it the paths by the rules T1 and T2 through the polyline's points: length, "
                "curvature, clearance");
  flags->output.add_to(*command, "the path document (default plan.json; '-': standard output)",
                       "an HTML report with pictures");
  flags->exports.add_to(*command, "1 % of the turn radius");
  std::vector<std::string> examples = {
      "hodograph plan harbour.geojson --turn-radius 3 --clearance 1 --report plan.html",
      "hodograph plan harbour.geojson --start 0,0 --goal 60,40 --turn-radius 3 --corners gentlest",
      "hodograph plan harbour.geojson --turn-radius 3 --compare --report plan.html",
      "hodograph plan harbour.geojson --turn-radius 3 --geojson plan.geojson --csv plan.csv",
      "hodograph check plan.json harbour.geojson"};
  if (has_geodesy()) {
    examples.emplace_back(
        "hodograph plan harbour.geojson --turn-radius 3 --wpl harbour.txt --datum 47.4,8.5,400");
  }
  command->examples(examples);
  command->note(
      "The turn radius and the clearance hold for every point of the path, not for samples, and\n"
      "hodograph check proves them again from the two files.");
  command->run([flags, numbers, offset] {
    if (flags->output.document.empty()) flags->output.document = "plan.json";
    if (offset.given()) flags->corner_offset = numbers->corner_offset;
    run(*flags);
  });
  return command;
}

}  // namespace hodograph::cli
