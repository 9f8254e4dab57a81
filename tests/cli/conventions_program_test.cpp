// SPDX-License-Identifier: MIT
// docs/conventions.md, the signs and units of the program: one test each.
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "cli/program.hpp"

namespace hodograph::test {
namespace {

TEST(Conventions, FlagsTakeDegreesOnlyWhereTheirNameSaysSo) {
  const Program program;
  // ψ = 90 degrees is ψ = π/2; without the suffix it would be 90 radians, which
  // is refused.
  const Outcome degrees = program.run({"loop", "--xi", "1", "--psi-deg", "90", "-o", "-"});
  const Outcome radians =
      program.run({"loop", "--xi", "1", "--psi", "1.5707963267948966", "-o", "-"});
  ASSERT_EQ(degrees.code, 0) << degrees.err;
  EXPECT_EQ(degrees.out, radians.out);
  EXPECT_EQ(program.run({"loop", "--xi", "1", "--psi", "90", "-o", "-"}).code, 2);
  // No other flag speaks of degrees, but for latitudes and longitudes.
  const std::regex command("\n  ([a-z][a-z-]*)(?: |\n)"), flag("^ +(-[a-zA-Z], )?--([a-z-]+)");
  const std::string overview = program.run({"--help"}).out;
  const std::string list = overview.substr(0, overview.find("\nOptions"));
  std::size_t commands = 0, with_degrees = 0;
  for (std::sregex_iterator it(list.begin(), list.end(), command), none; it != none; ++it) {
    ++commands;
    std::string name;
    for (const std::string& line : lines_of(program.run({(*it)[1], "--help"}).out)) {
      std::smatch found;
      if (std::regex_search(line, found, flag)) name = found[2];
      if (line.empty()) name.clear();
      const bool says_so = name.ends_with("-deg");
      if (says_so) ++with_degrees;
      if (!name.empty() && line.find("degrees") != std::string::npos) {
        EXPECT_TRUE(says_so || name == "datum") << (*it)[1] << ": " << line;
      }
    }
  }
  EXPECT_GT(commands, 20u);
  EXPECT_GT(with_degrees, 8u);
}

TEST(Conventions, HeadingsOfTheProgramCountFromXTowardsY) {
  const Program program;
  const Outcome made = program.run({"hermite", "--begin", "0,0", "--begin-deg", "90", "--end",
                                    "0,1", "--end-deg", "90", "--length", "1", "-o", "line.json"});
  ASSERT_EQ(made.code, 0) << made.err;
  const Outcome points = program.run({"sample", "line.json", "--count", "2", "-o", "-"});
  ASSERT_EQ(points.code, 0) << points.err;
  EXPECT_TRUE(points.out.ends_with(",1\n")) << points.out;  // y = 1, a length of 1 away
}

TEST(Conventions, AFailureIsOneLineAndItsCodeSaysWhose) {
  const Program program;
  expect_refused(program.run({"corner", "none.csv", "--curvature", "1"}), "none.csv", 2);
  expect_refused(program.run({"hermite", "--begin", "0,0", "--begin-deg", "0", "--end", "1,0",
                              "--end-deg", "0", "--length", "0.5"}),
                 "at least", 3);
}

}  // namespace
}  // namespace hodograph::test
