// SPDX-License-Identifier: MIT
// The options that subcommands share.
#pragma once

#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/source.hpp"
#include "hodograph/construction/fit.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/io/report.hpp"

namespace hodograph::cli {

/// What sentences call an input file: "standard input" for "-".
std::string input_name(const std::string& file);

/// The argument that names the path document to read.
void add_document_to(Command& command, std::string& document);

/// How to fit.
struct FitFlags {
  double tolerance = 0.0;
  std::size_t segments = 0;
  std::size_t most_segments = FitOptions{}.most_segments;
  std::string choice = "order-ten", knots = "adaptive";
  bool closed = false, distribute_roll = false;

  void add_to(Command& command, const std::string& tolerance_help);
  /// Faults as Error: outside_domain where neither a tolerance nor segments make sense.
  FitOptions options() const;
};

/// Where a fit goes.
struct OutputFlags {
  std::string document, report;

  void add_to(Command& command, const std::string& document_help, const std::string& report_help);
};

/// Writes the document and, where a file is named for it, the report; then the short table and the
/// names of the files on standard output (on standard error where a file itself goes to standard
/// output). Throws Error, also where both go to the same file.
void write_files(const PathDocument& document, const ReportData& report, const OutputFlags& output);

/// Fits a source, shows progress on a terminal, and writes as write_files does. Throws Error.
void fit_and_write(const Source& source, const FitFlags& flags, const OutputFlags& output,
                   const std::string& verb);

}  // namespace hodograph::cli
