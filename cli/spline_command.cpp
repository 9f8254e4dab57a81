// SPDX-License-Identifier: MIT
// hodograph spline: the C² path through points of the plane.
#include <memory>

#include "cli/commands.hpp"
#include "cli/made_path.hpp"
#include "cli/options.hpp"
#include "cli/points.hpp"
#include "hodograph/construction/planar_spline.hpp"

namespace hodograph::cli {
namespace {

struct SplineFlags {
  PointsFlags points;
  bool closed = false, merge = false;
  std::string knots = "uniform";
  OutputFlags output;
};

void run(SplineFlags flags) {
  if (flags.output.document.empty()) flags.output.document = "path.json";
  const auto points = flags.points.read();
  PlanarSplineOptions options;
  options.closed = flags.closed;
  options.parameters =
      flags.knots == "chord" ? SplineParameters::chord_length : SplineParameters::uniform;
  options.repeated = flags.merge ? RepeatedPoints::merge : RepeatedPoints::refuse;
  options.with_energy = true;
  auto spline = planar_spline(points, options).value();
  const PlanarSplineReport& report = spline.report;
  std::vector<std::pair<std::string, std::string>> more;
  more.emplace_back("Newton steps", std::to_string(report.newton_steps) +
                                        (report.continued ? ", by continuation" : ""));
  more.emplace_back("Residual", to_six_digits(report.residual));
  if (report.energy) more.emplace_back("Bending energy", to_six_digits(*report.energy));
  if (report.alternatives_tried > 0) {
    more.emplace_back("Solutions", std::to_string(report.solutions_found) + " found in " +
                                       std::to_string(report.alternatives_tried) +
                                       (report.alternatives_tried == 1 ? " trial" : " trials") +
                                       "; the one of least bending energy taken");
  }
  if (report.merged_points > 0) {
    more.emplace_back("Repeated points", std::to_string(report.merged_points) + " left out");
  }
  const std::string source = "points: " + flags.points.name() + "; " +
                             std::to_string(points.size()) + " points; " +
                             (flags.closed ? "closed" : "open");
  write_made_path(
      made_path(AnyPath(std::move(spline.path)), source, "C2 spline of planar quintics",
                options.parameters == SplineParameters::uniform ? "uniform knots" : "chord knots"),
      flags.output, more);
}

}  // namespace

std::unique_ptr<Command> spline_command(CLI::App& program) {
  auto flags = std::make_shared<SplineFlags>();
  auto command = std::make_unique<Command>(program, "spline",
                                           "The C2 path of planar quintics through points.");
  command
      ->positional("points", flags->points.file, "FILE",
                   "CSV file of x and y, or a JSON list of [x, y] ('-': standard input)")
      .required();
  command->group("Spline");
  command->flag("--closed", flags->closed, "return to the first point, smoothly");
  command
      ->option("--knots", flags->knots, "WAY",
               "parameter steps: uniform (default), or chord: the distances of the points, for "
               "points that are unevenly spaced")
      .one_of({"uniform", "chord"});
  command->flag("--merge-repeated", flags->merge,
                "leave out a point equal to the one before it, instead of refusing it");
  flags->points.add_columns_to(*command);
  flags->output.add_to(*command, "the path document (default path.json; '-': standard output)",
                       "an HTML report with pictures");
  command->examples(
      {"hodograph spline waypoints.csv -o path.json --report path.html",
       "hodograph spline track.csv --closed --knots chord -o - | hodograph inspect -"});
  command->run([flags] { run(*flags); });
  return command;
}

}  // namespace hodograph::cli
