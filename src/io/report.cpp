// SPDX-License-Identifier: MIT
// The report on a path.
#include "hodograph/io/report.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>

#include "hodograph/foundation/version.hpp"

namespace hodograph {
namespace {

constexpr int digits_shown = 4;
constexpr int digits_of_length = 9;
constexpr std::size_t most_knots_shown = 200;

enum class Rounding { nearest, down, up };

/// What lies this close to a short number, relatively, is that number as computed: bounds of the
/// curvature are within 2^-40 or so of what they bound.
constexpr double computed_width = 0x1p-36;

/// A number with so many digits; a bound is never made stronger by rounding it. A bound within
/// rounding of a short number, as a limit that is just kept, is shown with all its digits:
/// 4.000000000000045 rather than 4.001.
std::string rounded(double value, Rounding rounding, int digits) {
  std::array<char, 64> buffer{};
  const auto write = [&](double x) {
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x,
                                            std::chars_format::general, digits);
    return std::string_view(
        buffer.data(), error == std::errc{} ? static_cast<std::size_t>(end - buffer.data()) : 0);
  };
  const auto read = [](std::string_view text) {
    double x = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), x);
    return x;
  };
  std::string text(write(value));
  if (rounding == Rounding::nearest || !std::isfinite(value)) return text;
  const bool too_strong = rounding == Rounding::up ? read(text) < value : read(text) > value;
  if (!too_strong) return text;
  if (std::abs(value - read(text)) <= computed_width * std::abs(value)) return to_text(value);
  // Moved by half a unit of the last digit shown, the number rounds to the other side of itself.
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1 - digits);
  const double half = rounding == Rounding::up ? 0.5 * unit : -0.5 * unit;
  for (const double step : {half, 2.0 * half}) {
    if (!std::isfinite(value + step)) break;
    text = write(value + step);
    if (rounding == Rounding::up ? read(text) >= value : read(text) <= value) return text;
  }
  return to_text(value);
}

/// "1e-08" as "1e-8".
std::string short_exponent(std::string text) {
  const auto exponent = std::find(text.begin(), text.end(), 'e');
  if (exponent == text.end()) return text;
  const auto digits = exponent + 2;  // behind its sign
  while (digits + 1 < text.end() && *digits == '0') text.erase(digits);
  return text;
}

std::string shown(double value, Rounding rounding = Rounding::nearest, int digits = digits_shown) {
  return short_exponent(rounded(value, rounding, digits));
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : number + " " + unit;
}

/// "12.34", or "12.34 to 12.35" where the ends differ in the digits shown.
std::string enclosure_text(const Enclosure& value, int digits = digits_shown) {
  const auto text = [&](double number, Rounding rounding = Rounding::nearest) {
    return shown(number, rounding, digits);
  };
  std::string nearest = text(value.middle());
  if (text(value.lower()) == nearest && text(value.upper()) == nearest) return nearest;
  return text(value.lower(), Rounding::down) + " to " + text(value.upper(), Rounding::up);
}

std::string ratio_unit(const std::string& above, const std::string& below) {
  if (above.empty() || below.empty()) return above.empty() ? "" : above + " per unit \xce\xbe";
  return above + "/" + below;
}

std::string order_text(int order) {
  return order < 0 ? std::string("jumps") : "C" + std::to_string(order);
}

std::string tolerance_text(const ReportData& data) {
  return shown(*data.tolerance, Rounding::nearest, digits_of_length);
}

std::string error_text(const ReportData& data) {
  const ErrorPromise& error = *data.promises.error;
  const Enclosure& distance = error.distance;
  std::string text;
  if (error.certified) {
    text = "at most " + with_unit(shown(distance.upper(), Rounding::up), data.length_unit);
    if (distance.lower() > 0.0) {
      text += " and at least " + shown(distance.lower(), Rounding::down);
    }
    text += ", certified";
  } else {
    text = "about " + with_unit(shown(distance.upper(), Rounding::up), data.length_unit) +
           ", an estimate";
  }
  if (data.tolerance) text += " (tolerance " + tolerance_text(data) + ")";
  return text;
}

std::string time_text(double seconds) {
  constexpr double second = 1.0, millisecond = 1000.0;
  if (seconds >= second) return shown(seconds) + " s";
  return shown(seconds * millisecond) + " ms";
}

Series series_of(const std::vector<double>& x, const std::vector<double>& y) {
  Series series;
  series.x = x;
  series.y = y;
  return series;
}

constexpr std::string_view page_style =
    R"(:root{color-scheme:light dark;--paper:#fff;--ink:#1b2733;--soft:#51606e;--line:#dfe5ea}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);font:16px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,"DejaVu Sans",sans-serif}
main{max-width:1180px;margin:0 auto;padding:28px 20px 40px}
h1{font-size:1.7rem;line-height:1.2;margin:0 0 .3em;overflow-wrap:anywhere}
h2{font-size:1.1rem;margin:2em 0 .6em}
p{margin:.3em 0;max-width:70ch;overflow-wrap:anywhere}
.soft{color:var(--soft)}
table{border-collapse:collapse;width:100%;max-width:760px;margin:1.4em 0 0}
th,td{text-align:left;vertical-align:top;padding:.45em .8em .45em 0;border-bottom:1px solid var(--line);overflow-wrap:anywhere}
th{font-weight:400;color:var(--soft);width:34%}
td{font-variant-numeric:tabular-nums}
.figures{display:grid;gap:14px}
.three{grid-template-columns:repeat(auto-fit,minmax(min(100%,300px),1fr))}
.two{grid-template-columns:repeat(auto-fit,minmax(min(100%,420px),1fr))}
figure{margin:0;border:1px solid var(--line);border-radius:8px;padding:6px;min-width:0}
.wide{display:none}
@media (min-width:860px),print{.wide{display:block}.narrow{display:none}}
figure svg{display:block;width:100%;height:auto}
code{font:.95em ui-monospace,"DejaVu Sans Mono",monospace}
footer{margin-top:2.5em;color:var(--soft);font-size:.85rem}
@media (max-width:560px){main{padding:18px 12px 28px}h1{font-size:1.35rem}th{width:38%}}
@media screen and (prefers-color-scheme:dark){:root{--paper:#13181d;--ink:#e8edf2;--soft:#a3b1be;--line:#2a343d}}
@media print{body{font-size:11pt}main{max-width:none;padding:0}figure{break-inside:avoid}h2{break-after:avoid}.three{grid-template-columns:repeat(3,1fr)}.two{grid-template-columns:repeat(2,1fr)}}
)";

void append_figures(std::string& html, std::string_view heading, std::string_view columns,
                    std::span<const Plot> plots) {
  if (plots.empty()) return;
  html += "<h2>";
  html += heading;
  html += "</h2>\n<div class=\"figures ";
  html += columns;
  html += "\">\n";
  for (const Plot& plot : plots) html += "<figure>" + svg_element(plot) + "</figure>\n";
  html += "</div>\n";
}

std::vector<Plot> path_plots(const ReportData& data) {
  std::vector<Plot> plots;
  if (data.path.points.empty()) return plots;
  if (data.dimension == 2) {
    Plot plot = plane_picture(data.path, data.length_unit);
    if (!data.surroundings.empty()) {  // a map, as wide as the page
      constexpr double map_size = 720.0;
      plot.width = plot.height = map_size;
      plot.series.front().label = "path";
      plot.series.front().color = PlotColor::blue;
    }
    plot.series.insert(plot.series.begin(), data.surroundings.begin(), data.surroundings.end());
    plots.push_back(std::move(plot));
    return plots;
  }
  for (const Projection projection : {Projection::xy, Projection::xz, Projection::yz}) {
    plots.push_back(projected(data.path, projection, data.length_unit));
  }
  return plots;
}

std::vector<Plot> quantity_plots(const ReportData& data) {
  std::vector<Plot> plots;
  const std::string xi_label =
      "\xce\xbe" + (data.parameter_unit.empty() ? "" : " (" + data.parameter_unit + ")");
  const std::string per_length = data.length_unit.empty() ? "" : "1/" + data.length_unit;
  const auto add = [&](const std::string& title, const std::string& unit) -> Plot& {
    Plot plot;
    plot.title = title;
    plot.x.label = xi_label;
    plot.y.label = unit;
    if (data.knots.size() <= most_knots_shown) plot.x_marks = data.knots;
    plots.push_back(std::move(plot));
    return plots.back();
  };
  if (!data.speed.empty()) {
    add("Speed \xcf\x83", ratio_unit(data.length_unit, data.parameter_unit))
        .series.push_back(series_of(data.xi, data.speed));
  }
  if (!data.curvature.empty()) {
    Plot& plot = add("Curvature \xce\xba", per_length);
    plot.series.push_back(series_of(data.xi, data.curvature));
    if (data.curvature_limit) {
      plot.levels.push_back({*data.curvature_limit, "limit"});
      if (data.dimension == 2) plot.levels.push_back({-*data.curvature_limit, "limit"});
    }
  }
  if (!data.torsion.empty() && data.dimension == 3) {
    add("Torsion \xcf\x84", per_length).series.push_back(series_of(data.xi, data.torsion));
    plots.back().clip_outliers = true;
  }
  if (!data.body_rate.empty()) {
    Plot& plot =
        add("Angular velocity \xcf\x89",
            data.dimension == 2 ? ratio_unit("rad", data.parameter_unit)
                                : ratio_unit("rad", data.parameter_unit) + ", in the frame");
    constexpr std::array names = {"\xcf\x87\xe2\x82\x81", "\xcf\x87\xe2\x82\x82",
                                  "\xcf\x87\xe2\x82\x83"};
    constexpr std::array colors = {PlotColor::vermilion, PlotColor::green, PlotColor::purple};
    for (std::size_t axis = data.dimension == 2 ? 2 : 0; axis < 3; ++axis) {
      Series series = series_of(data.xi, {});
      for (const auto& rate : data.body_rate) series.y.push_back(rate[axis]);
      if (data.dimension != 2) series.label = names[axis];
      series.color = colors[axis];
      plot.series.push_back(std::move(series));
    }
  }
  plots.insert(plots.end(), data.further.begin(), data.further.end());
  if (!data.error.empty()) {
    Plot& plot = add("Position error", data.length_unit);
    plot.y.logarithmic = true;
    plot.series.push_back(series_of(data.error_xi, data.error));
    if (data.tolerance && *data.tolerance > 0.0) {
      plot.levels.push_back({*data.tolerance, "tolerance " + tolerance_text(data)});
    }
  }
  return plots;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> report_rows(const ReportData& data) {
  std::vector<std::pair<std::string, std::string>> rows;
  const std::string per_xi = ratio_unit(data.length_unit, data.parameter_unit);
  if (data.segments > 0) {
    rows.emplace_back("Segments", std::to_string(data.segments) + " of degree " +
                                      std::to_string(2 * data.preimage_degree + 1) +
                                      (data.closed ? ", closed" : ""));
  }
  if (data.promises.error) rows.emplace_back("Position error", error_text(data));
  if (data.promises.arc_length) {
    rows.emplace_back(
        "Length",
        with_unit(enclosure_text(*data.promises.arc_length, digits_of_length), data.length_unit));
  }
  if (data.promises.smallest_speed) {
    rows.emplace_back("Smallest speed",
                      with_unit(enclosure_text(*data.promises.smallest_speed), per_xi));
  }
  if (data.promises.largest_speed) {
    rows.emplace_back("Largest speed",
                      with_unit(enclosure_text(*data.promises.largest_speed), per_xi));
  }
  if (data.promises.curvature_bound) {
    rows.emplace_back(
        "Curvature",
        "at most " + with_unit(shown(*data.promises.curvature_bound, Rounding::up),
                               data.length_unit.empty() ? "" : "1/" + data.length_unit));
  }
  const bool has_joints = data.segments > 1 || data.closed;
  if (const auto& orders = data.promises.continuity; orders && has_joints) {
    rows.emplace_back("Continuity at the knots", "position " + order_text(orders->position) +
                                                     ", frame " + order_text(orders->frame) +
                                                     ", angular velocity " +
                                                     order_text(orders->angular_velocity));
  }
  if (data.seconds) rows.emplace_back("Time taken", time_text(*data.seconds));
  rows.insert(rows.end(), data.more.begin(), data.more.end());
  return rows;
}

std::string report_text(const ReportData& data) {
  const auto rows = report_rows(data);
  std::size_t widest = 0;
  for (const auto& row : rows) widest = std::max(widest, row.first.size());
  std::string text;
  for (const auto& [name, value] : rows) {
    text.append("  ").append(name).append(widest - name.size() + 2, ' ').append(value) += '\n';
  }
  return text;
}

std::vector<Plot> report_plots(const ReportData& data) {
  std::vector<Plot> plots = path_plots(data);
  for (Plot& plot : quantity_plots(data)) plots.push_back(std::move(plot));
  return plots;
}

std::string report_html(const ReportData& data) {
  const std::string title = escaped_markup(data.title.empty() ? "A path" : data.title);
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
      title + "</title>\n<style>\n";
  html += page_style;
  html += plot_style();
  html += "</style>\n</head>\n<body>\n<main>\n<h1>" + title + "</h1>\n";
  if (!data.summary.empty()) html += "<p>" + escaped_markup(data.summary) + "</p>\n";
  if (!data.document_name.empty()) {
    html += "<p class=\"soft\">The path is in <code>" + escaped_markup(data.document_name) +
            "</code>.</p>\n";
  }
  html += "<table>\n";
  for (const auto& [name, value] : report_rows(data)) {
    html += "<tr><th scope=\"row\">" + escaped_markup(name) + "</th><td>" + escaped_markup(value) +
            "</td></tr>\n";
  }
  html += "</table>\n";
  append_figures(html, data.first_heading, "three", data.first);
  if (!data.drawings.empty()) {
    if (data.first.empty()) html += "<h2>" + escaped_markup(data.first_heading) + "</h2>\n";
    for (const auto& [caption, svg] : data.drawings) {
      html += "<figure class=\"drawing\">\n" + svg + "<figcaption>" + escaped_markup(caption) +
              "</figcaption></figure>\n";
    }
  }
  append_figures(html, data.path.frames.empty() ? "The path" : "The path and its frame", "three",
                 path_plots(data));
  std::vector<Plot> quantities = quantity_plots(data);
  std::optional<Plot> error;
  if (!data.error.empty()) {
    error = std::move(quantities.back());
    quantities.pop_back();
  }
  append_figures(html, "Along the path", "two", quantities);
  if (error) {
    // Drawn twice: wide for a desk and for paper, with larger letters for a phone.
    constexpr double wide_width = 980.0;
    html += "<h2>Error along the path</h2>\n<figure class=\"narrow\">" + svg_element(*error);
    error->width = wide_width;
    html += "</figure>\n<figure class=\"wide\">" + svg_element(*error) + "</figure>\n";
  }
  html += "<footer>Hodograph " + std::string(version) + "</footer>\n</main>\n</body>\n</html>\n";
  return html;
}

}  // namespace hodograph
