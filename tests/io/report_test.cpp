// SPDX-License-Identifier: MIT
// The report: the table says what is promised and no more, the page stands alone.
#include "hodograph/io/report.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "markup_check.hpp"
#include "tests/support/random.hpp"

namespace hodograph {
namespace {

ReportData sample() {
  ReportData data;
  data.title = "Orbit <A> & B";
  data.summary = "One revolution.";
  data.document_name = "orbit.json";
  data.segments = 20;
  data.preimage_degree = 8;
  data.closed = true;
  data.length_unit = "LU";
  data.parameter_unit = "TU";
  data.promises.continuity = ContinuityOrders{4, 3, 3, 2};
  data.promises.error = ErrorPromise{Enclosure(0.0041231, 0.0081231), true, "orbit"};
  data.promises.arc_length = Enclosure(0.51234567890, 0.51234567891);
  data.promises.smallest_speed = Enclosure(0.08231, 0.08231);
  data.promises.largest_speed = Enclosure(1.4101, 1.4209);
  data.promises.curvature_bound = 91.23456;
  data.tolerance = 0.01;
  data.seconds = 0.0123;
  data.more = {{"Revolutions", "1"}};
  for (int i = 0; i <= 100; ++i) {
    const double t = 0.0628 * i;
    data.xi.push_back(t);
    data.path.points.push_back({std::cos(t), std::sin(t), 0.3 * t});
    data.speed.push_back(1.0);
    data.curvature.push_back(0.5);
    data.torsion.push_back(i == 50 ? std::numeric_limits<double>::quiet_NaN() : 1.0 / (i - 50));
    data.body_rate.push_back({0.1, 0.2, std::sin(t)});
    data.error_xi.push_back(t);
    data.error.push_back(0.008 * std::abs(std::sin(10.0 * t)));
  }
  data.path.frame_origins = {data.path.points[0]};
  data.path.frames = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  data.knots = {0, 1, 2, 3};
  return data;
}

TEST(Report, TheTableSaysWhatIsPromised) {
  EXPECT_EQ(
      report_text(sample()),
      "  Segments                 20 of degree 17, closed\n"
      "  Position error           at most 0.008124 LU and at least 0.004123, certified (tolerance "
      "0.01)\n"
      "  Length                   0.512345679 LU\n"
      "  Smallest speed           0.08231 LU/TU\n"
      "  Largest speed            1.41 to 1.421 LU/TU\n"
      "  Curvature                at most 91.24 1/LU\n"
      "  Continuity at the knots  position C4, frame C3, angular velocity C2\n"
      "  Time taken               12.3 ms\n"
      "  Revolutions              1\n");
  ReportData data = sample();
  data.promises.error->certified = false;
  EXPECT_NE(report_text(data).find("about 0.008124 LU, an estimate (tolerance 0.01)"),
            std::string::npos);
  data = {};
  data.segments = 1;
  EXPECT_EQ(report_text(data), "  Segments  1 of degree 1\n");
}

// A bound that is printed still holds.
TEST(Report, BoundsAreRoundedAwayFromTheTruth) {
  test::Random random("Report.BoundsAreRoundedAwayFromTheTruth");
  for (int i = 0; i < 20000; ++i) {
    ReportData data;
    const double bound = std::abs(random.chance(0.5) ? random.hostile() : random.uniform(0, 1000));
    data.promises.curvature_bound = bound;
    const auto rows = report_rows(data);
    ASSERT_EQ(rows.size(), 1U);  // nothing else is known of this path
    const std::string text = rows[0].second;
    constexpr std::size_t after_words = std::string_view("at most ").size();
    double printed = -1.0;
    std::from_chars(text.data() + after_words, text.data() + text.size(), printed);
    ASSERT_GE(printed, bound) << text;
    constexpr double two_units_of_four_digits = 1.003;  // half a unit and a unit of 1 in 1000, once
    if (bound > std::numeric_limits<double>::min()) {
      ASSERT_LE(printed / two_units_of_four_digits, bound) << text;
    }
  }
}

TEST(Report, ThePageStandsAlone) {
  const std::string html = report_html(sample());
  EXPECT_EQ(markup_problem(html), "");
  for (const std::string_view part :
       {"http", "<script", "<link", "@import", "url(", "src=", "nan", "inf\""}) {
    EXPECT_EQ(html.find(part), std::string::npos) << part;
  }
  for (const std::string_view part :
       {"<!DOCTYPE html>", "charset=\"utf-8\"", "name=\"viewport\"", "prefers-color-scheme:dark",
        "@media print", "<title>Orbit &lt;A&gt; &amp; B</title>", "orbit.json", "Speed σ",
        "Curvature κ", "Torsion τ", "Angular velocity ω", "Position error", "tolerance 0.01",
        "certified", "x–y", "x–z", "y–z"}) {
    EXPECT_NE(html.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(report_plots(sample()).size(), 8U);
}

TEST(Report, WhatIsMissingIsLeftOut) {
  const std::string html = report_html({});
  EXPECT_EQ(markup_problem(html), "");
  EXPECT_EQ(html.find("<svg"), std::string::npos);
  ReportData plane = sample();
  plane.dimension = 2;
  plane.torsion.clear();
  EXPECT_EQ(report_plots(plane).size(), 5U);
}

}  // namespace
}  // namespace hodograph
