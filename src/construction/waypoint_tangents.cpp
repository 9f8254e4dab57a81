// SPDX-License-Identifier: MIT
#include "hodograph/construction/waypoint_tangents.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "hodograph/construction/planar_hermite.hpp"
#include "hodograph/foundation/accuracy.hpp"

namespace hodograph {
namespace {

using Vector = Vector2<double>;

/// The waypoints without a repeated closing one.
struct Waypoints {
  std::span<const Vector> points;
  bool repeats_first = false;
};

std::optional<Fault> choose_waypoints(std::span<const Vector> points, bool closed,
                                      Waypoints& result) {
  result.repeats_first = closed && points.size() > 1 && points.front() == points.back();
  result.points = result.repeats_first ? points.first(points.size() - 1) : points;
  const std::size_t count = result.points.size();
  if (count < 2) {
    return Fault{FaultCode::too_few,
                 "a path needs at least 2 waypoints; got " + std::to_string(count),
                 std::nullopt,
                 "points",
                 static_cast<double>(count),
                 2.0};
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (!is_finite(result.points[k])) {
      return Fault{FaultCode::not_finite,
                   "waypoint " + std::to_string(k) + " has a coordinate that is not finite",
                   k,
                   "point",
                   std::nullopt,
                   std::nullopt};
    }
    if (k > 0 && result.points[k] == result.points[k - 1]) {
      return Fault{FaultCode::outside_domain,
                   "waypoint " + std::to_string(k) +
                       " is equal to the one before it; neighbouring waypoints must differ",
                   k,
                   "distance",
                   0.0,
                   0.0};
    }
  }
  if (closed && result.points.front() == result.points.back()) {
    return Fault{FaultCode::outside_domain,
                 "waypoint " + std::to_string(count) +
                     " is equal to the one before it; the first waypoint may be repeated once",
                 count,
                 "distance",
                 0.0,
                 0.0};
  }
  return std::nullopt;
}

/// A chord: its length and its unit vector.
struct Chord {
  double length = 0.0;
  Vector unit;
};

Chord chord_between(const Vector& from, const Vector& to) {
  // Scaled, so that differences neither overflow nor lose digits to underflow.
  const double scale =
      largest_component(Vector{0.5 * to.x - 0.5 * from.x, 0.5 * to.y - 0.5 * from.y});
  const Vector d{(0.5 * to.x - 0.5 * from.x) / scale, (0.5 * to.y - 0.5 * from.y) / scale};
  const double length = std::hypot(d.x, d.y);
  return {2.0 * scale * length, {d.x / length, d.y / length}};
}

std::optional<Vector> direction(const Vector& sum) {
  const double size = std::hypot(sum.x, sum.y);
  // A sum of two numbers of total size 1, each with some 8 roundings.
  constexpr double rounding = 8.0 * epsilon<double>();
  if (!(size > rounding)) return std::nullopt;
  return Vector{sum.x / size, sum.y / size};
}

Fault no_direction(std::size_t k, const char* reason) {
  return {FaultCode::zero_speed,
          "there is no direction at waypoint " + std::to_string(k) + ": " + reason,
          k,
          "tangent",
          0.0,
          std::nullopt};
}

Result<std::vector<Vector>> tangents_by_t1(std::span<const Vector> points, bool closed) {
  const std::size_t count = points.size();
  std::vector<Chord> chords;  // chords[k] leads from point k to the next one
  for (std::size_t k = 0; k + 1 < count; ++k) {
    chords.push_back(chord_between(points[k], points[k + 1]));
  }
  if (closed) chords.push_back(chord_between(points[count - 1], points[0]));
  std::vector<Vector> tangents(count);
  if (count == 2 && !closed) {
    tangents[0] = tangents[1] = chords[0].unit;
    return tangents;
  }
  for (std::size_t k = closed ? 0 : 1; k < (closed ? count : count - 1); ++k) {
    const Chord& before = chords[k > 0 ? k - 1 : count - 1];
    const Chord& after = chords[k];
    const double share = before.length < after.length ? 1.0 / (1.0 + before.length / after.length)
                                                      : (after.length / before.length) /
                                                            (1.0 + after.length / before.length);
    const auto tangent = direction(share * before.unit + (1.0 - share) * after.unit);
    if (!tangent) {
      return no_direction(k, "the path turns straight back there with equal chords (rule T1)");
    }
    tangents[k] = *tangent;
  }
  if (!closed) {
    const auto mirrored = [](const Vector& t, const Vector& unit) {
      const double along = 2.0 * dot(t, unit);
      return *direction(along * unit - t);
    };
    tangents[0] = mirrored(tangents[1], chords.front().unit);
    tangents[count - 1] = mirrored(tangents[count - 2], chords.back().unit);
  }
  return tangents;
}

Result<std::vector<Vector>> tangents_by_t2(std::span<const Vector> points,
                                           const WaypointOptions& options) {
  PlanarSplineOptions spline_options = options.spline;
  spline_options.closed = options.closed;
  spline_options.repeated = RepeatedPoints::refuse;
  const auto spline = planar_spline_preimage(points, spline_options);
  if (!spline) return spline.fault();
  std::vector<Vector> tangents(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Complex<double>& w = spline->node[k];
    const double size = std::hypot(w.re, w.im);
    if (!(size > 0.0)) return no_direction(k, "the C² spline comes to rest there (rule T2)");
    const Complex<double> unit{w.re / size, w.im / size};
    tangents[k] = *direction(hodograph_form(unit, unit));
  }
  return tangents;
}

Result<std::vector<Vector>> tangents_at(const Waypoints& waypoints,
                                        const WaypointOptions& options) {
  return options.rule == TangentRule::t1 ? tangents_by_t1(waypoints.points, options.closed)
                                         : tangents_by_t2(waypoints.points, options);
}

}  // namespace

Result<std::vector<Vector2<double>>> waypoint_tangents(std::span<const Vector2<double>> points,
                                                       const WaypointOptions& options) {
  Waypoints waypoints;
  if (auto fault = choose_waypoints(points, options.closed, waypoints)) return *fault;
  auto tangents = tangents_at(waypoints, options);
  if (tangents && waypoints.repeats_first) {
    const Vector first = tangents->front();
    (*tangents).push_back(first);
  }
  return tangents;
}

Result<PlanarPath<2>> waypoint_path(std::span<const Vector2<double>> points,
                                    const WaypointOptions& options) {
  if (!(options.speed > 0.0) || !is_finite(options.speed)) {
    return Fault{
        FaultCode::outside_domain,
        "the speed at the waypoints must be positive and finite; got " + to_text(options.speed),
        std::nullopt,
        "speed",
        options.speed,
        0.0};
  }
  Waypoints waypoints;
  if (auto fault = choose_waypoints(points, options.closed, waypoints)) return *fault;
  const auto tangents = tangents_at(waypoints, options);
  if (!tangents) return tangents.fault();
  const std::size_t count = waypoints.points.size();
  std::vector<double> knots{0.0};
  std::vector<PlanarHermitePoint> data;
  for (std::size_t k = 0; k < count + (options.closed ? 1 : 0); ++k) {
    const std::size_t at = k % count;
    data.push_back({waypoints.points[at], options.speed * (*tangents)[at]});
    if (k == 0) continue;
    knots.push_back(knots.back() + chord_between(data[k - 1].position, data[k].position).length);
  }
  return planar_hermite_path(std::move(knots), data, options.closed);
}

}  // namespace hodograph
