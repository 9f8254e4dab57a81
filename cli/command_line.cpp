// SPDX-License-Identifier: MIT
// Exit codes: 0 done, 2 bad input (also a wrong command line), 3 a request without a solution, 1
// anything else.
#include "cli/command_line.hpp"

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <new>
#include <utility>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "hodograph/foundation/fault.hpp"
#include "hodograph/foundation/version.hpp"

namespace hodograph::cli {
namespace {

constexpr std::size_t page_width = 100;  // characters
constexpr std::size_t help_column = 30;  // where the explanation of an option begins

enum ExitCode : int { done = 0, other = 1, bad_input = 2, no_solution = 3 };

/// `left`, then `text` in a column of its own, broken into lines.
std::string entry(const std::string& left, std::string_view text, std::size_t column) {
  std::string out = "  " + left;
  if (out.size() + 2 > column) {
    out += '\n' + std::string(column, ' ');
  } else {
    out.resize(column, ' ');
  }
  std::size_t used = column;
  bool first = true;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (!first && used + 1 + end > page_width) {
      out += '\n' + std::string(column, ' ');
      used = column;
    } else if (!first) {
      out += ' ';
      ++used;
    }
    out += text.substr(0, end);
    used += end;
    first = false;
    text.remove_prefix(std::min(text.size(), end + 1));
  }
  return out + '\n';
}

int fail(const std::string& sentence, ExitCode exit) {
  std::cerr << "hodograph: " << on_one_line(sentence) << '\n';
  return exit;
}

int fail(const Fault& fault) {
  const int exit = fail(fault.sentence, fault.code == FaultCode::cancelled ? other
                                        : is_no_solution(fault.code)       ? no_solution
                                                                           : bad_input);
  if (fault.quantity == "formula" && fault.index) show_place(*fault.index);
  if (fault.quantity == "text") show_remembered_place();
  return exit;
}

using Commands = std::vector<std::unique_ptr<Command>>;

std::string program_help(const CLI::App& program) {
  std::string text =
      "Pythagorean-hodograph paths: curves with an exact arc length and an exact moving frame.\n\n"
      "Usage: hodograph COMMAND [arguments]\n\nCommands\n";
  constexpr std::size_t column = 14;
  for (const CLI::App* const command :
       program.get_subcommands([](const CLI::App*) { return true; })) {
    text += entry(command->get_name(), command->get_description(), column);
  }
  text +=
      "\nOptions\n" +
      entry("-h,--help", "print this help; hodograph COMMAND --help prints that of a command", 15) +
      entry("--version", "print the version", 15);
  return text +
         "\nExample\n  hodograph orbit\n\n"
         "This fits the Lunar Gateway's orbit and writes the path and a report. A file name '-' "
         "is\n"
         "standard input or output. Exit codes: 2 bad input, 3 no solution, 1 anything else.\n";
}

/// The subcommands, as a list in a sentence.
std::string command_names(const CLI::App& program) {
  const auto all = program.get_subcommands([](const CLI::App*) { return true; });
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < all.size() ? ", " : " and ") + all[i]->get_name();
  }
  return text;
}

/// The subcommand that was named on the command line, for hints.
std::string called(const CLI::App& program) {
  const auto chosen = program.get_subcommands();
  return chosen.empty() ? "hodograph" : "hodograph " + chosen.front()->get_name();
}

}  // namespace

Option& Option::required() {
  option_->required();
  return *this;
}
Option& Option::one_of(const std::vector<std::string>& words) {
  option_->check(CLI::IsMember(words));
  return *this;
}
Option& Option::whole_number(std::size_t least, std::size_t most) {
  option_->check(CLI::Range(least, most));
  return *this;
}
Option& Option::list(int fewest, int most) {
  option_->delimiter(',')->expected(fewest, most);
  return *this;
}
Option& Option::needs(const Option& other) {
  option_->needs(other.option_);
  return *this;
}
Option& Option::excludes(const Option& other) {
  option_->excludes(other.option_);
  return *this;
}
bool Option::given() const { return option_->count() > 0; }

Command::Command(CLI::App& program, const std::string& name, const std::string& sentence)
    : app_(program.add_subcommand(name, sentence)), name_(name), sentence_(sentence) {
  app_->formatter_fn(
      [this](const CLI::App*, const std::string&, CLI::AppFormatMode) { return help(); });
}

CLI::Option* Command::add(const std::string& names, std::string& target) {
  return app_->add_option(names, target);
}
namespace {

/// CLI11 reads nothing as 0.
std::string said_something(const std::string& word) {
  return word.empty() ? "a number is missing" : "";
}

}  // namespace

CLI::Option* Command::add(const std::string& names, double& target) {
  return app_->add_option(names, target)->check(said_something);
}
CLI::Option* Command::add(const std::string& names, std::size_t& target) {
  return app_->add_option(names, target)->check(said_something);
}
CLI::Option* Command::add(const std::string& names, std::vector<double>& target) {
  return app_->add_option(names, target)->check(said_something);
}
CLI::Option* Command::add(const std::string& names, std::vector<std::string>& target) {
  return app_->add_option(names, target);
}

Option Command::flag(const std::string& names, bool& target, const std::string& help) {
  enter(names, "", help);
  return Option(app_->add_flag(names, target));
}

void Command::enter(const std::string& names, const std::string& shown, const std::string& help) {
  if (groups_.empty()) group("Options");
  std::string left;
  for (const char c : names) left += c == ',' ? std::string(", ") : std::string(1, c);
  groups_.back().entries.push_back({shown.empty() ? left : left + " " + shown, help});
}

void Command::run(std::function<void()> what) { app_->callback(std::move(what)); }

std::string Command::help() const {
  std::string text = sentence_ + "\n\nUsage: hodograph " + name_;
  for (const Entry& one : positionals_) text += " " + one.left;
  text += " [options]\n";
  if (!positionals_.empty()) text += '\n';
  for (const Entry& one : positionals_) text += entry(one.left, one.help, help_column);
  for (const Group& one : groups_) {
    text += '\n' + one.heading + '\n';
    for (const Entry& option : one.entries) text += entry(option.left, option.help, help_column);
  }
  text +=
      (groups_.empty() ? "\nOptions\n" : "") + entry("-h, --help", "print this help", help_column);
  text += examples_.size() == 1 ? "\nExample\n" : "\nExamples\n";
  for (const std::string& line : examples_) text += "  " + line + "\n";
  if (!note_.empty()) text += '\n' + note_ + '\n';
  return text;
}

int run_program(int count, const char* const* arguments) {
  CLI::App program("", "hodograph");
  program.set_version_flag("--version", std::string("hodograph ") + version);
  program.require_subcommand(1);
  program.formatter_fn([](const CLI::App* app, const std::string&, CLI::AppFormatMode) {
    return program_help(*app);
  });
  Commands commands;
  for (auto* const make : {fit_command,        orbit_command,
                           ascend_command,     spline_command,
                           hermite_command,    corner_command,
                           loop_command,       climb_command,
                           rational_command,   rational_hermite_command,
                           plan_command,       swarm_command,
                           separation_command, offset_command,
                           frame_command,      sweep_command,
                           follow_command,     codegen_command,
                           sample_command,     inspect_command,
                           check_command,      plot_command,
                           batch_command,      version_command}) {
    commands.push_back(make(program));
  }
  try {
    program.parse(count, arguments);
    return done;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version
    if (program.get_subcommands().empty() && error.get_name() == "RequiredError") {
      const bool named = count > 1 && arguments[1][0] != '-';
      return fail(std::string(named ? arguments[1] : "nothing") + " is no command; there are " +
                      command_names(program) + " (see hodograph --help)",
                  bad_input);
    }
    return fail(std::string(error.what()) + " (see " + called(program) + " --help)", bad_input);
  } catch (const Error& error) {
    return fail(error.fault());
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory for this", other);
  } catch (const std::exception& error) {
    return fail(error.what(), other);
  }
}

}  // namespace hodograph::cli
