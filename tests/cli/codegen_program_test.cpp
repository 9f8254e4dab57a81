// SPDX-License-Identifier: MIT
// hodograph codegen as a user runs it: the files compile, and a program gets its numbers.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace hodograph::test {
namespace {

constexpr const char* line =
    R"({"format": "hodograph-path", "version": 1, "algebra": "complex", "preimage_degree": 0,
        "closed": false, "knots": [0, 1], "segments": [{"start": [1, 2], "preimage": [[2, 0]]}]})";

TEST(CodegenProgram, WritesFilesThatCompileIntoAProgram) {
  const Program program;
  write_text(program.path("line.json"), line);
  const Outcome outcome = program.run({"codegen", "line.json", "--name", "line", "--casadi"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "wrote line.h\nwrote line.c\n");
  write_text(program.path("main.c"), R"(
#include <stdio.h>
#include "line.h"
int main(void) {
  double p[4];
  if (line_position(0.5, 1, p) != line_ok || line_position(2.0, 0, p) != line_outside) return 1;
  printf("%g %g %g %g\n", p[0], p[1], p[2], p[3]);
  return (int)line_n_in() - 1;
}
)");
  const Outcome run = program.shell(
      "cc -std=c99 -Wall -Wextra -pedantic -Werror main.c line.c -o main -lm && ./main");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "3 2 4 0\n");
  const Outcome cxx = program.shell(
      "c++ -std=c++98 -pedantic -Wno-long-long -Werror -x c++ "
      "-fsyntax-only -include line.h /dev/null");
  EXPECT_EQ(cxx.code, 0) << cxx.err;
}

TEST(CodegenProgram, RefusesWhatCannotBeWrittenOrNamed) {
  const Program program;
  write_text(program.path("line.json"), line);
  expect_refused(program.run({"codegen", "line.json", "--name", "2nd"}), "cannot name functions");
  expect_refused(program.run({"codegen", "line.json", "-o", "nowhere"}), "nowhere");
  expect_refused(program.run({"codegen", "none.json"}), "none.json");
  EXPECT_EQ(text_of_file(program.path("path.h")), "");
}

TEST(CodegenProgram, ARequestGivesTheSameText) {
  const Program program;
  write_text(program.path("line.json"), line);
  ASSERT_EQ(program.run({"codegen", "line.json", "--name", "line"}).code, 0);
  const Outcome batch =
      program.run({"batch"}, R"({"request": "codegen", "file": "line.json", "name": "line"})"
                             "\n");
  const auto result = nlohmann::json::parse(batch.out)["result"];
  EXPECT_EQ(result["header"], text_of_file(program.path("line.h")));
  EXPECT_EQ(result["source"], text_of_file(program.path("line.c")));
}

}  // namespace
}  // namespace hodograph::test
