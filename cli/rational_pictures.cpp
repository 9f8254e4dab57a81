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

constexpr std::size_t points = 3000;
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

/// The part of the values that a picture shows: the middle half, and as much besides on either
/// side. What goes to a pole or to infinity leaves it.
std::pair<double, double> window(std::vector<double> values) {
  values.erase(
      std::remove_if(values.begin(), values.end(), [](double x) { return !std::isfinite(x); }),
      values.end());
  if (values.empty()) return {0.0, 1.0};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  const double low = at(0.25), high = at(0.75), margin = high - low;
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
  std::vector<double> poles;
  for (const RealRoot& root : described.poles) poles.push_back(root.to_double());
  // Without an interval the whole line, t = centre + reach · tan(φ / 2), by the places that matter.
  std::vector<double> places = poles;
  if (described.stationary) {
    for (const RealRoot& root : *described.stationary) places.push_back(root.to_double());
  }
  places.erase(
      std::remove_if(places.begin(), places.end(), [](double x) { return !std::isfinite(x); }),
      places.end());
  double centre = 0.0, reach = 1.0;
  if (!places.empty()) {
    const auto [low, high] = std::minmax_element(places.begin(), places.end());
    centre = 0.5 * *low + 0.5 * *high;
    reach = std::max(1.0, 0.5 * *high - 0.5 * *low);
  }
  std::vector<double> ts;
  std::size_t next_pole = 0;
  for (std::size_t i = 0; i <= points; ++i) {
    const double share = static_cast<double>(i) / points;
    const double angle = std::numbers::pi * (share - 0.5);
    const double t = interval ? interval->first + share * (interval->second - interval->first)
                              : centre + reach * std::tan(angle);
    while (next_pole < poles.size() && poles[next_pole] < t) {
      ts.push_back(none);  // a gap
      ++next_pole;
    }
    ts.push_back(t);
  }

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
    box[c] = interval && poles.empty() ? std::pair(-std::numeric_limits<double>::max(),
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
        const bool drawn = !interval || (interval->first <= s.t && s.t <= interval->second);
        if (!drawn || !inside(s.point)) continue;
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
  constexpr double widest = 4.0;  // times the reach
  const auto near = [&](const Sample& s) {
    return interval || std::abs(s.t - centre) <= widest * reach;
  };
  std::vector<double> speeds;
  for (const Sample& s : samples) speeds.push_back(near(s) ? s.speed : none);
  const auto [low, high] = window(speeds);
  for (const Sample& s : samples) {
    const bool shown = near(s) && (poles.empty() || (low <= s.speed && s.speed <= high));
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
