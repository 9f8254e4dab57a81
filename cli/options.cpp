// SPDX-License-Identifier: MIT
#include "cli/options.hpp"

#include <cstdio>

#include "cli/fitting.hpp"
#include "cli/terminal.hpp"
#include "hodograph/frame/holonomy.hpp"
#include "hodograph/io/file.hpp"
#include "hodograph/io/report.hpp"

namespace hodograph::cli {
namespace {

void require_written(const std::optional<Fault>& fault) {
  if (fault) throw Error(*fault);
}

void require_two_files(const OutputFlags& output) {
  if (output.report != output.document) return;
  throw Error(Fault{FaultCode::malformed_document,
                    "the path document and the report cannot both go to " +
                        (output.report == "-" ? "standard output" : "'" + output.report + "'") +
                        "; name two files",
                    std::nullopt, "report", std::nullopt, std::nullopt});
}

/// Gives the document the roll that makes the frame of a closed path periodic.
void distribute_roll(PathDocument& document) {
  document.roll = document.path.visit([](const auto& path) -> std::optional<LinearRoll<double>> {
    if constexpr (std::remove_cvref_t<decltype(path)>::Point::dimension == 3) {
      return closing_roll(path).value();
    } else {
      return std::nullopt;
    }
  });
}

}  // namespace

std::string input_name(const std::string& file) { return file == "-" ? "standard input" : file; }

void add_document_to(Command& command, std::string& document) {
  command.positional("document", document, "FILE", "the path document ('-': standard input)")
      .required();
}

void FitFlags::add_to(Command& command, const std::string& tolerance_help) {
  command.group("Fitting");
  command.option("-t,--tolerance", tolerance, "LENGTH", tolerance_help);
  command
      .option("--segments", segments, "N",
              "a fixed number of uniform segments, instead of a tolerance")
      .whole_number(1, FitOptions{}.most_segments);
  command
      .option("--choice", choice, "CHOICE",
              "the interpolants: order-ten (default), or order-six as PHODCOS has them")
      .one_of({"order-ten", "order-six"});
  command
      .option("--knots", knots, "WAY",
              "where knots go: adaptive (default), or uniform, the fewest that do")
      .one_of({"adaptive", "uniform"});
  command.option("--most-segments", most_segments, "N",
                 "give up beyond this number (default 200000)");
  command.flag("--distribute-roll", distribute_roll,
               "closed paths: spread the roll that is left over after one round, so that the frame "
               "closes");
}

FitOptions FitFlags::options() const {
  FitOptions options;
  options.tolerance = tolerance;
  options.segments = segments;
  options.most_segments = most_segments;
  options.closed = closed;
  options.choice = choice == "order-six" ? HermiteChoice::order_six : HermiteChoice::order_ten;
  options.knots = knots == "uniform" ? FitKnots::uniform : FitKnots::adaptive;
  return options;
}

void OutputFlags::add_to(Command& command, const std::string& document_help,
                         const std::string& report_help) {
  command.group("Files");
  command.option("-o,--out", document, "FILE", document_help);
  command.option("--report", report, "FILE", report_help);
}

void write_files(const PathDocument& document, const ReportData& report,
                 const OutputFlags& output) {
  require_two_files(output);
  auto document_file = OutputFile::create(output.document).value();
  std::optional<OutputFile> report_file;
  if (!output.report.empty()) report_file = OutputFile::create(output.report).value();
  document_file.write(to_json(document));
  require_written(document_file.commit());
  if (report_file) {
    report_file->write(report_html(report));
    require_written(report_file->commit());
  }
  std::string text = report_text(report);
  if (output.document != "-") text += "wrote " + output.document + "\n";
  if (report_file && output.report != "-") text += "wrote " + output.report + "\n";
  if (output.document == "-" || output.report == "-") {
    std::fputs(text.c_str(), stderr);
  } else {
    print(text);
  }
}

void fit_and_write(const Source& source, const FitFlags& flags, const OutputFlags& output,
                   const std::string& verb) {
  require_two_files(output);
  // The names are tried before the work: one that cannot be written costs no time.
  static_cast<void>(OutputFile::create(output.document).value());
  if (!output.report.empty()) static_cast<void>(OutputFile::create(output.report).value());

  FitOptions options = flags.options();
  FittedPath fit = [&] {
    Progress progress(verb);
    options.progress = std::ref(progress);
    return fitted(source, options).value();
  }();
  if (flags.distribute_roll) distribute_roll(fit.document);
  write_files(fit.document, report_of(fit, output.document == "-" ? "" : output.document), output);
}

}  // namespace hodograph::cli
