// SPDX-License-Identifier: MIT
// The commands of a component that this program was built without.
#pragma once

#include <memory>
#include <string>

#include "cli/command_line.hpp"

namespace hodograph::cli {

/// A command of this name whose help says that the program was built without `library`, and which
/// refuses to run (Error, unsupported).
std::unique_ptr<Command> command_left_out(CLI::App& program, const std::string& name,
                                          const std::string& library);

}  // namespace hodograph::cli
