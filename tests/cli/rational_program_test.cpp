// SPDX-License-Identifier: MIT
// Rational PH curves, as a user runs the program: every case of the golden
// file, equal as rationals; the paper's examples; what is written to files;
// what is refused, and where.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "hodograph/io/document.hpp"
#include "io/markup_check.hpp"
#include "support/compare.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

const Json& golden() {
  static const Json file = Json::parse(
      text_of_file(std::string(HODOGRAPH_SOURCE_DIRECTORY) + "/tests/golden/rational.json"));
  return file;
}
const char* golden_kind(const Json& kind) {
  return kind == "trivial" ? "constant" : kind == "rational" ? "rational" : "polynomial";
}

void expect_fraction(const Json& found, const Json& expected) {
  EXPECT_EQ(found["numerator"], expected["num"]);
  EXPECT_EQ(found["denominator"], expected["den"]);
}

void expect_curve(const Json& found, const Json& expected) {
  EXPECT_EQ(found["kind"], golden_kind(expected["class"]));
  EXPECT_EQ(found["r"]["numerator"], expected["r_num"]);
  EXPECT_EQ(found["r"]["denominator"], expected["r_den"]);
  expect_fraction(found["lambda"], expected["lambda"]);
  expect_fraction(found["speed"], expected["signed_speed"]);
  EXPECT_EQ(found["arc_length"]["rational"], expected["arc_length_rational"] == 1);
  if (expected.contains("arc_length")) {
    expect_fraction(found["arc_length"]["function"], expected["arc_length"]);
  }
  if (expected.contains("arc_length_log_obstruction")) {
    expect_fraction(found["arc_length"]["obstruction"], expected["arc_length_log_obstruction"]);
  }
  EXPECT_EQ(found["poles"].size(), expected["real_poles"]);
  EXPECT_EQ(found["stationary_points"].size(), expected["real_zeros_of_lambda"]);
  if (expected.contains("dual_f") && !found["osculating_planes"].is_null()) {
    expect_fraction(found["osculating_planes"], expected["dual_f"]);
  }
  if (!expected.contains("decomposition")) return;
  const Json& parts = expected["decomposition"];
  EXPECT_EQ(found["decomposition"]["polynomial_lambda"], parts["polynomial_lambda"]);
  EXPECT_EQ(found["decomposition"]["constant"], parts["constant"]);
  std::size_t next = 0;  // the file lists factors of alpha without a principal part, too
  for (const Json& piece : parts["pieces"]) {
    if (piece["lambda"]["num"].empty()) continue;
    const auto& all = found["decomposition"]["pieces"];
    const bool there = std::any_of(all.begin(), all.end(), [&](const Json& one) {
      return one["pole"] == piece["q"] && one["r"]["numerator"] == piece["r_num"] &&
             one["r"]["denominator"] == piece["r_den"];
    });
    EXPECT_TRUE(there) << piece["q"];
    ++next;
  }
  EXPECT_EQ(found["decomposition"]["pieces"].size(), next);
}

void expect_case(const Json& found, const Json& c) {
  EXPECT_EQ(found["reduction"]["A"], c["A_reduced"]);
  EXPECT_EQ(found["reduction"]["factor"], c["R_right_factor"]);
  EXPECT_EQ(found["indicatrix"], c["F"]);
  EXPECT_EQ(found["norm"], c["norm"]);
  for (const char* axis : {"e1", "e2", "e3"}) EXPECT_EQ(found["frame"][axis], c["erf"][axis]);
  EXPECT_EQ(found["frame"]["angular_velocity"], c["erf"]["angular"]);
  EXPECT_EQ(found["frame"]["rotation_minimising"], c["erf"]["rotation_minimising"] == 1);
  const Json& theorem = c["theorem46"];
  EXPECT_EQ(found["existence"]["exists"], theorem["exists"] == 1);
  EXPECT_EQ(found["existence"]["freedom"], theorem["N"]);
  ASSERT_EQ(found["existence"]["strata"].size(), theorem["strata"].size());
  for (std::size_t i = 0; i < theorem["strata"].size(); ++i) {
    const Json &s = found["existence"]["strata"][i], &expected = theorem["strata"][i];
    EXPECT_EQ(s["order"], expected["n"]);
    EXPECT_EQ(s["poles"], expected["s"]);
    EXPECT_EQ(s["rank_two"], expected["rank_le_2"]);
    EXPECT_EQ(s["rank_one"], expected["rank_le_1"]);
  }
  for (std::size_t d = 0; d < std::min(c["dims_by_degB"].size(), found["dimensions"].size()); ++d) {
    EXPECT_EQ(found["dimensions"][d]["dimension"], c["dims_by_degB"][d]) << d;
    EXPECT_EQ(found["dimensions"][d]["predicted"], c["generic_formula_by_degB"][d]) << d;
  }
}

TEST(RationalRequest, GivesEveryGoldenCase) {
  const Program program;
  std::string requests;
  for (const Json& c : golden()["cases"]) {
    for (const auto& [degree, solution] : c["solutions"].items()) {
      requests += Json{{"request", "rational"},
                       {"A", c["A"]},
                       {"alpha", c["alpha"]},
                       {"degree", std::stoi(degree)},
                       {"curves", 1000}}
                      .dump() +
                  "\n";
    }
  }
  const Outcome outcome = program.run({"batch"}, requests);
  ASSERT_EQ(outcome.code, 0);
  const auto answers = lines_of(outcome.out);
  std::size_t next = 0, curves = 0;
  for (const Json& c : golden()["cases"]) {
    for (const auto& [degree, solution] : c["solutions"].items()) {
      SCOPED_TRACE(c["name"].get<std::string>() + ", deg B <= " + degree);
      ASSERT_LT(next, answers.size());
      const Json answer = Json::parse(answers[next++]);
      ASSERT_TRUE(answer["ok"]) << answer;
      const Json& found = answer["result"];
      expect_case(found, c);
      EXPECT_EQ(found["dimension"]["dimension"], solution["dim"]);
      EXPECT_EQ(found["lambda_numerators"], solution["lambda_numerators_h"]);
      EXPECT_EQ(found["rational_length_numerators"], solution["arc_length_rational_h"]);
      ASSERT_EQ(found["basis"].size(), solution["basis"].size());
      for (std::size_t i = 0; i < solution["basis"].size(); ++i) {
        EXPECT_EQ(found["basis"][i]["B"], solution["basis"][i]);
        EXPECT_EQ(found["basis"][i]["kind"], golden_kind(solution["class"][i]));
        EXPECT_EQ(found["basis"][i]["mu"], solution["mu"][i]);
      }
      ASSERT_EQ(found["curves"].size(), solution["curves"].size());
      for (std::size_t i = 0; i < solution["curves"].size(); ++i) {
        expect_curve(found["curves"][i], solution["curves"][i]);
        ++curves;
      }
    }
  }
  EXPECT_EQ(next, answers.size());
  EXPECT_GT(curves, 90u);
}

TEST(RationalCommand, PrintsThePapersExamplesInItsOrder) {
  const Program program;
  const Outcome text = program.run({"rational", "--examples"});
  ASSERT_EQ(text.code, 0) << text.err;
  std::size_t at = 0;
  for (const char* name : {"Example 5.1\n", "Remark 5.2\n", "Example 5.3\n", "Example 5.4\n",
                           "Example 5.5\n", "Example 5.6\n"}) {
    const std::size_t found = text.out.find(name, at);
    ASSERT_NE(found, std::string::npos) << name;
    at = found;
  }
  EXPECT_NE(text.out.find("the pole t = -1 has order 2 and the indicatrix has "
                          "an inflection there"),
            std::string::npos);

  const Outcome outcome = program.run({"rational", "--examples", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json examples = Json::parse(outcome.out)["examples"];
  ASSERT_EQ(examples.size(), 6u);
  std::vector<std::string> labels;
  for (const Json& example : examples) {
    SCOPED_TRACE(example["name"].get<std::string>());
    const std::string number = example["name"].get<std::string>().substr(8);
    const auto& cases = golden()["cases"];
    const auto c = std::find_if(cases.begin(), cases.end(), [&](const Json& one) {
      return one["name"] == "paper " + (number == "2" || number == " 5.2" ? "5.1" : number);
    });
    if (example["name"] == "Remark 5.2") {
      expect_case(example, cases[0]);
      EXPECT_EQ(example["basis"].size(), cases[0]["solutions"]["12"]["dim"]);
      continue;
    }
    ASSERT_NE(c, cases.end());
    expect_case(example, *c);
    const Json& solution = (*c)["solutions"][std::to_string(example["degree"].get<int>())];
    for (std::size_t i = 0; i < solution["basis"].size(); ++i) {
      EXPECT_EQ(example["basis"][i]["B"], solution["basis"][i]);
    }
    ASSERT_EQ(example["printed"].size(), (*c)["given_curves"].size());
    for (std::size_t i = 0; i < example["printed"].size(); ++i) {
      expect_curve(example["printed"][i], (*c)["given_curves"][i]);
      labels.push_back(example["printed"][i]["label"]);
    }
  }
  EXPECT_EQ(labels,
            (std::vector<std::string>{"p_6", "r", "(15)", "(16)", "p_4 (17)", "(18)", "p", "q"}));
}

TEST(RationalCommand, TakesTextFilesJsonAndStandardInput) {
  const Program program;
  const std::string a = "A = t^2 - (i + j)*t + k", alpha = "alpha = t^3";
  const std::string expected = program.run({"rational", a, alpha, "--json"}).out;
  ASSERT_FALSE(expected.empty());
  EXPECT_EQ(Json::parse(expected)["degree"],
            6);  // the least with a truly rational curve
  write_text(program.path("one.txt"), "# Example 5.1\n" + a + "\nalpha = t^3 # a comment\n");
  write_text(program.path("two.txt"), "degree = 6");
  write_text(program.path("one.json"),
             R"json({"A": "(t^2, -t, -t, 1)", "alpha": [0, 0, 0, "1"]})json");
  EXPECT_EQ(program.run({"rational", a + "; " + alpha, "--json"}).out, expected);
  EXPECT_EQ(program.run({"rational", "one.txt", "two.txt", "--json"}).out, expected);
  EXPECT_EQ(program.run({"rational", "one.json", "--json"}).out, expected);
  EXPECT_EQ(program.run({"rational", "-", "--json"}, a + "\n" + alpha).out, expected);
  EXPECT_EQ(program.run({"rational", "--json", "-o", "out.json", "one.txt"}).out,
            "wrote out.json\n");
  EXPECT_EQ(text_of_file(program.path("out.json")), expected);
  // What it says is what it takes.
  const Json said = Json::parse(expected);
  write_text(program.path("again.json"),
             Json{{"A", said["A"]}, {"alpha", said["alpha"]}, {"degree", said["degree"]}}.dump());
  EXPECT_EQ(program.run({"rational", "again.json", "--json"}).out, expected);
}

TEST(RationalCommand, ExaminesAGivenCurve) {
  const Program program;
  const std::string a = "A = t^2 - (i + j)*t + k";
  const Outcome text = program.run({"rational", a,
                                    "r = (t^6 + 3t^4 + t^3 + 3t^2 + 1, 12t^4 + "
                                    "t^3 - 12t^2, 3t^5 + t^3 + 3t)/t^3"});
  ASSERT_EQ(text.code, 0) << text.err;
  EXPECT_NE(text.out.find("The curve r, truly rational"), std::string::npos);
  EXPECT_NE(text.out.find("rational: (t^6 + 9*t^4 - 9*t^2 - 1)/t^3"), std::string::npos)
      << text.out;
  EXPECT_NE(text.out.find("B = -1/2*B1 - 1/2*B2 - 1/2*B3 - 1/2*B4"), std::string::npos) << text.out;
  // Its osculating planes give it back (formula (4)).
  const Json curve = Json::parse(
      program.run({"rational", a, "alpha = t^3", "--coefficients", "-1/2,0.5,0,3", "--json"}).out);
  EXPECT_EQ(curve["chosen"]["coordinates"], Json({"-1/2", "1/2", "0", "3"}));
  const Json planes = {{"A", curve["A"]}, {"f", curve["chosen"]["osculating_planes"]}};
  const Json back = Json::parse(program.run({"rational", planes.dump(), "--json"}).out);
  EXPECT_EQ(back["chosen"]["r"], curve["chosen"]["r"]);
}

TEST(RationalCommand, DrawsAndExports) {
  const Program program;
  const std::string question = "A = t^2 - (i+j)t + k; alpha = t^3";
  const Outcome outcome =
      program.run({"rational", question, "--svg", "curve.svg", "--nurbs", "curve.json",
                   "--interval", "0.5,3", "--latex", "-o", "curve.tex"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "wrote curve.svg\nwrote curve.json\nwrote curve.tex\n");
  ASSERT_EQ(program.run({"rational", question, "--svg", "line.svg"}).code, 0);
  for (const char* name : {"curve.svg", "line.svg"}) {
    const std::string svg = text_of_file(program.path(name));
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_EQ(markup_problem(svg), "");
  }

  // Whatever is described: the first truly rational curve is the one that is drawn.
  const Outcome few = program.run({"rational", question, "--curves", "0", "--nurbs", "same.json",
                                   "--interval", "0.5,3", "-o", "few.txt"});
  ASSERT_EQ(few.code, 0) << few.err;
  EXPECT_EQ(text_of_file(program.path("same.json")), text_of_file(program.path("curve.json")));

  // The NURBS is r = -2 B1 / t^3 at every place.
  const Json curve = Json::parse(text_of_file(program.path("curve.json")));
  double worst = 0.0;
  for (const Json& piece : curve["pieces"]) {
    const auto n = piece["degree"].get<int>();
    for (const double u : {0.0, 0.25, 0.7, 1.0}) {
      double weight = 0.0, choose = 1.0;
      std::array<double, 3> point{};
      for (int k = 0; k <= n; ++k) {
        const double b =
            choose * std::pow(u, k) * std::pow(1.0 - u, n - k) * piece["weights"][k].get<double>();
        weight += b;
        for (int c = 0; c < 3; ++c) point[c] += b * piece["control_points"][k][c].get<double>();
        choose = choose * (n - k) / (k + 1);
      }
      const double begin = piece["begin"], end = piece["end"], t = begin + u * (end - begin);
      const std::array<double, 3> r = {
          -2.0 * (std::pow(t, 6) + 3 * std::pow(t, 4) + 3 * t * t + 1) / std::pow(t, 3),
          24.0 / t - 24.0 * t, -6.0 * t * t - 6.0 / (t * t)};
      for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(point[c] / weight - r[c]));
    }
  }
  constexpr double rounding = 0x1.0p-40;  // numbers up to 100, some dozens of roundings
  EXPECT_LE(worst, rounding);
  const Json& nurbs = curve["nurbs"];
  EXPECT_EQ(nurbs["knots"].size(),
            nurbs["control_points"].size() + nurbs["degree"].get<std::size_t>() + 1);
  EXPECT_EQ(nurbs["weights"].size(), nurbs["control_points"].size());

  // A curve in the plane is a drawing.
  const std::string circle = "A = 1 + t k; r = (2t, t^2 - 1, 3)/(t^2 + 1) + (0, 0, 1/(t^2 + 1))";
  expect_refused(program.run({"rational", circle, "--dxf", "x.dxf", "--interval", "0,1"}),
                 "not parallel");
  const Outcome drawing =
      program.run({"rational", "A = 1 + t k; r = (2t, t^2 - 1, 3t^2 + 3)/(t^2 + 1)", "--dxf",
                   "circle.dxf", "--interval", "-1,1", "-o", "circle.txt"});
  ASSERT_EQ(drawing.code, 0) << drawing.err;
  EXPECT_NE(text_of_file(program.path("circle.dxf")).find("SPLINE"), std::string::npos);
  expect_refused(program.run({"rational", question, "--dxf", "x.dxf", "--interval", "1,2"}),
                 "--nurbs");
  EXPECT_EQ(text_of_file(program.path("x.dxf")), "");

  // A polynomial curve is a path.
  const Outcome path = program.run({"rational", "A = t^2 - (i+j)t + k; alpha = 1; degree = 5",
                                    "--path", "path.json", "--interval", "0,1"});
  ASSERT_EQ(path.code, 0) << path.err;
  EXPECT_EQ(program.run({"check", "path.json"}).code, 0);
  const auto document = load_document(program.path("path.json"));
  ASSERT_TRUE(document);
  EXPECT_GT(document->path.arc_length(), 0.0);
}

TEST(RationalCommand, WritesALatexDocument) {
  const Program program;
  const Outcome outcome = program.run({"rational", "--examples", "--latex"});
  ASSERT_EQ(outcome.code, 0);
  const std::string& tex = outcome.out;
  EXPECT_TRUE(tex.starts_with("\\documentclass{article}\n"));
  EXPECT_TRUE(tex.ends_with("\\end{document}\n"));
  // Braces, environments, \left and \right, and the two signs of mathematics
  // are in pairs.
  int depth = 0, lefts = 0;
  bool display = false, in_line = false;
  std::vector<std::string> open;
  for (std::size_t i = 0; i < tex.size(); ++i) {
    const std::string_view rest = std::string_view(tex).substr(i);
    if (rest.starts_with("\\{") || rest.starts_with("\\}") || rest.starts_with("\\$")) {
      ++i;
    } else if (tex[i] == '{') {
      ++depth;
    } else if (tex[i] == '}') {
      ASSERT_GT(depth--, 0) << rest.substr(0, 80);
    } else if (rest.starts_with("\\[")) {
      ASSERT_FALSE(display || in_line);
      display = true;
    } else if (rest.starts_with("\\]")) {
      ASSERT_TRUE(display);
      EXPECT_EQ(lefts, 0);
      display = false;
    } else if (tex[i] == '$') {
      ASSERT_FALSE(display);
      in_line = !in_line;
    } else if (rest.starts_with("\\left")) {
      ++lefts;
    } else if (rest.starts_with("\\right")) {
      ASSERT_GT(lefts--, 0);
    } else if (rest.starts_with("\\begin{")) {
      open.emplace_back(rest.substr(7, rest.find('}') - 7));
    } else if (rest.starts_with("\\end{")) {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(rest.substr(5, rest.find('}') - 5), open.back());
      open.pop_back();
    } else if (tex[i] == '^' || tex[i] == '_') {
      EXPECT_TRUE(display || in_line) << rest.substr(0, 80);
    }
  }
  EXPECT_EQ(depth, 0);
  EXPECT_FALSE(display || in_line);
  EXPECT_TRUE(open.empty());
}

TEST(RationalCommand, CarriesNamesFromOneWordToTheNext) {
  const Program program;
  const auto one =
      program.run({"rational", "c = t + 1; A = t^2 - (i+j)*t + k; alpha = c^2", "--json"});
  const auto three =
      program.run({"rational", "c = t + 1", "A = t^2 - (i+j)*t + k", "alpha = c^2", "--json"});
  EXPECT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(one.out, three.out);
}

TEST(RationalCommand, BreaksFormulasThatAreWiderThanThePage) {
  const Program program;
  const auto latex = [&](const std::string& alpha) {
    return program.run({"rational", "A = t^2 - (i+j)*t + k", "alpha = " + alpha, "--latex"}).out;
  };
  EXPECT_EQ(latex("t").find("flushleft"), std::string::npos);
  EXPECT_NE(
      latex("(t + 1)^2*(t^2 + 3)^2; degree = 12").find("\\begin{flushleft}$\\displaystyle C = "),
      std::string::npos);
}

TEST(RationalCommand, PointsAtMistakes) {
  const Program program;
  const auto run = [&](std::vector<std::string> words, const std::string& input = "") {
    words.insert(words.begin(), "rational");
    return program.run(words, input);
  };
  expect_refused(run({"A = t^2 - * t", "alpha = t"}), "line 1, column 11: ");
  expect_refused(run({"-"}, "A = t^2\nalpha = (t + 1"), "standard input, line 2, column 15: ");
  write_text(program.path("bad.txt"), "A = t\n\nalpha = t + q\n");
  expect_refused(run({"bad.txt"}), "bad.txt, line 3, column 13: the name 'q'");
  expect_refused(run({"A = t; alpha = i"}), "line 1, column 16: alpha should be real");
  expect_refused(run({"A = 1/t; alpha = t"}), "line 1, column 5: A should be a polynomial");
  expect_refused(run({"A = t; alpha = t", "alpha = 1"}),
                 "line 2, column 1: 'alpha' is defined twice");
  expect_refused(run({"c = t + 1", "A = t + k", "alpha = d^2"}), "line 3, column 9: the name 'd'");
  expect_refused(run({"{\"A\": \"t +\", \"alpha\": \"t\"}"}), "column 4");
  expect_refused(run({"{\"A\": [[1], [2]], \"alpha\": \"t\"}"}), "4 lists");
  expect_refused(run({"{\"A\": \"t\", \"beta\": \"t\"}"}), "beta");
  expect_refused(run({"{\"A\": [[0.1], [], [], []], \"alpha\": \"t\"}"}), "whole number");
  expect_refused(run({"alpha = t"}), "A is missing");
  expect_refused(run({"A = t"}), "alpha is missing");
  expect_refused(run({}), "there is no input");
  expect_refused(run({"nowhere.txt"}), "nowhere.txt");
  expect_refused(run({"A = t + k; alpha = t; r = (t, 0, 0)"}), "not parallel");
  expect_refused(run({"A = 1 + t k; f = 1/t"}), "identically 0");
  expect_refused(run({"A = t + k; alpha = t^3; r = (0, 0, 0); f = 1"}), "exclude each other");
  expect_refused(run({"A = t + k; alpha = t^3", "--coefficients", "1,2,3,4,5,6,7"}),
                 "coefficients");
  expect_refused(run({"A = t + k; alpha = t^3", "--coefficients", "t"}), "numbers");
  expect_refused(run({"A = t + k; alpha = t^3", "--nurbs", "-"}), "--interval");
  expect_refused(run({"A = t + k; alpha = t^3", "--nurbs", "-", "--interval", "1,2"}),
                 "only one file");
  expect_refused(run({"A = t + j; alpha = t^3", "--nurbs", "x.json", "--interval", "-1,1"}),
                 "a pole");
  expect_refused(run({"A = t + j; alpha = t^3", "--svg", "x.svg", "--interval", "2,1"}), "larger");
  expect_refused(run({"A = t + j; alpha = t; degree = 1", "--svg", "x.svg"}), "points");
  expect_refused(
      run({"A = t^2 - (i+j)t + k; alpha = t^3", "--path", "x.json", "--interval", "1,2"}),
      "denominator");
  expect_refused(run({"A = t + k; alpha = t", "--json", "--latex"}), "exclude");
  expect_refused(run({"--examples", "A = t"}), "no other input");
}

TEST(RationalCommand, RefusesOrAnswersHostileInputInTime) {
  const Program program;
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const auto run = [&](const std::string& text) { return program.run({"rational", "-"}, text); };
  const std::string digits(1'000'000, '7');
  expect_refused(run("A = 0; alpha = t"), "A");
  expect_refused(run("A = t; alpha = 0"), "alpha is 0");
  expect_refused(run("A = t - t; alpha = t"), "0");
  expect_refused(run("A = t^999999999; alpha = t"), "999999999");
  expect_refused(run("A = t^(2^40); alpha = t"), "exponent");
  expect_refused(run("A = t^65 + k; alpha = t"), "degree 65");
  expect_refused(run("A = t + k; alpha = t^65"), "degree 65");
  expect_refused(run("A = t + k; alpha = t; degree = 513"), "512");
  expect_refused(run("A = t + k; alpha = t; degree = -1"), "whole number");
  expect_refused(run("A = t + k; alpha = t; degree = 1e300"), "512");
  expect_refused(run("A = " + digits + "; alpha = t"), "digits");
  expect_refused(run("A = " + std::string(1'000'000, '(') + "; alpha = t"), "nest");
  expect_refused(run("A = t^64 + " + std::string(9'000, '7') + "k; alpha = t"), "too large");
  expect_refused(run("A = t + k; r = (1/(t^70 + 2), 0, 0)"), "not parallel");
  // A huge space: the compact answer, and why there is no more.
  const Outcome large = program.run(
      {"rational", "A = t^2 - (i+j)t + k", "alpha = (t^2 + 3)^9", "degree = 400", "--json"});
  ASSERT_EQ(large.code, 0) << large.err;
  const Json answer = Json::parse(large.out);
  EXPECT_TRUE(answer["basis"].is_null());
  EXPECT_NE(answer["basis_refused"].get<std::string>().find("smaller degree"), std::string::npos);
  EXPECT_TRUE(answer["dimension"]["prediction_exact"].get<bool>());
  EXPECT_EQ(answer["dimension"]["dimension"], answer["dimension"]["predicted"]);
  // Not reduced: reduced, and told.
  const Outcome turned = run("A = (t^2 - (i+j)t + k)(t - i); alpha = t^3");
  ASSERT_EQ(turned.code, 0) << turned.err;
  EXPECT_NE(turned.out.find("divided out       t - i"), std::string::npos) << turned.out;
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  constexpr double most = 60.0;  // all of them, on a busy machine and with sanitizers
  EXPECT_LT(seconds, most);
}

TEST(RationalDocument, ShowsWhatTheProgramSays) {
  // Below every command stand lines of what it prints, in order, however far indented.
  const auto text_in = [](const std::string& line) {
    return line.substr(std::min(line.find_first_not_of(' '), line.size()));
  };
  const Program program;
  const auto lines =
      lines_of(text_of_file(std::string(HODOGRAPH_SOURCE_DIRECTORY) + "/docs/rational.md"));
  std::size_t commands = 0, shown = 0, at = 0;
  std::vector<std::string> said;
  for (const std::string& line : lines) {
    if (line.starts_with("    $ hodograph ")) {
      const Outcome outcome = program.shell(line.substr(6));
      said = lines_of(outcome.out + outcome.err);
      std::transform(said.begin(), said.end(), said.begin(), text_in);
      at = 0;
      ++commands;
    } else if (!line.starts_with("    ")) {
      said.clear();
    } else if (!said.empty()) {
      const auto found =
          std::find(said.begin() + static_cast<std::ptrdiff_t>(at), said.end(), text_in(line));
      ASSERT_NE(found, said.end()) << line;
      at = static_cast<std::size_t>(found - said.begin()) + 1;
      ++shown;
    }
  }
  EXPECT_GE(commands, 4u);
  EXPECT_GE(shown, 25u);
}

TEST(RationalCommand, LeavesNoFileWhereItFails) {
  const Program program;
  write_text(program.path("old.json"), "old");
  expect_refused(program.run({"rational", "A = t + j; alpha = t^3", "--nurbs", "old.json",
                              "--interval", "-1,1"}),
                 "a pole");
  EXPECT_EQ(text_of_file(program.path("old.json")), "old");

  // Nor where it is stopped in the midst of some seconds' work.
  std::uint64_t state = 1;
  const auto polynomial = [&] {
    std::string text = "(1";
    for (int k = 1; k <= 64; ++k) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      text += " + " + std::to_string(state >> 2U) + "t^" + std::to_string(k);
    }
    return text + ")";
  };
  std::string a = "A = " + polynomial();
  for (const char* unit : {"i", "j", "k"}) a += " + " + polynomial() + unit;
  write_text(program.path("long.txt"), a + "\nalpha = " + polynomial());
  const Outcome stopped = program.shell(
      "env --default-signal=INT timeout -s INT 0.2 "
      "hodograph rational long.txt -o old.json --svg new.svg; cat old.json; ls");
  EXPECT_EQ(stopped.out, "oldlong.txt\nold.json\n");
}

}  // namespace
}  // namespace hodograph::test
