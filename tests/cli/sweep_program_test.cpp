// SPDX-License-Identifier: MIT
// hodograph sweep and the request "sweep", as a user runs them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>

#include "cli/program.hpp"
#include "support/compare.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;
constexpr double pi = std::numbers::pi;

/// A straight path of length 2.
const char* const straight =
    R"({"format": "hodograph-path", "version": 1, "algebra": "quaternion", "preimage_degree": 0, )"
    R"("closed": false, "knots": [0, 2], )"
    R"("segments": [{"start": [0, 0, 0], "preimage": [[1, 0, 0, 0]]}]})";

Json mesh_facts(const Program& program, const std::string& members) {
  const Outcome outcome = program.run({"batch", "-"}, R"({"request": "sweep", )" + members + "}\n");
  const Json answer = Json::parse(outcome.out);
  EXPECT_TRUE(answer["ok"].get<bool>()) << outcome.out;
  return answer["result"];
}

/// The volume of a binary STL, by the divergence theorem.
double stl_volume(const std::string& text) {
  std::uint32_t count = 0;
  std::memcpy(&count, text.data() + 80, 4);
  EXPECT_EQ(text.size(), 84 + 50 * std::size_t{count});
  double sum = 0.0;
  for (std::uint32_t t = 0; t < count; ++t) {
    float x[9];
    std::memcpy(x, text.data() + 84 + 50 * std::size_t{t} + 12, sizeof x);
    sum += x[0] * (x[4] * x[8] - x[5] * x[7]) - x[1] * (x[3] * x[8] - x[5] * x[6]) +
           x[2] * (x[3] * x[7] - x[4] * x[6]);
  }
  return sum / 6.0;
}

TEST(ProgramSweep, WritesEveryMeshFormatAndAPage) {
  const Program program;
  write_text(program.path("path.json"), straight);
  for (const char* file : {"tube.stl", "tube.obj", "tube.glb"}) {
    const Outcome outcome = program.run(
        {"sweep", "path.json", "--circle", "0.5", "-t", "0.001", "-o", file, "--report", "t.html"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("closed, manifold, oriented, Euler characteristic 2"),
              std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("none, certified"), std::string::npos);
    EXPECT_FALSE(text_of_file(program.path(file)).empty());
    const std::string page = text_of_file(program.path("t.html"));
    EXPECT_NE(page.find("<svg"), std::string::npos);
    EXPECT_EQ(page.find("nan"), std::string::npos);
  }
  const double volume = stl_volume(text_of_file(program.path("tube.stl")));
  const double tolerance = 0.001;
  EXPECT_LT(volume, pi * 0.25 * 2);
  EXPECT_GT(volume, pi * 0.25 * 2 - tolerance * 2 * pi * 0.5 * 2);
}

TEST(ProgramSweep, WritesTracksAndTubularFamilies) {
  const Program program;
  write_text(program.path("path.json"), straight);
  const Outcome track = program.run({"sweep", "path.json", "--track", "0.5,0", "-o", "-"});
  EXPECT_EQ(track.code, 0) << track.err;
  EXPECT_NE(track.out.find("\"control_points\": [[0, 0.5, 0], [2, 0.5, 0]]"), std::string::npos)
      << track.out;
  EXPECT_EQ(program.run({"sweep", "path.json", "--track", "0.5,0", "-o", "t.csv"}).code, 0);
  EXPECT_NE(text_of_file(program.path("t.csv")).find("\n2,2,0.5,0\n"), std::string::npos);
  // A straight line of length 2 carried up by 3: a rectangle.
  const Outcome family =
      program.run({"sweep", "path.json", "--along", "0,0,0,0,0,3", "-o", "wall.obj"});
  EXPECT_EQ(family.code, 0) << family.err;
  EXPECT_NE(family.out.find("a tubular family"), std::string::npos);
  EXPECT_NE(family.out.find("Area                 6\n"), std::string::npos) << family.out;
  // A loop out of any plane, carried, is free of contact with itself; carried nowhere it is not.
  ASSERT_EQ(program.run({"loop", "--xi", "1", "--psi", "2", "-o", "loop.json"}).code, 0);
  const auto carried = [&](const char* along) {
    return program.run({"sweep", "loop.json", "--along", along, "-o", "vase.obj"}).out;
  };
  EXPECT_NE(carried("0,0,0,0,0,2").find("none, certified"), std::string::npos);
  EXPECT_NE(carried("0,0,0,0,0,0").find("not excluded, undecided"), std::string::npos);
  expect_refused(program.run({"sweep", "path.json", "--along", "0,0,0,1", "-o", "x.stl"}),
                 "it takes 3 for each coefficient");
  expect_refused(program.run({"sweep", "path.json", "--track", "1,0", "--circle", "1"}),
                 "several profiles");
  expect_refused(
      program.run({"sweep", "path.json", "--turn", "1,0,0,0", "--frame", "erf", "-o", "x.stl"}),
      "takes no frame");
}

TEST(ProgramSweep, WritesStep) {
  const Program program;
  write_text(program.path("path.json"), straight);
  const Outcome outcome =
      program.run({"sweep", "path.json", "--polygon", "0,0,1,0,1,1,0.5,0.2", "-o", "bar.step"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("6 faces, exact, degree 1 along and 1 round"), std::string::npos)
      << outcome.out;
  const std::string text = text_of_file(program.path("bar.step"));
  EXPECT_EQ(text.substr(0, 13), "ISO-10303-21;");
  EXPECT_NE(text.find("MANIFOLD_SOLID_BREP"), std::string::npos);
}

TEST(ProgramSweep, RefusesInOneLineAndLeavesNoFile) {
  const Program program;
  write_text(program.path("path.json"), straight);
  const auto refused = [&](std::vector<std::string> arguments, const std::string& part) {
    arguments.insert(arguments.begin(), {"sweep", "path.json"});
    const Outcome outcome = program.run(arguments);
    EXPECT_TRUE(outcome.code == 2 || outcome.code == 3) << outcome.code;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_TRUE(text_of_file(program.path("x.stl")).empty());
  };
  refused({"-o", "x.stl"}, "no profile");
  refused({"--circle", "1", "--ellipse", "1,2", "-o", "x.stl"}, "several profiles");
  refused({"--circle", "-1", "-o", "x.stl"}, "radius is -1");
  refused({"--circle", "nan", "-o", "x.stl"}, "");
  refused({"--ellipse", "1,0", "-o", "x.stl"}, "half axis is 0");
  refused({"--polygon", "0,0,1,1,1,0,0,1", "-o", "x.stl"}, "touches or crosses itself");
  refused({"--polygon", "0,0,1,0,2,0", "-o", "x.stl"}, "touches or crosses itself");
  refused({"--polygon", "0,0,1,0,2,0,1", "-o", "x.stl"}, "pairs");
  refused({"--circle", "1", "--scale", "1,0", "-o", "x.stl"}, "scale comes down to 0");
  refused({"--circle", "1", "--scale", "1,-3,1", "-o", "x.stl"}, "scale");
  refused({"--circle", "1", "--frame", "closing", "-o", "x.stl"}, "closed");
  refused({"--circle", "1", "--gamma", "2", "-o", "x.stl"}, "periodic");
  refused({"--circle", "1", "-t", "0", "-o", "x.stl"}, "tolerance is 0");
  refused({"--circle", "1", "-t", "1e-14", "-o", "x.stl"}, "tolerance");
  refused({"--circle", "1", "--scale", "1,2,1", "-t", "1e-12", "-o", "x.obj"}, "triangles");
  refused({"--circle", "1", "-t", "1e-6", "--most-triangles", "100", "-o", "x.stl"}, "more than");
  refused({"--circle", "1", "-o", "x.xyz"}, "does not tell the format");
  refused({"--profile", "path.json", "-o", "x.stl"}, "in space");
  // Nothing is no number; numbers whose squares are none are too large and too small.
  refused({"--circle", "", "-o", "x.stl"}, "a number is missing");
  refused({"--circle", "1", "--scale", "", "-o", "x.stl"}, "a number is missing");
  refused({"--circle", "1e300", "-o", "x.stl"}, "reaches 1e+300");
  refused({"--rectangle", "1e-300,1e-300", "-o", "x.stl"}, "from the path; between");
  refused({"--track", "nan,1", "-o", "x.json"}, "not finite");
  refused({"--track", "inf,0", "-o", "x.csv"}, "not finite");
}

TEST(ProgramSweep, TubesThatMeetThemselvesAreRefusedWithTheRadius) {
  const Program program;
  EXPECT_EQ(program.run({"loop", "--length", "10", "-o", "loop.json"}).code, 0);
  const Outcome wide = program.run({"sweep", "loop.json", "--circle", "3", "-o", "x.stl"});
  EXPECT_EQ(wide.code, 2);
  const std::size_t at = wide.err.find("a radius of at most ");
  ASSERT_NE(at, std::string::npos) << wide.err;
  const std::string radius = wide.err.substr(at + 20, wide.err.find(' ', at + 20) - at - 20);
  // The radius that would do does, and the override makes what was refused.
  EXPECT_EQ(program.run({"sweep", "loop.json", "--circle", radius, "-o", "x.stl"}).code, 0);
  EXPECT_EQ(
      program.run({"sweep", "loop.json", "--circle", "3", "--allow-contact", "-o", "x.stl"}).code,
      0);
}

TEST(ProgramSweep, RequestsTellTheFacts) {
  const Program program;
  const std::string path = std::string(R"("document": )") + straight;
  const Json tube =
      mesh_facts(program, path + R"(, "profile": {"circle": 0.5}, "tolerance": 0.01)");
  EXPECT_TRUE(tube["certainly_free_of_contact"].get<bool>());
  EXPECT_TRUE(tube["tube"]["radius"]["upper"].is_null());
  EXPECT_LE(tube["mesh"]["deviation"].get<double>(), 0.01);
  EXPECT_EQ(tube["patches"]["count"], 4);
  EXPECT_EQ(tube["patches"]["degree_round"], 2);
  const Json bar = mesh_facts(program, path + R"(, "profile": {"rectangle": [1, 2]}, "out": ")" +
                                           program.path("bar.obj") + R"(")");
  EXPECT_EQ(bar["mesh"]["triangles"], 12);
  EXPECT_EQ(bar["mesh"]["volume"], 4.0);
  EXPECT_EQ(bar["mesh"]["area"], 16.0);
  EXPECT_FALSE(text_of_file(program.path("bar.obj")).empty());
  const Json road = mesh_facts(program, path + R"(, "profile": {"ribbon": [0.5, 1]})");
  EXPECT_EQ(road["mesh"]["area"], 3.0);
  EXPECT_EQ(road["mesh"]["boundary_edges"], 4);
  EXPECT_FALSE(road["mesh"].contains("volume"));
  const Json rolled =
      mesh_facts(program, path + R"(, "profile": {"circle": 0.5}, "frame": "rotation-minimising")");
  EXPECT_TRUE(rolled["patches"].is_null());
}

}  // namespace
}  // namespace hodograph::test
