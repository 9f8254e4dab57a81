// SPDX-License-Identifier: MIT
// hodograph rational: all rational PH curves with a given indicatrix, denominator and degree.
#include "cli/commands.hpp"
#include "cli/left_out.hpp"

#ifdef HODOGRAPH_HAS_RATIONAL
#include <algorithm>
#include <array>
#include <cstdio>

#include "cli/options.hpp"
#include "cli/rational_input.hpp"
#include "cli/rationals.hpp"
#include "cli/refuse.hpp"
#include "cli/terminal.hpp"
#include "hodograph/io/file.hpp"
#endif

namespace hodograph::cli {

#ifdef HODOGRAPH_HAS_RATIONAL
namespace {

struct RationalFlags {
  std::vector<std::string> input, coefficients;
  std::vector<double> interval;
  std::size_t described = usual_described_curves;
  std::string output = "-", picture, nurbs, dxf, path;
  bool json = false, latex = false, examples = false;
};

RationalProblem problem_of(const RationalFlags& flags) {
  RationalProblem problem;
  problem.described = flags.described;
  read_rational_input(flags.input, {[&](std::string_view text) { define(problem, text); },
                                    [&](Members& members) { define(problem, members); }});
  for (const std::string& text : flags.coefficients) {
    const auto value = parse_expression(text);
    const auto number = value ? real_polynomial(*value, "a coefficient") : value.fault();
    if (!number) refuse("coefficients: " + number.fault().sentence, "coefficients");
    if (!number->is_constant()) refuse("coefficients are numbers; got " + text, "coefficients");
    problem.coefficients.push_back(number->coefficient(0));
  }
  return problem;
}

/// The answers of the paper's examples, each with the curves that the paper prints.
std::string examples_text(const RationalFlags& flags) {
  std::string text;
  Json list = Json::array();
  std::vector<std::pair<std::string, std::string>> sections;
  for (const PaperExample& example : paper_examples()) {
    RationalProblem problem;
    problem.described = flags.described;
    define(problem, example.text);
    const RationalAnswer answer = answer_of(problem);
    Json json = {{"name", example.name}};
    if (flags.json) json.update(json_of(answer));
    std::string section = text_of(answer), latex = latex_of(answer);
    json["printed"] = Json::array();
    for (const auto& [label, r] : example.curves) {
      RationalProblem one = problem;
      one.described = 0;
      define(one, "r = " + std::string(r));
      DescribedCurve curve = *answer_of(one).chosen;
      curve.name = "the paper's " + std::string(label);
      section += text_of(curve);
      latex += latex_of(curve);
      if (flags.json) {
        Json printed = {{"label", label}};
        printed.update(json_of(curve));
        json["printed"].push_back(std::move(printed));
      }
    }
    list.push_back(std::move(json));
    const std::string remark = example.remark;
    text += (text.empty() ? "" : "\n\n") + std::string(example.name) + "\n" +
            std::string(std::string(example.name).size(), '=') + "\n" + section +
            (remark.empty() ? "" : "\n" + remark + "\n");
    sections.emplace_back(example.name, latex);
  }
  if (flags.latex) return latex_document(sections);
  if (!flags.json) return text;
  std::string out;
  append_json(out, {{"examples", std::move(list)}});
  return out + "\n";
}

void run(const RationalFlags& flags) {
  if (flags.json && flags.latex) refuse("--json and --latex exclude each other", "latex");
  if (flags.examples) {
    if (!flags.input.empty()) refuse("--examples takes no other input", "examples");
    if (const auto fault = write_file(flags.output, examples_text(flags))) throw Error(*fault);
    return;
  }
  if (flags.input.empty()) {
    refuse(
        "there is no input; right would be such as hodograph rational \"A = t^2 - (i+j)*t + k\" "
        "\"alpha = t^3\" (see hodograph rational --help)",
        "input");
  }
  const bool wants_interval = !flags.nurbs.empty() || !flags.dxf.empty() || !flags.path.empty();
  if (wants_interval && flags.interval.empty()) {
    refuse("--nurbs, --dxf and --path need --interval A,B", "interval");
  }
  const std::array<const std::string*, 5> names = {&flags.output, &flags.picture, &flags.nurbs,
                                                   &flags.dxf, &flags.path};
  if (std::count_if(names.begin(), names.end(), [](const auto* name) { return *name == "-"; }) >
      1) {
    refuse("only one file goes to standard output; name the others, the answer by --out", "out");
  }
  const RationalAnswer answer = answer_of(problem_of(flags));
  std::optional<std::pair<double, double>> interval;
  if (!flags.interval.empty()) interval = {flags.interval[0], flags.interval[1]};
  // All texts first: what fails leaves no file.
  std::vector<std::pair<std::string, std::string>> files;
  std::optional<DescribedCurve> curve;
  if (wants_interval || !flags.picture.empty()) curve = shown_curve(answer);
  if (!flags.picture.empty()) {
    files.emplace_back(flags.picture, to_svg(rational_pictures(*curve, interval), 2));
  }
  if (!flags.nurbs.empty()) {
    std::string text;
    append_json(text, nurbs_of(*curve, interval->first, interval->second));
    files.emplace_back(flags.nurbs, text + "\n");
  }
  if (!flags.dxf.empty()) {
    files.emplace_back(flags.dxf, dxf_of(*curve, interval->first, interval->second));
  }
  if (!flags.path.empty()) {
    constexpr std::size_t longest_source = 1000;  // characters
    const std::string r = to_text(curve->curve.position());
    const MadePath made = path_of(*curve, interval->first, interval->second,
                                  r.size() <= longest_source ? "r(t) = " + r : curve->name);
    files.emplace_back(flags.path, to_json(made.document));
  }
  std::string text;
  if (flags.json) {
    append_json(text, json_of(answer));
    text += "\n";
  } else if (flags.latex) {
    text = latex_document({{"", latex_of(answer)}});
  } else {
    text = text_of(answer);
  }
  files.emplace_back(flags.output, std::move(text));
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
}

}  // namespace

std::unique_ptr<Command> rational_command(CLI::App& program) {
  auto command = std::make_unique<Command>(
      program, "rational", "Rational PH curves, exactly: all that share an indicatrix A i A*.");
  auto flags = std::make_shared<RationalFlags>();
  command->positional("input", flags->input, "[TEXT or FILE]...",
                      "definitions such as \"A = t^2 - (i+j)*t + k\" and \"alpha = t^3\", files of "
                      "them or of JSON ('-': standard input)");
  command->group("The question");
  command->flag("--examples", flags->examples, "the six examples of the paper, in its order");
  command
      ->option("--curves", flags->described, "N",
               "describe up to N curves of the basis in full (default 8)")
      .whole_number(0, 1000000);
  constexpr int most_coefficients = 1000;
  command
      ->option("--coefficients", flags->coefficients, "C1,C2,...",
               "describe, draw and export this combination of the canonical basis")
      .list(1, most_coefficients);
  command->group("The answer");
  command->flag("--json", flags->json, "as one line of JSON, all numbers exact");
  command->flag("--latex", flags->latex, "as a LaTeX document");
  command->option("-o,--out", flags->output, "FILE", "where it goes (default: standard output)");
  command->group("The curve: r or f of the input, the combination, else the first that moves");
  command->option("--interval", flags->interval, "A,B", "from t = A to t = B").list(2, 2);
  command->option("--svg", flags->picture, "FILE",
                  "three views and the speed, between the poles (default: the whole line)");
  command->option("--nurbs", flags->nurbs, "FILE",
                  "JSON: rational Bezier pieces and one NURBS curve over the interval");
  command->option("--dxf", flags->dxf, "FILE",
                  "a curve in a plane z = constant over the interval as an exact spline for CAD");
  command->option("--path", flags->path, "FILE",
                  "a polynomial curve over the interval as a path document");
  command->examples(
      {"hodograph rational \"A = t^2 - (i+j)*t + k\" \"alpha = t^3\"",
       "hodograph rational \"A = t^2 - (i+j)*t + k; alpha = (t+1)^2; degree = 7\" --json",
       "hodograph rational rational.txt --svg curve.svg --interval 1,4 --nurbs curve.json",
       "hodograph rational --examples --latex -o examples.tex"});
  command->note(
      "A is a quaternion polynomial (units i, j, k), alpha the denominator of r = -2 B/alpha,\n"
      "degree (deg B) how far to look; r = (x, y, z)/q is a curve to be examined, and f the\n"
      "distance function of its osculating planes. Numbers are exact: 3/4, 0.25. See\n"
      "docs/rational.md.");
  command->run([flags] { run(*flags); });
  return command;
}

#else

std::unique_ptr<Command> rational_command(CLI::App& program) {
  return command_left_out(program, "rational", "FLINT");
}

#endif

}  // namespace hodograph::cli
