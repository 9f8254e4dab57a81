// SPDX-License-Identifier: MIT
// Rational PH curves between end points, as a user runs the program: the golden problems, proofs,
// files, refusals.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cli/program.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

const std::string golden_a = "A = i + (i + 3/2 j + 1/2 k - 1)t";

TEST(RationalHermiteRequest, AnswersEveryGoldenProblem) {
  const Json golden = Json::parse(
      text_of_file(std::string(HODOGRAPH_SOURCE_DIRECTORY) + "/tests/golden/rational.json"));
  const Program program;
  std::string requests;
  for (const Json& problem : golden["hermite"]) {
    Json request = {{"request", "rational_hermite"},
                    {"A", problem["A"]},
                    {"alpha", problem["alpha"]},
                    {"degree", problem["degB"]},
                    {"P0", problem["P0"]},
                    {"P1", problem["P1"]},
                    {"begin", problem["interval"][0]},
                    {"end", problem["interval"][1]}};
    if (!problem["v0"].is_null()) {
      request["v0"] = problem["v0"];
      request["v1"] = problem["v1"];
    }
    requests += request.dump() + "\n";
  }
  const Outcome outcome = program.run({"batch"}, requests);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  std::string line;
  for (const Json& problem : golden["hermite"]) {
    SCOPED_TRACE(problem["name"]);
    ASSERT_TRUE(std::getline(lines, line));
    const Json answer = Json::parse(line);
    ASSERT_TRUE(answer["ok"]) << line;
    const Json& found = answer["result"];
    EXPECT_EQ(found["cone"]["outcome"], problem["cone_test"]);
    if (problem["solvable"] == 0) {
      EXPECT_EQ(found["reason"], "contradiction");
      EXPECT_EQ(found["contradiction"].size(), problem["equations"]);
      continue;
    }
    EXPECT_EQ(found["unknowns"], problem["unknowns"]);
    EXPECT_EQ(found["equations"], problem["equations"]);
    EXPECT_EQ(found["freedom"], problem["free"]);
    bool positive = false;
    if (problem.contains("unique")) {
      positive = problem["unique"]["cusps_on_interval"] == 0;
    } else {
      positive = problem["maximin_node_speed"].get<std::string>()[0] != '-';
    }
    EXPECT_EQ(found["outcome"], positive ? "found" : "none");
    if (positive && problem.contains("unique")) {
      EXPECT_EQ(found["curve"]["r"]["numerator"], problem["unique"]["r_num"]);
      EXPECT_EQ(found["curve"]["r"]["denominator"], problem["unique"]["r_den"]);
    }
  }
}

TEST(RationalHermiteProgram, FindsACurveAndWritesIt) {
  const Program program;
  const Outcome outcome = program.run(
      {"rational-hermite", "P1 = (2, 9/4, 2); T0 = i; T1 = i + 2j + 2k", "--out", "answer.txt",
       "--svg", "curve.svg", "--nurbs", "curve.json", "--path", "path.json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(text_of_file(program.path("answer.txt")).find("every smaller space of the search"),
            std::string::npos);
  const Json nurbs = Json::parse(text_of_file(program.path("curve.json")));
  EXPECT_EQ(nurbs["nurbs"]["control_points"].back(), Json({2.0, 2.25, 2.0}));
  EXPECT_EQ(program.run({"check", "path.json"}).code, 0);
  EXPECT_NE(text_of_file(program.path("curve.svg")).find("</svg>"), std::string::npos);
}

TEST(RationalHermiteProgram, ProvesThatThereIsNone) {
  const Program program;
  const Outcome outside = program.run({"rational-hermite", golden_a, "P1 = (5/2, 0, 2)"});
  EXPECT_EQ(outside.code, 3);
  EXPECT_NE(outside.out.find("n = (0, 1, -1) has n . F >= 0"), std::string::npos) << outside.out;
  EXPECT_NE(outside.err.find("outside the cone"), std::string::npos);
  const Outcome weights =
      program.run({"rational-hermite", golden_a, "P1 = (2, 2, 3/2); alpha = (t+1)^5; degree = 10"});
  EXPECT_EQ(weights.code, 3);
  EXPECT_NE(weights.out.find("the mean of the speeds"), std::string::npos) << weights.out;
}

TEST(RationalHermiteProgram, SaysWhatItDoesWithIrrationalDirections) {
  constexpr double promised = 0x1p-10;  // by --direction-bits 10
  const Program program;
  const Outcome outcome = program.run({"rational-hermite", "P1 = (3, 1, 1); T0 = i + j; T1 = i",
                                       "--direction-bits", "10", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json answer = Json::parse(outcome.out);
  EXPECT_EQ(answer["outcome"], "found");
  EXPECT_FALSE(answer["begin_direction"]["exact"]);
  EXPECT_GT(answer["begin_direction"]["deviation"], 0.0);
  EXPECT_LE(answer["begin_direction"]["deviation"], promised);
  EXPECT_TRUE(answer["end_direction"]["exact"]);
}

TEST(RationalHermiteProgram, RefusesBadInput) {
  const Program program;
  const auto refused = [&](const std::vector<std::string>& words, const std::string& part) {
    std::vector<std::string> arguments = {"rational-hermite"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const Outcome outcome = program.run(arguments);
    EXPECT_EQ(outcome.code, 2) << words[0];
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  };
  refused({"T0 = i; T1 = j"}, "P1 is missing");
  refused({"P1 = (1, 2, 3)"}, "both tangents are needed");
  refused({"P1 = (1, 2, 3); T0 = i; v1 = j"}, "exclude each other");
  refused({"P1 = (1, 2, 3); T0 = 0i; T1 = j"}, "no direction");
  refused({"P1 = (t, 2, 3); T0 = i; T1 = j"}, "depends on t");
  refused({"P1 = (1, 2, 3); T0 = i; T1 = j; begin = 1"}, "begin < end");
  refused({"P1 = (1, 2, 3); T0 = i; T1 = j; alpha = 2t - 1"}, "alpha has a root at t = 1/2");
  refused({golden_a, "P1 = (1, 2, 3); T0 = j"}, "not the direction");
  refused({golden_a, "P1 = (1, 2, 3); v0 = -i"}, "does not have the direction");
  refused({"A = 0; P1 = (1, 2, 3)"}, "A");
  refused({"P1 = (1, 2, 3); T0 = i; T1 = j; base = t + 1", "--most-power", "1000"}, "64");
  refused({"P1 = (1, 2, 3); T0 = i; T1 = j; base = t^2 + 2", "--most-power", "60"}, "degree 120");
  refused({"P1 = (10^900 * 10^900, 2, 3); T0 = i; T1 = j"}, "at most 4096");
  refused({"P1 = (1, 2, 3); T0 = i; T1 = j", "--direction-bits", "99"}, "2^-60");
  refused({"P1 = (1, 2, 3); T0 = i; T1 = j", "--svg", "-"}, "standard output");
}

}  // namespace
}  // namespace hodograph::test
