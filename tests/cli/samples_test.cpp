// SPDX-License-Identifier: MIT
// The sample worlds and swarms of data/: made by their script, planned, and proven.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/program.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

const std::string root = HODOGRAPH_SOURCE_DIRECTORY;
std::string sample(const std::string& name) { return root + "/data/" + name; }

TEST(Samples, AreWhatTheirScriptMakes) {
  const Program program;
  const Outcome outcome = program.shell("python3 -B '" + root + "/tools/make_samples.py' --check");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  // A check that could not fail would be none.
  const Outcome empty = program.shell("mkdir none && python3 -B '" + root +
                                      "/tools/make_samples.py' --check --to none");
  EXPECT_EQ(empty.code, 1);
  EXPECT_EQ(line_count(empty.err), 10U) << empty.err;
}

struct PlannedWorld {
  std::vector<std::string> arguments;
  double largest_curvature, clearance;
  std::size_t fewest_segments;
};

TEST(Samples, AreWorldsThatArePlannedAndProven) {
  const Program program;
  const std::vector<PlannedWorld> worlds = {
      {{sample("obstacle_field.geojson"), "--turn-radius", "0.2", "--clearance", "0.05"},
       5,
       0.05,
       9},
      {{sample("obstacle_field.geojson"), "--turn-radius", "0.2", "--corners", "largest"}, 5, 0, 9},
      {{sample("intricate.geojson"), "--turn-radius", "0.2"}, 5, 0, 25},
      {{sample("city.geojson"), "--turn-radius", "4", "--clearance", "1", "--width", "2"},
       0.25,
       2,
       3},
      {{sample("stars.geojson"), "--turn-radius", "0.3", "--clearance", "0.05"}, 1 / 0.3, 0.05, 15},
  };
  for (const PlannedWorld& world : worlds) {
    std::vector<std::string> arguments = {"plan"};
    arguments.insert(arguments.end(), world.arguments.begin(), world.arguments.end());
    arguments.insert(arguments.end(), {"-o", "plan.json"});
    const Outcome made = program.run(arguments);
    ASSERT_EQ(made.code, 0) << world.arguments[0] << ": " << made.err;
    const Json document = Json::parse(text_of_file(program.path("plan.json")));
    EXPECT_GE(document["segments"].size(), world.fewest_segments) << world.arguments[0];
    EXPECT_LE(document["promises"]["largest_curvature"]["upper"].get<double>(),
              world.largest_curvature);
    for (const Json& row : document["promises"]["clearance"]["obstacles"]) {
      EXPECT_GE(row[1].get<double>(), world.clearance);
    }
    const Outcome checked = program.run({"check", "plan.json", world.arguments[0]});
    EXPECT_EQ(checked.code, 0) << checked.out;
  }
}

TEST(Samples, AreSwarmsThatKeepTheirDistances) {
  const Program program;
  const std::pair<const char*, std::size_t> swarms[] = {
      {"crossing_pair.json", 1}, {"six.json", 15}, {"twenty.json", 190}, {"mixed.json", 6}};
  for (const auto& [name, pairs] : swarms) {
    const Outcome made = program.run({"swarm", sample(name), "--json", "--closest", "1000"});
    ASSERT_EQ(made.code, 0) << name << ": " << made.err;
    const Json answer = Json::parse(made.out);
    EXPECT_TRUE(answer["conflicts"].empty()) << name;
    ASSERT_EQ(answer["closest"].size(), pairs) << name;
  }
  // S 12.5 % above the distance, and 1 % of S.
  const Json six = Json::parse(program.run({"swarm", sample("six.json"), "--json"}).out);
  constexpr double last_digit = 1e-4;  // of the coordinates given, hence of their distances
  for (const Json& vehicle : six["vehicles"]) {
    EXPECT_NEAR(vehicle["length"].get<double>(), 1.125, 2.0 * last_digit);
  }
  EXPECT_GE(six["closest"][0]["distance"]["lower"].get<double>(), 0.01125);
}

TEST(Samples, CompareAsTheFiguresDo) {
  const Program program;
  for (const char* name : {"obstacle_field.geojson", "intricate.geojson"}) {
    const Outcome made =
        program.run({"batch", "-"}, R"({"request": "plan", "world_file": ")" + sample(name) +
                                        R"(", "turn_radius": 0.2, "compare": true})" + "\n");
    const Json answer = Json::parse(made.out);
    ASSERT_TRUE(answer["ok"].get<bool>()) << made.out.substr(0, 300);
    const Json& result = answer["result"];
    const double corners = result["arc_length"]["upper"], polyline = result["polyline_length"];
    EXPECT_LT(corners, polyline);  // rounding shortens
    ASSERT_EQ(result["compared"].size(), 2U);
    for (const Json& rule : result["compared"]) {
      EXPECT_GT(rule["arc_length"]["lower"].get<double>(), polyline) << rule["rule"];
      EXPECT_GT(rule["curvature_jump"].get<double>(), 0.0);
      EXPECT_EQ(rule["continuity"]["frame"], 0);  // G1, no more
      EXPECT_TRUE(rule["document"].contains("segments"));
    }
  }
}

}  // namespace
}  // namespace hodograph::test
