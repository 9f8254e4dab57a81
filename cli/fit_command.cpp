// SPDX-License-Identifier: MIT
// hodograph fit: samples or a formula as a path.
#include <memory>

#include "cli/commands.hpp"
#include "cli/options.hpp"
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

[[noreturn]] void refuse(const std::string& sentence, const char* quantity) {
  throw Error(Fault{FaultCode::malformed_document, sentence, std::nullopt, quantity, std::nullopt,
                    std::nullopt});
}

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
  const std::string name = flags.samples == "-" ? "standard input" : flags.samples;
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

void add_fit(CLI::App& program) {
  auto flags = std::make_shared<FitCommandFlags>();
  CLI::App* const command = program.add_subcommand(
      "fit", "Fit samples of a curve, or a curve given by a formula, to a tolerance.");
  command->footer(
      example({"hodograph fit --formula \"1.5*sin(7.2*t), cos(9*t), exp(cos(1.8*t))\" -t 1e-6 -o "
               "curve.json",
               "hodograph fit track.csv --tolerance 0.01 -o track.json --report track.html",
               "generate | hodograph fit - -t 1e-6 -o - | hodograph sample - --count 100"}) +
      "\n\nSamples are joined by a spline of degree 5 (C4), whose error is certified; so is that "
      "of\n"
      "a formula. Formulas know + - * / ^, pi, e, t, sqrt exp log sin cos tan asin acos atan "
      "atan2\n"
      "sinh cosh tanh abs; \"x, y\" stands for z = 0.");
  auto* const samples =
      command
          ->add_option(
              "samples", flags->samples,
              "CSV file of a parameter and two or three coordinates a row ('-': standard input)")
          ->type_name("FILE");
  auto* const formula = command->add_option("--formula", flags->formula, "\"x(t), y(t), z(t)\"")
                            ->type_name("TEXT")
                            ->excludes(samples)
                            ->group("Formula");
  command->add_option("--from", flags->begin, "first t (default 0)")
      ->type_name("T")
      ->needs(formula)
      ->group("Formula");
  command->add_option("--to", flags->end, "last t (default 1)")
      ->type_name("T")
      ->needs(formula)
      ->group("Formula");
  command
      ->add_flag("--closed", flags->fit.closed,
                 "the curve returns to its start with its derivatives")
      ->needs(formula)
      ->group("Formula");
  command
      ->add_flag("--periodic", flags->periodic,
                 "the last sample repeats the first, one period later")
      ->excludes(formula)
      ->group("Samples");
  command->add_option("--degree", flags->degree, "of the spline: 5 (default) or 7")
      ->type_name("P")
      ->check(CLI::IsMember({5, 7}))
      ->group("Samples");
  command
      ->add_option("--parameter", flags->parameter_column,
                   "column of the parameter, by name or number (default: the first)")
      ->type_name("COLUMN")
      ->group("Samples");
  command
      ->add_option("--columns", flags->point_columns,
                   "columns of the coordinates (default: x, y, z, or those after the parameter)")
      ->type_name("A,B,C")
      ->delimiter(',')
      ->expected(2, 3)
      ->group("Samples");
  flags->fit.add_to(*command, "largest position error, in units of length");
  flags->output.add_to(*command, "the path document (default path.json; '-': standard output)",
                       "an HTML report with pictures");
  command->callback([flags] { run(*flags); });
}

}  // namespace hodograph::cli
