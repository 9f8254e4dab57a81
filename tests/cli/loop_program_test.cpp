// SPDX-License-Identifier: MIT
// Closed loops, as a user runs the program.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.hpp"
#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/io/document.hpp"
#include "support/compare.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

SpatialPath<3> path_in(const std::string& file) {
  const auto document = load_document(file);
  EXPECT_TRUE(document) << document.fault().sentence;
  const auto* path = document->path.get_if<SpatialPath<3>>();
  EXPECT_NE(path, nullptr);
  return *path;
}

TEST(LoopCommand, MakesTheLoopThatIsAskedFor) {
  const Program program;
  const Outcome made =
      program.run({"loop", "--length", "12", "--start", "1,2,30", "--direction", "0,1,0", "--xi",
                   "1", "--psi-deg", "108", "-o", "loop.json", "--report", "loop.html"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.out.find("position C2"), std::string::npos) << made.out;
  const auto path = path_in(program.path("loop.json"));
  constexpr double radians = 3.141592653589793 / 180.0;
  const auto expected =
      closed_loop({1.0, 108.0 * radians}, {12.0, {1, 2, 30}, level_frame({0, 1, 0}).value()})
          .value();
  EXPECT_EQ(path, expected);
  const Outcome checked = program.run({"check", "loop.json"});
  EXPECT_EQ(checked.code, 0) << checked.out << checked.err;
  EXPECT_NE(text_of_file(program.path("loop.html")).find("Torsion"), std::string::npos);
}

TEST(LoopCommand, MakesPlanarAndLimitMembers) {
  const Program program;
  ASSERT_EQ(program.run({"loop", "-o", "oval.json"}).code, 0);
  const auto oval = path_in(program.path("oval.json"));
  for (int i = 0; i <= 16; ++i) EXPECT_EQ(oval.position(i / 16.0).z, 0.0);
  ASSERT_EQ(program.run({"loop", "--limit", "negative", "--psi", "1", "-o", "limit.json"}).code, 0);
  EXPECT_EQ(path_in(program.path("limit.json")).speed(0.0), 0.0);
  EXPECT_EQ(program.run({"check", "oval.json"}).code, 0);
  EXPECT_EQ(program.run({"check", "limit.json"}).code, 0);
}

TEST(LoopCommand, ChoosesALoop) {
  const Program program;
  const Outcome near = program.run({"loop", "--near", "0.1,0.3,0.1", "-o", "near.json"});
  ASSERT_EQ(near.code, 0) << near.err;
  EXPECT_NE(near.out.find("Chosen"), std::string::npos);
  const Outcome distance = program.run(
      {"batch", "-"}, R"({"request": "nearest", "file": "near.json", "point": [0.1, 0.3, 0.1]})"
                      "\n");
  EXPECT_EQ(distance.code, 0) << distance.err;
  const Json answer = Json::parse(distance.out);
  ASSERT_TRUE(answer["ok"].get<bool>()) << distance.out;
  constexpr double newton = 0x1.0p-30;  // some steps of Newton leave about rounding
  EXPECT_LE(answer["result"]["distance"]["upper"].get<double>(), newton);
  const Outcome none = program.run({"loop", "--within=-0.1,-0.1,-0.1,0.1,0.1,0.1"});
  EXPECT_EQ(none.code, 3);
  EXPECT_NE(none.err.find("sticks out by"), std::string::npos) << none.err;
}

TEST(LoopCommand, RefusesInOneLine) {
  const Program program;
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"--psi", "108"},
                                             {"--length", "0"},
                                             {"--length", "nan"},
                                             {"--xi", "inf"},
                                             {"--direction", "0,0,0"},
                                             {"--normal", "1,0,0"},
                                             {"--near", "1,nan,2"},
                                             {"--near", "1e308,1e308,0"},
                                             {"--xi", ""},
                                             {"--start", "1,,2"},
                                             {"--within", "1,1,1,2,2,2"},
                                             {"--limit", "positive", "--for", "least-energy"}}) {
    std::vector<std::string> all = {"loop"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = program.run(all);
    EXPECT_EQ(outcome.code, 2) << words[0] << " " << words[1] << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST(LoopRequest, AnswersWithTheSameLoop) {
  const Program program;
  const Outcome outcome = program.run(
      {"batch", "-"},
      R"({"request": "loop", "length": 3, "xi": -0.5, "psi": 2, "normal": [0, 0, 1], "roll": 0.25})"
      "\n"
      R"({"request": "loop", "for": "extents", "extents": [0.3, 0.3, 0.1]})"
      "\n"
      R"({"request": "loop", "for": "near"})"
      "\n"
      R"({"request": "loop", "point": [1, 2, 3]})"
      "\n"
      R"({"request": "loop", "within": [[1, 2, 3]]})"
      "\n");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  std::vector<Json> answers;
  for (std::string line; std::getline(lines, line);) answers.push_back(Json::parse(line));
  ASSERT_EQ(answers.size(), 5U);
  const Json& first = answers[0]["result"];
  const auto expected = closed_loop_control_points({-0.5, 2.0}).value();
  const auto normal = frame_towards({1, 0, 0}, {0, 0, 1}).value();
  const auto frame = normal * Roll<double>{std::cos(0.125), std::sin(0.125)};
  for (std::size_t i = 0; i < 8; ++i) {
    const auto p = 3.0 * sandwich(frame, expected[i]);
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_CLOSE(first["control_points"][i][j].get<double>(), p[j], 256.0, 3.0);
    }
  }
  EXPECT_GT(first["bending_energy"]["lower"].get<double>(), 0.0);
  EXPECT_TRUE(answers[1]["ok"].get<bool>());
  EXPECT_LE(answers[1]["result"]["chosen"]["value"]["upper"].get<double>(), 0.02);
  for (std::size_t i = 2; i < 5; ++i) EXPECT_FALSE(answers[i]["ok"].get<bool>());
}

TEST(LoopCommand, TheLoopIsInspectedForEnergyAndTorsion) {
  const Program program;
  ASSERT_EQ(program.run({"loop", "--xi", "1", "--psi", "2", "-o", "loop.json"}).code, 0);
  const Outcome shown = program.run({"inspect", "loop.json"});
  EXPECT_EQ(shown.code, 0) << shown.err;
  for (const char* row : {"bending energy in", "smallest torsion in", "largest torsion in"}) {
    EXPECT_NE(shown.out.find(row), std::string::npos) << row;
  }
  const Outcome json = program.run({"inspect", "loop.json", "--json"});
  EXPECT_NE(json.out.find("\"spatial\": {\"bending_energy\""), std::string::npos) << json.out;
  write_text(program.path("requests.jsonl"),
             "{\"request\": \"analyse\", \"file\": \"loop.json\"}\n");
  const Outcome batch = program.run({"batch", "requests.jsonl"});
  EXPECT_NE(batch.out.find("\"largest_torsion\""), std::string::npos) << batch.out;
}

}  // namespace
}  // namespace hodograph::test
