// SPDX-License-Identifier: MIT
// hodograph fit: samples or a formula as a path.
#include <memory>

#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/refuse.hpp"
#include "cli/terminal.hpp"
#include "hodograph/io/file.hpp"
#include "hodograph/io/table.hpp"

namespace hodograph::cli {
namespace {

struct FitCommandFlags {
  std::string samples, formula;
  double begin = 0.0, end = 1.0;
  bool periodic = false;
  std::size_t degree = 5;
  std::string parameter_column;
  std::vector<std::string> point_columns;
  FitFlags fit;
  OutputFlags output;
};

Source source_of(const FitCommandFlags& flags) {
  if (!flags.formula.empty()) {
    remember_formula(flags.formula);
    return FormulaSource{flags.formula, flags.begin, flags.end};
  }
  if (flags.samples.empty()) {
    refuse(
        "give the samples to fit (a CSV file), or a curve with --formula (see hodograph fit "
        "--help)",
        "samples");
  }
  const std::string name = input_name(flags.samples);
  const Table table = read_table(read_file(flags.samples).value(), name).value();
  SampleColumns columns{flags.parameter_column, flags.point_columns};
  return SampleSource{curve_samples(table, columns, name).value(), name, flags.degree,
                      flags.periodic};
}

void run(FitCommandFlags flags) {
  if (flags.fit.tolerance == 0.0 && flags.fit.segments == 0) {
    refuse("say how exact the path should be: --tolerance LENGTH, or --segments N", "tolerance");
  }
  if (flags.output.document.empty()) flags.output.document = "path.json";
  fit_and_write(source_of(flags), flags.fit, flags.output, "fitting");
}

}  // namespace

std::unique_ptr<Command> fit_command(CLI::App& program) {
  auto flags = std::make_shared<FitCommandFlags>();
  auto command = std::make_unique<Command>(
      program, "fit", "Fit samples of a curve, or a curve given by a formula, to a tolerance.");
  Option samples = command->positional(
      "samples", flags->samples, "[FILE]",
      "CSV file of a parameter and two or three coordinates a row ('-': standard input)");
  command->group("Formula");
  Option formula = command->option("--formula", flags->formula, "TEXT",
                                   "\"x(t), y(t), z(t)\", instead of a file");
  formula.excludes(samples);
  command->option("--from", flags->begin, "T", "first t (default 0)").needs(formula);
  command->option("--to", flags->end, "T", "last t (default 1)").needs(formula);
  command
      ->flag("--closed", flags->fit.closed, "the curve returns to its start with its derivatives")
      .needs(formula);
  command->group("Samples");
  command
      ->flag("--periodic", flags->periodic, "the last sample repeats the first, one period later")
      .excludes(formula);
  command->option("--degree", flags->degree, "P", "of the spline: 5 (default) or 7");
  command->option("--parameter", flags->parameter_column, "COLUMN",
                  "column of the parameter, by name or number (default: the first)");
  command
      ->option("--columns", flags->point_columns, "A,B[,C]",
               "columns of the coordinates (default: x, y, z, or those after the parameter)")
      .list(2, 3);
  flags->fit.add_to(*command, "largest position error, in units of length");
  flags->output.add_to(*command, "the path document (default path.json; '-': standard output)",
                       "an HTML report with pictures");
  command->examples(
      {"hodograph fit --formula \"1.5*sin(7.2*t), cos(9*t), exp(cos(1.8*t))\" -t 1e-6",
       "hodograph fit track.csv --tolerance 0.01 -o track.json --report track.html",
       "generate | hodograph fit - -t 0.01 -o - | hodograph sample - --count 100"});
  command->note(
      "Samples are joined by a spline (C4), and the error against it is certified; so is the "
      "error\n"
      "against a formula. Formulas know + - * / ^, pi, e, t, sqrt exp log sin cos tan asin acos "
      "atan\n"
      "atan2 sinh cosh tanh abs; \"x, y\" stands for z = 0.");
  command->run([flags] { run(*flags); });
  return command;
}

}  // namespace hodograph::cli
