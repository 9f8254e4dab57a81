// SPDX-License-Identifier: MIT
// What plan and swarm write for other programs, and plans beside the rules T1 and T2.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "cli/program.hpp"
#include "hodograph/io/geodesy.hpp"
#include "hodograph/io/geojson.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

std::string harbour() {
  return std::string(HODOGRAPH_SOURCE_DIRECTORY) + "/examples/harbour.geojson";
}
std::string swarm_file() {
  return std::string(HODOGRAPH_SOURCE_DIRECTORY) + "/examples/swarm.json";
}

std::vector<std::vector<std::string>> rows_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}
/// The end of a path that was summed segment by segment: some tens of roundings.
constexpr double end_error = 128.0 * std::numeric_limits<double>::epsilon();

double number(const std::string& cell) { return std::strtod(cell.c_str(), nullptr); }

TEST(PlanExports, AreFilesThatOtherProgramsRead) {
  const Program program;
  std::vector<std::string> arguments = {
      "plan",         harbour(),   "--turn-radius", "3",     "--clearance", "1",         "-o",
      "p.json",       "--geojson", "p.geojson",     "--csv", "p.csv",       "--samples", "101",
      "--crazyswarm", "t.csv",     "--speed",       "5",     "--altitude",  "30"};
  if (has_geodesy()) {
    for (const char* more : {"--qgroundcontrol", "p.plan", "--wpl", "p.txt"}) {
      arguments.emplace_back(more);
    }
    arguments.insert(arguments.end(), {"--datum", "47.4,8.5,400"});
  }
  const Outcome made = program.run(arguments);
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.out.find("within 0.03 of the path, certified"), std::string::npos) << made.out;

  const auto samples = rows_of(text_of_file(program.path("p.csv")));
  ASSERT_EQ(samples.size(), 102U);
  EXPECT_EQ(samples[0][0], "time");
  EXPECT_EQ(number(samples[1][0]), 0.0);
  EXPECT_EQ(number(samples[1][4]), 30.0);
  const Json document = Json::parse(text_of_file(program.path("p.json")));
  const double length = document["promises"]["arc_length"]["upper"];
  EXPECT_NEAR(number(samples.back()[0]), length / 5.0, length * end_error);
  EXPECT_NEAR(number(samples.back()[2]), 80.0, 80.0 * end_error);
  EXPECT_NEAR(number(samples.back()[3]), 60.0, 60.0 * end_error);

  const auto polynomials = rows_of(text_of_file(program.path("t.csv")));
  ASSERT_GT(polynomials.size(), 2U);
  EXPECT_EQ(polynomials[0].size(), 33U);
  EXPECT_EQ(number(polynomials[1][17]), 30.0);  // z^0

  const Json map = Json::parse(text_of_file(program.path("p.geojson")));
  const Json& line = map["features"].back();
  EXPECT_EQ(line["geometry"]["type"], "LineString");
  EXPECT_LE(line["properties"]["largest_curvature"][1].get<double>(), 1.0 / 3.0);
  EXPECT_GE(line["properties"]["clearance"][0].get<double>(), 1.0);
  ASSERT_TRUE(has_geodesy()) << "the tests need GeographicLib (libgeographiclib-dev)";
  const Json plan = Json::parse(text_of_file(program.path("p.plan")));
  const Json& items = plan["mission"]["items"];
  EXPECT_EQ(items[0]["command"], 178);
  EXPECT_EQ(items[0]["params"][1], 5);
  const auto plane = LocalTangentPlane::create({47.4, 8.5, 400});
  const Json& last = items.back()["params"];
  const auto goal = plane->to_local({last[4], last[5], last[6].get<double>() + 400.0});
  constexpr double accuracy = 2e-8;  // not a tolerance: twice what the conversion states
  EXPECT_NEAR(goal->x, 80.0, accuracy);
  EXPECT_NEAR(goal->y, 60.0, accuracy);
  EXPECT_NEAR(goal->z, 30.0, accuracy);
  EXPECT_EQ(line["geometry"]["coordinates"].back(),
            Json({last[5], last[4], 430.0 + last[6].get<double>() - 30.0}));
  EXPECT_EQ(text_of_file(program.path("p.txt")).find("QGC WPL 110\n"), 0U);
}

TEST(MissionRequests, WriteWhatTheOptionsWrite) {
  ASSERT_TRUE(has_geodesy()) << "the tests need GeographicLib (libgeographiclib-dev)";
  const Program program;
  ASSERT_EQ(program
                .run({"plan",
                      harbour(),
                      "--turn-radius",
                      "3",
                      "--clearance",
                      "1",
                      "-o",
                      "p.json",
                      "--qgroundcontrol",
                      "p.plan",
                      "--wpl",
                      "p.txt",
                      "--chord",
                      "0.1",
                      "--datum",
                      "47.4,8.5,400",
                      "--speed",
                      "5",
                      "--acceleration",
                      "2",
                      "--altitude",
                      "30"})
                .code,
            0);
  const std::string flown =
      R"({"request": "mission", "file": "p.json", "chord": 0.1, "datum": [47.4, 8.5, 400], )"
      R"("speed": 5, "acceleration": 2, "altitude": 30)";
  const Outcome outcome =
      program.run({"batch"}, flown + "}\n" + flown + R"(, "format": "wpl"})" + "\n" + flown +
                                 R"(, "acceptance_radius": 3, "out": "r.plan"})" + "\n" + flown +
                                 R"(, "out": "-"})" + "\n");
  std::istringstream lines(outcome.out);
  std::vector<Json> answers;
  for (std::string line; std::getline(lines, line);) answers.push_back(Json::parse(line));
  ASSERT_EQ(answers.size(), 4U);
  EXPECT_EQ(answers[0]["result"]["mission"], text_of_file(program.path("p.plan")));
  EXPECT_EQ(answers[1]["result"]["mission"], text_of_file(program.path("p.txt")));
  EXPECT_EQ(answers[2]["result"]["out"], Json({{"file", "r.plan"}, {"format", "qgroundcontrol"}}));
  const Json plan = Json::parse(text_of_file(program.path("r.plan")));
  EXPECT_EQ(plan["mission"]["items"].size(),
            Json::parse(text_of_file(program.path("p.plan")))["mission"]["items"].size());
  EXPECT_EQ(plan["mission"]["items"].back()["params"][1], 3);
  EXPECT_EQ(answers[3]["fault"]["quantity"], "/out");
}

TEST(PlanExports, AreTheWorldItselfInLocalCoordinates) {
  const Program program;
  const Outcome made = program.run({"plan", harbour(), "--turn-radius", "3", "--clearance", "1",
                                    "-o", "p.json", "--geojson", "p.geojson", "--compare"});
  ASSERT_EQ(made.code, 0) << made.err;
  const auto before = load_world(harbour()), after = load_world(program.path("p.geojson"));
  ASSERT_TRUE(before);
  ASSERT_TRUE(after);
  EXPECT_EQ(before->world.obstacles(), after->world.obstacles());
  EXPECT_EQ(before->goal, after->goal);
  const Json map = Json::parse(text_of_file(program.path("p.geojson")));
  std::size_t lines = 0;
  for (const Json& feature : map["features"]) {
    lines += feature["geometry"]["type"] == "LineString" ? 1U : 0U;
  }
  EXPECT_EQ(lines, 3U);
  // The plan of the file that was written is the same.
  const Outcome again =
      program.run({"plan", "p.geojson", "--turn-radius", "3", "--clearance", "1", "-o", "q.json"});
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(Json::parse(text_of_file(program.path("p.json")))["segments"],
            Json::parse(text_of_file(program.path("q.json")))["segments"]);
}

TEST(PlanExports, RefuseWhatTheyCannotWrite) {
  const Program program;
  const auto refused = [&](std::vector<std::string> more, const std::string& part) {
    std::vector<std::string> arguments = {"plan", harbour(), "--turn-radius", "3", "-o", "p.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refused(program.run(arguments), part);
    EXPECT_FALSE(std::filesystem::exists(program.path("p.json")));
  };
  refused({"--qgroundcontrol", "p.plan"}, "--datum");
  refused({"--wpl", "p.txt", "--datum", "91,0,0"}, "latitude");
  refused({"--geojson", "p.geojson", "--chord", "0"}, "positive");
  refused({"--csv", "p.csv", "--tolerance", "1"}, "--crazyswarm");
  refused({"--crazyswarm", "p.cs", "--speed", ""}, "a number is missing");
  // Below the rounding there is no end to halving.
  const Outcome endless = program.run({"plan", harbour(), "--turn-radius", "3", "-o", "q.json",
                                       "--crazyswarm", "p.cs", "--tolerance", "1e-300"});
  EXPECT_EQ(endless.code, 3) << endless.err;
  EXPECT_NE(endless.err.find("within the rounding"), std::string::npos) << endless.err;
  EXPECT_FALSE(std::filesystem::exists(program.path("p.cs")));
}

TEST(PlanComparison, ShowsWhatTheRulesBreak) {
  const Program program;
  const Outcome made = program.run({"plan", harbour(), "--turn-radius", "3", "--clearance", "1",
                                    "-o", "p.json", "--compare", "--report", "p.html"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.out.find("Rule T1"), std::string::npos) << made.out;
  EXPECT_NE(made.out.find("breaks the clearance"), std::string::npos) << made.out;
  const std::string page = text_of_file(program.path("p.html"));
  for (const char* part : {"rule T1", "rule T2", "grown by 1", "shortest polyline", "limit"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
}

TEST(SwarmExports, AreAMissionForEveryVehicle) {
  const Program program;
  std::vector<std::string> arguments = {"swarm", swarm_file(), "--geojson", "s.geojson",
                                        "--csv", "s.csv",      "--samples", "11"};
  if (has_geodesy()) {
    arguments.insert(arguments.end(), {"--qgroundcontrol", "m", "--wpl", "m", "--datum", "1,2,3"});
  }
  const Outcome made = program.run(arguments);
  ASSERT_EQ(made.code, 0) << made.err;
  const Json map = Json::parse(text_of_file(program.path("s.geojson")));
  EXPECT_EQ(map["features"].size(), 6U);
  const auto samples = rows_of(text_of_file(program.path("s.csv")));
  ASSERT_EQ(samples.size(), 12U);
  EXPECT_EQ(samples[0].size(), 1U + 3U * 6U);
  EXPECT_EQ(samples[0][1], "a.x");
  ASSERT_TRUE(has_geodesy()) << "the tests need GeographicLib (libgeographiclib-dev)";
  for (const char* id : {"a", "b", "c", "d", "e", "f"}) {
    EXPECT_TRUE(std::filesystem::exists(program.path("m/" + std::string(id) + ".plan")));
    EXPECT_TRUE(std::filesystem::exists(program.path("m/" + std::string(id) + ".waypoints")));
  }
}

TEST(MixedSwarm, IsMadeAroundThePathsThatAreGiven) {
  const Program program;
  write_text(program.path("empty.geojson"), R"({"type": "FeatureCollection", "features": []})");
  ASSERT_EQ(program
                .run({"plan", "empty.geojson", "--start", "0.5,-0.5", "--goal", "0.5,0.8",
                      "--turn-radius", "0.2", "-o", "given.json"})
                .code,
            0);
  const auto swarm = [&](const std::string& name, const std::string& altitude) {
    write_text(program.path(name),
               R"({"excess": 0.125, "clearance": 0.02, "vehicles": [
        {"id": "given", "file": "given.json", "altitude": 0.5},
        {"id": "a", "start": {"position": [0, 0.5], "angle": 0},
         "end": {"position": [1, 0], "angle": 0}, "altitude": )" +
                   altitude + "}]}");
  };
  swarm("high.json", "0.75");
  const Outcome above = program.run({"swarm", "high.json"});
  EXPECT_EQ(above.code, 0) << above.out;
  swarm("level.json", "0.5");
  EXPECT_EQ(program.run({"swarm", "level.json"}).code, 3);
  const Outcome apart = program.run({"swarm", "level.json", "--deconflict", "-o", "fleet"});
  ASSERT_EQ(apart.code, 0) << apart.err;
  EXPECT_NE(apart.out.find("path given"), std::string::npos) << apart.out;
  const Json fleet = Json::parse(text_of_file(program.path("fleet/swarm.json")));
  EXPECT_EQ(fleet["vehicles"][0]["departure"], 0);  // the given one stays
  EXPECT_EQ(fleet["vehicles"][1]["altitude"], 0.5);
  EXPECT_EQ(program.run({"swarm", "fleet/swarm.json"}).code, 0);
  const Outcome least = program.run({"swarm", "level.json", "--least", "separated", "--json"});
  ASSERT_EQ(least.code, 0) << least.err;
  const Json answer = Json::parse(least.out);
  EXPECT_TRUE(answer["conflicts"].empty());
  EXPECT_EQ(answer["vehicles"][0]["id"], "given");
  EXPECT_TRUE(answer["vehicles"][1].contains("solution"));
}

TEST(SeparationCommand, CountsAltitudes) {
  const Program program;
  ASSERT_EQ(program.run({"swarm", swarm_file(), "-o", "fleet"}).code, 0);
  const auto least = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"separation", "fleet/a.json", "fleet/b.json", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = program.run(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out)["distance"]["lower"].get<double>();
  };
  const double level = least({}), above = least({"--altitude", "0,3"});
  constexpr double width = 1e-8;  // not a tolerance: of the enclosures, 1e-9 of the length
  EXPECT_NEAR(above, std::hypot(level, 3.0), width);
  EXPECT_NEAR(least({"--altitude", "2"}), level, width);
  EXPECT_NEAR(least({"--altitude", "0,3", "--ellipsoid", "3"}), std::hypot(level, 1.0), width);
}

}  // namespace
}  // namespace hodograph::test
