// SPDX-License-Identifier: MIT
// hodograph follow: a path as fast as a vehicle can, within a tube round it.
#include "cli/commands.hpp"
#include "cli/left_out.hpp"
#include "hodograph/foundation/result.hpp"

#ifdef HODOGRAPH_HAS_CONTROL
#include <cstdio>
#include <memory>
#include <numbers>

#include "cli/follows.hpp"
#include "cli/motions.hpp"
#include "cli/options.hpp"
#include "cli/refuse.hpp"
#include "cli/terminal.hpp"
#include "hodograph/io/file.hpp"
#include "hodograph/io/geojson.hpp"
#endif

namespace hodograph::cli {

#ifdef HODOGRAPH_HAS_CONTROL
namespace {

struct FollowFlags {
  std::string document, world, report, table, output, independent = "time";
  FollowRequest request;
  std::vector<double> start_offset;
  double from = 0.0, to = 0.0, end_speed = 0.0, duration = 0.0, heading_degrees = 0.0;
  double clearance = 0.0, width = 0.0;
  bool from_given = false, to_given = false, end_given = false, duration_given = false;
  bool offset_given = false;
  double step = 0.0, disturbance = 0.02;
  bool step_given = false, hard = false;
  std::size_t horizon = HorizonOptions{}.intervals;
};

void tell(const FollowFlags& flags, const std::string& text) {
  if (flags.output == "-" || flags.table == "-" || flags.report == "-") {
    std::fputs(text.c_str(), stderr);
  } else {
    print(text);
  }
}

std::string json_text(const Json& json) {
  std::string text;
  append_json(text, json);
  return text + "\n";
}

void drive(const FollowFlags& flags, const PathDocument& document, const FollowRequest& request) {
  if (!(flags.disturbance >= 0.0 && flags.disturbance <= 1.0)) {
    throw Error(Fault{FaultCode::outside_domain,
                      "the disturbance is " + to_text(flags.disturbance) +
                          "; it is a share of the limits, from 0 to 1",
                      std::nullopt, "disturbance", flags.disturbance,
                      flags.disturbance < 0.0 ? 0.0 : 1.0});
  }
  HorizonOptions options;
  options.step = flags.step;
  options.intervals = flags.horizon;
  options.effort = request.options.effort;
  options.hard = flags.hard;
  constexpr std::size_t most_plans = 10000;
  HorizonDrive driven_so;
  {
    const InterruptGuard guard;
    Progress progress("driving");
    driven_so = driven(document.path, request, options, flags.disturbance, most_plans,
                       [&progress](double fraction) {
                         progress.show(std::to_string(static_cast<int>(100.0 * fraction)) + " %");
                         return !InterruptGuard::requested();
                       });
  }
  std::string text = table_of(rows_of(driven_so));
  if (!flags.output.empty()) {
    if (const auto fault = write_file(flags.output, json_text(json_of(driven_so)))) {
      throw Error(*fault);
    }
    if (flags.output != "-") text += "wrote " + flags.output + "\n";
  }
  tell(flags, text);
}

void run(FollowFlags flags) {
  const PathDocument document = load_document(flags.document).value();
  const bool planar = document.path.dimension() == 2;
  FollowRequest& request = flags.request;
  constexpr std::size_t most_iterations = 300;  // some ten times what it usually takes
  request.options.solver.max_iterations = most_iterations;
  request.start.xi = flags.from_given ? flags.from : document.path.xi_begin();
  if (flags.to_given) request.options.xi_end = flags.to;
  if (flags.end_given) request.options.end_speed = flags.end_speed;
  request.start.heading = flags.heading_degrees * std::numbers::pi / 180.0;
  if (flags.start_offset.size() > (planar ? 1U : 2U)) {
    refuse("a path in the plane has one offset, to its left", "start_offset");
  }
  std::copy(flags.start_offset.begin(), flags.start_offset.end(), request.start.offset.begin());
  if (flags.independent == "xi") request.options.independent = FollowIndependent::progress;
  if (flags.duration_given) {
    request.options.aim = FollowAim::most_progress;
    request.options.duration = flags.duration;
  }
  std::optional<World> world;
  std::optional<WorldRoom> room;
  if (!flags.world.empty()) {
    world = load_world(flags.world).value().world;
    room = room_in(document, *world, flags.clearance, flags.width);
    if (!flags.offset_given) {
      request.limits.offset = room->offset();
    } else if (request.limits.offset > room->offset()) {
      throw Error(Fault{FaultCode::outside_domain,
                        "the offset is " + to_text(request.limits.offset) +
                            "; the certified clearance of " + to_text(room->clearance) +
                            " leaves " + to_text(room->offset()),
                        std::nullopt, "offset", request.limits.offset, room->offset()});
    }
  } else if (!flags.offset_given) {
    refuse("say how far the vehicle may leave the path: --offset, or --world and --clearance",
           "offset");
  }
  if (flags.step_given) {
    drive(flags, document, request);
    return;
  }
  Following found;
  {
    const InterruptGuard guard;
    Progress progress("following");
    request.options.solver.progress = [&progress](const SolverIteration& at) {
      progress.show("iteration " + std::to_string(at.iteration) + ", objective " +
                    to_text(at.objective));
      return !InterruptGuard::requested();
    };
    found = follow(document.path, request.limits, request.start, request.options).value();
  }
  std::string text = table_of(rows_of(found, request, room));
  const auto write = [&](const std::string& file, const std::string& content) {
    if (file.empty()) return;
    if (const auto fault = write_file(file, content)) throw Error(*fault);
    if (file != "-") text += "wrote " + file + "\n";
  };
  const std::size_t dimension = document.path.dimension();
  const std::string report =
      flags.report.empty()
          ? ""
          : report_html(report_of(document, found, request, room, world ? &*world : nullptr));
  write(flags.output, json_text(json_of(found, request, room, true, dimension)));
  write(flags.table, csv_of(found, dimension));
  write(flags.report, report);
  tell(flags, text);
}

}  // namespace

std::unique_ptr<Command> follow_command(CLI::App& program) {
  auto flags = std::make_shared<FollowFlags>();
  auto command = std::make_unique<Command>(
      program, "follow", "Follow a path as fast as a vehicle can, within a tube round it.");
  add_document_to(*command, flags->document);
  FollowRequest& request = flags->request;
  command->group("What the vehicle can");
  command->option("--speed", request.limits.speed, "V", "the largest speed").required();
  command
      ->option("--acceleration", request.limits.acceleration, "A",
               "the largest acceleration: forwards, in space in any direction")
      .required();
  command->option("--braking", request.limits.braking, "A",
                  "in the plane: the largest deceleration (default: as the acceleration)");
  command->option("--lateral-acceleration", request.limits.lateral_acceleration, "A",
                  "in the plane: the largest across the way (default: none)");
  command->option("--turn-radius", request.limits.turn_radius, "R",
                  "in the plane: the least radius it can steer (default 0)");
  command->group("How far from the path");
  Option offset = command->option("--offset", request.limits.offset, "D",
                                  "at most; the tube must be free of folds");
  Option world = command->option("--world", flags->world, "FILE",
                                 "GeoJSON obstacles: as far as the clearance allows");
  command->option("--clearance", flags->clearance, "C", "kept from obstacles (default 0)")
      .needs(world);
  command->option("--width", flags->width, "W", "of the vehicle (default 0)").needs(world);
  command->group("From where to where");
  Option from = command->option("--from-xi", flags->from, "XI", "default: where the path begins");
  Option to = command->option("--to-xi", flags->to, "XI", "default: where it ends; once round");
  command->option("--start-speed", request.start.speed, "V", "default 0");
  command->option("--start-heading-deg", flags->heading_degrees, "A",
                  "in the plane: to the left of the path (default 0)");
  command->option("--start-offset", flags->start_offset, "D[,E]", "along e2 (and e3); default 0")
      .list(1, 2);
  Option end = command->option("--end-speed", flags->end_speed, "V", "in the plane (default: any)");
  Option duration = command->option("--duration", flags->duration, "T",
                                    "as far as possible in this time instead of the least time");
  command->group("How");
  Option independent =
      command
          ->option("--independent", flags->independent, "VARIABLE",
                   "time (default), or xi: for a vehicle that always moves forwards")
          .one_of({"time", "xi"});
  Option intervals = command
                         ->option("--intervals", request.options.intervals, "N",
                                  "of constant control (default 200)")
                         .whole_number(2, 100000);
  command->option("--effort", request.options.effort, "W",
                  "what the controls cost, as a share of the time (default 0.01)");
  command->group("Receding horizon");
  Option step = command->option("--horizon-step", flags->step, "T",
                                "plan anew every T seconds while driving, and time it");
  step.excludes(duration).excludes(end).excludes(independent).excludes(intervals);
  command->option("--horizon", flags->horizon, "N", "steps ahead (default 30)")
      .whole_number(2, 1000)
      .needs(step);
  command
      ->option("--disturbance", flags->disturbance, "E",
               "random errors of the state between plans, as a share of its limits "
               "(default 0.02)")
      .needs(step);
  command
      ->flag("--hard", flags->hard,
             "in the plane: never plan to leave the tube; where that cannot be, stop (default: "
             "leave it as little as possible)")
      .needs(step);
  command->group("Files");
  command->option("-o,--out", flags->output, "FILE", "everything as JSON ('-': standard output)");
  command->option("--csv", flags->table, "FILE", "one row for every node").excludes(step);
  command->option("--report", flags->report, "FILE", "an HTML report with pictures").excludes(step);
  command->examples(
      {"hodograph follow plan.json --speed 10 --acceleration 2 --lateral-acceleration 3 "
       "--world harbour.geojson --clearance 0.5 --report follow.html",
       "hodograph follow track.json --speed 1 --acceleration 0.5 --offset 0.05 --csv nodes.csv",
       "hodograph follow plan.json --speed 10 --acceleration 2 --lateral-acceleration 3 "
       "--offset 0.5 --horizon-step 0.1"});
  command->note(
      "In the plane the vehicle is a car, in space a point that accelerates in any direction. The\n"
      "unit of length is the path's, that of time the second. Ctrl-C stops between two iterations\n"
      "and writes nothing. See docs/control.md.");
  command->run([=] {
    flags->from_given = from.given();
    flags->to_given = to.given();
    flags->end_given = end.given();
    flags->duration_given = duration.given();
    flags->offset_given = offset.given();
    flags->step_given = step.given();
    run(*flags);
  });
  return command;
}

#else

std::unique_ptr<Command> follow_command(CLI::App& program) {
  return command_left_out(program, "follow", "Ipopt");
}

#endif

}  // namespace hodograph::cli
