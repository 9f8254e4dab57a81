// SPDX-License-Identifier: MIT
// Offsets, combs, profiles and facts of planar paths, as a user runs the program.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "hodograph/io/table.hpp"
#include "io/markup_check.hpp"
#include "support/compare.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

/// The closed C² spline through points of the unit circle, to the left round it: ring.json.
void make_ring(const Program& program) {
  constexpr int count = 12;
  std::string points = "x,y\n";
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * i / count;
    points += Json(std::cos(angle)).dump() + "," + Json(std::sin(angle)).dump() + "\n";
  }
  write_text(program.path("ring.csv"), points);
  const Outcome made = program.run({"spline", "ring.csv", "--closed", "-o", "ring.json"});
  ASSERT_EQ(made.code, 0) << made.err;
}

/// An open path that turns to both sides: wave.json.
void make_wave(const Program& program) {
  write_text(program.path("wave.csv"), "x,y\n0,0\n1,2\n2.5,2.2\n3,0.5\n4,0\n5,1.5\n6.5,1\n");
  const Outcome made = program.run({"spline", "wave.csv", "-o", "wave.json"});
  ASSERT_EQ(made.code, 0) << made.err;
}

void make_space_path(const Program& program) {
  const Outcome made =
      program.run({"fit", "--formula", "t, t^2, t^3", "-t", "1e-3", "-o", "space.json"});
  ASSERT_EQ(made.code, 0) << made.err;
}

Table table_of(const std::string& text) { return read_table(text).value(); }

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(OffsetCommand, PointsLieAtTheDistanceToTheLeft) {
  const Program program;
  make_wave(program);
  const Outcome offset =
      program.run({"offset", "wave.json", "-d", "0.25,-0.5", "--format", "csv", "--count", "41"});
  ASSERT_EQ(offset.code, 0) << offset.err;
  const Outcome path = program.run({"sample", "wave.json", "--count", "41", "--with", "frame"});
  const Table points = table_of(offset.out), samples = table_of(path.out);
  ASSERT_EQ(points.row_count(), 82u);
  EXPECT_EQ(points.names, (std::vector<std::string>{"distance", "xi", "x", "y"}));
  const std::size_t normal = samples.column("e2x").value();
  for (std::size_t i = 0; i < points.row_count(); ++i) {
    const std::size_t row = i % 41;
    const double distance = i < 41 ? 0.25 : -0.5;
    EXPECT_EQ(points.at(i, 0), distance);
    EXPECT_EQ(points.at(i, 1), samples.at(row, 0));
    const Vector2<double> expected = {samples.at(row, 2) + distance * samples.at(row, normal),
                                      samples.at(row, 3) + distance * samples.at(row, normal + 1)};
    EXPECT_CLOSE((Vector2<double>{points.at(i, 2), points.at(i, 3)}), expected, 64, 8.0);
  }
}

TEST(OffsetCommand, JsonHasControlPointsAndCertainCusps) {
  const Program program;
  make_wave(program);
  const auto offsets = [&](double distance) {
    const Outcome outcome =
        program.run({"offset", "wave.json", "-d", Json(distance).dump(), "--format", "json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(line_count(outcome.out), 1u);
    return Json::parse(outcome.out);
  };
  const Json answer = offsets(0.25);
  const Json& pieces = answer["offsets"][0]["pieces"];
  EXPECT_EQ(answer["offsets"][0]["degree"], 9);
  EXPECT_EQ(pieces.size(), 6u);
  for (const Json& piece : pieces) {
    EXPECT_EQ(piece["control_points"].size(), 10u);
    EXPECT_EQ(piece["weights"].size(), 10u);
  }
  const Outcome ends =
      program.run({"offset", "wave.json", "-d", "0.25", "--format", "csv", "--count", "2"});
  const Table table = table_of(ends.out);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_CLOSE(pieces.front()["control_points"].front()[axis].get<double>(),
                 table.at(0, 2 + axis), 64, 8.0);
    EXPECT_CLOSE(pieces.back()["control_points"].back()[axis].get<double>(), table.at(1, 2 + axis),
                 64, 8.0);
  }
  // Between the limits there is no cusp, and beyond them there are: the wave's sharpest bends are
  // inside its segments.
  constexpr double little = 0x1p-10;  // far more than the limits' width
  for (const char* side : {"left", "right"}) {
    const double sign = side[0] == 'l' ? 1.0 : -1.0;
    const Json& limit = answer["cusp_free_offsets"][side];
    const double within = sign * limit["lower"].get<double>() * (1 - little);
    const double beyond = sign * limit["upper"].get<double>() * (1 + little);
    EXPECT_TRUE(offsets(within)["offsets"][0]["cusps"].empty());
    EXPECT_FALSE(offsets(beyond)["offsets"][0]["cusps"].empty());
  }
}

TEST(OffsetCommand, TheSuffixTellsTheFormatAndATableIsPrinted) {
  const Program program;
  make_wave(program);
  for (const char* suffix : {"dxf", "svg", "csv", "json", "DXF"}) {
    const std::string file = std::string("offsets.") + suffix;
    const Outcome outcome = program.run({"offset", "wave.json", "-d", "0.1,2", "-o", file});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(outcome.out.ends_with("wrote " + file + "\n")) << outcome.out;
    EXPECT_NE(outcome.out.find("Cusps"), std::string::npos);
    EXPECT_NE(outcome.out.find("at xi"), std::string::npos);
    EXPECT_NE(outcome.out.find("certified"), std::string::npos);
  }
  const std::string drawing = text_of_file(program.path("offsets.dxf"));
  EXPECT_EQ(drawing, text_of_file(program.path("offsets.DXF")));
  EXPECT_EQ(occurrences(drawing, "\nSPLINE\n"), 2u);  // one object an offset
  EXPECT_EQ(occurrences(drawing, "\noffset 0.1\n"), 2u);
  EXPECT_TRUE(drawing.ends_with("EOF\n"));
  const std::string picture = text_of_file(program.path("offsets.svg"));
  EXPECT_EQ(markup_problem(picture), "");
  EXPECT_NE(picture.find("offset 0.1"), std::string::npos);
  EXPECT_NE(picture.find("cusps"), std::string::npos);
}

TEST(OffsetCommand, FlowsThroughPipes) {
  const Program program;
  make_wave(program);
  const Outcome outcome = program.shell(
      "cat wave.json | hodograph offset - -d -0.1 --format dxf 2>table.txt | tail -n 1");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "EOF\n");
  EXPECT_NE(text_of_file(program.path("table.txt")).find("-0.1"), std::string::npos);
}

TEST(OffsetCommand, RefusesInOneLineAndLeavesNoFile) {
  const Program program;
  make_wave(program);
  make_space_path(program);
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& part) {
    std::vector<std::string> all = {"offset"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    expect_refused(program.run(all), part);
  };
  refused({"space.json", "-d", "1", "-o", "x.svg"}, "in space");
  refused({"wave.json", "-d", "0", "-o", "x.svg"}, "distance is 0");
  refused({"wave.json", "-d", "1,nan", "-o", "x.svg"}, "finite");
  refused({"wave.json", "-d", "1e308", "-o", "x.dxf"}, "range of numbers");
  refused({"wave.json", "-d", "1", "-o", "x.png"}, "--format");
  refused({"wave.json", "-d", "1"}, "--format");
  refused({"wave.json", "-o", "x.svg"}, "--distance");
  refused({"wave.json", "-d", "one", "-o", "x.svg"}, "one");
  refused({"wave.json", "-d", "1", "-o", "no/such/folder.svg"}, "no/such");
  for (const auto& entry : std::filesystem::directory_iterator(program.path(""))) {
    EXPECT_FALSE(entry.path().filename().string().starts_with("x.")) << entry.path();
  }
}

TEST(PlotCommand, DrawsCombsProfilesAndOffsets) {
  const Program program;
  make_wave(program);
  const auto drawn = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = {"plot", "wave.json"};
    all.insert(all.end(), more.begin(), more.end());
    const Outcome outcome = program.run(all);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(markup_problem(outcome.out), "");
    EXPECT_EQ(outcome.out.find("nan"), std::string::npos);
    return outcome.out;
  };
  const std::string comb = drawn({"--view", "comb", "--comb-scale", "0.5"});
  EXPECT_NE(comb.find("hg-thin"), std::string::npos);
  EXPECT_NE(comb.find("teeth of 0.5"), std::string::npos);
  EXPECT_NE(drawn({"--view", "comb", "--offset", "-0.1"}).find("offset -0.1"), std::string::npos);
  const std::string profile = drawn({"--view", "profile"});
  for (const char* part : {"extremes", "inflections", "largest", "smallest"}) {
    EXPECT_NE(profile.find(part), std::string::npos) << part;
  }
  EXPECT_NE(drawn({"--offset", "1.5"}).find("cusps"), std::string::npos);
  EXPECT_NE(drawn({"--offset", "-2,-1,1,2,3"}).find("offsets to the left"), std::string::npos);
}

TEST(PlotCommand, RefusesOptionsOfOtherPictures) {
  const Program program;
  ASSERT_EQ(program.run({"spline", "-"}, "0,0\n1,1\n2,0\n").code, 0);
  expect_refused(program.run({"plot", "path.json", "--view", "xz"}), "in the plane");
  expect_refused(program.run({"plot", "path.json", "--comb-scale", "2"}), "comb");
  expect_refused(program.run({"offset", "path.json", "-d", "1", "--format", "svg", "-n", "9"}),
                 "--count");
}

TEST(PlotCommand, RefusesPlanarPicturesOfPathsInSpace) {
  const Program program;
  make_space_path(program);
  make_wave(program);
  expect_refused(program.run({"plot", "space.json", "--view", "comb"}), "in space");
  expect_refused(program.run({"plot", "space.json", "--view", "profile"}), "in space");
  expect_refused(program.run({"plot", "space.json", "--offset", "1"}), "in space");
  expect_refused(program.run({"plot", "wave.json", "--offset", "0"}), "distance is 0");
  expect_refused(program.run({"plot", "wave.json", "--offset", "1", "--view", "profile"}),
                 "profile");
  expect_refused(program.run({"plot", "wave.json", "--view", "comb", "--comb-scale", "-1"}), "-1");
}

TEST(InspectCommand, TellsHowAPlanarPathTurnsAndWhatItEncloses) {
  const Program program;
  make_ring(program);
  const Outcome json = program.run({"inspect", "ring.json", "--json"});
  ASSERT_EQ(json.code, 0) << json.err;
  const Json facts = Json::parse(json.out)["planar"];
  const auto contains = [](const Json& range, double value) {
    return range["lower"].get<double>() <= value && value <= range["upper"].get<double>();
  };
  // 2π within the two doubles around it: the enclosure is a few roundings wide.
  constexpr double round = 6.283185307179586;
  EXPECT_TRUE(contains(facts["rotation_index"], round)) << facts["rotation_index"];
  // Twelve points leave the circle by some 1e-5; its area and energy are π and 2π.
  constexpr double near_circle = 0x1p-8;
  EXPECT_NEAR(facts["signed_area"]["lower"].get<double>(), round / 2, near_circle);
  EXPECT_NEAR(facts["bending_energy"]["upper"].get<double>(), round, near_circle);
  EXPECT_TRUE(facts["inflections"].empty());
  EXPECT_TRUE(facts["cusp_free_offsets"]["right"]["upper"].is_null());  // it never turns right
  const Outcome text = program.run({"inspect", "ring.json"});
  for (const char* row :
       {"rotation index in", "absolute rotation in", "bending energy in", "signed area in",
        "smallest curvature in", "largest curvature in", "inflections", "any to the right"}) {
    EXPECT_NE(text.out.find(row), std::string::npos) << row << "\n" << text.out;
  }
  EXPECT_NE(text.out.find(facts["largest_curvature"]["upper"].dump()), std::string::npos);

  make_wave(program);
  const Outcome open = program.run({"inspect", "wave.json"});
  EXPECT_EQ(open.out.find("signed area"), std::string::npos);
  EXPECT_NE(open.out.find("inflections"), std::string::npos);
  EXPECT_NE(open.out.find("at xi"), std::string::npos);
  make_space_path(program);
  EXPECT_EQ(program.run({"inspect", "space.json"}).out.find("inflections"), std::string::npos);
  EXPECT_FALSE(
      Json::parse(program.run({"inspect", "space.json", "--json"}).out).contains("planar"));
}

}  // namespace
}  // namespace hodograph::test
