// SPDX-License-Identifier: MIT
#include "cli/made_path.hpp"

#include <array>
#include <cstdio>

#include "cli/fitting.hpp"
#include "hodograph/foundation/version.hpp"

namespace hodograph::cli {

MadePath made_path(AnyPath path, const std::string& source, const std::string& method,
                   const std::string& choice) {
  MadePath made{PathDocument{std::move(path)}, {}};
  made.document.provenance.program = std::string("hodograph ") + version;
  made.document.provenance.source = source;
  made.document.provenance.method = method;
  made.document.provenance.choice = choice;
  made.facts = facts_of(made.document.path);
  made.document.promises = promises_of(made.facts);
  return made;
}

void write_made_path(const MadePath& made, const OutputFlags& output,
                     const std::vector<std::pair<std::string, std::string>>& more) {
  ReportData report =
      report_of(made.document, made.facts, output.document == "-" ? "" : output.document);
  report.more.insert(report.more.end(), more.begin(), more.end());
  write_files(made.document, report, output);
}

std::string to_six_digits(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

}  // namespace hodograph::cli
