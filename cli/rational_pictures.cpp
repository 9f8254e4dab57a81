// SPDX-License-Identifier: MIT
// Rational curves drawn between their poles, and as paths.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "cli/rationals.hpp"

namespace hodograph::cli {
namespace {

constexpr std::size_t points_between_poles = 1200;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A parameter with the point and the signed speed there.
struct Sample {
  double t;
  Vector3<double> point;
  double speed;
};

double value(const RationalFunction& f, const Rational& t) {
  return f.denominator().value(t).is_zero() ? none : f.value(t).to_double();
}

Sample sample_at(const RationalPhCurve& curve, const RationalFunction& speed, double t) {
  const auto exact = Rational::exactly(t);
  const Sample gap{t, {none, none, none}, none};
  if (!exact || curve.position().denominator().value(*exact).is_zero()) return gap;
  const auto point = position(curve, t);
  return point ? Sample{t, *point, value(speed, *exact)} : gap;
}

/// Parameters of a branch between two poles, or an end: crowded towards both.
void add_branch(std::vector<double>& ts, double begin, double end) {
  for (std::size_t i = 0; i <= points_between_poles; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / (points_between_poles + 1);
    ts.push_back(begin + 0.5 * (end - begin) * (1.0 - std::cos(std::numbers::pi * share)));
  }
  ts.push_back(none);
}

/// The part of the values that a picture shows: the middle nine tenths, and as much besides on
/// either side. What goes to a pole leaves it.
std::pair<double, double> window(std::vector<double> values) {
  values.erase(
      std::remove_if(values.begin(), values.end(), [](double x) { return !std::isfinite(x); }),
      values.end());
  if (values.empty()) return {0.0, 1.0};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  const double low = at(0.1), high = at(0.9), margin = high - low;
  return {std::max(values.front(), low - margin), std::min(values.back(), high + margin)};
}

}  // namespace

std::vector<Plot> rational_pictures(const DescribedCurve& described,
                                    const std::optional<std::pair<double, double>>& interval) {
  const RationalPhCurve& curve = described.curve;
  if (interval && !(interval->first < interval->second && std::isfinite(interval->first) &&
                    std::isfinite(interval->second))) {
    throw Error(Fault{FaultCode::not_increasing,
                      "an interval runs from a number to a larger one; got " +
                          to_text(interval->first) + " to " + to_text(interval->second),
                      std::nullopt, "interval", interval->first, std::nullopt});
  }
  // Places that matter; the picture reaches as far beyond them as they lie apart.
  std::vector<double> poles;
  for (const RealRoot& root : described.poles) poles.push_back(root.to_double());
  std::vector<double> places = poles;
  if (described.stationary) {
    for (const RealRoot& root : *described.stationary) places.push_back(root.to_double());
  }
  places.erase(
      std::remove_if(places.begin(), places.end(), [](double x) { return !std::isfinite(x); }),
      places.end());
  double begin = -2.0, end = 2.0;
  if (!places.empty()) {
    const auto [low, high] = std::minmax_element(places.begin(), places.end());
    const double beyond = std::max(2.0, *high - *low);
    begin = *low - beyond;
    end = *high + beyond;
  }
  if (interval) std::tie(begin, end) = *interval;
  std::vector<double> ts;
  double from = begin;
  for (const double pole : poles) {
    if (!(begin < pole && pole < end)) continue;
    add_branch(ts, from, pole);
    from = pole;
  }
  add_branch(ts, from, end);

  const RationalFunction speed = curve.speed();
  std::vector<Sample> samples;
  for (const double t : ts) {
    samples.push_back(std::isfinite(t) ? sample_at(curve, speed, t)
                                       : Sample{none, {none, none, none}, none});
  }
  std::array<std::pair<double, double>, 3> box;
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<double> values;
    for (const Sample& s : samples) values.push_back(s.point[c]);
    box[c] = poles.empty() ? std::pair(-std::numeric_limits<double>::max(),
                                       std::numeric_limits<double>::max())
                           : window(std::move(values));
  }
  const auto inside = [&](const Vector3<double>& p) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (!(box[c].first <= p[c] && p[c] <= box[c].second)) return false;
    }
    return true;
  };
  constexpr std::array<const char*, 3> names = {"x", "y", "z"};
  constexpr std::array<std::array<std::size_t, 2>, 3> views = {{{0, 1}, {0, 2}, {1, 2}}};
  std::vector<Plot> plots;
  for (const auto& [across, up] : views) {
    Plot plot;
    plot.x.label = names[across];
    plot.y.label = names[up];
    plot.equal_aspect = true;
    Series line;
    for (const Sample& s : samples) {
      const bool shown = inside(s.point);
      line.x.push_back(shown ? s.point[across] : none);
      line.y.push_back(shown ? s.point[up] : none);
    }
    plot.series.push_back(std::move(line));
    if (described.stationary) {
      for (const RealRoot& root : *described.stationary) {
        const Sample s = sample_at(curve, speed, root.to_double());
        if (!(begin <= s.t && s.t <= end) || !inside(s.point)) continue;
        plot.marks.push_back(
            {{s.point[across], s.point[up]}, root.multiplicity() % 2 != 0 ? "cusp" : "stop"});
      }
    }
    plots.push_back(std::move(plot));
  }
  Plot plot;
  plot.x.label = "t";
  plot.y.label = "speed, negative against F";
  plot.clip_outliers = true;
  Series line;
  const auto [low, high] = window([&] {
    std::vector<double> values;
    for (const Sample& s : samples) values.push_back(s.speed);
    return values;
  }());
  for (const Sample& s : samples) {
    const bool shown = poles.empty() || (low <= s.speed && s.speed <= high);
    line.x.push_back(shown ? s.t : none);
    line.y.push_back(shown ? s.speed : none);
  }
  plot.series.push_back(std::move(line));
  plots.push_back(std::move(plot));
  plots.front().title = described.name;
  return plots;
}

MadePath path_of(const DescribedCurve& curve, double begin, double end, const std::string& source) {
  return made_path(AnyPath::create(path_numbers(curve.curve, begin, end).value()).value(), source,
                   "rational PH curve", "polynomial");
}

}  // namespace hodograph::cli
