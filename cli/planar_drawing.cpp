// SPDX-License-Identifier: MIT
#include "cli/planar_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <type_traits>
#include <utility>

#include "cli/planar_facts.hpp"
#include "cli/sample_plan.hpp"

namespace hodograph::cli {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t points_of_drawing = 4000;
constexpr std::size_t fewest_a_segment = 2, most_a_segment = 600;
constexpr std::size_t most_marked_knots = 400;  // more are a solid line of dots
constexpr double picture_width = 640.0, picture_height = 480.0;
constexpr double profile_height = 320.0;

/// The path at one place, from one side of it.
struct DrawnSample {
  double xi = 0.0, arc_length = 0.0;
  Vector2<double> position{}, normal{};
  double curvature = none;  ///< not a number where the path stands still; the normal as well
};

template <class P, class Curve>
DrawnSample sample_of(const P& path, const Curve& curve, std::size_t segment, double u) {
  DrawnSample sample;
  sample.xi = path.xi_of({segment, u});
  sample.arc_length = path.arc_length({segment, u});
  sample.position = curve.position(u);
  const auto jet = curve.template preimage_jet<1>(u);
  const double size = std::hypot(jet[0].re, jet[0].im);
  if (!(size > 0.0)) {
    sample.normal = {none, none};
    return sample;
  }
  const double c = jet[0].re / size, s = jet[0].im / size;  // of half the tangent's angle
  sample.normal = {-2.0 * c * s, c * c - s * s};
  sample.curvature = curvature(jet);
  return sample;
}

/// What a sample is: the first of a segment, or one that was asked for.
struct Role {
  bool first = false, asked = false;
};

/// Calls visit(sample, role) along the path: every segment from its begin to its end, and at `more`
/// parameters, which ascend. (A std::function, so that it is compiled once for every kind of path.)
void for_each_sample(const AnyPath& path, const std::vector<double>& more,
                     const std::function<void(const DrawnSample&, Role)>& visit) {
  path.visit([&](const auto& p) {
    using P = std::remove_cvref_t<decltype(p)>;
    if constexpr (P::Point::dimension == 2) {
      const std::size_t intervals =
          std::clamp(points_of_drawing / p.segment_count(), fewest_a_segment, most_a_segment);
      auto next = more.begin();
      std::vector<std::pair<double, bool>> places;
      for (std::size_t k = 0; k < p.segment_count(); ++k) {
        places.clear();
        for (std::size_t i = 0; i <= intervals; ++i) {
          places.emplace_back(static_cast<double>(i) / static_cast<double>(intervals), false);
        }
        const double begin = p.knots()[k], end = p.knots()[k + 1];
        for (; next != more.end() && *next <= end; ++next) {
          places.emplace_back(std::clamp((*next - begin) / (end - begin), 0.0, 1.0), true);
        }
        std::sort(places.begin(), places.end());
        for (std::size_t i = 0; i < places.size(); ++i) {
          visit(sample_of(p, p.segment(k), k, places[i].first), Role{i == 0, places[i].second});
        }
      }
    } else {
      throw Error(Fault{FaultCode::unsupported,
                        "the path is in space; this picture is of paths in the plane", std::nullopt,
                        "dimension", 3.0, 2.0});
    }
  });
}

void add(Series& series, const Vector2<double>& p) {
  series.x.push_back(p.x);
  series.y.push_back(p.y);
}

Plot empty_picture(const PathDocument& document, const std::string& title) {
  const std::string unit = document.length_unit.empty() ? "" : " (" + document.length_unit + ")";
  Plot plot;
  plot.title = title;
  plot.x.label = "x" + unit;
  plot.y.label = "y" + unit;
  plot.equal_aspect = true;
  plot.width = picture_width;
  plot.height = picture_height;
  return plot;
}

void add_path(Plot& plot, const AnyPath& path) {
  Series line{"path", {}, {}, SeriesStyle::line, PlotColor::blue};
  Series knots{"knots", {}, {}, SeriesStyle::dots, PlotColor::blue};
  for_each_sample(path, {}, [&](const DrawnSample& at, Role role) {
    add(line, at.position);
    if (role.first) add(knots, at.position);
  });
  add(knots, {line.x.back(), line.y.back()});
  plot.marks.push_back({{line.x.front(), line.y.front()}, "start", PlotColor::grey});
  plot.series.push_back(std::move(line));
  if (knots.x.size() <= most_marked_knots) plot.series.push_back(std::move(knots));
}

void add_offset(Plot& plot, const AnyPath& path, const PathOffset& offset, Series line,
                Series& cusp_dots) {
  // Offsets of a corner do not meet; what turns by less than this is no corner that is seen.
  constexpr double seen_angle = 0x1p-10;
  std::vector<double> places;
  for (const OffsetCusp& cusp : offset.cusps) places.push_back(cusp.xi);
  std::sort(places.begin(), places.end());
  Vector2<double> before{};
  for_each_sample(path, places, [&](const DrawnSample& at, Role role) {
    const Vector2<double> point = at.position + offset.distance * at.normal;
    const bool jumps =
        role.first && !line.x.empty() &&
        std::max(std::abs(at.normal.x - before.x), std::abs(at.normal.y - before.y)) > seen_angle;
    if (jumps) add(line, {none, none});
    add(line, point);
    before = at.normal;
    if (role.asked) add(cusp_dots, point);
  });
  plot.series.push_back(std::move(line));
}

double extent_of(const Series& line) {
  const auto [left, right] = std::minmax_element(line.x.begin(), line.x.end());
  const auto [bottom, top] = std::minmax_element(line.y.begin(), line.y.end());
  return std::max(*right - *left, *top - *bottom);
}

/// Where a parameter of the path stands on the axis of arc lengths.
double arc_length_at(const AnyPath& path, double xi) {
  return path.arc_length(std::clamp(xi, path.xi_begin(), path.xi_end()));
}

std::string six_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace

Plot offset_picture(const PathDocument& document, const std::vector<PathOffset>& offsets) {
  Plot plot = empty_picture(document, "Offsets");
  add_path(plot, document.path);
  add_offsets(plot, document.path, offsets);
  return plot;
}

void add_offsets(Plot& plot, const AnyPath& path, const std::vector<PathOffset>& offsets) {
  constexpr std::array colors = {PlotColor::vermilion, PlotColor::green, PlotColor::gold};
  Series dots{"cusps", {}, {}, SeriesStyle::dots, PlotColor::grey};
  bool left_named = false, right_named = false;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    Series line;
    if (offsets.size() <= colors.size()) {
      line.label = "offset " + to_text(offsets[i].distance);
      line.color = colors[i];
    } else {  // one colour for either side, named once
      const bool left = offsets[i].distance > 0.0;
      if (!std::exchange(left ? left_named : right_named, true)) {
        line.label = left ? "offsets to the left" : "offsets to the right";
      }
      line.color = left ? PlotColor::vermilion : PlotColor::green;
    }
    add_offset(plot, path, offsets[i], std::move(line), dots);
  }
  if (!dots.x.empty()) plot.series.push_back(std::move(dots));
}

Plot curvature_comb(const PathDocument& document, const std::optional<double>& scale) {
  if (scale && !(*scale > 0.0 && std::isfinite(*scale))) {
    throw Error(Fault{FaultCode::outside_domain,
                      "the scale of the comb is " + to_text(*scale) +
                          "; it should be positive: the length of a tooth where the curvature is 1",
                      std::nullopt, "comb_scale", *scale, 0.0});
  }
  constexpr double longest_tooth = 0.2;  // of the path's extent
  constexpr std::size_t teeth = 160;
  const AnyPath& path = document.path;
  Plot plot = empty_picture(document, "Curvature comb");
  add_path(plot, path);
  double largest = 0.0;
  for_each_sample(path, {}, [&](const DrawnSample& at, Role) {
    if (std::isfinite(at.curvature)) largest = std::max(largest, std::abs(at.curvature));
  });
  const double factor = scale           ? *scale
                        : largest > 0.0 ? longest_tooth * extent_of(plot.series.front()) / largest
                                        : 1;
  // Teeth evenly along the path.
  SamplePlan plan;
  plan.count = teeth + 1;
  const std::vector<double> places = sampled_parameters(path, plan).value();
  Series comb{"", {}, {}, SeriesStyle::thin_line, PlotColor::purple};
  Series crest{"curvature, teeth of " + six_digits(factor) + " |\xce\xba|",
               {},
               {},
               SeriesStyle::line,
               PlotColor::purple};
  for_each_sample(path, places, [&](const DrawnSample& at, Role role) {
    const Vector2<double> tip = at.position - (factor * at.curvature) * at.normal;
    add(crest, tip);
    if (!role.asked) return;
    add(comb, at.position);
    add(comb, tip);
    add(comb, {none, none});
  });
  plot.series.insert(plot.series.begin(), std::move(crest));
  plot.series.insert(plot.series.begin(), std::move(comb));
  return plot;
}

Plot curvature_profile(const PathDocument& document) {
  constexpr std::size_t most_marks = 2000;
  const AnyPath& path = document.path;
  const std::string& unit = document.length_unit;
  Plot plot;
  plot.title = "Curvature";
  plot.x.label = "arc length" + (unit.empty() ? "" : " (" + unit + ")");
  if (!unit.empty()) plot.y.label = "1/" + unit;
  plot.width = picture_width;
  plot.height = profile_height;
  plot.clip_outliers = true;
  Series line{"", {}, {}, SeriesStyle::line, PlotColor::blue};
  const auto facts = planar_facts_of(path);
  std::vector<double> places;
  if (facts) {
    for (const CurvaturePlace& one : facts->curvature_extremes) places.push_back(one.xi);
    std::sort(places.begin(), places.end());
  }
  std::pair<double, double> lowest{0.0, std::numeric_limits<double>::infinity()};
  std::pair<double, double> highest{0.0, -std::numeric_limits<double>::infinity()};
  for_each_sample(path, places, [&](const DrawnSample& at, Role) {
    add(line, {at.arc_length, at.curvature});
    if (at.curvature < lowest.second) lowest = {at.arc_length, at.curvature};
    if (at.curvature > highest.second) highest = {at.arc_length, at.curvature};
  });
  plot.series.push_back(std::move(line));
  if (!facts) return plot;  // for_each_sample has thrown
  if (facts->smallest_curvature.lower() < 0.0 && facts->largest_curvature.upper() > 0.0) {
    plot.levels.push_back({0.0, ""});
  }
  if (facts->curvature_extremes.size() <= most_marks) {
    Series dots{"extremes", {}, {}, SeriesStyle::dots, PlotColor::vermilion};
    for (const CurvaturePlace& one : facts->curvature_extremes) {
      if (one.kind == "undecided") continue;
      add(dots, {arc_length_at(path, one.xi), one.curvature.middle()});
    }
    if (!dots.x.empty()) plot.series.push_back(std::move(dots));
  }
  if (facts->inflections.size() <= most_marks) {
    Series dots{"inflections", {}, {}, SeriesStyle::dots, PlotColor::green};
    for (const CurvaturePlace& one : facts->inflections) {
      if (one.kind == "simple") add(dots, {arc_length_at(path, one.xi), 0.0});
    }
    if (!dots.x.empty()) plot.series.push_back(std::move(dots));
  }
  // The largest and the smallest by name; the values are those that are certain.
  const auto mark = [&](const Enclosure& value, double at, const std::string& name) {
    if (!value.is_bounded() || !std::isfinite(at)) return;
    plot.marks.push_back(
        {{at, value.middle()}, name + " " + six_digits(value.middle()), PlotColor::vermilion});
  };
  mark(facts->largest_curvature, highest.first, "largest");
  if (facts->smallest_curvature.lower() < facts->largest_curvature.lower()) {
    mark(facts->smallest_curvature, lowest.first, "smallest");
  }
  if (path.knots().size() <= most_marked_knots) plot.x_marks = path.knot_arc_lengths();
  return plot;
}

}  // namespace hodograph::cli
