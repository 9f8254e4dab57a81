// SPDX-License-Identifier: MIT
// A run of hodograph batch: reads, has answered, writes, shows progress.
#pragma once

#include <cstddef>
#include <string>

#include "cli/requests/batch_output.hpp"

namespace hodograph::cli {

struct BatchOptions {
  std::string input = "-", output = "-";  ///< "-": standard input and output
  std::size_t jobs = 1;                   ///< threads that answer
  bool resume = false;                    ///< go on where an earlier run was broken off
  bool progress = false;                  ///< show it also where standard error is no terminal
  OnFault on_fault = OnFault::report;
};

/// Answers every line of the input in order; blank lines are passed over. The results do not depend
/// on the number of jobs. Throws Error: malformed_document (the input cannot be read, or is not
/// that of the run to go on with), not_written, cancelled (Ctrl-C: what was begun is finished and
/// written), and with OnFault::stop the first fault.
void run_batch(const BatchOptions& options);

}  // namespace hodograph::cli
