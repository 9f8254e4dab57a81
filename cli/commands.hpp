// SPDX-License-Identifier: MIT
// The subcommands of the program, one a file. Each says what its options are and what it does;
// failures leave as Error and become one line and an exit code in command_line.cpp.
#pragma once

#include <memory>
#include <vector>

#include "cli/command_line.hpp"

namespace hodograph::cli {

std::unique_ptr<Command> fit_command(CLI::App& program);
std::unique_ptr<Command> orbit_command(CLI::App& program);
std::unique_ptr<Command> spline_command(CLI::App& program);
std::unique_ptr<Command> hermite_command(CLI::App& program);
std::unique_ptr<Command> loop_command(CLI::App& program);
std::unique_ptr<Command> climb_command(CLI::App& program);
std::unique_ptr<Command> rational_command(CLI::App& program);
std::unique_ptr<Command> rational_hermite_command(CLI::App& program);
std::unique_ptr<Command> ascend_command(CLI::App& program);
std::unique_ptr<Command> frame_command(CLI::App& program);
std::unique_ptr<Command> corner_command(CLI::App& program);
std::unique_ptr<Command> plan_command(CLI::App& program);
std::unique_ptr<Command> swarm_command(CLI::App& program);
std::unique_ptr<Command> separation_command(CLI::App& program);
std::unique_ptr<Command> offset_command(CLI::App& program);
std::unique_ptr<Command> sweep_command(CLI::App& program);
std::unique_ptr<Command> follow_command(CLI::App& program);
std::unique_ptr<Command> codegen_command(CLI::App& program);
std::unique_ptr<Command> sample_command(CLI::App& program);
std::unique_ptr<Command> inspect_command(CLI::App& program);
std::unique_ptr<Command> check_command(CLI::App& program);
std::unique_ptr<Command> plot_command(CLI::App& program);
std::unique_ptr<Command> batch_command(CLI::App& program);
std::unique_ptr<Command> version_command(CLI::App& program);

}  // namespace hodograph::cli
