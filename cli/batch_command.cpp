// SPDX-License-Identifier: MIT
// hodograph batch: requests as JSON Lines in, results as JSON Lines out.
#include <algorithm>
#include <memory>

#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/requests/batch.hpp"

namespace hodograph::cli {

std::unique_ptr<Command> batch_command(CLI::App& program) {
  struct BatchFlags {
    std::string input = "-", output = "-";
  };
  auto flags = std::make_shared<BatchFlags>();
  auto command = std::make_unique<Command>(
      program, "batch",
      "Answer requests: JSON Lines in, one result a line out, in the same order.");
  command->positional("requests", flags->input, "[FILE]", "the requests (default: standard input)");
  command->option("-o,--out", flags->output, "FILE", "the results (default: standard output)");
  command->examples({"echo '{\"request\": \"orbit\", \"name\": \"gateway\"}' | hodograph batch",
                     "hodograph batch requests.jsonl -o results.jsonl"});
  std::string note = "Requests (docs/requests.md describes each)\n";
  std::size_t column = 0;
  for (const RequestKind& kind : request_kinds()) column = std::max(column, kind.name.size() + 2);
  for (const RequestKind& kind : request_kinds()) {
    note += "  " + std::string(kind.name) + std::string(column - kind.name.size(), ' ') +
            std::string(kind.summary) + "\n";
  }
  command->note(
      note +
      "\nA line that cannot be answered is answered with {\"ok\": false, \"fault\": ...}, and the\n"
      "stream goes on; the exit code is 0 where the stream was read to its end.");
  command->run([flags] { run_batch(flags->input, flags->output); });
  return command;
}

}  // namespace hodograph::cli
