// SPDX-License-Identifier: MIT
// hodograph follow as a user runs it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

/// A straight road of length 20.
constexpr const char* road =
    R"({"format": "hodograph-path", "version": 1, "algebra": "complex", "preimage_degree": 2,
        "closed": false, "knots": [0, 20],
        "segments": [{"start": [0, 0], "preimage": [[1, 0], [1, 0], [1, 0]]}]})";
/// An obstacle three above it.
constexpr const char* world =
    R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {},
        "geometry": {"type": "Polygon",
                     "coordinates": [[[5, 3], [8, 3], [8, 6], [5, 6], [5, 3]]]}}]})";

TEST(FollowProgram, WritesWhatItFound) {
  const Program program;
  write_text(program.path("road.json"), road);
  write_text(program.path("world.json"), world);
  const Outcome outcome =
      program.run({"follow", "road.json", "--speed", "2", "--acceleration", "1", "--world",
                   "world.json", "--clearance", "2", "--intervals", "20", "-o", "out.json", "--csv",
                   "way.csv", "--report", "way.html"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("of 1 allowed"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("of 2 needed; of the path 3, certified"), std::string::npos)
      << outcome.out;
  const Json found = Json::parse(text_of_file(program.path("out.json")));
  EXPECT_EQ(found["nodes"].size(), 21u);
  // 2 s to speed up, then 18 at a speed of 2, as twenty intervals tell it.
  EXPECT_GE(found["duration"].get<double>(), 10.99);
  EXPECT_LE(found["duration"].get<double>(), 11.1);
  EXPECT_TRUE(found["tube"].is_null());
  EXPECT_LE(found["largest_offset"], found["offset_limit"]);
  EXPECT_GE(found["clearance"]["on_the_way"].get<double>(), 2.0);
  EXPECT_EQ(line_count(text_of_file(program.path("way.csv"))), 22u);
  EXPECT_NE(text_of_file(program.path("way.html")).find("Offset from the path"), std::string::npos);
}

TEST(FollowProgram, DrivesAHorizonAndTellsTheLatencies) {
  const Program program;
  write_text(program.path("road.json"), road);
  const Outcome outcome =
      program.run({"follow", "road.json", "--speed", "2", "--acceleration", "1", "--offset", "0.5",
                   "--horizon-step", "0.5", "--horizon", "6", "-o", "drive.json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Latency"), std::string::npos) << outcome.out;
  const Json drive = Json::parse(text_of_file(program.path("drive.json")));
  EXPECT_EQ(drive["latencies_s"].size() + 1, drive["plans"].get<std::size_t>());
}

/// A round of radius 1 or so.
void make_round(const Program& program) {
  write_text(program.path("round.csv"), "x,y\n1,0\n0,1\n-1,0\n0,-1\n");
  const Outcome made = program.run({"spline", "round.csv", "--closed", "-o", "round.json"});
  ASSERT_EQ(made.code, 0) << made.err;
}

/// A bend in space.
constexpr const char* bend =
    R"({"format": "hodograph-path", "version": 1, "algebra": "quaternion", "preimage_degree": 2,
        "closed": false, "knots": [0, 3],
        "segments": [{"start": [0, 0, 0],
                      "preimage": [[1, 0, 0, 0], [1, 0, 0.2, 0.1], [1, 0.1, 0, 0.3]]}]})";

TEST(FollowProgram, GoesOnceRoundAClosedPathFromAnywhere) {
  const Program program;
  make_round(program);
  for (const char* from : {"0", "0.6"}) {
    const Outcome outcome = program.run({"follow", "round.json", "--speed", "2", "--acceleration",
                                         "1", "--lateral-acceleration", "1", "--offset", "0.1",
                                         "--from-xi", from, "--intervals", "40", "-o", "out.json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json found = Json::parse(text_of_file(program.path("out.json")));
    const Json &first = found["nodes"].front(), &last = found["nodes"].back();
    EXPECT_GT(last["arc_length"].get<double>() - first["arc_length"].get<double>(), 6.0);
    EXPECT_LT(found["largest_offset"], found["tube"]);
    EXPECT_LE(found["largest_offset"], found["offset_limit"]);
    const Outcome drive =
        program.run({"follow", "round.json", "--speed", "2", "--acceleration", "1",
                     "--lateral-acceleration", "1", "--offset", "0.1", "--from-xi", from,
                     "--horizon-step", "0.25", "--horizon", "8", "-o", "drive.json"});
    ASSERT_EQ(drive.code, 0) << drive.err;
    const Json driven = Json::parse(text_of_file(program.path("drive.json")));
    EXPECT_GT(driven["xi"].get<double>() - std::stod(from), 0.9 * found["progress"].get<double>());
  }
}

TEST(FollowProgram, FollowsAPathInSpace) {
  const Program program;
  write_text(program.path("space.json"), bend);
  const Outcome outcome =
      program.run({"follow", "space.json", "--speed", "1", "--acceleration", "0.5", "--offset",
                   "0.05", "--intervals", "30", "-o", "out.json", "--csv", "way.csv"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json found = Json::parse(text_of_file(program.path("out.json")));
  EXPECT_EQ(found["nodes"].front()["position"].size(), 3u);
  EXPECT_LE(found["largest_offset"], found["offset_limit"]);
  EXPECT_FALSE(found.contains("largest_lateral"));
  const Outcome drive =
      program.run({"follow", "space.json", "--speed", "1", "--acceleration", "0.5", "--offset",
                   "0.05", "--horizon-step", "0.3", "--horizon", "8"});
  EXPECT_EQ(drive.code, 0) << drive.err;
}

TEST(FollowProgram, RefusesWhatCannotBe) {
  const Program program;
  write_text(program.path("road.json"), road);
  write_text(program.path("world.json"), world);
  const std::vector<std::string> usual = {"follow", "road.json",      "--speed",
                                          "2",      "--acceleration", "1"};
  const auto with = [&](std::vector<std::string> more) {
    std::vector<std::string> all = usual;
    all.insert(all.end(), more.begin(), more.end());
    return program.run(all);
  };
  expect_refused(with({}), "--offset");
  expect_refused(with({"--world", "world.json", "--clearance", "4"}), "nothing is left");
  expect_refused(with({"--world", "world.json", "--offset", "5"}), "leaves 2.99");
  expect_refused(with({"--offset", "1", "--independent", "xi"}), "take time independent");
  expect_refused(with({"--offset", "1", "--end-speed", "-1"}), "end_speed");
  expect_refused(with({"--offset", "1", "--start-offset", "1,2"}), "one offset");
  expect_refused(with({"--offset", "1", "--to-xi", "0.5", "--end-speed", "2"}),
                 "it can be at most");
  expect_refused(with({"--offset", "1", "--horizon-step", "1e-6"}), "must be at least 0.001");
  expect_refused(with({"--offset", "1", "--hard"}), "--horizon-step");
  EXPECT_EQ(text_of_file(program.path("out.json")), "");
}

}  // namespace
}  // namespace hodograph::test
