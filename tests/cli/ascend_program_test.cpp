// SPDX-License-Identifier: MIT
// Ascents from the Moon, as a user runs the program.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

TEST(AscendCommand, SolvesTheProblemWithGravityAndWritesAReport) {
  const Program program;
  const Outcome run = program.run({"ascend", "--problem", "energy", "--start", "+z", "--guesses",
                                   "1", "--report", "up.html", "--csv", "up.csv", "-o", "up.json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("5.75992"), std::string::npos) << run.out;
  const std::string page = text_of_file(program.path("up.html"));
  for (const char* part : {"Moon", "Thrust", "Speed", "tangent", "Height above the surface"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(line_count(text_of_file(program.path("up.csv"))), 102u);
  const Json json = Json::parse(text_of_file(program.path("up.json")));
  const Json& ascent = json["ascents"][0];
  EXPECT_EQ(json["problem"], "energy");
  EXPECT_EQ(ascent["nodes"]["position_km"].size(), 101u);
  EXPECT_LE(ascent["again"]["orbit_error_km"].get<double>(), 0.01);
  EXPECT_GE(ascent["again"]["lowest_height_km"].get<double>(), 0.0);
}

TEST(AscendCommand, SolvesInTheCoordinatesOfThePathEachStartOnce) {
  const Program program;
  const Outcome run =
      program.run({"ascend", "--problem", "energy", "--start", "+z,+z", "--coordinates", "path",
                   "--guesses", "1", "--report", "none", "-o", "up.json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("5.7599"), std::string::npos) << run.out;
  const Json json = Json::parse(text_of_file(program.path("up.json")));
  EXPECT_EQ(json["ascents"].size(), 1u);
  EXPECT_EQ(json["ascents"][0]["coordinates"], "path");
}

TEST(AscendCommand, SolvesThePublishedProblemAndSaysWhatTheFigureDoes) {
  const Program program;
  const Outcome run = program.run({"ascend", "--problem", "tracking,figure", "--start", "+z",
                                   "--guesses", "1", "--report", "ascent.html"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("0.0005173"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("does not reach"), std::string::npos) << run.out;
  const std::string page = text_of_file(program.path("ascent-tracking.html"));
  EXPECT_NE(page.find("no gravity"), std::string::npos);
  EXPECT_NE(page.find("Gimbal angle"), std::string::npos);
  EXPECT_NE(text_of_file(program.path("ascent-figure.html")).find("does not arrive"),
            std::string::npos);
}

TEST(AscendCommand, RefusesWhatItCannotDo) {
  const Program program;
  const auto refused = [&](const std::vector<std::string>& arguments, int code,
                           const std::string& words) {
    std::vector<std::string> all = {"ascend", "--report", "never.html"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome run = program.run(all);
    EXPECT_EQ(run.code, code) << run.err;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(text_of_file(program.path("never.html")), "");
  };
  refused({"--start", "up"}, 2, "the starts are +z");
  refused({"--problem", "flight"}, 2, "the problems are tracking");
  refused({"--problem", "tracking", "--coordinates", "path"}, 2, "with gravity");
  refused({"--problem", "energy", "--start", "+z", "--duration", "1"}, 2, "duration_s is 1");
  refused({"--problem", "energy", "--start", "+z", "--thrust", "1.5", "--guesses", "1",
           "--most-iterations", "30"},
          3, "energy from +z");
}

TEST(AscendCommand, StopsOnCtrlCAndLeavesFilesWhole) {
  const Program program;
  write_text(program.path("ascent.html"), "as before");
  // Once, as a terminal sends it: timeout without --foreground sends it to the program and then to
  // the whole group, and the second ends the program at once. A job in the background inherits an
  // ignored signal.
  const Outcome run = program.shell(
      "env --default-signal=INT timeout --foreground --preserve-status -s INT 2 "
      "hodograph ascend --problem time --guesses 1000 --report ascent.html");
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_NE(run.err.find("stopped on request"), std::string::npos) << run.err;
  EXPECT_EQ(text_of_file(program.path("ascent.html")), "as before");
}

}  // namespace
}  // namespace hodograph::test
