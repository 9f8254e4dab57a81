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
#ifdef HODOGRAPH_HAS_ORBIT
  text += ", orbit";
#endif
#ifdef HODOGRAPH_HAS_CERTIFY
  text += ", certify";
#endif
  return text + "\nreads and writes " + std::string(document_format) + " documents, version " +
         std::to_string(document_version) + "\n";
}

}  // namespace

void add_version(CLI::App& program) {
  CLI::App* const command =
      program.add_subcommand("version", "Print the version and the components that are built in.");
  command->footer("Example:\n  hodograph version");
  command->callback([] { print(version_text()); });
}

}  // namespace hodograph::cli
