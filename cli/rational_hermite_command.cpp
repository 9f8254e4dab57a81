// SPDX-License-Identifier: MIT
// hodograph rational-hermite: a curve without cusps between two points with given tangents.
#include "cli/commands.hpp"
#include "cli/left_out.hpp"

#ifdef HODOGRAPH_HAS_RATIONAL
#include <algorithm>
#include <array>
#include <cstdio>

#include "cli/rational_hermites.hpp"
#include "cli/rational_input.hpp"
#include "cli/terminal.hpp"
#include "hodograph/io/file.hpp"
#endif

namespace hodograph::cli {

#ifdef HODOGRAPH_HAS_RATIONAL
namespace {

struct RationalHermiteFlags {
  std::vector<std::string> input;
  std::size_t least_power = 0, most_power = 0, largest_degree = 0;
  std::size_t rounds = default_rounds, direction_bits = default_direction_bits;
  std::string output = "-", picture, nurbs, path;
  bool json = false;
};

RationalHermiteProblem problem_of(const RationalHermiteFlags& flags) {
  RationalHermiteProblem problem;
  problem.least_power = flags.least_power;
  problem.most_power = std::max(flags.least_power, flags.most_power);
  if (flags.largest_degree > 0) problem.largest_degree = flags.largest_degree;
  problem.limits.most_rounds = flags.rounds;
  problem.direction_bits = static_cast<long>(std::min<std::size_t>(flags.direction_bits, 1'000));
  read_rational_input(flags.input, {[&](std::string_view text) { define(problem, text); },
                                    [&](Members& members) { define(problem, members); }});
  return problem;
}

void run(const RationalHermiteFlags& flags) {
  if (flags.input.empty()) {
    throw Error(Fault{FaultCode::malformed_document,
                      "there is no input; right would be such as hodograph rational-hermite "
                      "\"P1 = (2, 9/4, 2); T0 = i; T1 = i + 2j + 2k\" (see --help)",
                      std::nullopt, "input", std::nullopt, std::nullopt});
  }
  const std::array<const std::string*, 4> names = {&flags.output, &flags.picture, &flags.nurbs,
                                                   &flags.path};
  if (std::count_if(names.begin(), names.end(), [](const auto* name) { return *name == "-"; }) >
      1) {
    throw Error(Fault{FaultCode::malformed_document,
                      "only one file goes to standard output; name the others, the answer by --out",
                      std::nullopt, "out", std::nullopt, std::nullopt});
  }
  const RationalHermiteAnswer answer = answer_of(problem_of(flags));
  // All texts first: what fails leaves no file.
  std::vector<std::pair<std::string, std::string>> files(1);
  if (flags.json) {
    append_json(files[0].second, json_of(answer));
    files[0].second += "\n";
  } else {
    files[0].second = text_of(answer);
  }
  files[0].first = flags.output;
  if (answer.curve) {
    const double begin = answer.data.begin.to_double(), end = answer.data.end.to_double();
    if (!flags.picture.empty()) {
      files.emplace_back(flags.picture,
                         to_svg(rational_pictures(*answer.curve, std::pair(begin, end)), 2));
    }
    if (!flags.nurbs.empty()) {
      std::string text;
      append_json(text, nurbs_of(*answer.curve, begin, end));
      files.emplace_back(flags.nurbs, text + "\n");
    }
    if (!flags.path.empty()) {
      const MadePath made = path_of(*answer.curve, begin, end, answer.sentence);
      files.emplace_back(flags.path, to_json(made.document));
    }
  }
  std::string note;
  bool taken = false;
  for (const auto& [name, content] : files) {
    if (const auto fault = write_file(name, content)) throw Error(*fault);
    taken = taken || name == "-";
    if (name != "-") note += "wrote " + name + "\n";
  }
  if (taken) {
    std::fputs(note.c_str(), stderr);
  } else {
    print(note);
  }
  if (!answer.curve) {  // the proof is written; the status says that there is no curve
    throw Error(Fault{FaultCode::no_interpolant, answer.sentence, std::nullopt, "curve",
                      std::nullopt, std::nullopt});
  }
}

}  // namespace

std::unique_ptr<Command> rational_hermite_command(CLI::App& program) {
  auto command = std::make_unique<Command>(
      program, "rational-hermite",
      "A rational PH curve without cusps between two points with given tangents, or a proof that "
      "there is none.");
  auto flags = std::make_shared<RationalHermiteFlags>();
  command->positional(
      "input", flags->input, "[TEXT or FILE]...",
      "definitions such as \"P1 = (2, 9/4, 2)\" and \"T0 = i\", files of them or of "
      "JSON ('-': standard input)");
  command->group("The search, where the input gives no degree");
  command->option("--least-power", flags->least_power, "K",
                  "alpha = base^K and higher (default 0)");
  command->option("--most-power", flags->most_power, "L", "up to alpha = base^L (default: K)");
  command->option("--largest-degree", flags->largest_degree, "D",
                  "look up to deg B = D (default: 16 and the degree of alpha)");
  command->option("--rounds", flags->rounds, "N", "linear programs for each space (default 48)");
  command->option("--direction-bits", flags->direction_bits, "B",
                  "replace directions of irrational length within 2^-B rad (default 30)");
  command->group("The answer");
  command->flag("--json", flags->json, "as one line of JSON, all numbers exact");
  command->option("-o,--out", flags->output, "FILE", "where it goes (default: standard output)");
  command->option("--svg", flags->picture, "FILE", "three views of the curve and its speed");
  command->option("--nurbs", flags->nurbs, "FILE",
                  "JSON: rational Bezier pieces and one NURBS curve");
  command->option("--path", flags->path, "FILE", "a polynomial curve as a path document");
  command->examples({
      "hodograph rational-hermite \"P1 = (2, 9/4, 2); T0 = i; T1 = i + 2j + 2k\"",
      "hodograph rational-hermite \"P1 = (2, 9/4, 2); v0 = 3i; v1 = i + 2j + 2k; base = t + 1\" "
      "--least-power 3 --most-power 8 --json",
      "hodograph rational-hermite \"A = i + (i + 3/2 j + 1/2 k - 1)t; P1 = (2, 2, 3/2)\" "
      "\"alpha = (t+1)^5; degree = 12\" --svg curve.svg --nurbs curve.json",
  });
  command->note(
      "P0 (default: the origin) and P1 are the end points, T0 and T1 directions of tangents, or\n"
      "v0 and v1 derivatives there; begin and end the parameters (default 0 and 1). A is chosen\n"
      "unless given. alpha and degree name one space of curves r = -2 B/alpha; without a degree\n"
      "the smallest space with a curve is looked for, of all powers of base. The exit status is 3\n"
      "where there is no curve; the proof is printed. See docs/rational.md.");
  command->run([flags] { run(*flags); });
  return command;
}

#else

std::unique_ptr<Command> rational_hermite_command(CLI::App& program) {
  return command_left_out(program, "rational-hermite", "FLINT or Clp");
}

#endif

}  // namespace hodograph::cli
