// SPDX-License-Identifier: MIT
// Planar constructions as a user runs them: spline, hermite, corner.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "support/compare.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

constexpr const char* five_points = "x,y\n0,0\n1,0.5\n2,0.2\n2.5,1.5\n1,2\n";

Json inspected(const Program& program, const std::string& file) {
  const Outcome outcome = program.run({"inspect", file, "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return Json::parse(outcome.out);
}

void expect_checked(const Program& program, const std::string& file) {
  const Outcome outcome = program.run({"check", file});
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST(SplineCommand, MakesACheckedC2PathFromATableAndFromJson) {
  const Program program;
  write_text(program.path("points.csv"), five_points);
  const Outcome made = program.run({"spline", "points.csv", "--report", "path.html"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.out.find("wrote path.json"), std::string::npos) << made.out;
  EXPECT_NE(made.out.find("Newton steps"), std::string::npos) << made.out;
  const Json facts = inspected(program, "path.json");
  EXPECT_EQ(facts["segments"], 4);
  EXPECT_EQ(facts["dimension"], 2);
  EXPECT_GE(facts["continuity"]["position"], 2);
  // The golden spline "open 4 spans"; Newton's iteration leaves a few hundred roundings.
  constexpr double golden_length = 5.567466733440345;
  constexpr double rounding = 256 * epsilon<double>() * golden_length;
  EXPECT_NEAR(facts["length"].get<double>(), golden_length, rounding);
  expect_checked(program, "path.json");

  write_text(program.path("points.json"), "[[0,0],[1,0.5],[2,0.2],[2.5,1.5],[1,2]]");
  ASSERT_EQ(program.run({"spline", "points.json", "-o", "same.json"}).code, 0);
  const Json a = Json::parse(text_of_file(program.path("path.json")));
  const Json b = Json::parse(text_of_file(program.path("same.json")));
  EXPECT_EQ(a["segments"], b["segments"]);
}

TEST(SplineCommand, ClosesAndMergesAndRefuses) {
  const Program program;
  write_text(program.path("square.csv"), "0,0\n1,0\n1,1\n0,1\n");
  ASSERT_EQ(program.run({"spline", "square.csv", "--closed", "-o", "square.json"}).code, 0);
  const Json facts = inspected(program, "square.json");
  EXPECT_EQ(facts["closed"], true);
  EXPECT_EQ(facts["segments"], 4);
  expect_checked(program, "square.json");

  write_text(program.path("twice.csv"), "0,0\n1,0\n1,0\n2,1\n");
  expect_refused(program.run({"spline", "twice.csv"}), "2");
  EXPECT_EQ(program.run({"spline", "twice.csv", "--merge-repeated"}).code, 0);
  expect_refused(program.run({"spline", "-"}, "1,2\n"), "");
  expect_refused(program.run({"spline", "-"}, "1\n2\n3\n"), "two columns");
  expect_refused(program.run({"spline", "-"}, "[[0,0],[1]]"), "standard input, at /1: ");
  expect_refused(program.run({"spline", "-"}, "[[0,0],[1,"), "JSON");
  expect_refused(program.run({"spline", "-"}, "0,0\n1,nan\n"), "nan");
}

TEST(HermiteCommand, HasTheLengthThatWasAskedFor) {
  const Program program;
  const Outcome made = program.run({"hermite", "--begin", "0,0", "--begin-deg", "45", "--end",
                                    "1,0", "--end-deg", "60", "--length", "1.12"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.out.find("Rotation index"), std::string::npos) << made.out;
  const Json facts = inspected(program, "path.json");
  constexpr double length = 1.12, roundings = 16 * epsilon<double>();
  EXPECT_NEAR(facts["length"].get<double>(), length, length * roundings);
  expect_checked(program, "path.json");
  expect_refused(program.run({"hermite", "--begin", "0,0", "--begin-deg", "45", "--end", "1,0",
                              "--end-deg", "60", "--length", "0.9"}),
                 "0.9", 3);
  expect_refused(program.run({"hermite", "--begin", "0,0", "--begin-deg", "9", "--end", "1,0",
                              "--length", "2"}),
                 "--end-direction");
  expect_refused(program.run({"hermite", "--begin", "0,0", "--end", "1,0"}), "--begin-derivative");
  expect_refused(program.run({"hermite", "--begin", "0", "--end", "1,0"}), "--begin");
}

TEST(HermiteCommand, RefusesWhatContradictsItself) {
  const Program program;
  const auto refused = [&](std::vector<std::string> more, const std::string& part) {
    more.insert(more.begin(), {"hermite", "--begin", "0,0", "--end", "1,0"});
    expect_refused(program.run(more), part);
  };
  refused({"--begin-deg", "3", "--end-deg", "3"}, "--length");
  refused({"--begin-derivative", "1,0", "--end-derivative", "1,0", "--length", "2"}, "excludes");
  refused({"--length", "2", "--begin-deg", "3", "--begin-direction", "1,0", "--end-deg", "3"},
          "excludes");
  refused({"--begin-derivative", "1,0", "--end-derivative", "1,1", "-o", "a", "--report", "a"},
          "'a'");
  refused({"--begin-derivative", "1,0", "--end-derivative", "1,1", "-o", "-", "--report", "-"},
          "standard output");
  EXPECT_FALSE(std::filesystem::exists(program.path("a")));
}

TEST(HermiteCommand, OfAStraightLineTheCurvatureIsZero) {
  const Program program;
  const Outcome made = program.run({"hermite", "--begin", "0,0", "--begin-derivative", "1,0",
                                    "--end", "1,0", "--end-derivative", "1,0"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.out.find("at most 0\n"), std::string::npos) << made.out;
  // One segment meets no other at a knot.
  EXPECT_EQ(made.out.find("Continuity"), std::string::npos) << made.out;
}

TEST(CornerCommand, KeepsItsCurvature) {
  const Program program;
  write_text(program.path("route.csv"), "x,y\n0,0\n2,0\n3,2\n6,2\n");
  const Outcome made = program.run({"corner", "route.csv", "--curvature", "5"});
  ASSERT_EQ(made.code, 0) << made.err;
  const Json facts = inspected(program, "path.json");
  EXPECT_EQ(facts["segments"], 5);
  // The corner touches its bound: the enclosure of the largest curvature is promised_width wide.
  constexpr double bound = 5.0, promised_width = 0x1p-19;
  EXPECT_LE(facts["curvature_bound"].get<double>(), bound * (1.0 + promised_width));
  expect_checked(program, "path.json");
  expect_refused(program.run({"corner", "route.csv", "--curvature", "0.1"}), "", 3);
  expect_refused(program.run({"corner"}), "polyline");
  expect_refused(program.run({"corner", "--before", "0,0", "--at", "1,0", "--after", "1,1", "--leg",
                              "1", "--curvature", "2"}),
                 "one of");
  const Outcome one = program.run(
      {"corner", "--before", "0,0", "--at", "1,0", "--after", "1,1", "--curvature", "4"});
  ASSERT_EQ(one.code, 0);
  EXPECT_NE(one.out.find("at most 4.0000000000"), std::string::npos) << one.out;  // not 4.001
  EXPECT_EQ(inspected(program, "path.json")["segments"], 1);
}

}  // namespace
}  // namespace hodograph::test
