// SPDX-License-Identifier: MIT
// hodograph plan, and what check makes of plans that somebody has touched.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/program.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

/// Far above the rounding of coordinates of 80 (about 1e-14), far below what anybody would see.
constexpr double lie = 1e-9;

std::string harbour() {
  return std::string(HODOGRAPH_SOURCE_DIRECTORY) + "/examples/harbour.geojson";
}

void plan(const Program& program) {
  const Outcome made = program.run({"plan", harbour(), "--turn-radius", "3", "--clearance", "1",
                                    "-o", "plan.json", "--report", "plan.html"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.out.find("certified"), std::string::npos) << made.out;
}

TEST(PlanCommand, IsProvenAgainFromTheFilesAlone) {
  const Program program;
  plan(program);
  const Outcome checked = program.run({"check", "plan.json", harbour()});
  EXPECT_EQ(checked.code, 0) << checked.err;
  EXPECT_NE(checked.out.find("clearance"), std::string::npos);
  EXPECT_EQ(checked.out.find("skipped"), std::string::npos) << checked.out;
  const Json promises = Json::parse(text_of_file(program.path("plan.json")))["promises"];
  EXPECT_LE(promises["largest_curvature"]["upper"].get<double>(), 1.0 / 3.0);
  ASSERT_GE(promises["clearance"]["obstacles"].size(), 2U);
  for (const Json& row : promises["clearance"]["obstacles"]) EXPECT_GE(row[1].get<double>(), 1.0);
  EXPECT_EQ(promises["end"], Json::parse("[80.0, 60.0]"));
  // Without the world the clearance is left out, and said so.
  const Outcome alone = program.run({"check", "plan.json"});
  EXPECT_EQ(alone.code, 0);
  EXPECT_NE(alone.out.find("skipped  clearance"), std::string::npos) << alone.out;
}

TEST(PlanCommand, NoCoefficientCanBeMovedUnseen) {
  const Program program;
  plan(program);
  const Json document = Json::parse(text_of_file(program.path("plan.json")));
  int lies = 0;
  const auto expect_found = [&](const Json& touched, const std::string& what) {
    write_text(program.path("lie.json"), touched.dump());
    const Outcome outcome = program.run({"check", "lie.json", harbour()});
    EXPECT_EQ(outcome.code, 2) << what << "\n" << outcome.out;
    ++lies;
  };
  for (std::size_t k = 0; k < document["segments"].size(); ++k) {
    const std::string at = "/segments/" + std::to_string(k);
    for (const char* place : {"/start/0", "/start/1", "/preimage/0/0", "/preimage/0/1",
                              "/preimage/1/0", "/preimage/1/1", "/preimage/2/0", "/preimage/2/1"}) {
      Json touched = document;
      Json& number = touched[Json::json_pointer(at + place)];
      number = number.get<double>() + lie;
      expect_found(touched, at + place);
    }
  }
  for (const char* place :
       {"/promises/clearance/obstacles/0/1", "/promises/largest_curvature/lower"}) {
    Json touched = document;
    Json& number = touched[Json::json_pointer(place)];
    number = number.get<double>() + lie;
    expect_found(touched, place);
  }
  Json fewer = document;
  fewer["promises"]["clearance"]["obstacles"].erase(0);
  expect_found(fewer, "an obstacle left out");
  Json moved = document;
  moved["promises"]["clearance"]["reach"] = 100.0;
  expect_found(moved, "a larger reach");
  EXPECT_GE(lies, 40);
}

TEST(PlanCommand, RefusesInOneLine) {
  const Program program;
  const auto refused = [&](std::vector<std::string> more, const std::string& part, int code = 2) {
    std::vector<std::string> arguments{"plan", harbour()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refused(program.run(arguments), part, code);
  };
  refused({"--turn-radius", "0"}, "turn radius");
  refused({"--turn-radius", "1", "--clearance", "-1"}, "clearance");
  refused({"--turn-radius", "1", "--start", "15,0"}, "west quay");
  refused({"--turn-radius", "1", "--goal", "1000,0"}, "bounds");
  refused({"--turn-radius", "1", "--clearance", "7"}, "walled in", 3);
  refused({"--turn-radius", "300"}, "turn radius", 3);
  refused({}, "--turn-radius");
  write_text(program.path("empty.geojson"), "{\"type\": \"FeatureCollection\", \"features\": []}");
  expect_refused(program.run({"plan", "empty.geojson", "--turn-radius", "1"}), "--start");
  write_text(program.path("torn.geojson"), "{\"type\": \"FeatureCollection\", \"features\": [");
  expect_refused(program.run({"plan", "torn.geojson", "--turn-radius", "1"}), "line 1");
  expect_refused(program.run({"plan", "none.geojson", "--turn-radius", "1"}), "none.geojson");
  EXPECT_FALSE(std::filesystem::exists(program.path("plan.json")));
  // In an empty world the path is a line.
  const Outcome line = program.run(
      {"plan", "empty.geojson", "--turn-radius", "1", "--start", "0,0", "--goal", "3,4"});
  EXPECT_EQ(line.code, 0) << line.err;
  expect_refused(program.run({"check", "plan.json", "torn.geojson"}), "line 1");
}

}  // namespace
}  // namespace hodograph::test
