// SPDX-License-Identifier: MIT
#include "cli/swarm_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "cli/made_path.hpp"

namespace hodograph::cli {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr int colors = 6;  // of PlotColor

/// Places of one vehicle at evenly spaced times.
using Track = std::vector<Vector3<double>>;

struct Extent {
  double left = std::numeric_limits<double>::infinity(), right = -left;
  double bottom = left, top = -left;

  void add(double x, double y, double margin) {
    left = std::min(left, x - margin);
    right = std::max(right, x + margin);
    bottom = std::min(bottom, y - margin);
    top = std::max(top, y + margin);
  }
};

struct Span {
  double begin = std::numeric_limits<double>::infinity(), end = -begin;
};

/// From the first start to the last arrival.
Span span_of(const SwarmFacts& facts) {
  Span span;
  for (const Vehicle& v : facts.vehicles) {
    span.begin = std::min(span.begin, v.motion.start_time());
    span.end = std::max(span.end, v.motion.end_time());
  }
  return span;
}

std::vector<Track> tracks_of(const SwarmFacts& facts, const Span& span, std::size_t frames) {
  std::vector<Track> tracks;
  for (const Vehicle& v : facts.vehicles) {
    Track track;
    for (std::size_t i = 0; i <= frames; ++i) {
      const double x = static_cast<double>(i) / static_cast<double>(frames);
      track.push_back(v.motion.position(span.begin * (1.0 - x) + span.end * x));
    }
    tracks.push_back(std::move(track));
  }
  return tracks;
}

std::string pixels(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

/// A share of the duration, as keyTimes has them.
std::string share(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.5f", std::clamp(value, 0.0, 1.0));
  return text;
}

/// When a vehicle is too close to another, as shares of the span, disjoint and in order.
std::vector<Span> alarms_of(const SwarmFacts& facts, std::size_t vehicle, const Span& span) {
  std::vector<Span> all, merged;
  const double length = span.end - span.begin;
  for (const Conflict& c : facts.conflicts) {
    if (c.pair.first != vehicle && c.pair.second != vehicle) continue;
    for (const ClosePassage& p : c.passages) {
      all.push_back({std::clamp((p.begin - span.begin) / length, 0.0, 1.0),
                     std::clamp((p.end - span.begin) / length, 0.0, 1.0)});
    }
  }
  std::sort(all.begin(), all.end(), [](const Span& a, const Span& b) { return a.begin < b.begin; });
  for (const Span& one : all) {
    if (!merged.empty() && one.begin <= merged.back().end) {
      merged.back().end = std::max(merged.back().end, one.end);
    } else {
      merged.push_back(one);
    }
  }
  return merged;
}

/// Shown while an alarm lasts.
std::string alarm_animation(const std::vector<Span>& alarms, const std::string& duration) {
  std::string values = "0", times = "0";
  for (const Span& alarm : alarms) {
    values += ";1;0";
    times += ";" + share(alarm.begin) + ";" + share(alarm.end);
  }
  return "<animate attributeName=\"opacity\" calcMode=\"discrete\" values=\"" + values +
         "\" keyTimes=\"" + times + "\" dur=\"" + duration + "\" repeatCount=\"indefinite\"/>";
}

/// The animation as one element.
std::string animation_element(const SwarmFacts& facts) {
  constexpr std::size_t frames = 300, most_named = 40;
  constexpr double width = 800.0, head = 36.0, foot = 40.0, edge = 24.0, most_height = 640.0;
  constexpr double smallest_dot = 3.5, name_offset = 4.0;
  const std::string duration = "12s";
  const Span span = span_of(facts);
  const std::vector<Track> tracks = tracks_of(facts, span, frames);
  Extent extent;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const double reach = facts.vehicles[i].radius + 0.5 * facts.goal.clearance;
    for (const auto& p : tracks[i]) extent.add(p.x, p.y, reach);
  }
  const double wide = std::max(extent.right - extent.left, std::numeric_limits<double>::min());
  const double high = std::max(extent.top - extent.bottom, std::numeric_limits<double>::min());
  const double scale = std::min((width - 2.0 * edge) / wide, most_height / high);
  const double height = head + foot + edge + scale * high;
  const double shift = 0.5 * (width - scale * wide);
  const auto x_of = [&](double x) { return pixels(shift + scale * (x - extent.left)); };
  const auto y_of = [&](double y) { return pixels(head + scale * (extent.top - y)); };
  const std::string size = pixels(width) + " " + pixels(height);

  std::string out =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"hg-plot\" id=\"swarm\" "
      "viewBox=\"0 0 " +
      size + "\" width=\"" + pixels(width) + "\" height=\"" + pixels(height) +
      "\" role=\"img\" aria-label=\"A swarm in flight\">\n";
  out += "<style>" + std::string(plot_style()) +
         ".alarm{fill:none;stroke:#d5500c;stroke-width:3}.reach{stroke-dasharray:3 3;opacity:.7}"
         "</style>\n";
  out += "<rect class=\"hg-paper\" width=\"100%\" height=\"100%\"/>\n";
  out += "<text class=\"hg-title\" x=\"" + pixels(edge) + "\" y=\"22\">" +
         std::to_string(facts.vehicles.size()) + " vehicles, time " + to_six_digits(span.begin) +
         " to " + to_six_digits(span.end) + "</text>\n";
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    out += "<polyline class=\"hg-line hg-thin hg-c" + std::to_string(i % colors) + "\" points=\"";
    for (const auto& p : tracks[i]) out += x_of(p.x) + "," + y_of(p.y) + " ";
    out.back() = '"';
    out += "/>\n";
  }
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const Vehicle& vehicle = facts.vehicles[i];
    const std::string color = " hg-c" + std::to_string(i % colors);
    const double radius = std::max(smallest_dot, scale * vehicle.radius);
    const double reach = scale * (vehicle.radius + 0.5 * facts.goal.clearance);
    out += "<g><circle class=\"hg-dot" + color + "\" r=\"" + pixels(radius) + "\"/>";
    if (reach > radius) {
      out += "<circle class=\"hg-line hg-thin reach" + color + "\" r=\"" + pixels(reach) + "\"/>";
    }
    if (const auto alarms = alarms_of(facts, i, span); !alarms.empty()) {
      out += "<circle class=\"alarm\" opacity=\"0\" r=\"" + pixels(std::max(reach, radius) + 3.0) +
             "\">" + alarm_animation(alarms, duration) + "</circle>";
    }
    if (tracks.size() <= most_named) {
      out += "<text class=\"hg-text hg-halo\" x=\"" + pixels(radius + name_offset) + "\" y=\"-" +
             pixels(name_offset) + "\">" + escaped_markup(vehicle.id) + "</text>";
    }
    out += "<animateTransform attributeName=\"transform\" type=\"translate\" values=\"";
    for (const auto& p : tracks[i]) out += x_of(p.x) + "," + y_of(p.y) + ";";
    out.back() = '"';
    out += " dur=\"" + duration + "\" repeatCount=\"indefinite\"/></g>\n";
  }
  const std::string line = pixels(height - foot * 0.5), from = pixels(edge),
                    to = pixels(width - edge);
  out += "<line class=\"hg-axis\" x1=\"" + from + "\" x2=\"" + to + "\" y1=\"" + line + "\" y2=\"" +
         line + "\"/>\n<circle class=\"hg-dot hg-c5\" r=\"5\" cy=\"" + line + "\" cx=\"" + from +
         "\"><animate attributeName=\"cx\" values=\"" + from + ";" + to + "\" dur=\"" + duration +
         "\" repeatCount=\"indefinite\"/></circle>\n";
  return out + "</svg>\n";
}

}  // namespace

Plot path_picture(const SwarmFacts& facts) {
  constexpr std::size_t points = 400, most_named = 8;
  Plot plot;
  plot.title = "Paths";
  plot.x.label = "x";
  plot.y.label = "y";
  plot.equal_aspect = true;
  plot.width = 560.0;
  plot.height = 420.0;
  for (std::size_t i = 0; i < facts.vehicles.size(); ++i) {
    const Vehicle& vehicle = facts.vehicles[i];
    const Span span{vehicle.motion.start_time(), vehicle.motion.end_time()};
    Series line;
    line.color = static_cast<PlotColor>(i % colors);
    for (std::size_t k = 0; k <= points; ++k) {
      const double x = static_cast<double>(k) / static_cast<double>(points);
      const auto p = vehicle.motion.position(span.begin * (1.0 - x) + span.end * x);
      line.x.push_back(p.x);
      line.y.push_back(p.y);
    }
    if (facts.vehicles.size() <= most_named) {
      plot.marks.push_back({{line.x.front(), line.y.front()}, vehicle.id, *line.color});
    }
    plot.series.push_back(std::move(line));
  }
  // Where the closest two are when they are closest.
  const auto pairs = closest_pairs(facts);
  if (!pairs.empty()) {
    Series dots{"the closest two", {}, {}, SeriesStyle::dots, PlotColor::vermilion};
    for (const std::size_t i : {pairs[0].first, pairs[0].second}) {
      const auto p = facts.vehicles[i].motion.position(pairs[0].entry.time);
      dots.x.push_back(p.x);
      dots.y.push_back(p.y);
    }
    plot.series.push_back(std::move(dots));
  }
  return plot;
}

Plot pair_picture(const SwarmFacts& facts) {
  constexpr std::size_t points = 400, most_drawn = 200, named = 3;
  constexpr PlotColor named_colors[] = {PlotColor::vermilion, PlotColor::blue, PlotColor::green};
  const auto pairs = closest_pairs(facts);
  Plot plot;
  plot.title = pairs.size() <= most_drawn
                   ? "Separations of " + std::to_string(pairs.size()) + " pairs"
                   : "Separations of the closest " + std::to_string(most_drawn) + " pairs";
  plot.x.label = "time";
  plot.y.label = "distance";
  plot.width = 560.0;
  plot.height = 420.0;
  if (facts.goal.clearance > 0.0) {
    plot.levels.push_back({facts.goal.clearance, to_six_digits(facts.goal.clearance)});
  }
  Series others{"", {}, {}, SeriesStyle::thin_line, PlotColor::grey};
  std::vector<Series> closest;
  for (std::size_t k = 0; k < std::min(pairs.size(), most_drawn); ++k) {
    const Vehicle &a = facts.vehicles[pairs[k].first], &b = facts.vehicles[pairs[k].second];
    Series line =
        distances_in_time(a.motion, b.motion, facts.goal.separation.vertical_scale, points);
    if (k < named) {
      line.label = a.id + " and " + b.id + ": " + to_six_digits(pairs[k].entry.distance.lower());
      line.color = named_colors[k];
      closest.push_back(std::move(line));
    } else {
      others.x.insert(others.x.end(), line.x.begin(), line.x.end());
      others.y.insert(others.y.end(), line.y.begin(), line.y.end());
      others.x.push_back(none);
      others.y.push_back(none);
    }
  }
  if (!closest.empty()) plot.series.push_back(at_zero(closest[0]));
  if (!others.x.empty()) plot.series.push_back(std::move(others));
  for (Series& line : closest) plot.series.push_back(std::move(line));
  return plot;
}

std::string animated_svg(const SwarmFacts& facts) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + animation_element(facts);
}

std::string animated_html(const SwarmFacts& facts) {
  const Span span = span_of(facts);
  return R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>A swarm in flight</title>
<style>
body{margin:1.5rem auto;max-width:800px;padding:0 1rem;font:15px system-ui,sans-serif;color:#1b2733;background:#fff}
svg{width:100%;height:auto}
.controls{display:flex;gap:1rem;align-items:center}
input{flex:1}
output{min-width:7em;font-variant-numeric:tabular-nums}
@media (prefers-color-scheme:dark){body{color:#e8edf2;background:#13181d}}
</style>
</head>
<body>
)" + animation_element(facts) +
         R"(<div class="controls">
<button type="button" id="play">Pause</button>
<input type="range" id="time" min="0" max="1" step="any" value="0" aria-label="Time">
<output id="now"></output>
</div>
<script>
const begin = )" +
         to_text(span.begin) + ", length = " + to_text(span.end - span.begin) + R"(, seconds = 12;
const svg = document.getElementById('swarm'), slider = document.getElementById('time');
const play = document.getElementById('play'), now = document.getElementById('now');
const show = () => {
  const x = (svg.getCurrentTime() / seconds) % 1;
  slider.value = x;
  now.textContent = 'time ' + (begin + x * length).toPrecision(4);
};
const pause = (yes) => {
  yes ? svg.pauseAnimations() : svg.unpauseAnimations();
  play.textContent = yes ? 'Play' : 'Pause';
};
play.onclick = () => pause(!svg.animationsPaused());
slider.oninput = () => {
  pause(true);
  svg.setCurrentTime(Math.min(slider.value, 0.9999) * seconds);
  show();
};
const tick = () => { if (!svg.animationsPaused()) show(); requestAnimationFrame(tick); };
if (matchMedia('(prefers-reduced-motion: reduce)').matches) pause(true);
show();
tick();
</script>
</body>
</html>
)";
}

}  // namespace hodograph::cli
