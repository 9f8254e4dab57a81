// SPDX-License-Identifier: MIT
// Pictures: well-formed, self-contained, finite whatever the data.
#include "hodograph/io/svg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "markup_check.hpp"
#include "src/io/ticks.hpp"
#include "tests/support/random.hpp"

namespace hodograph {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<std::string> labels(const io_detail::TickedRange& range) {
  std::vector<std::string> all;
  for (const auto& tick : range.ticks) all.push_back(tick.label);
  return all;
}
using Labels = std::vector<std::string>;

TEST(Ticks, AreRoundNumbers) {
  EXPECT_EQ(labels(io_detail::linear_ticks(0.0, 1.0, 5)),
            (Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(labels(io_detail::linear_ticks(-1.1, 1.1, 4)), (Labels{"−1", "0", "1"}));
  EXPECT_EQ(labels(io_detail::linear_ticks(-30.0, 70.0, 3)), (Labels{"0", "50"}));
  const auto small = io_detail::linear_ticks(0.0, 4.1e-9, 4);  // not a tolerance: an axis
  EXPECT_EQ(labels(small), (Labels{"0", "2", "4"}));
  EXPECT_EQ(small.factor, "×10⁻⁹");
  const auto large = io_detail::linear_ticks(1.21e7, 1.24e7, 4);
  EXPECT_EQ(labels(large), (Labels{"1.21", "1.22", "1.23", "1.24"}));
  EXPECT_EQ(large.factor, "×10⁷");
  EXPECT_EQ(labels(io_detail::decade_ticks(-7.5, -2.1, 10)),
            (Labels{"10⁻²", "10⁻³", "10⁻⁴", "10⁻⁵", "10⁻⁶", "10⁻⁷", "10⁻⁸"}));
}

TEST(Ticks, AreFewAndInsideTheRange) {
  test::Random random("Ticks.AreFewAndInsideTheRange");
  for (int i = 0; i < 20000; ++i) {
    const double a = random.spread(-990, 990);
    const double b = a + random.spread(-20, 5) * a;
    const double low = std::min(a, b), high = std::max(a, b);
    if (!(low < high)) continue;
    const auto range = io_detail::linear_ticks(low, high, 5);
    ASSERT_LE(range.ticks.size(), 7U) << low << " " << high;
    for (const auto& tick : range.ticks) {
      ASSERT_LE(low, tick.value);
      ASSERT_LE(tick.value, high);
      ASSERT_FALSE(tick.label.empty());
      ASSERT_LT(tick.label.size(), 24U);
    }
  }
}

Plot busy_plot() {
  Plot plot;
  plot.title = "a < b & \"c\"";
  plot.x.label = "ξ (TU)";
  plot.y.label = "LU";
  plot.series = {{"first", {0, 1, 2}, {1, 3, 2}},
                 {"", {0, 2}, {2, 2}, SeriesStyle::dashed_line},
                 {"dots", {0, 1}, {1, 1}, SeriesStyle::dots, PlotColor::gold}};
  plot.arrows = {{"e₁", PlotColor::green, {{{0, 1}, {1, 2}}}}};
  plot.marks = {{{2, 2}, "end", PlotColor::grey}};
  plot.levels = {{2.5, "limit"}};
  plot.x_marks = {0, 1, 2};
  return plot;
}

TEST(Svg, IsWellFormedAndComplete) {
  const std::string svg = to_svg(busy_plot());
  EXPECT_EQ(markup_problem(svg), "");
  for (const std::string_view part :
       {"a &lt; b &amp; &quot;c&quot;", ">first<", ">dots<", ">e₁<", ">limit<", ">end<", "ξ (TU)",
        "hg-dash", "prefers-color-scheme"}) {
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(svg.find("http://www.w3.org/2000/svg"), svg.find("http"));
  EXPECT_EQ(svg.rfind("http"), svg.find("http"));
  const std::vector<Plot> plots(5, busy_plot());
  EXPECT_EQ(markup_problem(to_svg(plots, 3)), "");
  EXPECT_EQ(markup_problem(to_svg(std::span<const Plot>{}, 3)), "");
  EXPECT_EQ(svg_element(busy_plot()).find("http"), std::string::npos);
}

// A gap for a point that is not finite; equal scales; the lower edge for zero on a logarithmic
// axis.
TEST(Svg, DrawsWhatItSays) {
  Plot plot;
  plot.series = {{"", {0, 1, 2, 3, 4}, {0, 1, nan, 1, 0}}};
  std::string svg = svg_element(plot);
  const std::size_t line = svg.find("hg-line");
  const std::string path = svg.substr(line, svg.find("/>", line) - line);
  EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 2);
  EXPECT_EQ(std::count(path.begin(), path.end(), 'L'), 2);
  plot.series = {{"", {0, 1, 2}, {0.0, 0.01, 10}}};
  plot.y.logarithmic = true;
  svg = svg_element(plot);
  EXPECT_NE(svg.find(">10⁻²<"), std::string::npos);
  EXPECT_NE(svg.find(">10¹<"), std::string::npos);
}

TEST(Svg, ManyPointsAreThinnedOut) {
  Plot plot;
  Series series;
  for (int i = 0; i <= 1000000; ++i) {
    series.x.push_back(i);
    series.y.push_back(std::sin(i / 100000.0));
  }
  plot.series = {series};
  EXPECT_LT(svg_element(plot).size(), 100000U);
}

TEST(Svg, AnyNumbersGiveAFiniteWellFormedPicture) {
  test::Random random("Svg.AnyNumbersGiveAFiniteWellFormedPicture");
  for (int i = 0; i < 3000; ++i) {
    const auto number = [&] {
      switch (random.integer(0, 9)) {
        case 0:
          return nan;
        case 1:
          return infinity * random.sign();
        case 2:
          return 1.0;
        default:
          return random.hostile();
      }
    };
    Plot plot;
    plot.x.logarithmic = random.chance(0.3);
    plot.y.logarithmic = random.chance(0.3);
    plot.equal_aspect = random.chance(0.3);
    plot.clip_outliers = random.chance(0.3);
    for (std::int64_t k = random.integer(0, 2); k > 0; --k) {
      Series series;
      series.label = random.chance(0.5) ? "name" : "";
      series.style = static_cast<SeriesStyle>(random.integer(0, 2));
      for (std::int64_t n = random.integer(0, 90); n > 0; --n) series.x.push_back(number());
      for (std::int64_t n = random.integer(0, 90); n > 0; --n) series.y.push_back(number());
      plot.series.push_back(series);
    }
    plot.arrows = {{"", PlotColor::blue, {{{number(), number()}, {number(), number()}}}}};
    plot.marks = {{{number(), number()}, "m", PlotColor::blue}};
    plot.levels = {{number(), "l"}};
    plot.x_marks = {number()};
    if (random.chance(0.1)) plot.width = plot.height = 10.0;
    const std::string svg = to_svg(plot);
    ASSERT_EQ(markup_problem(svg), "");
    ASSERT_EQ(svg.find("nan"), std::string::npos) << svg;
    ASSERT_EQ(svg.find("inf"), std::string::npos) << svg;
    ASSERT_LT(svg.size(), 60000U);
  }
}

TEST(Svg, HostileTextIsHarmless) {
  EXPECT_EQ(escaped_markup("<script>&'\"\x01\xff</"),
            "&lt;script&gt;&amp;'&quot;\xef\xbf\xbd\xef\xbf\xbd&lt;/");
  Plot plot = busy_plot();
  plot.title = plot.x.label = plot.series[0].label = "\"/><script>\xff]]>";
  EXPECT_EQ(markup_problem(to_svg(plot)), "");
  EXPECT_EQ(to_svg(plot).find("<script"), std::string::npos);
}

TEST(PathPictures, ShowTheAxesTheyName) {
  FramedPolyline curve;
  curve.points = {{1, 20, 300}, {2, 21, 301}};
  curve.frame_origins = {curve.points[0]};
  curve.frames = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  curve.closed = true;
  const Plot plot = projected(curve, Projection::yz, "m", 0.5);
  EXPECT_EQ(plot.x.label, "y (m)");
  EXPECT_EQ(plot.y.label, "z (m)");
  EXPECT_EQ(plot.series[0].x, (std::vector<double>{20, 21, 20}));
  EXPECT_EQ(plot.series[0].y, (std::vector<double>{300, 301, 300}));
  ASSERT_EQ(plot.arrows.size(), 3U);
  EXPECT_EQ(plot.arrows[2].from_to[0].second, (Vector2<double>{20, 300.5}));
  EXPECT_TRUE(plot.equal_aspect);
  EXPECT_EQ(plane_picture(curve).arrows.size(), 2U);
  EXPECT_EQ(markup_problem(to_svg(projected({}, Projection::xy))), "");
}

}  // namespace
}  // namespace hodograph
