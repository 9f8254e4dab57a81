// SPDX-License-Identifier: MIT
// The program as a user runs it: help, exit codes, pipes, files.
#include "cli/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "support/compare.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

constexpr const char* curve_23 = "1.5*sin(7.2*t), cos(9*t), exp(cos(1.8*t))";

const std::vector<std::string> commands = {
    "fit",     "orbit", "hermite", "corner",     "loop",    "climb",   "frame",
    "sweep",   "plan",  "swarm",   "separation", "spline",  "offset",  "sample",
    "inspect", "check", "plot",    "batch",      "version", "rational"};

/// Fits curve (23) of the PHODCOS paper into curve.json.
void make_curve(const Program& program) {
  const Outcome made =
      program.run({"fit", "--formula", curve_23, "-t", "1e-6", "-o", "curve.json"});
  ASSERT_EQ(made.code, 0) << made.err;
}

/// A table of a closed curve, as a user's program would write it.
std::string circle_table(int count) {
  std::string text = "t,x,y,z\n";
  for (int i = 0; i <= count; ++i) {
    const double t = static_cast<double>(i) / count, angle = i == count ? 0.0 : 2 * M_PI * t;
    text += std::to_string(t) + "," + Json(std::cos(angle)).dump() + "," +
            Json(std::sin(angle)).dump() + "," + Json(0.1 * std::sin(2 * angle)).dump() + "\n";
  }
  return text;
}

TEST(ProgramHelp, EverySubcommandHasASentenceAUsageAndAnExample) {
  const Program program;
  const Outcome top = program.run({"--help"});
  EXPECT_EQ(top.code, 0);
  for (const std::string& command : commands) {
    EXPECT_NE(top.out.find("\n  " + command + " "), std::string::npos) << command;
    const Outcome help = program.run({command, "--help"});
    EXPECT_EQ(help.code, 0);
    EXPECT_EQ(help.err, "");
    EXPECT_NE(help.out.find("Usage: "), std::string::npos) << help.out;
    EXPECT_NE(help.out.find("Example"), std::string::npos) << help.out;
    EXPECT_NE(help.out.find("\n  hodograph " + command), std::string::npos) << help.out;
    constexpr std::size_t widest = 100;
    for (const std::string& line : lines_of(help.out)) EXPECT_LE(line.size(), widest) << line;
  }
}

/// Puts the files of examples/ where the program runs.
void copy_examples(const Program& program) {
  const std::filesystem::path from = std::string(HODOGRAPH_SOURCE_DIRECTORY) + "/examples";
  for (const auto& entry : std::filesystem::directory_iterator(from)) {
    ASSERT_TRUE(std::filesystem::copy_file(entry.path(), program.path(entry.path().filename())));
  }
}

TEST(ProgramReadme, EveryCommandRuns) {
  const Program program;
  copy_examples(program);
  int commands_found = 0;
  for (const std::string& line :
       lines_of(text_of_file(std::string(HODOGRAPH_SOURCE_DIRECTORY) + "/README.md"))) {
    if (!line.starts_with("    hodograph ")) continue;
    const Outcome outcome = program.shell(line);
    EXPECT_EQ(outcome.code, 0) << line << "\n" << outcome.err;
    ++commands_found;
  }
  EXPECT_GE(commands_found, 12);
}

TEST(ProgramHelp, EveryExampleRuns) {
  const Program program;
  ASSERT_EQ(program.run({"orbit"}).code, 0);  // gateway.json
  copy_examples(program);
  ASSERT_EQ(program.run({"fit", "track.csv", "-t", "0.01", "-o", "track.json"}).code, 0);
  write_text(program.path("generate"), "#!/bin/sh\ncat track.csv\n");
  std::filesystem::permissions(program.path("generate"), std::filesystem::perms::owner_all);
  int examples = 0;
  for (const std::string& command : commands) {
    bool in_examples = false;
    for (const std::string& line : lines_of(program.run({command, "--help"}).out)) {
      if (line.starts_with("Example")) in_examples = true;
      if (!line.starts_with("  ")) in_examples = in_examples && line.starts_with("Example");
      if (!in_examples || line.find("hodograph") == std::string::npos) continue;
      const Outcome outcome = program.shell("PATH=.:$PATH; " + line);
      EXPECT_EQ(outcome.code, 0) << line << "\n" << outcome.err;
      ++examples;
    }
  }
  EXPECT_GE(examples, 37);
}

TEST(ProgramUsage, WrongCommandLinesAreOneLineAndExitTwo) {
  const Program program;
  expect_refused(program.run({}), "no command");
  expect_refused(program.run({"nonsense"}), "nonsense is no command");
  expect_refused(program.run({"fit", "--tolerance", "abc", "x.csv"}), "abc");
  expect_refused(program.run({"fit"}), "--tolerance");
  expect_refused(program.run({"fit", "-t", "1e-6"}), "CSV");
  expect_refused(program.run({"fit", "--formula", "t,t,t", "-t", "-1"}), "-1");
  expect_refused(program.run({"fit", "--formula", "t,t,t", "-t", "nan"}), "tolerance");
  expect_refused(program.run({"orbit", "--orbit", "moon"}), "moon");
  expect_refused(program.run({"orbit", "--initial", "1,2"}), "--initial");
  expect_refused(program.run({"orbit", "--initial", "1,0.1,nan"}), "vy");
  expect_refused(program.run({"sample"}), "document");
  expect_refused(program.run({"sample", "a.json", "--count", "0"}), "--count");
  expect_refused(program.run({"check", "there is no such file.json"}), "no such file");
  const Outcome version = program.run({"--version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_TRUE(version.out.starts_with("hodograph 0.")) << version.out;
}

TEST(ProgramUsage, NoSolutionExitsThree) {
  const Program program;
  expect_refused(program.run({"fit", "--formula", curve_23, "-t", "1e-9", "--most-segments", "3"}),
                 "segments", 3);
  expect_refused(program.run({"fit", "--formula", curve_23, "-t", "1e-300"}), "", 3);
  EXPECT_FALSE(std::filesystem::exists(program.path("path.json")));
}

TEST(ProgramFormula, MistakesAreNamedByTheirCharacter) {
  const Program program;
  const auto refused = [&](const std::string& formula, const std::string& part) {
    expect_refused(program.run({"fit", "--formula", formula, "-t", "1e-3"}), part);
  };
  refused("sin(t, cos(t), t", "character 6");
  refused("sin(t), cos(t), foo(t)", "character 17");
  refused("1, 2, 3, 4", "character 8");
  refused("t", "character 2");
  refused("1 +, 2, 3", "character 4");
  refused("t, t, t)", "character 8");
  refused("t, t**2, t", "power");
  refused("1e999*t, t, t", "double");
  refused(std::string(100000, '('), "characters");
  refused(std::string(5000, '('), "levels");
  refused(std::string(5000, '-') + "t, t, t", "levels");
  refused("t\n;rm -rf, t, t", "character 3");
}

TEST(ProgramFormula, OperatorsBindAsInMathematics) {
  const Program program;
  const Outcome fit =
      program.run({"fit", "--formula", "-t^2 + 2^-1 + 3*t, 8/4/2*t - 1 - 1, t^2^3 + e*t - pi", "-t",
                   "1e-6", "-o", "f.json"});
  ASSERT_EQ(fit.code, 0) << fit.err;
  const Outcome samples = program.run({"sample", "f.json", "--xi", "0,1", "--format", "json"});
  const Json rows = Json::parse(samples.out)["rows"];
  const double e = std::exp(1.0), pi = std::acos(-1.0);
  const double expected[2][3] = {{0.5, -2.0, -pi}, {2.5, -1.0, 1.0 + e - pi}};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {  // data at knots are met to rounding
      EXPECT_CLOSE(rows[i][j + 2].get<double>(), expected[i][j], 64, 4.0);
    }
  }
}

TEST(ProgramFit, FormulasAreCertifiedAndChecked) {
  const Program program;
  make_curve(program);
  const Json document = Json::parse(text_of_file(program.path("curve.json")));
  EXPECT_TRUE(document["promises"]["error"]["certified"].get<bool>());
  EXPECT_LE(document["promises"]["error"]["upper"].get<double>(),
            1e-6);  // not a tolerance: request data
  EXPECT_EQ(document["promises"]["continuity"]["position"], 4);
  const Outcome check = program.run({"check", "curve.json"});
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_NE(check.out.find("error (certified)"), std::string::npos);
  EXPECT_EQ(check.out.find("skipped"), std::string::npos) << check.out;
}

TEST(ProgramFit, SamplesAreCertifiedAgainstTheirSpline) {
  const Program program;
  write_text(program.path("track.csv"), circle_table(64));
  const Outcome fit = program.run({"fit", "track.csv", "--periodic", "-t", "1e-6", "-o",
                                   "track.json", "--report", "track.html"});
  ASSERT_EQ(fit.code, 0) << fit.err;
  EXPECT_EQ(fit.err, "");
  EXPECT_NE(fit.out.find("wrote track.json"), std::string::npos);
  EXPECT_NE(fit.out.find("certified"), std::string::npos) << fit.out;
  const Json document = Json::parse(text_of_file(program.path("track.json")));
  EXPECT_TRUE(document["closed"].get<bool>());
  EXPECT_TRUE(document["promises"]["error"]["certified"].get<bool>());
  const Outcome skipped = program.run({"check", "track.json"});
  EXPECT_EQ(skipped.code, 0);
  EXPECT_NE(skipped.out.find("--samples"), std::string::npos);
  const Outcome check =
      program.run({"check", "track.json", "--samples", "track.csv", "--periodic"});
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_NE(check.out.find("error (certified)"), std::string::npos);
  const std::string report = text_of_file(program.path("track.html"));
  EXPECT_NE(report.find("<svg"), std::string::npos);
}

TEST(ProgramFit, BadTablesAreRefusedWithTheirLine) {
  const Program program;
  const auto refused = [&](const std::string& table, const std::string& part) {
    write_text(program.path("bad.csv"), table);
    expect_refused(program.run({"fit", "bad.csv", "-t", "1e-3"}), part);
  };
  refused("t,x,y,z\n0,0,0,0\n1,1,zwei,3\n", "line 3");
  refused("t,x,y,z\n0,0,0,0\n1,1,nan,3\n", "line 3");
  refused("t,x,y,z\n0,0,0,0\n0,1,2,3\n", "increas");
  refused("t,x,y,z\n0,0,0,0\n1,1,2\n", "line 3");
  refused("t,x,y,z\n0,0,0,0\n1,1,2,3\n", "6");
  refused("", "bad.csv");
  refused("\xff\xfe\x00\x01", "bad.csv");
}

TEST(ProgramOrbit, WithoutArgumentsEndsWithTheTableAndTheFiles) {
  const Program program;
  const Outcome orbit = program.run({"orbit"});
  ASSERT_EQ(orbit.code, 0) << orbit.err;
  EXPECT_EQ(orbit.err, "");  // no progress in a pipe
  for (const char* part :
       {"egments", "estimate", "C4", "wrote gateway.json\nwrote gateway.html\n"}) {
    EXPECT_NE(orbit.out.find(part), std::string::npos) << part << "\n" << orbit.out;
  }
  const Json document = Json::parse(text_of_file(program.path("gateway.json")));
  EXPECT_TRUE(document["closed"].get<bool>());
  EXPECT_EQ(document["segments"].size(), 30u);  // the adaptive count of the order-ten choice
  EXPECT_FALSE(document["promises"]["error"]["certified"].get<bool>());
  EXPECT_LE(document["promises"]["error"]["upper"].get<double>(),
            1e-9);  // not a tolerance: request data
  const Outcome check = program.run({"check", "gateway.json"});
  EXPECT_EQ(check.code, 0) << check.err;
}

TEST(ProgramOrbit, FramesUnitsAndStarts) {
  const Program program;
  const Outcome inertial = program.run(
      {"orbit", "--frame", "inertial", "--units", "km", "-t", "0.001", "-o", "inertial.json"});
  ASSERT_EQ(inertial.code, 0) << inertial.err;
  const Json document = Json::parse(text_of_file(program.path("inertial.json")));
  EXPECT_EQ(document["units"]["length"], "km");
  EXPECT_FALSE(document["closed"].get<bool>());
  EXPECT_TRUE(std::filesystem::exists(program.path("inertial.html")));
  EXPECT_EQ(program.run({"check", "inertial.json"}).code, 0);

  const Outcome own = program.run({"orbit", "--initial", "1.0273,-0.18551533506611556,-0.1145",
                                   "-o", "own.json", "--report", "none"});
  ASSERT_EQ(own.code, 0) << own.err;
  EXPECT_FALSE(std::filesystem::exists(program.path("own.html")));
  EXPECT_EQ(program.run({"check", "own.json"}).code, 0);
}

TEST(ProgramPipes, DocumentsAndTablesFlowThroughPipes) {
  const Program program;
  const Outcome outcome =
      program.shell(std::string("hodograph fit --formula '") + curve_23 +
                    "' -t 1e-6 -o - 2>table.txt | hodograph sample - --count 11");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 12u);
  EXPECT_EQ(lines[0], "xi,s,x,y,z");
  EXPECT_TRUE(lines[1].starts_with("0,0,")) << lines[1];
  EXPECT_NE(text_of_file(program.path("table.txt")).find("egments"), std::string::npos);

  write_text(program.path("track.csv"), circle_table(32));
  const Outcome samples = program.shell(
      "cat track.csv | hodograph fit - -t 1e-3 -o - 2>/dev/null | hodograph inspect -");
  EXPECT_EQ(samples.code, 0) << samples.err;
  EXPECT_NE(samples.out.find("segments"), std::string::npos);
}

TEST(ProgramSample, PlacesAndColumns) {
  const Program program;
  make_curve(program);
  const Outcome json = program.run({"sample", "curve.json", "--xi", "0,0.5,1", "--format", "json",
                                    "--with", "frame,rates,curvature,speed,preimage,derivatives"});
  ASSERT_EQ(json.code, 0) << json.err;
  const Json table = Json::parse(json.out);
  ASSERT_EQ(table["rows"].size(), 3u);
  EXPECT_EQ(table["columns"].size(), table["rows"][0].size());
  EXPECT_EQ(table["rows"][1][0], 0.5);
  const Outcome step = program.run({"sample", "curve.json", "--step", "0.5"});
  EXPECT_GE(line_count(step.out), 20u);
  expect_refused(program.run({"sample", "curve.json", "--xi", "2"}), "outside [0, 1]");
  expect_refused(program.run({"sample", "curve.json", "--arc-length", "-1"}), "arc length");
  expect_refused(program.run({"sample", "curve.json", "--step", "1e-300"}), "");
  expect_refused(program.run({"sample", "curve.json", "--count", "5", "--step", "1"}), "");
}

TEST(ProgramInspect, TextAndJsonAgree) {
  const Program program;
  make_curve(program);
  const Outcome json = program.run({"inspect", "curve.json", "--json"});
  ASSERT_EQ(json.code, 0) << json.err;
  EXPECT_EQ(line_count(json.out), 1u);
  const Json facts = Json::parse(json.out);
  EXPECT_EQ(facts["continuity"]["position"], 4);
  EXPECT_LE(facts["arc_length"]["lower"].get<double>(), facts["length"].get<double>());
  EXPECT_LE(facts["length"].get<double>(), facts["arc_length"]["upper"].get<double>());
  const Outcome text = program.run({"inspect", "curve.json"});
  EXPECT_NE(text.out.find(facts["length"].dump()), std::string::npos) << text.out;
}

TEST(ProgramPlot, WritesSvg) {
  const Program program;
  make_curve(program);
  for (const char* view : {"path", "xy", "xz", "yz", "quantities", "all"}) {
    const Outcome plot = program.run({"plot", "curve.json", "--view", view});
    EXPECT_EQ(plot.code, 0) << plot.err;
    EXPECT_NE(plot.out.find("<svg"), std::string::npos);
    EXPECT_TRUE(plot.out.ends_with("</svg>\n")) << view;
  }
}

// ---- documents that lie or are broken
// ----------------------------------------------------------------

/// The document with the number after `key` (inside the object `of`) moved to its neighbour.
std::string with_neighbour(const std::string& document, const std::string& of,
                           const std::string& key, double towards) {
  const std::size_t object = of.empty() ? 0 : document.find(std::string("\"") + of + "\": {");
  const std::size_t at = document.find(std::string("\"") + key + "\": ", object) + key.size() + 4;
  const std::size_t end = document.find_first_of(",\n}", at);
  const double number = std::stod(document.substr(at, end - at));
  return document.substr(0, at) + Json(std::nextafter(number, towards)).dump() +
         document.substr(end);
}

TEST(ProgramCheck, FailsOnTheSmallestLie) {
  const Program program;
  make_curve(program);
  const std::string honest = text_of_file(program.path("curve.json"));
  const double above = std::numeric_limits<double>::infinity();
  struct Lie {
    const char *of, *key, *named;
    double towards;
  };
  for (const Lie& lie :
       {Lie{"arc_length", "lower", "arc length", above},
        Lie{"arc_length", "upper", "arc length", 0.0},
        Lie{"smallest_speed", "lower", "smallest speed", above},
        Lie{"smallest_speed", "upper", "smallest speed", 0.0},
        Lie{"largest_speed", "lower", "largest speed", above},
        Lie{"largest_speed", "upper", "largest speed", 0.0},
        Lie{"", "curvature_bound", "curvature", 0.0}, Lie{"error", "lower", "error", above},
        Lie{"error", "upper", "error", 0.0}}) {
    write_text(program.path("lie.json"), with_neighbour(honest, lie.of, lie.key, lie.towards));
    const Outcome outcome = program.run({"check", "lie.json"});
    expect_refused(outcome, std::string("broken promise: ") + lie.named);
  }
  for (const char* key : {"position", "preimage", "frame", "angular_velocity"}) {
    const std::string text = std::string("\"") + key + "\": ";
    std::string lie = honest;
    const std::size_t at = lie.find(text) + text.size();
    lie[at] = static_cast<char>(lie[at] + 1);
    write_text(program.path("lie.json"), lie);
    expect_refused(program.run({"check", "lie.json"}), "broken promise: continuity");
  }
  std::string torn = honest;  // a coefficient of the curve itself
  const std::size_t at = torn.find("\"preimage\": [[", torn.find("\"segments\"")) + 16;
  torn[at] = torn[at] == '9' ? '8' : '9';
  write_text(program.path("lie.json"), torn);
  const Outcome outcome = program.run({"check", "lie.json"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(line_count(outcome.err), 1u);
}

TEST(ProgramDocuments, BrokenOnesAreRefusedInOneLine) {
  const Program program;
  make_curve(program);
  const std::string whole = text_of_file(program.path("curve.json"));
  const std::vector<std::string> broken = {
      "",
      "{",
      "null",
      "[1, 2]",
      whole.substr(0, whole.size() / 2),
      whole.substr(0, whole.size() - 3),
      "\xff\xfe",
      std::string(100000, '['),
      std::string("{\"format\": ") + std::string(50000, '{'),
      "{\"format\": \"hodograph-path\", \"version\": 1e999}",
      whole + whole,
  };
  for (const std::string& text : broken) {
    write_text(program.path("broken.json"), text);
    for (const char* command : {"inspect", "check", "sample", "plot"}) {
      expect_refused(program.run({command, "broken.json"}), "broken.json");
    }
  }
  expect_refused(program.run({"inspect", "."}), "directory");
}

TEST(ProgramFiles, AFailedRunLeavesTheOldFileWhole) {
  const Program program;
  write_text(program.path("old.json"), "what was there before");
  const Outcome failed = program.run(
      {"fit", "--formula", curve_23, "-t", "1e-300", "-o", "old.json", "--report", "old.html"});
  EXPECT_EQ(failed.code, 3);
  EXPECT_EQ(text_of_file(program.path("old.json")), "what was there before");
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(program.path(""))) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(".std")) names.insert(name);
  }
  EXPECT_EQ(names, std::set<std::string>{"old.json"});
  expect_refused(program.run({"orbit", "-o", "no/such/folder/x.json"}), "no/such/folder");
}

}  // namespace
}  // namespace hodograph::test
