// SPDX-License-Identifier: MIT
// hodograph version: what this program is made of.
#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "hodograph/foundation/version.hpp"
#include "hodograph/io/document.hpp"

namespace hodograph::cli {
namespace {

std::string version_text() {
  std::string text = std::string("hodograph ") + version + "\ncomponents: core, io";
#ifdef HODOGRAPH_HAS_SURFACE
  text += ", surface";
#endif
#ifdef HODOGRAPH_HAS_PLANNING
  text += ", planning";
#endif
#ifdef HODOGRAPH_HAS_ORBIT
  text += ", orbit";
#endif
#ifdef HODOGRAPH_HAS_CERTIFY
  text += ", certify";
#endif
#ifdef HODOGRAPH_HAS_RATIONAL
  text += ", rational";
#endif
  return text + "\nreads and writes " + std::string(document_format) + " documents, version " +
         std::to_string(document_version) + "\n";
}

}  // namespace

std::unique_ptr<Command> version_command(CLI::App& program) {
  auto command = std::make_unique<Command>(
      program, "version", "Print the version and the components that are built in.");
  command->examples({"hodograph version"});
  command->run([] { print(version_text()); });
  return command;
}

}  // namespace hodograph::cli
