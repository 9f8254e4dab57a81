// SPDX-License-Identifier: MIT
// Runs the program as a user does: arguments and standard input in; exit code, standard output and
// standard error out.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "io/temporary_directory.hpp"

extern char** environ;

namespace hodograph::test {

struct Outcome {
  int code = -1;  ///< 128 + the signal's number where the program was killed
  std::string out, err;
};

inline std::string text_of_file(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline void write_text(const std::string& name, std::string_view text) {
  std::ofstream(name, std::ios::binary) << text;
}

/// The program, run inside a folder of its own.
class Program {
 public:
  /// A file name inside the folder.
  std::string path(const std::string& name) const { return folder_.path(name); }

  Outcome run(const std::vector<std::string>& arguments, std::string_view input = "") const {
    return execute(HODOGRAPH_PROGRAM, arguments, input);
  }
  /// A line as typed into a shell, with `hodograph` on the search path.
  Outcome shell(const std::string& line, std::string_view input = "") const {
    const std::string program = HODOGRAPH_PROGRAM;
    const std::string folder = program.substr(0, program.rfind('/'));
    return execute("/bin/sh", {"-c", "PATH='" + folder + "':$PATH; " + line}, input);
  }

 private:
  Outcome execute(const std::string& file, const std::vector<std::string>& arguments,
                  std::string_view input) const {
    const std::string in = path(".stdin"), out = path(".stdout"), err = path(".stderr");
    write_text(in, input);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    constexpr mode_t owner = 0600;
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, in.c_str(), O_RDONLY, owner);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, owner);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, owner);
    posix_spawn_file_actions_addchdir_np(&actions, folder_.path("").c_str());
    std::vector<std::string> words = {file};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    pid_t child = 0;
    Outcome outcome;
    if (posix_spawn(&child, file.c_str(), &actions, nullptr, pointers.data(), environ) == 0) {
      int status = 0;
      waitpid(child, &status, 0);
      constexpr int killed = 128;
      outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : killed + WTERMSIG(status);
    }
    posix_spawn_file_actions_destroy(&actions);
    outcome.out = text_of_file(out);
    outcome.err = text_of_file(err);
    return outcome;
  }

  TemporaryDirectory folder_;
};

inline std::size_t line_count(std::string_view text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// One line on standard error that contains `part`, nothing on standard output, and this exit code.
inline void expect_refused(const Outcome& outcome, const std::string& part, int code = 2) {
  EXPECT_EQ(outcome.code, code) << outcome.err;
  EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
  EXPECT_TRUE(outcome.err.starts_with("hodograph: ")) << outcome.err;
  EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

}  // namespace hodograph::test
