// SPDX-License-Identifier: MIT
// Pictures as SVG: curves in axes with round ticks, linear or logarithmic, and paths with frames.
//
// The pictures need nothing else: no font, no script, no network. Colours differ for colour-blind
// readers, too, and follow the reader's preference for light or dark.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hodograph/algebra/preimage_algebra.hpp"

namespace hodograph {

/// The colours of a picture, in the order in which series take them.
enum class PlotColor { blue, vermilion, green, purple, gold, grey };

enum class SeriesStyle { line, dashed_line, thin_line, dots };

/// One curve: points (x_i, y_i) in order. A point that is not finite makes a gap; on a logarithmic
/// axis a value that is not positive lies on the lower edge.
struct Series {
  std::string label{};  ///< in the legend; empty: not in the legend
  std::vector<double> x{}, y{};
  SeriesStyle style = SeriesStyle::line;
  std::optional<PlotColor> color{};  ///< by default the next one
};

/// Arrows of one colour from `from` to `to`, for example one vector of a frame along a path.
struct Arrows {
  std::string label{};
  PlotColor color = PlotColor::vermilion;
  std::vector<std::pair<Vector2<double>, Vector2<double>>> from_to{};
};

/// A dot with a name, for example where a path starts.
struct PlotMark {
  Vector2<double> at{};
  std::string label{};
  PlotColor color = PlotColor::grey;
};

/// A horizontal line across the picture, for example a tolerance.
struct PlotLevel {
  double y = 0.0;
  std::string label{};
};

struct PlotAxis {
  std::string label{};
  bool logarithmic = false;
};

/// A picture of curves in axes. The ranges follow from what it shows.
struct Plot {
  std::string title{};
  PlotAxis x{}, y{};
  std::vector<Series> series{};
  std::vector<Arrows> arrows{};
  std::vector<PlotMark> marks{};
  std::vector<PlotLevel> levels{};
  std::vector<double> x_marks{};         ///< short lines on the lower edge, for example knots
  bool equal_aspect = false;             ///< the same scale on both axes, where both are linear
  bool clip_outliers = false;            ///< let rare large values of y leave the picture (poles)
  double width = 480.0, height = 300.0;  ///< in pixels of 1/96 inch
};

/// The most decades a logarithmic axis shows; smaller values lie on its lower edge.
inline constexpr int most_decades = 10;

/// A whole SVG file of one picture, or of several in a grid, row by row.
std::string to_svg(const Plot& plot);
std::string to_svg(std::span<const Plot> plots, std::size_t columns);

/// The picture as an <svg> element for an HTML page that contains plot_style() in a <style>.
std::string svg_element(const Plot& plot);
/// The style sheet (CSS) of the pictures.
std::string_view plot_style();

/// Two axes of space to look at: the first one points right, the second one up.
enum class Projection { xy, xz, yz };

/// A curve in space (or in the plane z = 0) as points, with frames at some of them.
struct FramedPolyline {
  std::vector<Vector3<double>> points{};
  std::vector<Vector3<double>> frame_origins{};
  std::vector<Frame3<double>> frames{};  ///< as many as origins
  std::vector<Vector3<double>> knots{};  ///< drawn as dots
  bool closed = false;
};

/// A curve seen along one axis, with equal scales; where it starts is marked. Frame vectors have
/// the same length in all projections: `arrow_fraction` of the largest extent of the curve.
Plot projected(const FramedPolyline& curve, Projection projection,
               const std::string& length_unit = "", double arrow_fraction = 0.07);

/// A plane curve with its tangent and normal.
Plot plane_picture(const FramedPolyline& curve, const std::string& length_unit = "");

/// Text with the characters that mean something in XML and HTML escaped; what no XML file may
/// contain (control characters, bytes that are not UTF-8) becomes U+FFFD.
std::string escaped_markup(std::string_view text);

}  // namespace hodograph
