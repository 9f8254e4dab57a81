// SPDX-License-Identifier: MIT
// hodograph batch: requests as JSON Lines in, results as JSON Lines out.
#include <memory>

#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/requests/batch.hpp"

namespace hodograph::cli {

void add_batch(CLI::App& program) {
  struct BatchFlags {
    std::string input = "-", output = "-";
  };
  auto flags = std::make_shared<BatchFlags>();
  CLI::App* const command = program.add_subcommand(
      "batch", "Answer requests: JSON Lines in, one result a line out, in the same order.");
  std::string names;
  for (const RequestKind& kind : request_kinds()) {
    names += "\n  " + std::string(kind.name) + std::string(14 - kind.name.size(), ' ') +
             std::string(kind.summary);
  }
  command->footer(
      "Requests (docs/requests.md describes each):" + names + "\n\n" +
      example({"echo '{\"request\": \"orbit\", \"name\": \"gateway\"}' | hodograph batch",
               "hodograph batch requests.jsonl -o results.jsonl"}) +
      "\n\nA line that cannot be answered is answered with {\"ok\": false, \"fault\": ...}, and "
      "the\n"
      "stream goes on; the exit code is 0 if the stream was read to its end.");
  command->add_option("requests", flags->input, "the requests (default: standard input)")
      ->type_name("FILE");
  command->add_option("-o,--out,--output", flags->output, "the results (default: standard output)")
      ->type_name("FILE")
      ->group("Files");
  command->callback([flags] { run_batch(flags->input, flags->output); });
}

}  // namespace hodograph::cli
