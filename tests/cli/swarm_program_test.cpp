// SPDX-License-Identifier: MIT
// hodograph separation and hodograph swarm as a user runs them: certified distances, exit codes,
// files, trajectories, and what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

// What is asked of an enclosure, relative to paths of length 1 (SeparationGoal), and as much again
// for rounding.
constexpr double enclosure_width = 2.0 * 0x1.0p-30;
// Where a distance is least to that width it is flat: times and places are known to its root.
constexpr double time_width = 0x1.0p-13;

/// A straight path of unit length in a direction of the plane, half its angle from the x axis.
std::string line_document(double x, double y, double half_angle) {
  const Json document = {
      {"format", "hodograph-path"},
      {"version", 1},
      {"algebra", "complex"},
      {"preimage_degree", 0},
      {"closed", false},
      {"knots", {0, 1}},
      {"segments",
       {{{"start", {x, y}}, {"preimage", {{std::cos(half_angle), std::sin(half_angle)}}}}}}};
  return document.dump();
}

/// The same along the x axis of space, at a height.
std::string high_line_document(double z) {
  const Json document = {{"format", "hodograph-path"},
                         {"version", 1},
                         {"algebra", "quaternion"},
                         {"preimage_degree", 0},
                         {"closed", false},
                         {"knots", {0, 1}},
                         {"segments", {{{"start", {0, 0, z}}, {"preimage", {{1, 0, 0, 0}}}}}}};
  return document.dump();
}

/// Paths (t, 0) and (1/4, t - 1/2): closest at t = 3/8, √2/8 apart.
void write_crossing(const Program& program) {
  write_text(program.path("east.json"), line_document(0.0, 0.0, 0.0));
  write_text(program.path("north.json"), line_document(0.25, -0.5, std::acos(-1.0) / 4.0));
}

void copy_swarm(const Program& program) {
  ASSERT_TRUE(
      std::filesystem::copy_file(std::string(HODOGRAPH_SOURCE_DIRECTORY) + "/examples/swarm.json",
                                 program.path("swarm.json")));
}

Json answer(const Program& program, const std::vector<std::string>& arguments) {
  const Outcome outcome = program.run(arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return Json::parse(outcome.out);
}

TEST(ProgramSeparation, EnclosesWhatIsKnown) {
  const Program program;
  write_crossing(program);
  const Json json = answer(program, {"separation", "east.json", "north.json", "--json"});
  const double exact = std::sqrt(2.0) / 8.0;
  EXPECT_LE(json["distance"]["lower"].get<double>(), exact);
  EXPECT_GE(json["distance"]["upper"].get<double>(), exact);
  EXPECT_LE(json["distance"]["upper"].get<double>() - json["distance"]["lower"].get<double>(),
            enclosure_width);
  EXPECT_LE(json["time_range"]["lower"].get<double>(), 0.375);
  EXPECT_GE(json["time_range"]["upper"].get<double>(), 0.375);
  // The second twice as fast and an eighth later: (1/4, 2t - 3/4), closest at t = 7/20.
  const Json later = answer(program, {"separation", "east.json", "north.json", "--speed", "1,2",
                                      "--start", "0,0.125", "--json"});
  const double closest = std::hypot(0.1, 0.05);
  EXPECT_LE(later["distance"]["lower"].get<double>(), closest);
  EXPECT_GE(later["distance"]["upper"].get<double>(), closest);
  EXPECT_LE(later["time_range"]["lower"].get<double>(), 0.35);
  EXPECT_GE(later["time_range"]["upper"].get<double>(), 0.35);
  // The same by the arrival, and with a check by steps.
  const Json arriving =
      answer(program, {"separation", "east.json", "north.json", "--start", "0,0.125", "--arrival",
                       "1,0.625", "--step", "0.01", "--json"});
  EXPECT_GE(arriving["stepped"]["sampled"].get<double>(),
            arriving["distance"]["lower"].get<double>());
  EXPECT_LE(arriving["stepped"]["distance"]["lower"].get<double>(), closest);
  EXPECT_EQ(arriving["distance"], later["distance"]);
}

TEST(ProgramSeparation, AnswersWithItsExitCode) {
  const Program program;
  write_crossing(program);
  const std::vector<std::string> question = {"separation", "east.json", "north.json", "--at-least"};
  auto with = [&](const std::string& distance) {
    std::vector<std::string> all = question;
    all.push_back(distance);
    return program.run(all);
  };
  const Outcome yes = with("0.1767");
  EXPECT_EQ(yes.code, 0) << yes.err;
  EXPECT_NE(yes.out.find("Keeps 0.1767"), std::string::npos) << yes.out;
  EXPECT_NE(yes.out.find("yes"), std::string::npos);
  const Outcome no = with("0.1768");
  EXPECT_EQ(no.code, 3);
  EXPECT_EQ(line_count(no.err), 1u) << no.err;
  EXPECT_NE(no.err.find("0.1768 is asked for"), std::string::npos) << no.err;
  EXPECT_NE(no.out.find("Closer"), std::string::npos) << no.out;
}

TEST(ProgramSeparation, HeightsMayCountLess) {
  const Program program;
  write_text(program.path("low.json"), high_line_document(0.0));
  write_text(program.path("high.json"), high_line_document(0.75));
  const auto distance = [&](const std::string& factor) {
    return answer(program, {"separation", "low.json", "high.json", "--ellipsoid", factor, "--json"})
        .at("distance");
  };
  for (const auto& [factor, expected] : {std::pair("1", 0.75), std::pair("3", 0.25)}) {
    const Json found = distance(factor);
    EXPECT_LE(found["lower"].get<double>(), expected);
    EXPECT_GE(found["upper"].get<double>(), expected);
  }
}

TEST(ProgramSeparation, TrapezoidsAreSlower) {
  const Program program;
  write_crossing(program);
  // From rest at acceleration 2 to speed 1 takes 1/2 and the distance 1/4; so does the braking.
  const Json json = answer(program, {"separation", "east.json", "north.json", "--acceleration", "2",
                                     "--json", "--at-least", "0.01"});
  const double time = json["time"].get<double>(), s = json["first"][0].get<double>();
  EXPECT_NEAR(s, 0.375, time_width);           // the place does not depend on the common timing
  EXPECT_NEAR(time, 0.5 + 0.125, time_width);  // 1/4 by then 1/2, the rest at speed 1
  EXPECT_EQ(json["keeps"], "yes");
  EXPECT_TRUE(json["passages"].empty());
}

TEST(ProgramSeparation, DrawsTheDistance) {
  const Program program;
  write_crossing(program);
  const Outcome outcome = program.run(
      {"separation", "east.json", "north.json", "--at-least", "0.1", "--svg", "distance.svg"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("wrote distance.svg"), std::string::npos);
  EXPECT_NE(text_of_file(program.path("distance.svg")).find("least 0.176777"), std::string::npos);
}

TEST(ProgramSeparation, RefusesWhatMakesNoSense) {
  const Program program;
  write_crossing(program);
  const auto refused = [&](std::vector<std::string> more, const std::string& part) {
    std::vector<std::string> all = {"separation", "east.json", "north.json"};
    all.insert(all.end(), more.begin(), more.end());
    expect_refused(program.run(all), part);
  };
  refused({"--speed", "0"}, "speed");
  refused({"--speed", "1,2,3"}, "--speed");
  refused({"--speed", "1", "--arrival", "2"}, "--arrival");
  refused({"--arrival", "-1"}, "-1");
  refused({"--deceleration", "1"}, "--acceleration");
  refused({"--ellipsoid", "0"}, "ellipsoid");
  refused({"--ellipsoid", "nan"}, "ellipsoid");
  refused({"--at-least", "-1"}, "-1");
  refused({"--step", "0"}, "step");
  refused({"--stands", "never", "--start", "0,5"}, "common time");
  refused({"--stands", "sometimes"}, "sometimes");
  expect_refused(program.run({"separation", "east.json", "nothing.json"}), "nothing.json");
}

TEST(ProgramSwarm, SixVehiclesArriveTogetherAndCertainlyApart) {
  const Program program;
  copy_swarm(program);
  const Outcome made = program.run(
      {"swarm", "swarm.json", "-o", "fleet", "--matrix", "matrix.csv", "--svg", "swarm.svg"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(made.err, "");
  EXPECT_NE(made.out.find("All arrive at 1.125"), std::string::npos) << made.out;
  EXPECT_NE(made.out.find("All 15 pairs keep 0.01125, certified"), std::string::npos) << made.out;
  for (const char* name : {"a", "b", "c", "d", "e", "f"}) {
    const std::string file = std::string("fleet/") + name + ".json";
    const Json document = Json::parse(text_of_file(program.path(file)));
    const Json& length = document["promises"]["arc_length"];
    EXPECT_LE(length["lower"].get<double>(), 1.125);  // 12.5 % above the distance
    EXPECT_GE(length["upper"].get<double>(), 1.125);
    EXPECT_LE(document["promises"]["largest_curvature"]["upper"].get<double>(), 8.0);
    EXPECT_EQ(program.run({"check", file}).code, 0);
  }
  // The matrix is that of the pairs one by one.
  const auto rows = lines_of(text_of_file(program.path("matrix.csv")));
  ASSERT_EQ(rows.size(), 7u);
  EXPECT_EQ(rows[0], "vehicle,a,b,c,d,e,f");
  const Json pair = answer(
      program, {"separation", "fleet/c.json", "fleet/e.json", "--arrival", "1.125", "--json"});
  const double lower = pair["distance"]["lower"].get<double>();
  const std::string& row_of_c = rows[3];
  std::istringstream fields(row_of_c);
  std::string field;
  for (int i = 0; i < 6; ++i) std::getline(fields, field, ',');  // c, then a to e
  constexpr double rounding = 0x1p-40;  // of how a pair is bounded; far more than it can be
  EXPECT_NEAR(std::stod(field), lower, rounding) << row_of_c;
  // The fleet's own file says the same.
  const Json again = answer(program, {"swarm", "fleet/swarm.json", "--json"});
  EXPECT_EQ(again["conflicts"].size(), 0u);
  EXPECT_EQ(again["closest"][0]["first"], "c");
  EXPECT_EQ(again["closest"][0]["second"], "e");
  EXPECT_NEAR(again["closest"][0]["distance"]["lower"].get<double>(), lower, rounding);
  EXPECT_NE(text_of_file(program.path("swarm.svg")).find("Separations of 15 pairs"),
            std::string::npos);
}

TEST(ProgramSwarm, SaysWhichPairIsTooCloseAndKeepsItApart) {
  const Program program;
  copy_swarm(program);
  const Outcome close = program.run({"swarm", "swarm.json", "--clearance", "0.03", "-o", "close"});
  EXPECT_EQ(close.code, 3);
  EXPECT_EQ(line_count(close.err), 1u) << close.err;
  EXPECT_NE(close.err.find("'c' and 'e'"), std::string::npos) << close.err;
  EXPECT_NE(close.out.find("c and e are too close"), std::string::npos) << close.out;
  EXPECT_TRUE(std::filesystem::exists(program.path("close/swarm.json")));
  // By delays and other lengths, at the same arrival.
  const Json apart =
      answer(program, {"swarm", "swarm.json", "--clearance", "0.03", "--deconflict", "--json"});
  EXPECT_EQ(apart["conflicts"].size(), 0u);
  EXPECT_GE(apart["closest"][0]["distance"]["lower"].get<double>(), 0.03);
  EXPECT_EQ(apart["arrival"], 1.125);
  // By delays alone, the paths as they are; the file that is written holds them.
  const Outcome delayed = program.run({"swarm", "close/swarm.json", "--deconflict", "-o", "apart"});
  EXPECT_EQ(delayed.code, 0) << delayed.err;
  const Json checked = answer(program, {"swarm", "apart/swarm.json", "--json"});
  EXPECT_GE(checked["closest"][0]["distance"]["lower"].get<double>(), 0.03);
  EXPECT_EQ(text_of_file(program.path("apart/a.json")), text_of_file(program.path("close/a.json")));
  // What nothing keeps apart: they start closer than that.
  expect_refused(program.run({"swarm", "swarm.json", "--clearance", "0.15", "--deconflict"}),
                 "no choice keeps all vehicles apart", 3);
}

TEST(ProgramSwarm, ArrivesAsEarlyAsItMay) {
  const Program program;
  copy_swarm(program);
  const Json feasible = answer(program, {"swarm", "swarm.json", "--least", "feasible", "--json"});
  const Json separated = answer(
      program, {"swarm", "swarm.json", "--least", "separated", "--clearance", "0.0217", "--json"});
  EXPECT_GT(feasible["arrival"].get<double>(), 1.0);
  EXPECT_LT(feasible["arrival"].get<double>(), 1.125);
  EXPECT_GT(separated["arrival"].get<double>(), feasible["arrival"].get<double>());
  EXPECT_GE(separated["closest"][0]["distance"]["lower"].get<double>(), 0.0217);
  const Json by_length = answer(program, {"swarm", "swarm.json", "--length", "1.125", "--json"});
  const Json by_time = answer(program, {"swarm", "swarm.json", "--arrival", "1.125", "--json"});
  EXPECT_EQ(by_length, by_time);
}

/// The rows of a table of numbers, without its header.
std::vector<std::vector<double>> numbers_of(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  for (const std::string& line : lines_of(csv)) {
    if (line.starts_with("duration") || line.starts_with("xi")) continue;
    std::vector<double> row;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');) row.push_back(std::stod(field));
    rows.push_back(row);
  }
  return rows;
}

/// A derivative of the polynomial of one axis (0 to 3) of a row, at a time since its begin.
double polynomial(const std::vector<double>& row, std::size_t axis, std::size_t order, double t) {
  double sum = 0.0;
  for (std::size_t k = 8; k-- > order;) {
    double factor = 1.0;
    for (std::size_t i = 0; i < order; ++i) factor *= static_cast<double>(k - i);
    sum = sum * t + factor * row[1 + 8 * axis + k];
  }
  return sum;
}

TEST(ProgramSwarm, TrajectoriesStayWithinTheStatedError) {
  const Program program;
  copy_swarm(program);
  const Outcome made = program.run({"swarm", "swarm.json", "-o", "fleet", "--crazyswarm", "csv",
                                    "--tolerance", "1e-5"});  // not a tolerance: request data
  ASSERT_EQ(made.code, 0) << made.err;
  const std::size_t at = made.out.find("within ") + 7;
  const double stated = std::stod(made.out.substr(at));
  EXPECT_LE(stated, 1.01e-5);  // not a tolerance: the data above, rounded up to three digits
  // Third derivatives of terms up to 1 over pieces of 1/64 at the least: 210 · 64³ of 2^-52, some
  // ten operations each.
  constexpr double jerk_rounding = 0x1.0p-23;
  double largest = 0.0;
  for (const char* name : {"a", "b", "c", "d", "e", "f"}) {
    const std::string text = text_of_file(program.path(std::string("csv/") + name + ".csv"));
    EXPECT_TRUE(text.starts_with("duration,x^0,x^1,x^2,x^3,x^4,x^5,x^6,x^7,y^0,")) << text;
    const auto pieces = numbers_of(text);
    // The path at arc lengths, which are times at speed 1.
    constexpr std::size_t count = 2001;
    const auto samples = numbers_of(
        program.run({"sample", std::string("fleet/") + name + ".json", "-n", std::to_string(count)})
            .out);
    ASSERT_EQ(samples.size(), count);
    std::size_t piece = 0;
    double begin = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const double t = 1.125 * static_cast<double>(i) / static_cast<double>(count - 1);
      while (piece + 1 < pieces.size() && t > begin + pieces[piece][0]) begin += pieces[piece++][0];
      ASSERT_EQ(pieces[piece].size(), 33u);
      const std::vector<double>& place = samples[i];  // xi, s, x, y or alike
      const double x = place[place.size() - 2], y = place[place.size() - 1];
      largest = std::max(largest, std::hypot(polynomial(pieces[piece], 0, 0, t - begin) - x,
                                             polynomial(pieces[piece], 1, 0, t - begin) - y));
    }
    for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        for (std::size_t order = 0; order <= 3; ++order) {
          const double end = polynomial(pieces[k], axis, order, pieces[k][0]);
          EXPECT_NEAR(end, polynomial(pieces[k + 1], axis, order, 0.0), jerk_rounding) << name << k;
        }
      }
    }
  }
  EXPECT_LE(largest, stated);
  EXPECT_GT(largest, 0.01 * stated);  // the bound is of use
}

TEST(ProgramSwarm, TrajectoriesFollowPathsInSpaceFromRestToRest) {
  const Program program;
  ASSERT_EQ(program
                .run({"fit", "--formula", "cos(3*t), sin(3*t), t^2", "-t", "1e-6", "-o",
                      "coil.json"})  // not a tolerance: request data
                .code,
            0);
  write_text(program.path("coil-swarm.json"),
             R"({"vehicles": [{"id": "coil", "file": "coil.json", "departure": 0.5, "speed": 2,
                 "acceleration": 4, "deceleration": 8}, {"id": "first", "file": "coil.json"}]})");
  const Outcome made = program.run({"swarm", "coil-swarm.json", "--crazyswarm", "csv",
                                    "--tolerance", "1e-6"});  // not a tolerance: request data
  ASSERT_EQ(made.code, 0) << made.err;
  const double stated = std::stod(made.out.substr(made.out.find("within ") + 7));
  const Json again = answer(program, {"swarm", "coil-swarm.json", "--crazyswarm", "csv", "--json",
                                      "--tolerance", "1e-6"});  // not a tolerance: request data
  EXPECT_LE(again["trajectories"]["error"].get<double>(), stated);
  EXPECT_EQ(again["trajectories"]["folder"], "csv");
  const double length = again["vehicles"][0]["length"].get<double>();
  // Half a unit of time to speed 2 and 1/2 of the length, a quarter and 1/4 to brake.
  const double cruise = (length - 0.75) / 2.0, total = 0.75 + cruise;
  const auto arc_length = [&](double t) {
    if (t < 0.5) return 2.0 * t * t;
    if (t < 0.5 + cruise) return 0.5 + 2.0 * (t - 0.5);
    return length - 4.0 * (total - t) * (total - t);
  };
  const auto pieces = numbers_of(text_of_file(program.path("csv/coil.csv")));
  EXPECT_EQ(pieces[0][0], 0.5);  // it stands until the other has flown half a unit of time
  constexpr int count = 200;
  std::string places;
  std::vector<double> times;
  for (int i = 0; i <= count; ++i) {
    times.push_back(total * i / count);
    places += (i == 0 ? "" : ",") + Json(std::clamp(arc_length(times.back()), 0.0, length)).dump();
  }
  const Json rows = Json::parse(
      program.run({"sample", "coil.json", "--arc-length", places, "--format", "json"}).out)["rows"];
  ASSERT_EQ(rows.size(), times.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    double begin = 0.0;
    std::size_t piece = 0;
    const double t = 0.5 + times[i];
    while (piece + 1 < pieces.size() && t > begin + pieces[piece][0]) begin += pieces[piece++][0];
    double off = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double d =
          polynomial(pieces[piece], axis, 0, t - begin) - rows[i][2 + axis].get<double>();
      off += d * d;
    }
    largest = std::max(largest, std::sqrt(off));
  }
  EXPECT_LE(largest, stated);
  EXPECT_GT(largest, 0.001 * stated);
  EXPECT_NEAR(polynomial(pieces.back(), 0, 1, pieces.back()[0]), 0.0, stated);  // at rest
}

TEST(ProgramSwarm, TheAnimationNeedsNothingElse) {
  const Program program;
  copy_swarm(program);
  const Outcome made =
      program.run({"swarm", "swarm.json", "--clearance", "0.03", "--animation", "flight.html"});
  EXPECT_EQ(made.code, 3);
  ASSERT_EQ(program.run({"swarm", "swarm.json", "--animation", "flight.svg"}).code, 0);
  for (const char* name : {"flight.html", "flight.svg"}) {
    std::string text = text_of_file(program.path(name));
    std::size_t moving = 0;
    for (std::size_t at = text.find("<animateTransform"); at != std::string::npos;
         at = text.find("<animateTransform", at + 1)) {
      ++moving;
    }
    EXPECT_EQ(moving, 6u);
    const std::string name_space = "http://www.w3.org/2000/svg";
    text.erase(text.find(name_space), name_space.size());
    EXPECT_EQ(text.find("http"), std::string::npos);
    EXPECT_EQ(text.find("nan"), std::string::npos);
  }
  // The two that are too close are marked, the others not.
  const std::string marked = text_of_file(program.path("flight.html"));
  std::size_t marks = 0;
  for (std::size_t at = marked.find("class=\"alarm\""); at != std::string::npos;
       at = marked.find("class=\"alarm\"", at + 1)) {
    ++marks;
  }
  EXPECT_EQ(marks, 2u);
  EXPECT_EQ(text_of_file(program.path("flight.svg")).find("class=\"alarm\""), std::string::npos);
}

TEST(ProgramSwarm, BrokenFilesAreRefusedInOneLine) {
  const Program program;
  const std::string end = R"("end": {"position": [1, 0], "angle": 0}})";
  const std::string start = R"({"start": {"position": [0, 0], "angle": 0.5}, )";
  const auto refused = [&](const std::string& text, const std::string& part) {
    write_text(program.path("bad.json"), text);
    const Outcome outcome = program.run({"swarm", "bad.json"});
    expect_refused(outcome, part);
    EXPECT_NE(outcome.err.find("bad.json"), std::string::npos) << outcome.err;
  };
  refused("", "no JSON");
  refused("[]", "an object is needed");
  refused("{}", "vehicles");
  refused(R"({"vehicles": []})", "at least one vehicle");
  refused(R"({"vehicles": [7]})", "/vehicles/0");
  refused(R"({"vehicles": [)" + start + end + "]}", "say when");
  refused(R"({"arrival": 2, "length": 2, "vehicles": [)" + start + end + "]}", "say when");
  refused(R"({"arrival": 2, "vehicles": [{)" + end + "]}", "start");
  refused(R"({"arrival": 2, "speeed": 1, "vehicles": [)" + start + end + "]}", "speeed");
  refused(R"({"arrival": 2, "vehicles": [)" + start + R"("id": "../x", )" + end + "]}", "../x");
  refused(R"({"arrival": 2, "vehicles": [)" + start + R"("id": "x", )" + end + ", " + start +
              R"("id": "x", )" + end + "]}",
          "another vehicle's");
  refused(R"({"arrival": 2, "vehicles": [)" + start + R"("speed": 0, )" + end + "]}", "positive");
  refused(R"({"arrival": 2, "vehicles": [)" + start + end + R"(, {"file": "x.json"}]})", "x.json");
  refused(R"({"arrival": 2, "vehicles": [)" + start + R"("altitude": "high", )" + end + "]}",
          "altitude");
  refused(R"({"vehicles": [{"file": "x.json"}]})", "x.json");
  refused(std::string(100000, '['), "deeper");
  write_text(program.path("fast.json"), R"({"length": 2, "vehicles": [)" + start + end + ", " +
                                            start + R"("speed": 2, )" + end + "]}");
  expect_refused(program.run({"swarm", "fast.json"}), "speed 2");
  // Nothing that is asked for has a solution: too short, or bent too much.
  write_text(program.path("short.json"), R"({"arrival": 0.5, "vehicles": [)" + start + end + "]}");
  const Outcome early = program.run({"swarm", "short.json"});
  EXPECT_NE(early.code, 0);
  EXPECT_EQ(line_count(early.err), 1u) << early.err;
}

}  // namespace
}  // namespace hodograph::test
