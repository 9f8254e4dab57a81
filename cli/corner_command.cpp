// SPDX-License-Identifier: MIT
// hodograph corner: a corner of two lines, or every corner of a polyline, rounded with continuous
// curvature.
#include <memory>
#include <optional>

#include "cli/commands.hpp"
#include "cli/made_path.hpp"
#include "cli/options.hpp"
#include "cli/points.hpp"
#include "cli/refuse.hpp"
#include "hodograph/construction/corner.hpp"

namespace hodograph::cli {
namespace {

struct CornerFlags {
  PointsFlags points;
  std::vector<double> before, at, after;
  std::optional<double> leg, most_curvature, most_deviation;
  bool closed = false;
  OutputFlags output;
};

using Rows = std::vector<std::pair<std::string, std::string>>;

void round_one(const CornerFlags& flags) {
  if (flags.before.empty() || flags.after.empty()) {
    refuse("a corner needs --before X,Y and --after X,Y, points on the lines that meet in it",
           "corner");
  }
  const auto given = [](const auto& value) { return static_cast<int>(value.has_value()); };
  if (given(flags.leg) + given(flags.most_curvature) + given(flags.most_deviation) > 1) {
    refuse(
        "give one of --leg, --curvature and --deviation (without any, the corner takes all the "
        "room there is)",
        "corner");
  }
  const Corner corner{{flags.before[0], flags.before[1]},
                      {flags.at[0], flags.at[1]},
                      {flags.after[0], flags.after[1]}};
  const RoundedCorner rounded =
      (flags.leg              ? corner_of_leg(corner, *flags.leg)
       : flags.most_curvature ? corner_of_curvature(corner, *flags.most_curvature)
       : flags.most_deviation ? corner_of_deviation(corner, *flags.most_deviation)
                              : corner_of_room(corner))
          .value();
  const Rows more = {{"Turning angle", to_six_digits(rounded.shape.turning_angle) + " rad"},
                     {"From the corner point", to_six_digits(rounded.leg) + " to either end"},
                     {"Peak curvature", to_six_digits(rounded.shape.peak_curvature)},
                     {"Deviation", to_six_digits(rounded.shape.deviation) + " in the middle"}};
  write_made_path(made_path(PlanarPath<2>::create({0.0, 1.0}, {rounded.curve}, false).value(),
                            "a corner", "G2 corner"),
                  flags.output, more);
}

void round_all(const CornerFlags& flags) {
  if (flags.leg)
    refuse("--leg is for one corner; a polyline takes --curvature or --deviation", "corner");
  const auto points = flags.points.read();
  auto path = rounded_polyline(points, {.most_curvature = flags.most_curvature,
                                        .most_deviation = flags.most_deviation,
                                        .closed = flags.closed})
                  .value();
  double polyline = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) polyline += norm(points[i] - points[i - 1]);
  if (flags.closed) polyline += norm(points.front() - points.back());
  const Rows more = {{"Polyline", to_six_digits(polyline) + " long, " +
                                      std::to_string(points.size()) + " points"}};
  write_made_path(
      made_path(AnyPath(std::move(path)), "polyline: " + flags.points.name(), "G2 corners"),
      flags.output, more);
}

}  // namespace

std::unique_ptr<Command> corner_command(CLI::App& program) {
  auto flags = std::make_shared<CornerFlags>();
  struct Numbers {
    double leg = 0.0, curvature = 0.0, deviation = 0.0;
  };
  auto numbers = std::make_shared<Numbers>();
  auto command = std::make_unique<Command>(
      program, "corner",
      "Round one corner, or all corners of a polyline, with continuous curvature.");
  Option points = command->positional(
      "points", flags->points.file, "[FILE]",
      "the polyline: CSV file of x and y, or a JSON list of [x, y] ('-': standard input)");
  command->group("One corner");
  Option at = command->option("--at", flags->at, "X,Y", "the corner point, instead of a file");
  at.list(2, 2).excludes(points);
  command->option("--before", flags->before, "X,Y", "a point on the line that comes in")
      .list(2, 2)
      .needs(at);
  command->option("--after", flags->after, "X,Y", "a point on the line that goes out")
      .list(2, 2)
      .needs(at);
  Option leg = command->option("--leg", numbers->leg, "LENGTH",
                               "from the corner point to where the rounding begins and ends");
  command->group("How");
  Option curvature = command->option("--curvature", numbers->curvature, "K",
                                     "the largest curvature: the smallest corners that keep it");
  Option deviation = command->option("--deviation", numbers->deviation, "LENGTH",
                                     "the largest distance from the corner point");
  command->flag("--closed", flags->closed, "the polyline returns to its first point");
  flags->points.add_columns_to(*command);
  flags->output.add_to(*command, "the path document (default path.json; '-': standard output)",
                       "an HTML report with pictures");
  command->examples(
      {"hodograph corner --before 0,0 --at 1,0 --after 1,1 --curvature 4",
       "hodograph corner route.csv --curvature 0.2 -o route.json --report route.html"});
  command->note("Without --curvature and --deviation every corner takes all the room there is.");
  command->run([flags, numbers, points, at, leg, curvature, deviation] {
    if (flags->output.document.empty()) flags->output.document = "path.json";
    if (leg.given()) flags->leg = numbers->leg;
    if (curvature.given()) flags->most_curvature = numbers->curvature;
    if (deviation.given()) flags->most_deviation = numbers->deviation;
    if (at.given()) return round_one(*flags);
    if (!points.given()) {
      refuse(
          "give the polyline (a file), or one corner with --before, --at and --after (see "
          "hodograph corner --help)",
          "corner");
    }
    round_all(*flags);
  });
  return command;
}

}  // namespace hodograph::cli
