// SPDX-License-Identifier: MIT
// hodograph climb: from every kind of file, checked again, flown in time, written as missions; what
// check makes of climbs that somebody has touched; and refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/program.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

std::string ridge() { return std::string(HODOGRAPH_SOURCE_DIRECTORY) + "/examples/ridge.csv"; }

Outcome climb_ridge(const Program& program, std::vector<std::string> more = {}) {
  std::vector<std::string> words{
      "climb", ridge(), "--max-climb-deg", "8", "--max-descent-deg", "12", "--turn-radius",
      "60",    "-o",    "ridge.json"};
  words.insert(words.end(), more.begin(), more.end());
  return program.run(words);
}

TEST(ClimbCommand, KeepsTheLimitsAndIsProvenAgain) {
  const Program program;
  const Outcome made = climb_ridge(program, {"--report", "ridge.html"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.out.find("a corner in pitch"), std::string::npos) << made.out;
  const Outcome checked = program.run({"check", "ridge.json"});
  EXPECT_EQ(checked.code, 0) << checked.err;
  EXPECT_NE(checked.out.find("sine of the climb angle, segments 0 to"), std::string::npos);
  const Json promises = Json::parse(text_of_file(program.path("ridge.json")))["promises"];
  EXPECT_LE(promises["curvature_bound"].get<double>(), 1.0 / 60.0);
  const double up = std::sin(8.0 * std::acos(-1.0) / 180.0);
  const double down = -std::sin(12.0 * std::acos(-1.0) / 180.0);
  constexpr double rounding = 0x1.0p-48;  // of enclosures of a number below 1
  for (const Json& row : promises["helix"]["sines"]) {
    EXPECT_LE(row[2].get<double>(), up + rounding);
    EXPECT_GE(row[1].get<double>(), down - rounding);
  }
  const std::string report = text_of_file(program.path("ridge.html"));
  EXPECT_NE(report.find("Climb 4"), std::string::npos);
}

TEST(ClimbCommand, NoCoefficientCanBeMovedUnseen) {
  const Program program;
  ASSERT_EQ(program
                .run({"climb", "--begin", "0,0,0", "--begin-deg", "30", "--end", "3,1,1.5",
                      "--end-deg", "-40", "--climb-deg", "20", "-o", "climb.json"})
                .code,
            0);
  const Json document = Json::parse(text_of_file(program.path("climb.json")));
  constexpr double lie = 1e-9;  // far above rounding, far below what anybody would see
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      Json touched = document;
      auto& number = touched["segments"][0]["preimage"][i][j];
      number = number.get<double>() + lie;
      write_text(program.path("lie.json"), touched.dump());
      const Outcome outcome = program.run({"check", "lie.json"});
      EXPECT_EQ(outcome.code, 2) << i << " " << j << "\n" << outcome.out;
    }
  }
  Json steeper = document;
  steeper["promises"]["helix"]["axis"]["x"] = lie;
  write_text(program.path("lie.json"), steeper.dump());
  const Outcome tilted = program.run({"check", "lie.json"});
  EXPECT_EQ(tilted.code, 2);
  EXPECT_NE(tilted.err.find("sine of the climb angle"), std::string::npos) << tilted.err;
}

TEST(ClimbCommand, FliesInTimeAndWritesMissions) {
  const Program program;
  const Outcome made =
      climb_ridge(program, {"--csv", "times.csv", "--samples", "101", "--speed", "20",
                            "--acceleration", "2", "--datum", "46.5,8.0,600", "--qgroundcontrol",
                            "ridge.plan", "--wpl", "ridge.waypoints", "--chord", "0.5"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.out.find("within 0.5 of the path, certified"), std::string::npos) << made.out;
  const auto rows = lines_of(text_of_file(program.path("times.csv")));
  ASSERT_EQ(rows.size(), 102U);
  EXPECT_TRUE(rows[0].starts_with("time,s,x,y,z,speed"));
  EXPECT_TRUE(text_of_file(program.path("ridge.waypoints")).starts_with("QGC WPL 110\n"));
  const Json plan = Json::parse(text_of_file(program.path("ridge.plan")));
  EXPECT_EQ(plan["fileType"], "Plan");
  EXPECT_GT(plan["mission"]["items"].size(), 10U);
}

TEST(ClimbCommand, ReadsJsonAndGeoJsonAndDegrees) {
  const Program program;
  write_text(program.path("points.json"),
             R"({"waypoints": [[0, 0, 0], {"position": [30, 0, 4], "direction": [1, 1],
                 "climb_angle": 0.1}, [60, 40, 12]]})");
  EXPECT_EQ(program.run({"climb", "points.json", "--max-climb-deg", "10", "-o", "a.json"}).code, 0);
  constexpr double rounding = 0x1.0p-44;  // of an enclosure, and of the altitude
  const Json a = Json::parse(text_of_file(program.path("a.json")));
  EXPECT_NEAR(a["promises"]["helix"]["sines"][1][1].get<double>(), std::sin(0.1), rounding);

  write_text(program.path("degrees.csv"),
             "x,y,z,heading_deg,climb_deg\n0,0,0,0,5\n30,10,4,45,5\n40,40,1,90,0\n");
  EXPECT_EQ(program.run({"climb", "degrees.csv", "-o", "b.json"}).code, 3);  // down at +5 degrees
  write_text(program.path("degrees.csv"),
             "x,y,z,heading_deg,climb_deg\n0,0,0,0,5\n30,10,4,45,-5\n40,40,1,90,0\n");
  EXPECT_EQ(program.run({"climb", "degrees.csv", "-o", "b.json"}).code, 0);

  const std::string line = R"({"type": "Feature", "properties": {}, "geometry": {"type":
      "LineString", "coordinates": [[8.0, 46.5, 660], [8.006, 46.501, 700]]}})";
  write_text(program.path("line.geojson"), line);
  const Outcome flown =
      program.run({"climb", "line.geojson", "--geographic", "--datum", "46.5,8,600",
                   "--max-climb-deg", "8", "--turn-radius", "60", "-o", "c.json"});
  ASSERT_EQ(flown.code, 0) << flown.err;
  constexpr double places = 1e-6;  // a hundred times the accuracy of the local plane
  const Json c = Json::parse(text_of_file(program.path("c.json")));
  EXPECT_NEAR(c["segments"][0]["start"][2].get<double>(), 60.0, places);
  expect_refused(program.run({"climb", "line.geojson", "--geographic", "--max-climb-deg", "8"}),
                 "--datum");
}

TEST(ClimbCommand, SaysWhatWouldBeFeasible) {
  const Program program;
  expect_refused(program.run({"climb", "--begin", "0,0,0", "--end", "10,0,8", "--climb-deg", "60"}),
                 "needs at least 17.32050807568", 3);
  expect_refused(program.run({"climb", ridge(), "--climb-deg", "8", "--turn-radius", "60"}),
                 "span 0: climb angle", 3);
  expect_refused(program.run({"climb", "--begin", "0,0,0", "--end", "10,0,8"}),
                 "span 0 is not level: give its angle by --climb-deg");
  expect_refused(
      program.run({"climb", "--begin", "0,0,0", "--end", "10,0,8", "--turn-radius", "-5"}),
      "span 0 is not level");
  expect_refused(program.run({"climb", "--begin", "0,0,0", "--end", "10,0,8", "--max-climb-deg",
                              "45", "--turn-radius", "-5"}),
                 "-5");
  expect_refused(
      program.run({"climb", "--begin", "0,0,0", "--end", "10,0,8", "--max-descent-deg", "5"}),
      "needs a climb angle above 0", 3);
  expect_refused(program.run({"climb", "--begin", "0,0,0", "--end", "10,0,0", "--climb-deg", "5"}),
                 "its altitude changes by 0", 3);
  expect_refused(program.run({"climb", "--begin", "0,0,0"}), "--end X,Y,Z");
  expect_refused(program.run({"climb"}), "give the waypoints");
  expect_refused(program.run({"climb", "-"}, "x,y\n1,2\n3,4\n"), "three columns");
  expect_refused(program.run({"climb", "-"}, "[[0, 0], [1, 1]]"), "three numbers [x, y, z]");
  expect_refused(program.run({"climb", "-"}, R"({"type": "Polygon"})"), "'Point' and 'LineString'");
  expect_refused(
      program.run({"climb", "-"}, R"([{"position": [0, 0, 0], "hading": 1}, [1, 1, 1]])"),
      "hading");
}

}  // namespace
}  // namespace hodograph::test
