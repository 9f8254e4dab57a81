// SPDX-License-Identifier: MIT
#include "cli/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/point_state.hpp"
#include "cli/sample_plan.hpp"

namespace hodograph::cli {
namespace {

constexpr std::size_t points_a_segment = 24;
constexpr std::size_t fewest_points = 600, most_points = 6000;
constexpr std::size_t frames_of_a_report = 36;

Vector3<double> in_space(const std::vector<double>& v) {
  return {v[0], v[1], v.size() > 2 ? v[2] : 0.0};
}

/// Parameters that follow the knots: the same number inside every segment, the knots included.
std::vector<double> parameters_by_segment(const AnyPath& path, std::size_t wanted) {
  SamplePlan plan;
  plan.count_per_segment = std::max<std::size_t>(2, wanted / path.segment_count());
  return sampled_parameters(path, plan).value();
}

std::size_t drawn_points(const AnyPath& path) {
  return std::clamp(path.segment_count() * points_a_segment, fewest_points, most_points);
}

}  // namespace

FramedPolyline framed_polyline(const PathDocument& document, std::size_t points,
                               std::size_t frames) {
  const AnyPath& path = document.path;
  FramedPolyline picture;
  picture.closed = path.is_closed();
  std::vector<double> point(path.dimension());
  for (const double xi : parameters_by_segment(path, points)) {
    path.position(xi, point);
    picture.points.push_back(in_space(point));
  }
  constexpr std::size_t most_knots = 400;  // more are a solid line of dots
  if (path.knots().size() <= most_knots) {
    for (const double xi : path.knots()) {
      path.position(xi, point);
      picture.knots.push_back(in_space(point));
    }
  }
  for (std::size_t i = 0; i < frames; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(
                                                      1, path.is_closed() ? frames : frames - 1));
    const double xi = parameter_at(path, std::min(path.arc_length(), share * path.arc_length()));
    const PointState state = state_at(path, xi, document.roll);
    if (!state.moves) continue;
    picture.frame_origins.push_back(in_space(state.position[0]));
    const auto& axes = state.frame[0];
    picture.frames.push_back(
        {in_space(axes[0]), in_space(axes[1]),
         axes.size() > 2 ? in_space(axes[2]) : Vector3<double>{0.0, 0.0, 1.0}});
  }
  return picture;
}

void add_drawing(ReportData& data, const PathDocument& document) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const AnyPath& path = document.path;
  const std::size_t points = drawn_points(path);
  data.path = framed_polyline(document, points, frames_of_a_report);
  for (const double xi : parameters_by_segment(path, std::min(points, most_points / 2))) {
    const PointState state = state_at(path, xi, document.roll);
    data.xi.push_back(xi);
    data.speed.push_back(state.speed[0]);
    data.curvature.push_back(state.moves ? state.curvature : none);
    data.torsion.push_back(state.torsion ? *state.torsion : none);
    if (!state.moves) {
      data.body_rate.push_back({none, none, none});
    } else {
      const auto& chi = state.rates.body_per_xi[0];
      data.body_rate.push_back(chi.size() == 1 ? Vector3<double>{0.0, 0.0, chi[0]} : in_space(chi));
    }
  }
}

}  // namespace hodograph::cli
