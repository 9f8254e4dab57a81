// SPDX-License-Identifier: MIT
#include "cli/left_out.hpp"

#include "hodograph/foundation/result.hpp"

namespace hodograph::cli {

std::unique_ptr<Command> command_left_out(CLI::App& program, const std::string& name,
                                          const std::string& library) {
  auto command = std::make_unique<Command>(
      program, name, "Not in this program: it was built without " + library + ".");
  command->examples({"hodograph " + name + " --help"});
  command->run([name, library] {
    throw Error(Fault{FaultCode::unsupported,
                      "this program was built without " + library + " and offers no '" + name + "'",
                      std::nullopt, "command", std::nullopt, std::nullopt});
  });
  return command;
}

}  // namespace hodograph::cli
