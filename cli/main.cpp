// SPDX-License-Identifier: MIT
// hodograph: the program. Exit codes: 0 done, 2 bad input (also a wrong command line), 3 a request
// without a solution, 1 anything else. A failure is one line on standard error.
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "hodograph/foundation/fault.hpp"
#include "hodograph/foundation/version.hpp"

namespace hodograph::cli {
namespace {

int code(ExitCode exit) { return static_cast<int>(exit); }

int fail(const std::string& sentence, ExitCode exit) {
  std::cerr << "hodograph: " << on_one_line(sentence) << '\n';
  return code(exit);
}

int fail(const Fault& fault) {
  const int exit = fail(fault.sentence,
                        is_no_solution(fault.code) ? ExitCode::no_solution : ExitCode::bad_input);
  if (fault.quantity == "formula" && fault.index) show_place(*fault.index);
  return exit;
}

void describe_program(CLI::App& program) {
  program.description(
      "Pythagorean-hodograph paths: curves with an exact arc length and an exact moving frame.");
  program.footer(
      "Example:\n"
      "  hodograph orbit                 fit the Lunar Gateway's orbit, write a report\n\n"
      "Every subcommand explains itself: hodograph fit --help. A file name '-' is standard input "
      "or\n"
      "output. Exit codes: 2 bad input, 3 no solution, 1 anything else.");
  program.set_version_flag("--version", std::string("hodograph ") + version);
  program.require_subcommand(1);
  program.get_formatter()->column_width(34);
  program.failure_message(CLI::FailureMessage::simple);
}

/// The subcommand that was named on the command line, for hints.
std::string called(const CLI::App& program) {
  const auto chosen = program.get_subcommands();
  return chosen.empty() ? "hodograph" : "hodograph " + chosen.front()->get_name();
}

int run(int count, const char* const* arguments) {
  CLI::App program;
  program.name("hodograph");
  describe_program(program);
  add_fit(program);
  add_orbit(program);
  add_sample(program);
  add_inspect(program);
  add_check(program);
  add_plot(program);
  add_batch(program);
  add_version(program);
  try {
    program.parse(count, arguments);
    return code(ExitCode::done);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version
    return fail(std::string(error.what()) + " (see " + called(program) + " --help)",
                ExitCode::bad_input);
  } catch (const Error& error) {
    return fail(error.fault());
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory for this", ExitCode::other);
  } catch (const std::exception& error) {
    return fail(error.what(), ExitCode::other);
  }
}

}  // namespace
}  // namespace hodograph::cli

int main(int count, char** arguments) { return hodograph::cli::run(count, arguments); }
