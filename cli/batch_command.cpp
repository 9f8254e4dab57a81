// SPDX-License-Identifier: MIT
// hodograph batch: requests as JSON Lines in, results as JSON Lines out.
#include <algorithm>
#include <memory>

#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/requests/run_batch.hpp"

namespace hodograph::cli {

std::unique_ptr<Command> batch_command(CLI::App& program) {
  struct BatchFlags {
    BatchOptions options;
    std::string on_fault = "report";
  };
  auto flags = std::make_shared<BatchFlags>();
  BatchOptions& options = flags->options;
  options.jobs = all_cores();
  auto command = std::make_unique<Command>(
      program, "batch",
      "Answer requests: JSON Lines in, one result a line out, in the same order.");
  command->positional("requests", options.input, "[FILE]",
                      "the requests (default: standard input)");
  const Option out =
      command->option("-o,--out", options.output, "FILE", "the results (default: standard output)");
  command
      ->option("-j,--jobs", options.jobs, "N",
               "threads that answer (default: one a core); the results do not depend on it")
      .whole_number(1, most_jobs);
  command
      ->option("--on-fault", flags->on_fault, "WAY",
               "a line that cannot be answered: report (default: its fault is its result), skip "
               "(no result, a line on standard error), or stop")
      .one_of({"report", "skip", "stop"});
  command->flag("--progress", options.progress,
                "show progress also where standard error is no terminal");
  command
      ->flag("--resume", options.resume,
             "go on where a run with the same requests and -o FILE was broken off")
      .needs(out);
  command->examples({"echo '{\"request\": \"orbit\", \"name\": \"gateway\"}' | hodograph batch",
                     "hodograph batch requests.jsonl -o results.jsonl",
                     "hodograph batch requests.jsonl -o results.jsonl --resume"});
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
      "stream goes on; the exit code is 0 where the stream was read to its end. With --on-fault\n"
      "stop it is 2 or 3, as the fault is of bad input or of no solution. Until all is done the\n"
      "results are in FILE.partial, with which --resume goes on after a kill or Ctrl-C.");
  command->run([flags] {
    flags->options.on_fault = flags->on_fault == "skip"   ? OnFault::skip
                              : flags->on_fault == "stop" ? OnFault::stop
                                                          : OnFault::report;
    run_batch(flags->options);
  });
  return command;
}

}  // namespace hodograph::cli
