// SPDX-License-Identifier: MIT
// hodograph frame and the request "frame", as a user runs them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "cli/program.hpp"
#include "hodograph/io/table.hpp"
#include "io/markup_check.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

constexpr double pi = std::numbers::pi;
/// Angles and axes of the loops here are known to a hundred roundings.
constexpr double hundred_roundings = 0x1p-45;

/// Example 1 of the paper on closed loops, as loop.json.
void make_loop(const Program& program) {
  const Outcome made = program.run({"loop", "--xi", "1", "--psi-deg", "108", "-o", "loop.json"});
  ASSERT_EQ(made.code, 0) << made.err;
}

void make_curve(const Program& program) {
  const Outcome made =
      program.run({"fit", "--formula", "t, t^2, t^3", "-t", "1e-3", "-o", "curve.json"});
  ASSERT_EQ(made.code, 0) << made.err;
}

Json json_of(const Program& program, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "frame");
  arguments.insert(arguments.end(), {"--format", "json"});
  const Outcome outcome = program.run(arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return Json::parse(outcome.out);
}

double middle(const Json& enclosure) {
  return 0.5 * (enclosure["lower"].get<double>() + enclosure["upper"].get<double>());
}

TEST(FrameCommand, WritesRowsOfRotationsAxesAndRates) {
  const Program program;
  make_loop(program);
  const Outcome outcome = program.run({"frame", "loop.json", "-n", "21", "-o", "frames.csv"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("rotation-minimising"), std::string::npos);
  EXPECT_NE(outcome.out.find("wrote frames.csv"), std::string::npos);
  const Table table = read_table(text_of_file(program.path("frames.csv"))).value();
  ASSERT_EQ(table.row_count(), 21U);
  ASSERT_EQ(table.column_count, 22U);
  EXPECT_EQ(table.names[5], "roll");
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    // A unit quaternion whose images of i, j, k are the axes; no rotation about the tangent.
    const double w = table.at(i, 6), x = table.at(i, 7), y = table.at(i, 8), z = table.at(i, 9);
    EXPECT_NEAR(w * w + x * x + y * y + z * z, 1.0, hundred_roundings);
    EXPECT_NEAR(table.at(i, 10), w * w + x * x - y * y - z * z, hundred_roundings);
    EXPECT_NEAR(table.at(i, 13), 2 * (x * y - w * z), hundred_roundings);
    EXPECT_NEAR(table.at(i, 18), w * w + z * z - x * x - y * y, hundred_roundings);
    EXPECT_NEAR(table.at(i, 19), 0.0, hundred_roundings);
  }
}

TEST(FrameCommand, TellsTheTwistOfThePapersExamples) {
  const Program program;
  make_loop(program);
  const Json smooth =
      json_of(program, {"loop.json", "--kind", "periodic", "--gamma", "smooth-negative"});
  constexpr double nine_digits = 0.5e-9;  // not a tolerance: half of the last digit of the errata
  EXPECT_NEAR(middle(smooth["absolute_twist"]), 0.817156375, nine_digits);
  EXPECT_EQ(smooth["inflections"].size(), 2U);
  const Json least = json_of(program, {"loop.json", "--kind", "periodic"});
  EXPECT_NEAR(least["gamma"].get<double>(), -0.462949157, nine_digits);
  EXPECT_NEAR(middle(least["absolute_twist"]), 0.651693178, nine_digits);
  const Json given = json_of(program, {"loop.json", "--kind", "periodic", "--gamma", "-1"});
  EXPECT_NEAR(middle(given["absolute_twist"]), 1.146287015, nine_digits);
  const Json even = json_of(program, {"loop.json", "--kind", "least-twist"});
  EXPECT_LE(middle(even["absolute_twist"]), middle(least["absolute_twist"]));
  EXPECT_EQ(even["frames"].front()["axes"].size(), 3U);
  const Json erf = json_of(program, {"loop.json", "--kind", "erf", "--xi", "0,0.5,1"});
  EXPECT_EQ(erf["frames"].size(), 3U);
  EXPECT_EQ(erf["twist"], erf["erf_twist"]);
}

TEST(FrameCommand, TurnsTheSecondAxisWhereItIsAsked) {
  const Program program;
  make_curve(program);
  const Json frame = json_of(program, {"curve.json", "--kind", "least-twist", "--begin-normal",
                                       "0,0,1", "--end-normal", "0,1,0", "-n", "2"});
  const auto first = frame["frames"][0]["axes"], last = frame["frames"][1]["axes"];
  // The third axis is level across where the second is as steep as can be.
  EXPECT_NEAR(first[2][2].get<double>(), 0.0, hundred_roundings);
  EXPECT_GT(first[1][2].get<double>(), 0.0);
  EXPECT_NEAR(last[2][1].get<double>(), 0.0, hundred_roundings);
  EXPECT_GT(last[1][1].get<double>(), 0.0);
  const Json turned = json_of(program, {"curve.json", "--begin-deg", "90", "--count-in-xi", "2"});
  EXPECT_NEAR(turned["frames"][0]["roll"].get<double>(), pi / 2, hundred_roundings);
}

TEST(FrameCommand, DrawsAReport) {
  const Program program;
  make_curve(program);
  const Outcome outcome = program.run(
      {"frame", "curve.json", "--kind", "frenet", "--report", "frame.html", "-o", "frames.json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string report = text_of_file(program.path("frame.html"));
  EXPECT_NE(report.find("Rotation about the tangent"), std::string::npos);
  EXPECT_NE(report.find("Absolute twist"), std::string::npos);
  EXPECT_TRUE(Json::accept(text_of_file(program.path("frames.json"))));
}

TEST(FrameCommand, RefusesWhatDoesNotFit) {
  const Program program;
  make_loop(program);
  make_curve(program);
  expect_refused(program.run({"frame", "loop.json", "--gamma", "2"}), "periodic");
  expect_refused(program.run({"frame", "loop.json", "--kind", "periodic", "--gamma", "0"}),
                 "other than 0");
  expect_refused(program.run({"frame", "loop.json", "--kind", "periodic", "--gamma", "nice"}),
                 "smooth-positive");
  expect_refused(program.run({"frame", "curve.json", "--kind", "periodic"}), "closed");
  expect_refused(program.run({"frame", "loop.json", "--kind", "least-twist", "--end-deg", "3"}),
                 "open");
  expect_refused(program.run({"frame", "curve.json", "--kind", "erf", "--begin-deg", "3"}),
                 "begin");
  expect_refused(program.run({"frame", "curve.json", "--begin-normal", "0,0,0"}), "tangent");
  expect_refused(program.run({"frame", "curve.json", "-o", "-", "--report", "-"}), "both");
  write_text(program.path("points.csv"), "x,y\n0,0\n1,2\n2,0\n");
  ASSERT_EQ(program.run({"spline", "points.csv", "-o", "plane.json"}).code, 0);
  expect_refused(program.run({"frame", "plane.json"}), "plane");
  // A straight line has no principal normal; every other frame exists.
  ASSERT_EQ(program.run({"fit", "--formula", "t, 2*t, -t", "-t", "1e-3", "-o", "line.json"}).code,
            0);
  expect_refused(program.run({"frame", "line.json", "--kind", "frenet"}), "straight");
  EXPECT_EQ(program.run({"frame", "line.json"}).code, 0);
}

TEST(FrameRequest, AnswersInOneLine) {
  const Program program;
  make_loop(program);
  const std::string requests =
      R"({"request": "frame", "file": "loop.json", "kind": "periodic", "choose_gamma": "smooth-positive"})"
      "\n"
      R"({"request": "frame", "file": "loop.json", "kind": "rotation-minimising", "begin_normal": [0, 0, 1], "count": 5})"
      "\n"
      R"({"request": "frame", "file": "loop.json", "kind": "periodic", "gamma": 1, "choose_gamma": "least"})"
      "\n"
      R"({"request": "frame", "file": "loop.json", "count": 5, "xi": [0]})"
      "\n";
  const Outcome outcome = program.run({"batch", "-"}, requests);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 4U);
  const Json first = Json::parse(lines[0]), second = Json::parse(lines[1]);
  ASSERT_TRUE(first["ok"]);
  constexpr double six_digits = 0.5e-5;  // not a tolerance: half of the last digit of the paper
  EXPECT_NEAR(first["result"]["gamma"].get<double>(), 3.44469, six_digits);
  EXPECT_FALSE(first["result"].contains("frames"));
  ASSERT_TRUE(second["ok"]);
  ASSERT_EQ(second["result"]["frames"].size(), 5U);
  EXPECT_NEAR(second["result"]["frames"][0]["axes"][1][2].get<double>(), 1.0, hundred_roundings);
  EXPECT_FALSE(Json::parse(lines[2])["ok"]);
  EXPECT_FALSE(Json::parse(lines[3])["ok"]);
}

TEST(FrameCommand, SaysWhereThePrincipalNormalJumps) {
  const Program program;
  write_text(program.path("points.csv"), "x,y,z\n0,0,0\n4,0,1\n8,4,2\n12,4,3\n");
  ASSERT_EQ(program.run({"climb", "points.csv", "--ground-length", "6.5", "-o", "c.json"}).code, 0);
  const Outcome frame = program.run({"frame", "c.json", "--kind", "frenet", "-o", "f.csv"});
  EXPECT_EQ(frame.code, 0) << frame.err;
  EXPECT_NE(frame.out.find("The normal jumps"), std::string::npos) << frame.out;
  EXPECT_NE(frame.out.find(" rad"), std::string::npos);
  const Outcome json = program.run({"frame", "c.json", "--kind", "frenet", "-o", "f.json"});
  EXPECT_EQ(json.code, 0);
  EXPECT_NE(text_of_file(program.path("f.json")).find("\"normal_jumps\": [{\"knot\": 1"),
            std::string::npos);
}

}  // namespace
}  // namespace hodograph::test
