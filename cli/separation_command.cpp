// SPDX-License-Identifier: MIT
// hodograph separation: how close two vehicles come, at any time.
#include <cstdio>
#include <memory>
#include <optional>

#include "cli/commands.hpp"
#include "cli/made_path.hpp"
#include "cli/motions.hpp"
#include "cli/terminal.hpp"
#include "hodograph/io/file.hpp"

namespace hodograph::cli {
namespace {

struct SeparationFlags {
  std::string first, second, stands = standing_words[0], picture;
  std::vector<double> speed, departure, arrival, acceleration, deceleration, lateral_acceleration,
      altitude;
  double at_least = 0.0, ellipsoid = 1.0, step = 0.0;
  bool at_least_given = false, step_given = false, as_json = false;
};

/// The number for the first or the second path: one number is for both.
std::optional<double> one_of(const std::vector<double>& numbers, std::size_t which) {
  if (numbers.empty()) return std::nullopt;
  return numbers.size() == 1 ? numbers[0] : numbers[which];
}

Flight flight_of(const SeparationFlags& flags, std::size_t which) {
  Flight flight;
  flight.departure = one_of(flags.departure, which).value_or(0.0);
  flight.speed = one_of(flags.speed, which);
  flight.arrival = one_of(flags.arrival, which);
  flight.acceleration = one_of(flags.acceleration, which);
  flight.deceleration = one_of(flags.deceleration, which);
  flight.lateral_acceleration = one_of(flags.lateral_acceleration, which);
  flight.presence = presence_of(flags.stands);
  flight.altitude = one_of(flags.altitude, which);
  return flight;
}

void run(const SeparationFlags& flags) {
  const PathDocument first = load_document(flags.first).value();
  const PathDocument second = load_document(flags.second).value();
  const TimedMotion a = motion_of(first.path, flight_of(flags, 0));
  const TimedMotion b = motion_of(second.path, flight_of(flags, 1));
  SeparationGoal goal;
  goal.vertical_scale = vertical_scale_of(flags.ellipsoid);
  const SeparationFacts facts = separation_facts(
      a, b, goal, flags.at_least_given ? std::optional(flags.at_least) : std::nullopt,
      flags.step_given ? std::optional(flags.step) : std::nullopt);
  if (!flags.picture.empty()) {
    const auto fault = write_file(flags.picture, to_svg(separation_picture(a, b, goal, facts)));
    if (fault) throw Error(*fault);
  }
  std::string text;
  if (flags.as_json) {
    append_json(text, json_of(facts));
    text += "\n";
  } else {
    text = table_of(rows_of(facts));
    if (!flags.picture.empty() && flags.picture != "-") text += "wrote " + flags.picture + "\n";
  }
  if (flags.picture == "-") {
    std::fputs(text.c_str(), stderr);
  } else {
    print(text);
  }
  if (facts.keeps == hodograph::Answer::yes) return;
  const bool certain = facts.keeps == hodograph::Answer::no;
  throw Error(Fault{
      FaultCode::not_separated,
      "the paths come " + std::string(certain ? "as close as " : "within rounding as close as ") +
          to_text(facts.least.distance.upper()) + ", at time " + to_six_digits(facts.least.time) +
          "; at least " + to_text(flags.at_least) + " is asked for",
      std::nullopt, "at_least", facts.least.distance.upper(), flags.at_least});
}

}  // namespace

std::unique_ptr<Command> separation_command(CLI::App& program) {
  auto flags = std::make_shared<SeparationFlags>();
  auto command = std::make_unique<Command>(
      program, "separation",
      "How close two vehicles come on their paths, at any time: a certified least distance.");
  command->positional("first", flags->first, "FIRST", "a path document ('-': standard input)")
      .required();
  command->positional("second", flags->second, "SECOND", "the other one").required();
  command->group("How the paths are flown (one number for both, or one each)");
  const auto pair = [&](const char* name, std::vector<double>& target, const char* shown,
                        const char* help) {
    Option option = command->option(name, target, shown, help);
    option.list(1, 2);
    return option;
  };
  const Option speed =
      pair("--speed", flags->speed, "V[,V]", "arc length a unit of time (default 1)");
  pair("--start", flags->departure, "T[,T]", "when they start (default 0)");
  Option arrival = pair("--arrival", flags->arrival, "T[,T]",
                        "when they arrive: the constant speeds that take so long");
  arrival.excludes(speed);
  Option acceleration = pair("--acceleration", flags->acceleration, "A[,A]",
                             "from rest to rest, up to the speed: a trapezoidal profile");
  acceleration.excludes(arrival);
  pair("--deceleration", flags->deceleration, "D[,D]", "while getting slower (default: A)")
      .needs(acceleration);
  pair("--lateral-acceleration", flags->lateral_acceleration, "A[,A]",
       "slower in bends, so that v^2 times the curvature stays below this everywhere")
      .needs(acceleration);
  pair("--altitude", flags->altitude, "Z[,Z]", "of paths in the plane (default 0)");
  command
      ->option("--stands", flags->stands, "WHEN",
               "whether they stand at the ends of their paths before they start and after they "
               "have arrived: always (default), before, after, or never")
      .one_of({std::begin(standing_words), std::end(standing_words)});
  command->group("Question");
  Option at_least = command->option("--at-least", flags->at_least, "D",
                                    "whether they keep this distance; exit code 3 if not");
  command->option("--ellipsoid", flags->ellipsoid, "FACTOR",
                  "heights count 1/FACTOR, as downwash asks for (default 1: a sphere)");
  Option step = command->option("--step", flags->step, "T",
                                "the distance at times T apart, too, and what that proves");
  command->group("Output");
  command->flag("--json", flags->as_json, "the answer as JSON");
  command->option("--svg", flags->picture, "FILE", "a picture of the distance against time");
  command->examples(
      {"hodograph separation fleet/a.json fleet/e.json --at-least 0.01",
       "hodograph separation fleet/a.json fleet/e.json --speed 1,0.8 --start 0,0.25 --svg "
       "distance.svg",
       "hodograph separation fleet/a.json fleet/e.json --speed 2 --acceleration 4 --json"});
  command->note(
      "The bounds hold for every instant and with rounding included; they are not samples.");
  command->run([flags, at_least, step] {
    flags->at_least_given = at_least.given();
    flags->step_given = step.given();
    run(*flags);
  });
  return command;
}

}  // namespace hodograph::cli
