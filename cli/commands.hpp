// SPDX-License-Identifier: MIT
// The subcommands of the program, one a file. Each registers its options and, as its callback, what
// it does; failures leave as Error and become one line and an exit code in main.cpp.
#pragma once

#include <CLI/CLI.hpp>

namespace hodograph::cli {

void add_fit(CLI::App& program);
void add_orbit(CLI::App& program);
void add_sample(CLI::App& program);
void add_inspect(CLI::App& program);
void add_check(CLI::App& program);
void add_plot(CLI::App& program);
void add_batch(CLI::App& program);
void add_version(CLI::App& program);

/// What goes wrong outside of any construction, as the program's exit code; see main.cpp.
enum class ExitCode { done = 0, other = 1, bad_input = 2, no_solution = 3 };

}  // namespace hodograph::cli
