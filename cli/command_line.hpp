// SPDX-License-Identifier: MIT
// Command lines and their help: a thin layer over CLI11, so that the files of the subcommands need
// not compile it.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace hodograph::cli {

/// One option or positional argument, to add conditions to.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option& required();
  Option& one_of(const std::vector<std::string>& words);
  Option& whole_number(std::size_t least, std::size_t most);
  /// A list with commas between its items.
  Option& list(int fewest, int most);
  Option& needs(const Option& other);
  Option& excludes(const Option& other);
  bool given() const;

 private:
  CLI::Option* option_;
};

/// One subcommand: its options in groups, what its help says, and what it does.
class Command {
 public:
  /// `sentence` is the first line of the help.
  Command(CLI::App& program, const std::string& name, const std::string& sentence);

  /// An argument without a name.
  template <class T>
  Option positional(const std::string& name, T& target, const std::string& shown,
                    const std::string& help) {
    positionals_.push_back({shown, help});
    return Option(add(name, target));
  }
  /// The options that follow stand under this heading.
  void group(const std::string& heading) { groups_.push_back({heading, {}}); }
  /// An option; `names` as "-t,--tolerance", `shown` is what stands for its value in the help.
  template <class T>
  Option option(const std::string& names, T& target, const std::string& shown,
                const std::string& help) {
    enter(names, shown, help);
    return Option(add(names, target));
  }
  Option flag(const std::string& names, bool& target, const std::string& help);
  void examples(const std::vector<std::string>& lines) { examples_ = lines; }
  /// A paragraph at the end of the help, as it stands.
  void note(const std::string& text) { note_ = text; }
  void run(std::function<void()> what);

  /// The help page.
  std::string help() const;

 private:
  struct Entry {
    std::string left, help;
  };
  struct Group {
    std::string heading;
    std::vector<Entry> entries;
  };
  CLI::Option* add(const std::string& names, std::string& target);
  CLI::Option* add(const std::string& names, double& target);
  CLI::Option* add(const std::string& names, std::size_t& target);
  CLI::Option* add(const std::string& names, std::vector<double>& target);
  CLI::Option* add(const std::string& names, std::vector<std::string>& target);
  void enter(const std::string& names, const std::string& shown, const std::string& help);

  CLI::App* app_;
  std::string name_, sentence_, note_;
  std::vector<Entry> positionals_;
  std::vector<Group> groups_;
  std::vector<std::string> examples_;
};

/// The whole program: reads the command line, runs the subcommand, turns failures into one line on
/// standard error and the exit code.
int run_program(int count, const char* const* arguments);

}  // namespace hodograph::cli
