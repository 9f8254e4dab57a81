// SPDX-License-Identifier: MIT
// Pictures as SVG.
#include "hodograph/io/svg.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "markup.hpp"
#include "ticks.hpp"

namespace hodograph {
namespace {

using io_detail::append_pixels;
using io_detail::decade_ticks;
using io_detail::linear_ticks;
using io_detail::Markup;
using io_detail::TickedRange;

// Sizes in pixels.
constexpr double character_width = 6.6;  // of 12 px text, on average a little less
constexpr double title_line = 20.0;
constexpr double legend_line = 17.0;
constexpr double tick_text_line = 18.0;
constexpr double label_line = 17.0;
constexpr double edge = 8.0;
constexpr double arrow_head = 4.5;
constexpr double arrow_head_slope = 0.45;
/// Points nearer to the last drawn one than this are not drawn: a quarter of a pixel is not seen.
constexpr double finest_step = 0.25;
/// What lies this far outside the picture is drawn at this distance.
constexpr double farthest = 10000.0;
/// Numbers beyond this are not drawn: sums and differences of drawn ones stay finite.
constexpr double largest_drawn = 1e290;
/// Room around the data, as a fraction of their extent.
constexpr double padding = 0.05;

/// Numbers nearer to zero than this are drawn as zero: a millionth of a drawn one is a normal
/// number.
constexpr double smallest_drawn = 1e-290;

bool is_drawn(double value) { return std::abs(value) <= largest_drawn; }

std::string color_class(PlotColor color) {
  return "hg-c" + std::to_string(static_cast<int>(color));
}

double text_width(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) count += (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
  return character_width * static_cast<double>(count);
}

/// The extent of finite numbers.
struct Extent {
  double lower = std::numeric_limits<double>::infinity();
  double upper = -std::numeric_limits<double>::infinity();
  void add(double value) {
    if (!is_drawn(value)) return;
    if (std::abs(value) < smallest_drawn) value = 0.0;
    lower = std::min(lower, value);
    upper = std::max(upper, value);
  }
  bool empty() const { return !(lower <= upper); }
};

/// One axis: from numbers to pixels.
struct Scale {
  TickedRange range;
  bool logarithmic = false;
  double first_pixel = 0.0, last_pixel = 1.0;

  double position(double value) const {
    double shown = value;
    if (logarithmic) shown = value > 0.0 ? std::log10(value) : range.lower;
    if (logarithmic) shown = std::max(shown, range.lower);
    return place(shown);
  }
  /// Of a tick, or a decimal logarithm on a logarithmic axis.
  double place(double shown) const {
    const double fraction = (shown - range.lower) / (range.upper - range.lower);
    const double pixel = first_pixel + fraction * (last_pixel - first_pixel);
    return std::clamp(pixel, -farthest, farthest);
  }
};

/// Everything a plot shows, along one axis.
template <class Visit>
void for_each_number(const Plot& plot, bool along_x, const Visit& visit) {
  for (const Series& series : plot.series) {
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
      if (is_drawn(series.x[i]) && is_drawn(series.y[i]))
        visit(along_x ? series.x[i] : series.y[i]);
    }
  }
  for (const Arrows& arrows : plot.arrows) {
    for (const auto& [from, to] : arrows.from_to) {
      if (!is_drawn(from.x) || !is_drawn(from.y) || !is_drawn(to.x) || !is_drawn(to.y)) continue;
      visit(along_x ? from.x : from.y);
      visit(along_x ? to.x : to.y);
    }
  }
  for (const PlotMark& mark : plot.marks) {
    if (is_drawn(mark.at.x) && is_drawn(mark.at.y)) visit(along_x ? mark.at.x : mark.at.y);
  }
  for (const PlotLevel& level : plot.levels) {
    if (!along_x && is_drawn(level.y)) visit(level.y);
  }
}

Extent extent_of(const Plot& plot, bool along_x) {
  const bool logarithmic = along_x ? plot.x.logarithmic : plot.y.logarithmic;
  Extent extent;
  for_each_number(plot, along_x, [&](double value) {
    if (!logarithmic) {
      extent.add(value);
    } else if (value > 0.0) {
      extent.add(std::log10(value));
    }
  });
  if (extent.empty()) return {0.0, 1.0};
  if (logarithmic) extent.lower = std::max(extent.lower, extent.upper - most_decades);
  return extent;
}

/// The extent without the rare values far away: four times the range in which all but one in twenty
/// of them lie, where the whole is larger than that.
Extent central_extent(const Plot& plot, const Extent& whole) {
  std::vector<double> values;
  for_each_number(plot, false, [&](double value) { values.push_back(value); });
  constexpr std::size_t tail = 40;  // one in forty at either end
  if (values.size() < tail) return whole;
  const auto at = [&](std::size_t index) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(index);
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  const double low = at(values.size() / tail), high = at(values.size() - 1 - values.size() / tail);
  constexpr double room = 1.5;
  const double width = high - low;
  if (!(width >= smallest_drawn)) return whole;
  return {std::max(whole.lower, low - room * width), std::min(whole.upper, high + room * width)};
}

/// A constant gets a range around it that is wider than its rounding.
void widen_constant(Extent& extent) {
  constexpr double relative_width = 1e-6;  // labels then need at most 8 digits
  const double size = std::max(std::abs(extent.lower), std::abs(extent.upper));
  const double least = size == 0.0 ? 1.0 : relative_width * size;
  if (extent.upper - extent.lower >= least) return;
  const double middle = 0.5 * extent.lower + 0.5 * extent.upper;
  const bool constant = extent.upper == extent.lower;
  const double half = constant && size > 0.0 ? 0.5 * size : 0.5 * least;
  extent = {middle - half, middle + half};
}

void pad(Extent& extent, double fraction) {
  const double room = fraction * (extent.upper - extent.lower);
  extent.lower -= room;
  extent.upper += room;
}

/// One entry of the legend.
struct LegendEntry {
  std::string_view label;
  std::string style;
  bool dots;
};

std::vector<PlotColor> colors_of(const Plot& plot) {
  constexpr int color_count = 6;
  std::vector<PlotColor> colors;
  int next = 0;
  for (const Series& series : plot.series) {
    colors.push_back(series.color ? *series.color : static_cast<PlotColor>(next++ % color_count));
  }
  return colors;
}

std::string line_class(const Series& series, PlotColor color) {
  return std::string(series.style == SeriesStyle::dashed_line ? "hg-line hg-dash "
                     : series.style == SeriesStyle::thin_line ? "hg-line hg-thin "
                                                              : "hg-line ") +
         color_class(color);
}

std::vector<LegendEntry> legend_of(const Plot& plot, const std::vector<PlotColor>& colors) {
  std::vector<LegendEntry> legend;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& series = plot.series[i];
    if (series.label.empty()) continue;
    const bool dots = series.style == SeriesStyle::dots;
    legend.push_back({series.label,
                      dots ? "hg-dot " + color_class(colors[i]) : line_class(series, colors[i]),
                      dots});
  }
  for (const Arrows& arrows : plot.arrows) {
    if (!arrows.label.empty()) {
      legend.push_back({arrows.label, "hg-line " + color_class(arrows.color), false});
    }
  }
  return legend;
}

/// Draws one plot.
class Drawing {
 public:
  explicit Drawing(const Plot& plot)
      : plot_(plot), colors_(colors_of(plot)), legend_(legend_of(plot, colors_)) {
    lay_out();
  }

  /// The picture without the surrounding <svg>.
  std::string content() {
    draw_head();
    draw_axes();
    markup_.open("svg")
        .attribute("x", left_)
        .attribute("y", top_)
        .attribute("width", right_ - left_)
        .attribute("height", bottom_ - top_)
        .attribute("viewBox", view_box());
    markup_.out += ">\n";
    draw_levels();
    for (std::size_t i = 0; i < plot_.series.size(); ++i) draw_series(plot_.series[i], colors_[i]);
    for (const Arrows& arrows : plot_.arrows) draw_arrows(arrows);
    markup_.out += "</svg>\n";
    for (const PlotMark& mark : plot_.marks) draw_mark(mark);
    return std::move(markup_.out);
  }

 private:
  std::string view_box() const {
    std::string box;
    for (const double number : {left_, top_, right_ - left_, bottom_ - top_}) {
      append_pixels(box, number);
      box += ' ';
    }
    box.pop_back();
    return box;
  }

  void lay_out() {
    constexpr double pixels_per_x_tick = 78.0, pixels_per_y_tick = 36.0;
    top_ = edge + (plot_.title.empty() && plot_.y.label.empty() ? 0.0 : title_line);
    right_ = plot_.width - 2.5 * edge;
    legend_top_ = top_;
    double x = edge;
    if (!legend_.empty()) top_ += legend_line;
    for (const LegendEntry& entry : legend_) {
      const double width = legend_width(entry);
      if (x > edge && x + width > plot_.width - edge) {
        x = edge;
        top_ += legend_line;
      }
      x += width;
    }
    top_ += edge;
    bottom_ = plot_.height - edge - tick_text_line - (plot_.x.label.empty() ? 0.0 : label_line);
    bottom_ = std::max(bottom_, top_ + 1.0);

    const bool equal_aspect = plot_.equal_aspect && !plot_.x.logarithmic && !plot_.y.logarithmic;
    Extent x_extent = extent_of(plot_, true), y_extent = extent_of(plot_, false);
    if (plot_.clip_outliers && !plot_.y.logarithmic) y_extent = central_extent(plot_, y_extent);
    const int y_count = std::max(2, static_cast<int>((bottom_ - top_) / pixels_per_y_tick));
    if (plot_.y.logarithmic) {
      for (const PlotLevel& level : plot_.levels) {  // room above a level for its name
        constexpr double room = 0.5;
        if (is_drawn(level.y) && level.y > 0.0) {
          y_extent.upper = std::max(y_extent.upper, std::log10(level.y) + room);
        }
      }
      y_.range = decade_ticks(y_extent.lower, y_extent.upper, y_count);
    } else {
      widen_constant(y_extent);
      pad(y_extent, padding);
    }
    if (!plot_.x.logarithmic) {
      widen_constant(x_extent);
      pad(x_extent, equal_aspect ? padding : 0.0);
    }
    // The labels of the vertical axis take room from the picture, which changes its aspect and
    // with it, where the scales are equal, the labels: two rounds settle it.
    const double most_left = 0.5 * plot_.width;
    left_ = std::min(2.0 * edge + 3.0 * character_width, most_left);
    right_ = std::max(right_, most_left + 1.0);
    for (int round = 0; round < 2; ++round) {
      if (equal_aspect) equalize(x_extent, y_extent);
      if (!plot_.y.logarithmic) y_.range = linear_ticks(y_extent.lower, y_extent.upper, y_count);
      double widest = 0.0;
      for (const auto& tick : y_.range.ticks) widest = std::max(widest, text_width(tick.label));
      left_ = std::min(2.0 * edge + widest, most_left);
    }
    const int x_count = std::max(2, static_cast<int>((right_ - left_) / pixels_per_x_tick));
    x_.range = plot_.x.logarithmic ? decade_ticks(x_extent.lower, x_extent.upper, x_count)
                                   : linear_ticks(x_extent.lower, x_extent.upper, x_count);
    x_.logarithmic = plot_.x.logarithmic;
    y_.logarithmic = plot_.y.logarithmic;
    x_.first_pixel = left_;
    x_.last_pixel = right_;
    y_.first_pixel = bottom_;
    y_.last_pixel = top_;
  }

  /// Widens one extent until a unit has the same length on both axes.
  void equalize(Extent& x, Extent& y) const {
    const double x_unit = (x.upper - x.lower) / (right_ - left_);
    const double y_unit = (y.upper - y.lower) / (bottom_ - top_);
    const bool x_is_narrow = x_unit < y_unit;
    Extent& narrow = x_is_narrow ? x : y;
    const double width = x_is_narrow ? y_unit * (right_ - left_) : x_unit * (bottom_ - top_);
    const double middle = 0.5 * narrow.lower + 0.5 * narrow.upper;
    narrow = {middle - 0.5 * width, middle + 0.5 * width};
  }

  static double legend_width(const LegendEntry& entry) { return text_width(entry.label) + 38.0; }

  void draw_head() {
    const double baseline = edge + 12.0;
    std::string unit = plot_.y.label;
    if (!y_.range.factor.empty()) unit += (unit.empty() ? "" : " ") + y_.range.factor;
    if (!plot_.title.empty() || !unit.empty()) {
      markup_.open("text")
          .attribute("x", edge)
          .attribute("y", baseline)
          .attribute("class", std::string_view("hg-title"));
      markup_.out += '>' + escaped_markup(plot_.title);
      if (!unit.empty()) {
        markup_.out += "<tspan class=\"hg-unit\"";
        if (!plot_.title.empty()) markup_.attribute("dx", 8.0);
        markup_.out += '>' + escaped_markup(unit) + "</tspan>";
      }
      markup_.out += "</text>\n";
    }
    double x = edge, y = legend_top_ + 12.0;
    for (const LegendEntry& entry : legend_) {
      if (x > edge && x + legend_width(entry) > plot_.width - edge) {
        x = edge;
        y += legend_line;
      }
      if (entry.dots) {
        dot(x + 10.0, y - 4.0, entry.style);
      } else {
        markup_.line(x, y - 4.0, x + 20.0, y - 4.0, entry.style);
      }
      markup_.text(x + 25.0, y, "hg-text", entry.label);
      x += legend_width(entry);
    }
  }

  void draw_axes() {
    for (const auto& tick : y_.range.ticks) {
      const double y = y_.place(tick.value);
      markup_.line(left_, y, right_, y, "hg-grid");
      markup_.text(left_ - 6.0, y + 4.0, "hg-text hg-end", tick.label);
    }
    for (const auto& tick : x_.range.ticks) {
      const double x = x_.place(tick.value);
      markup_.line(x, top_, x, bottom_, "hg-grid");
      markup_.text(x, bottom_ + 15.0, "hg-text hg-middle", tick.label);
    }
    for (const double value : plot_.x_marks) {
      if (!is_drawn(value)) continue;
      const double x = x_.position(value);
      if (x < left_ - 1.0 || x > right_ + 1.0) continue;
      constexpr double length = 5.0;
      markup_.line(x, bottom_, x, bottom_ - length, "hg-mark");
    }
    markup_.line(left_, bottom_, right_, bottom_, "hg-axis");
    std::string label = plot_.x.label;
    if (!x_.range.factor.empty()) label += (label.empty() ? "" : " ") + x_.range.factor;
    if (!label.empty()) markup_.text(right_, plot_.height - edge, "hg-text hg-end", label);
  }

  void draw_levels() {
    for (const PlotLevel& level : plot_.levels) {
      if (!is_drawn(level.y)) continue;
      const double y = y_.position(level.y);
      markup_.line(left_, y, right_, y, "hg-level");
      const bool below = y < top_ + legend_line;
      markup_.text(right_ - 4.0, below ? y + 14.0 : y - 5.0, "hg-text hg-halo hg-end", level.label);
    }
  }

  void dot(double x, double y, std::string_view style, double radius = 2.5) {
    markup_.open("circle")
        .attribute("cx", x)
        .attribute("cy", y)
        .attribute("r", radius)
        .attribute("class", style)
        .close();
  }

  void draw_series(const Series& series, PlotColor color) {
    const std::size_t count = std::min(series.x.size(), series.y.size());
    if (series.style == SeriesStyle::dots) {
      double last_x = -2.0 * farthest, last_y = last_x;
      for (std::size_t i = 0; i < count; ++i) {
        if (!is_drawn(series.x[i]) || !is_drawn(series.y[i])) continue;
        const double x = x_.position(series.x[i]), y = y_.position(series.y[i]);
        if (std::max(std::abs(x - last_x), std::abs(y - last_y)) < finest_step) continue;
        dot(last_x = x, last_y = y, "hg-dot " + color_class(color));
      }
      return;
    }
    markup_.open("path").attribute("class", line_class(series, color));
    markup_.out += " d=\"";
    bool pen_down = false;
    double drawn_x = 0.0, drawn_y = 0.0, x = 0.0, y = 0.0;
    bool pending = false;  // the last point is not drawn yet
    const auto line_to = [&] {
      markup_.out += pen_down ? 'L' : 'M';
      markup_.point(x, y);
      drawn_x = x;
      drawn_y = y;
      pen_down = true;
      pending = false;
    };
    for (std::size_t i = 0; i < count; ++i) {
      if (!is_drawn(series.x[i]) || !is_drawn(series.y[i])) {
        if (pending) line_to();
        pen_down = false;
        continue;
      }
      x = x_.position(series.x[i]);
      y = y_.position(series.y[i]);
      if (pen_down && std::max(std::abs(x - drawn_x), std::abs(y - drawn_y)) < finest_step) {
        pending = true;
      } else {
        line_to();
      }
    }
    if (pending) line_to();
    markup_.out += '"';
    markup_.close();
  }

  void draw_arrows(const Arrows& arrows) {
    markup_.open("path").attribute("class", "hg-arrow " + color_class(arrows.color));
    markup_.out += " d=\"";
    for (const auto& [from, to] : arrows.from_to) {
      if (!is_drawn(from.x) || !is_drawn(from.y) || !is_drawn(to.x) || !is_drawn(to.y)) continue;
      const double x1 = x_.position(from.x), y1 = y_.position(from.y);
      const double x2 = x_.position(to.x), y2 = y_.position(to.y);
      markup_.out += 'M';
      markup_.point(x1, y1);
      markup_.out += 'L';
      markup_.point(x2, y2);
      const double length = std::hypot(x2 - x1, y2 - y1);
      if (length < arrow_head) continue;  // seen almost from its tip
      const double u = arrow_head * (x2 - x1) / length, v = arrow_head * (y2 - y1) / length;
      markup_.out += 'M';
      markup_.point(x2 - u - arrow_head_slope * v, y2 - v + arrow_head_slope * u);
      markup_.out += 'L';
      markup_.point(x2, y2);
      markup_.out += 'L';
      markup_.point(x2 - u + arrow_head_slope * v, y2 - v - arrow_head_slope * u);
    }
    markup_.out += '"';
    markup_.close();
  }

  void draw_mark(const PlotMark& mark) {
    if (!is_drawn(mark.at.x) || !is_drawn(mark.at.y)) return;
    const double x = x_.position(mark.at.x), y = y_.position(mark.at.y);
    constexpr double radius = 3.5;
    dot(x, y, "hg-dot hg-ring " + color_class(mark.color), radius);
    const bool left_side = x + text_width(mark.label) + 8.0 > right_;
    if (!mark.label.empty()) {
      markup_.text(left_side ? x - 7.0 : x + 7.0, y - 6.0,
                   left_side ? "hg-text hg-halo hg-end" : "hg-text hg-halo", mark.label);
    }
  }

  const Plot& plot_;
  std::vector<PlotColor> colors_;
  std::vector<LegendEntry> legend_;
  double left_ = 0.0, top_ = 0.0, right_ = 1.0, bottom_ = 1.0, legend_top_ = 0.0;
  Scale x_, y_;
  Markup markup_;
};

void open_svg(Markup& markup, double width, double height, std::string_view title,
              bool standalone) {
  markup.open("svg");
  if (standalone) markup.attribute("xmlns", std::string_view("http://www.w3.org/2000/svg"));
  std::string box = "0 0 ";
  append_pixels(box, width);
  box += ' ';
  append_pixels(box, height);
  markup.attribute("class", std::string_view("hg-plot")).attribute("viewBox", box);
  if (standalone) markup.attribute("width", width).attribute("height", height);
  markup.attribute("role", std::string_view("img"));
  if (!title.empty()) markup.attribute("aria-label", title);
  markup.out += ">\n";
}

}  // namespace

std::string svg_element(const Plot& plot) {
  Markup markup;
  open_svg(markup, plot.width, plot.height, plot.title, false);
  return markup.out + Drawing(plot).content() + "</svg>\n";
}

std::string to_svg(const Plot& plot) { return to_svg(std::span(&plot, 1), 1); }

std::string to_svg(std::span<const Plot> plots, std::size_t columns) {
  columns = std::clamp<std::size_t>(columns, 1, std::max<std::size_t>(plots.size(), 1));
  double width = 0.0, height = 0.0;
  std::vector<std::pair<double, double>> corners;
  for (std::size_t first = 0; first < plots.size(); first += columns) {
    double x = 0.0, tallest = 0.0;
    for (std::size_t i = first; i < std::min(plots.size(), first + columns); ++i) {
      corners.emplace_back(x, height);
      x += plots[i].width;
      tallest = std::max(tallest, plots[i].height);
    }
    width = std::max(width, x);
    height += tallest;
  }
  Markup markup;
  markup.out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  open_svg(markup, width, height, plots.empty() ? "" : std::string_view(plots[0].title), true);
  markup.out += "<style>\n" + std::string(plot_style()) + "</style>\n";
  markup.out += "<rect width=\"100%\" height=\"100%\" class=\"hg-paper\"/>\n";
  for (std::size_t i = 0; i < plots.size(); ++i) {
    markup.open("svg")
        .attribute("x", corners[i].first)
        .attribute("y", corners[i].second)
        .attribute("width", plots[i].width)
        .attribute("height", plots[i].height);
    markup.out += ">\n" + Drawing(plots[i]).content() + "</svg>\n";
  }
  return markup.out + "</svg>\n";
}

}  // namespace hodograph
