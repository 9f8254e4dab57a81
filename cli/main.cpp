// SPDX-License-Identifier: MIT
// hodograph: the program.
#include "cli/command_line.hpp"

int main(int count, char** arguments) { return hodograph::cli::run_program(count, arguments); }
