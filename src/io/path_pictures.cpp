// SPDX-License-Identifier: MIT
// Pictures of paths: what is seen along an axis, with frames.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "hodograph/io/svg.hpp"

namespace hodograph {
namespace {

constexpr double picture_width = 360.0, picture_height = 360.0;

struct Axes {
  std::size_t right, up;
  const char* right_name;
  const char* up_name;
};

Axes axes_of(Projection projection) {
  switch (projection) {
    case Projection::xy:
      return {0, 1, "x", "y"};
    case Projection::xz:
      return {0, 2, "x", "z"};
    case Projection::yz:
      return {1, 2, "y", "z"};
  }
  return {0, 1, "x", "y"};
}

double extent(const std::vector<Vector3<double>>& points) {
  double largest = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = 0.0, high = 0.0;
    bool first = true;
    for (const auto& point : points) {
      if (!std::isfinite(point[axis])) continue;
      low = first ? point[axis] : std::min(low, point[axis]);
      high = first ? point[axis] : std::max(high, point[axis]);
      first = false;
    }
    largest = std::max(largest, high - low);
  }
  return largest;
}

Plot picture(const FramedPolyline& curve, const Axes& axes, const std::string& length_unit,
             double arrow_length, std::size_t vectors) {
  assert(curve.frames.size() == curve.frame_origins.size());
  const auto seen = [&](const Vector3<double>& v) -> Vector2<double> {
    return {v[axes.right], v[axes.up]};
  };
  const std::string unit = length_unit.empty() ? "" : " (" + length_unit + ")";
  Plot plot;
  plot.width = picture_width;
  plot.height = picture_height;
  plot.equal_aspect = true;
  plot.title = std::string(axes.right_name) + "\xe2\x80\x93" + axes.up_name;
  plot.x.label = axes.right_name + unit;
  plot.y.label = axes.up_name + unit;
  Series line;
  for (const auto& point : curve.points) {
    line.x.push_back(seen(point).x);
    line.y.push_back(seen(point).y);
  }
  if (curve.closed && !curve.points.empty()) {
    line.x.push_back(line.x.front());
    line.y.push_back(line.y.front());
  }
  plot.series.push_back(std::move(line));
  if (!curve.knots.empty()) {
    Series knots{"knots", {}, {}, SeriesStyle::dots, PlotColor::blue};
    for (const auto& point : curve.knots) {
      knots.x.push_back(seen(point).x);
      knots.y.push_back(seen(point).y);
    }
    plot.series.push_back(std::move(knots));
  }
  constexpr std::array names = {"e\xe2\x82\x81", "e\xe2\x82\x82", "e\xe2\x82\x83"};
  constexpr std::array colors = {PlotColor::vermilion, PlotColor::green, PlotColor::purple};
  for (std::size_t i = 0; i < vectors && !curve.frames.empty(); ++i) {
    Arrows arrows{names[i], colors[i], {}};
    for (std::size_t k = 0; k < curve.frames.size(); ++k) {
      const Frame3<double>& frame = curve.frames[k];
      const Vector3<double>& vector = i == 0 ? frame.e1 : i == 1 ? frame.e2 : frame.e3;
      const Vector3<double>& origin = curve.frame_origins[k];
      arrows.from_to.emplace_back(seen(origin), seen(origin + arrow_length * vector));
    }
    plot.arrows.push_back(std::move(arrows));
  }
  if (!curve.points.empty()) {
    plot.marks.push_back({seen(curve.points.front()), "start", PlotColor::grey});
  }
  return plot;
}

}  // namespace

Plot projected(const FramedPolyline& curve, Projection projection, const std::string& length_unit,
               double arrow_fraction) {
  return picture(curve, axes_of(projection), length_unit, arrow_fraction * extent(curve.points), 3);
}

Plot plane_picture(const FramedPolyline& curve, const std::string& length_unit) {
  constexpr double arrow_fraction = 0.07;
  Plot plot = picture(curve, axes_of(Projection::xy), length_unit,
                      arrow_fraction * extent(curve.points), 2);
  plot.title = "Path";
  return plot;
}

}  // namespace hodograph
