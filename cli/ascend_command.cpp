// SPDX-License-Identifier: MIT
// hodograph ascend: from the Moon's surface to the Lunar Gateway's orbit.
#include "cli/commands.hpp"
#include "cli/left_out.hpp"
#include "hodograph/foundation/fault.hpp"

#ifdef HODOGRAPH_HAS_CONTROL
#include <algorithm>
#include <filesystem>
#include <memory>
#include <numbers>

#include "cli/ascents.hpp"
#include "cli/refuse.hpp"
#include "cli/terminal.hpp"
#include "hodograph/io/file.hpp"
#endif

namespace hodograph::cli {

#ifdef HODOGRAPH_HAS_CONTROL
namespace {

struct AscendFlags {
  std::vector<std::string> problems = {"tracking", "energy"};
  std::vector<std::string> starts = {"all"};
  std::string coordinates = "rectangular";
  AscentOptions options;
  std::size_t guesses = AscentSolving{}.guesses, most_iterations = 0, intervals = 100;
  double singular_degrees = default_singular_theta * 180.0 / std::numbers::pi;
  std::string document, table, report = "ascent.html";
  bool as_json = false;
};

void write(const std::string& file, const std::string& text, std::string& written) {
  if (const auto fault = write_file(file, text)) throw Error(*fault);
  if (file != "-") written += "wrote " + file + "\n";
}

/// The file of one problem: with several problems, "ascent-energy.html" for "ascent.html".
std::string file_of(const std::string& file, const std::string& problem, bool several) {
  if (!several || file == "-") return file;
  const std::filesystem::path path(file);
  return (path.parent_path() / (path.stem().string() + "-" + problem + path.extension().string()))
      .string();
}

void run(const AscendFlags& flags) {
  for (const std::string& problem : flags.problems) {
    if (std::find(ascent_problems.begin(), ascent_problems.end(), problem) ==
        ascent_problems.end()) {
      refuse("there is no problem '" + on_one_line(problem) +
                 "'; the problems are tracking, figure, energy and time",
             "problem");
    }
  }
  std::vector<std::string> starts;
  const auto add = [&starts](const std::string& name) {  // once each
    if (std::find(starts.begin(), starts.end(), name) == starts.end()) starts.push_back(name);
  };
  for (const std::string& name : flags.starts) {
    if (name == "all") {
      for (const AscentStart& start : ascent_starts()) add(start.name);
    } else {
      add(ascent_start(name).value().name);
    }
  }
  AscentOptions options = flags.options;
  options.along_path = flags.coordinates == "path";
  const bool gravity = std::any_of(
      flags.problems.begin(), flags.problems.end(),
      [](const std::string& problem) { return problem == "energy" || problem == "time"; });
  if (options.along_path && !gravity) {
    refuse("--coordinates path is for the problems with gravity, energy and time", "coordinates");
  }
  options.tracking.singular_theta = flags.singular_degrees * std::numbers::pi / 180.0;
  options.tracking.intervals = options.powered.intervals = flags.intervals;
  for (AscentSolving* solving : {&options.tracking.solving, &options.powered.solving}) {
    solving->guesses = flags.guesses;
    if (flags.most_iterations > 0) solving->max_iterations = flags.most_iterations;
  }

  std::vector<AscentSet> sets;
  const InterruptGuard guard;  // the orbit comes first: a second or less
  const AscentReference reference = AscentReference::gateway().value();
  {
    Progress progress("ascending");
    const AscentWatch watch = [&](const std::string& line) {
      progress.show(line);
      return !InterruptGuard::requested();
    };
    for (const std::string& problem : flags.problems) {
      sets.push_back(solved_ascents(reference, problem, starts, options, watch));
    }
  }
  std::string text, written;
  Json all = Json::array();
  const bool several = sets.size() > 1;
  for (const AscentSet& set : sets) {
    text += text_of(set) + "\n";
    for (const PoweredAscent& ascent : set.powered) {
      if (ascent.again.lowest_later_height_km < 0.0) {
        text += ascent.start.name + " goes " + to_text(-ascent.again.lowest_later_height_km) +
                " km below the surface between two nodes: take more --intervals or a larger "
                "--margin-km\n";
      }
    }
    if (flags.report != "none") {
      write(file_of(flags.report, set.problem, several), report_html(report_of(reference, set)),
            written);
    }
    if (!flags.table.empty()) {
      write(file_of(flags.table, set.problem, several), csv_of(set), written);
    }
    if (flags.as_json || !flags.document.empty()) all.push_back(json_of(set, true));
  }
  if (!flags.document.empty()) {
    std::string json;
    append_json(json, several ? all : all.front());
    write(flags.document, json + "\n", written);
  }
  if (flags.as_json) {
    std::string json;
    append_json(json, several ? all : all.front());
    print(json + "\n");
  } else {
    print(text + written);
  }
}

}  // namespace

std::unique_ptr<Command> ascend_command(CLI::App& program) {
  auto flags = std::make_shared<AscendFlags>();
  auto command = std::make_unique<Command>(
      program, "ascend",
      "From the Moon's surface to the Lunar Gateway's orbit, by optimal control.");
  command->group("What to solve");
  constexpr int most = 100;
  command
      ->option("--problem", flags->problems, "LIST",
               "tracking: problem (25) of the PHODCOS paper, as published; figure: the setting of "
               "its figure, which does not arrive; energy: with gravity, least energy in a given "
               "time; time: with gravity, least time (default tracking,energy)")
      .list(1, most);
  command
      ->option("--start", flags->starts, "LIST",
               "places on the surface: +z (north pole), -z, +x, -x, -y, +y, or all (default); one "
               "that begins with a minus sign as --start=-z")
      .list(1, most);
  command->group("With gravity");
  PoweredOptions& powered = flags->options.powered;
  command->option("--duration", powered.duration_s, "SECONDS",
                  "of energy; where time starts its search (default 5400)");
  command->option("--thrust", powered.thrust_limit_m_s2, "A", "most thrust, m/s2 (default 5)");
  command->option("--surface-km", powered.surface_km, "R",
                  "radius of the surface (default 1740, as published; the mean is 1737.4)");
  command->option("--margin-km", powered.margin_km, "H",
                  "kept above the surface at the nodes (default 0.2)");
  command
      ->option("--coordinates", flags->coordinates, "NAME",
               "what it is solved in: rectangular (default), or path: progress along the orbit and "
               "offset from it")
      .one_of(ascent_coordinates);
  command->group("As published");
  command->option("--singular-deg", flags->singular_degrees, "A",
                  "the gimbal angle theta at the starts -y and +y, where it has no effect on the "
                  "direction (default 45)");
  command->group("How");
  command->option("--intervals", flags->intervals, "N", "of constant control (default 100)")
      .whole_number(2, 100000);
  command->option("--guesses", flags->guesses, "N", "initial guesses tried, the best kept (4)")
      .whole_number(1, 1000);
  command
      ->option("--most-iterations", flags->most_iterations, "N",
               "for each guess (default 100 as published, 300 with gravity)")
      .whole_number(1, 1000000);
  command->group("Output");
  command->option("--report", flags->report, "FILE",
                  "HTML report with pictures (default ascent.html; with several problems "
                  "ascent-energy.html and so on; 'none': no report)");
  command->option("--csv", flags->table, "FILE", "a row for every node, as CSV");
  command->option("-o,--out", flags->document, "FILE",
                  "everything, as JSON ('-': standard output)");
  command->flag("--json", flags->as_json, "everything as JSON instead of the table");
  command->examples({"hodograph ascend",
                     "hodograph ascend --problem time --start +z,+y --csv nodes.csv",
                     "hodograph ascend --problem energy --start=-z --duration 7200 --json",
                     "hodograph ascend --problem figure --guesses 1 --report figure.html"});
  command->note(
      "The published problem has no gravity, and nothing keeps it out of the Moon. "
      "docs/control.md\n"
      "says what is solved, how, and what is known of the answers. Ctrl-C stops between two\n"
      "iterations and writes nothing.");
  command->run([flags] { run(*flags); });
  return command;
}

#else

std::unique_ptr<Command> ascend_command(CLI::App& program) {
  return command_left_out(program, "ascend", "Ipopt");
}

#endif

}  // namespace hodograph::cli
