// SPDX-License-Identifier: MIT
// hodograph swarm: vehicles that arrive together or fly given paths, all pairs certified.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>

#include "cli/commands.hpp"
#include "cli/made_path.hpp"
#include "cli/options.hpp"
#include "cli/polynomial_flight.hpp"
#include "cli/refuse.hpp"
#include "cli/requests/batch.hpp"
#include "cli/swarm_exports.hpp"
#include "cli/swarm_pictures.hpp"
#include "cli/swarms.hpp"
#include "cli/terminal.hpp"
#include "hodograph/io/file.hpp"
#include "hodograph/io/geodesy.hpp"

namespace hodograph::cli {
namespace {

struct SwarmFlags {
  std::string swarm, least, folder, matrix, picture, animation, crazyswarm;
  double arrival = 0.0, length = 0.0, excess = 0.0, clearance = 0.0, ellipsoid = 1.0;
  double longest_delay = 0.0, latest_excess = 0.0, tolerance = 0.0;
  std::size_t delays = 0, later_arrivals = 0, closest = 10;
  SwarmExportFlags exports;
  bool deconflict = false, as_json = false, tolerance_given = false;
  /// The members of the file that options replace.
  std::vector<std::pair<std::string, Json>> replaced, moves;
};

void write(const std::string& file, const std::string& text) {
  if (const auto fault = write_file(file, text)) throw Error(*fault);
}

void make_output_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    refuse("the folder '" + on_one_line(folder) + "' cannot be made: " + error.message(), "file",
           FaultCode::not_written);
  }
}

std::string file_in(const std::string& folder, const std::string& name) {
  return (std::filesystem::path(folder) / name).string();
}

/// The file's members, those that options name replaced, and file names as seen from here.
Json members_of(const SwarmFlags& flags) {
  Json json = parsed_json(read_file(flags.swarm).value(), "the swarm");
  if (!json.is_object()) return json;
  for (const auto& [name, value] : flags.replaced) {
    if (name == "arrival" || name == "length" || name == "excess" || name == "least") {
      for (const char* const other : {"arrival", "length", "excess", "least"}) json.erase(other);
    }
    json[name] = value;
  }
  if (flags.deconflict && !json.contains("deconflict")) json["deconflict"] = Json::object();
  for (const auto& [name, value] : flags.moves) {
    if (json["deconflict"].is_object()) json["deconflict"][name] = value;
  }
  const auto found = json.find("vehicles");
  if (found == json.end() || !found->is_array() || flags.swarm == "-") return json;
  const std::filesystem::path folder = std::filesystem::path(flags.swarm).parent_path();
  for (Json& vehicle : *found) {
    if (!vehicle.is_object() || !vehicle.contains("file") || !vehicle["file"].is_string()) continue;
    vehicle["file"] = (folder / vehicle["file"].get<std::string>()).string();
  }
  return json;
}

/// Faults name the file.
SwarmRequest request_of(const SwarmFlags& flags) {
  try {
    const Json json = members_of(flags);
    Members members(json, "", "the swarm");
    SwarmRequest request = swarm_request(members);
    members.require_all_known();
    return request;
  } catch (const Error& error) {
    Fault fault = error.fault();
    const std::string name = input_name(flags.swarm);
    if (fault.sentence.find(name) == std::string::npos) {
      fault.sentence = name + ": " + fault.sentence;
    }
    throw Error(fault);
  }
}

/// The folder of path documents, with the swarm that flies them. The files' names are added.
void write_documents(const SwarmFlags& flags, const SwarmFacts& facts, std::string& written) {
  if (flags.folder.empty()) return;
  for (const Vehicle& vehicle : facts.vehicles) {
    if (vehicle.id == "swarm") {
      refuse("no vehicle may be called 'swarm' where a folder is written: swarm.json is the swarm",
             "id");
    }
  }
  make_output_folder(flags.folder);
  for (std::size_t i = 0; i < facts.vehicles.size(); ++i) {
    write(file_in(flags.folder, facts.vehicles[i].id + ".json"), to_json(facts.documents[i]));
  }
  write(file_in(flags.folder, "swarm.json"), swarm_json(facts));
  written += "wrote " + std::to_string(facts.vehicles.size()) + " paths and " +
             file_in(flags.folder, "swarm.json") + "\n";
}

/// How many polynomials were written, and their error as JSON; null where none were asked for.
Json write_polynomials(const SwarmFlags& flags, const SwarmFacts& facts, std::string& written) {
  if (flags.crazyswarm.empty()) return {};
  constexpr double share = 1e-6;  // not a tolerance: the default, of the longest path
  double begin = facts.vehicles[0].motion.start_time(), longest = 0.0;
  for (const Vehicle& vehicle : facts.vehicles) {
    begin = std::min(begin, vehicle.motion.start_time());
    longest = std::max(longest, vehicle.motion.length());
  }
  const double tolerance = flags.tolerance_given ? flags.tolerance : share * longest;
  double error = 0.0;
  std::size_t pieces = 0;
  std::vector<std::string> files;
  for (std::size_t i = 0; i < facts.vehicles.size(); ++i) {
    const auto flight =
        polynomial_flight(facts.documents[i].path, facts.vehicles[i].motion, begin, tolerance);
    if (!flight) {
      Fault fault = flight.fault();
      fault.sentence = "'" + facts.vehicles[i].id + "': " + fault.sentence;
      throw Error(fault);
    }
    error = std::max(error, flight->error);
    pieces += flight->pieces.size();
    files.push_back(crazyswarm_csv(*flight));
  }
  make_output_folder(flags.crazyswarm);
  for (std::size_t i = 0; i < files.size(); ++i) {
    write(file_in(flags.crazyswarm, facts.vehicles[i].id + ".csv"), files[i]);
  }
  // Rounding to three digits takes off at most 1/200.
  constexpr double three_digits = 1.0 + 1.0 / 128.0;
  char bound[32];
  std::snprintf(bound, sizeof bound, "%.3g", error * three_digits);
  written += "wrote " + std::to_string(files.size()) + " trajectories to " + flags.crazyswarm +
             ": " + std::to_string(pieces) + " polynomials, within " + bound +
             " of the paths at every instant, certified\n";
  return {{"folder", flags.crazyswarm}, {"polynomials", pieces}, {"error", error}};
}

bool ends_in_html(const std::string& file) {
  std::string suffix = std::filesystem::path(file).extension().string();
  for (char& c : suffix) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return suffix == ".html" || suffix == ".htm";
}

void run(const SwarmFlags& flags) {
  flags.exports.check();
  const SwarmFacts facts = swarm_facts(request_of(flags));
  std::string written;
  write_documents(flags, facts, written);
  const Json trajectories = write_polynomials(flags, facts, written);
  const auto write_text = [&](const std::string& file, const std::string& text) {
    write(file, text);
    written += "wrote " + file + "\n";
  };
  if (!flags.matrix.empty()) write_text(flags.matrix, matrix_csv(facts));
  if (!flags.picture.empty()) {
    const Plot plots[] = {path_picture(facts), pair_picture(facts)};
    write_text(flags.picture, to_svg(plots, 2));
  }
  if (!flags.animation.empty()) {
    write_text(flags.animation,
               ends_in_html(flags.animation) ? animated_html(facts) : animated_svg(facts));
  }
  written += flags.exports.write(facts);
  std::string text;
  if (flags.as_json) {
    Json json = json_of(facts, flags.closest, false, false);
    if (!trajectories.is_null()) json["trajectories"] = trajectories;
    append_json(text, json);
    text += "\n";
  } else {
    if (facts.arrival) text = "  All arrive at " + to_text(*facts.arrival) + "\n\n";
    text += text_of(facts, flags.closest) + written;
  }
  print(text);
  if (const auto fault = conflict_fault(facts)) throw Error(*fault);
}

}  // namespace

std::unique_ptr<Command> swarm_command(CLI::App& program) {
  auto flags = std::make_shared<SwarmFlags>();
  auto command = std::make_unique<Command>(
      program, "swarm",
      "Vehicles that arrive together, or fly given paths: made, kept apart, all pairs certified.");
  command
      ->positional("swarm", flags->swarm, "SWARM",
                   "the vehicles: a JSON file, described in docs/requests.md ('-': standard input)")
      .required();
  command->group("When they arrive (instead of what the file says)");
  Option arrival = command->option("--arrival", flags->arrival, "T", "at this time");
  Option length = command->option("--length", flags->length, "S",
                                  "on paths of this length, those that leave together");
  Option excess = command->option(
      "--excess", flags->excess, "F",
      "later than straight flight by this fraction of the longest: 0.125 is 12.5 % more");
  Option least =
      command->option("--least", flags->least, "KIND",
                      "as early as possible: feasible, as the curvature limits allow; or "
                      "separated, so that all keep their distance");
  least.one_of({"feasible", "separated"});
  arrival.excludes(length).excludes(excess).excludes(least);
  length.excludes(excess).excludes(least);
  excess.excludes(least);
  command->group("Their distance");
  Option clearance = command->option(
      "--clearance", flags->clearance, "D",
      "what all pairs keep besides their radii at every instant; exit code 3 if they do not");
  Option ellipsoid = command->option("--ellipsoid", flags->ellipsoid, "FACTOR",
                                     "heights count 1/FACTOR, as downwash asks for");
  command->flag("--deconflict", flags->deconflict,
                "change departures, the solutions flown and, last, the arrival until all keep it");
  Option longest_delay =
      command->option("--longest-delay", flags->longest_delay, "T",
                      "of a departure (default: an eighth of the longest flight)");
  Option delays = command->option("--delays", flags->delays, "N",
                                  "how many delays are tried up to it (default 4)");
  Option latest =
      command->option("--latest-excess", flags->latest_excess, "F",
                      "how much later the arrival may be, as a fraction (default 0.25)");
  Option later = command->option("--later-arrivals", flags->later_arrivals, "N",
                                 "how many later arrivals are tried (default 4)");
  delays.whole_number(0, 10000);
  later.whole_number(0, 10000);
  command->group("Files");
  command->option("-o,--out", flags->folder, "FOLDER",
                  "a path document for every vehicle, and swarm.json that flies them");
  command->option("--matrix", flags->matrix, "FILE",
                  "the least separation of every pair, as CSV (lower bounds)");
  command->option("--svg", flags->picture, "FILE",
                  "a picture of the paths and of the separations against time");
  command->option("--animation", flags->animation, "FILE",
                  "the flight: a page with a slider (.html) or a picture that moves (.svg)");
  Option crazyswarm = command->option(
      "--crazyswarm", flags->crazyswarm, "FOLDER",
      "a trajectory for every vehicle, as CSV: polynomials of degree 7 in time, yaw 0");
  Option tolerance = command->option("--tolerance", flags->tolerance, "LENGTH",
                                     "of those polynomials (default: 1e-6 of the longest path)");
  tolerance.needs(crazyswarm);
  flags->exports.add_to(*command);
  command->group("Output");
  command->option("--closest", flags->closest, "N", "how many pairs are listed (default 10)")
      .whole_number(0, 1000000);
  command->flag("--json", flags->as_json, "the answer as JSON");
  std::vector<std::string> examples = {
      "hodograph swarm swarm.json -o fleet --svg swarm.svg --animation swarm.html",
      "hodograph swarm swarm.json --clearance 0.03 --deconflict --matrix separations.csv",
      "hodograph swarm swarm.json --least separated --crazyswarm trajectories",
      "hodograph swarm fleet/swarm.json --clearance 0.01 --json"};
  if (has_geodesy()) {
    examples.emplace_back(
        "hodograph swarm swarm.json --qgroundcontrol missions --datum 47.4,8.5,400");
  }
  command->examples(examples);
  command->note("All distances hold for every instant, rounding included; they are not samples.");
  command->run([=] {
    const auto replace = [&](const Option& option, const char* name, const Json& value) {
      if (option.given()) flags->replaced.emplace_back(name, value);
    };
    replace(arrival, "arrival", flags->arrival);
    replace(length, "length", flags->length);
    replace(excess, "excess", flags->excess);
    replace(least, "least", flags->least);
    replace(clearance, "clearance", flags->clearance);
    replace(ellipsoid, "ellipsoid", flags->ellipsoid);
    const auto move = [&](const Option& option, const char* name, const Json& value) {
      if (!option.given()) return;
      flags->moves.emplace_back(name, value);
      flags->deconflict = true;
    };
    move(longest_delay, "longest_delay", flags->longest_delay);
    move(delays, "delays", flags->delays);
    move(latest, "latest_excess", flags->latest_excess);
    move(later, "later_arrivals", flags->later_arrivals);
    flags->tolerance_given = tolerance.given();
    run(*flags);
  });
  return command;
}

}  // namespace hodograph::cli
