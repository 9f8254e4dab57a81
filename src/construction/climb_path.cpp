// SPDX-License-Identifier: MIT
// Climbs within limits, and helical splines: the length over ground from the limits, plans of that
// length, and their lifting.
#include "hodograph/construction/climb_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "end_point_faults.hpp"
#include "hodograph/construction/lift.hpp"
#include "hodograph/frame/continuity.hpp"

namespace hodograph {
namespace {

constexpr double quarter_turn = 0.5 * std::numbers::pi;

DirectedPoint over_ground(const HeadedPoint& p) {
  return {{p.position.x, p.position.y}, p.heading};
}

std::optional<Fault> limits_fault(const ClimbLimits& limits) {
  const std::pair<const char*, double> angles[] = {{"climb angle", limits.climb_angle},
                                                   {"descent angle", limits.descent_angle}};
  for (const auto& [name, angle] : angles) {
    if (angle >= 0.0 && angle < quarter_turn) continue;
    return Fault{std::isnan(angle) ? FaultCode::not_finite : FaultCode::outside_domain,
                 std::string("the largest ") + name +
                     " must be at least 0 and below pi/2, in radians; got " + to_text(angle),
                 std::nullopt,
                 name,
                 angle,
                 quarter_turn};
  }
  return std::nullopt;
}

/// Whether a path with this climb exists; the climb is the altitudes' own.
bool is_met(const HeadedPoint& begin, const HeadedPoint& end, double rise, double angle,
            double turn_radius) {
  return turn_limited_path(over_ground(begin), over_ground(end), rise / std::tan(angle),
                           turn_radius)
      .has_value();
}

/// A plan's refusal in terms of the climb. The climb named is tried with these altitudes.
Fault in_terms_of_climb(Fault fault, const HeadedPoint& begin, const HeadedPoint& end, double angle,
                        double turn_radius) {
  if (fault.code != FaultCode::no_interpolant || fault.quantity != "length" || !fault.bound) {
    return fault;
  }
  const double rise = end.position.z - begin.position.z;
  const double slope = std::abs(std::tan(angle)), least = *fault.bound * slope;
  double bound = least;
  for (const double excess : planar_detail::tried_excesses) {
    const double more = std::copysign(least * (1.0 + excess), rise);
    const double risen = (begin.position.z + more) - begin.position.z;  // as altitudes round
    bound = std::abs(risen);
    if (is_met(begin, end, risen, angle, turn_radius)) break;
  }
  const bool between = fault.sentence.find("whole turns") != std::string::npos;
  const bool more_than = fault.sentence.find("more than") != std::string::npos;
  const std::string what = rise > 0.0 ? " of climb" : " of descent";
  fault.sentence =
      std::string(rise > 0.0 ? "climb" : "descent") + " angle " + to_text(angle) +
      " rad with a turn radius of " + to_text(turn_radius) +
      (between     ? " is met with less, or with a whole turn by " + to_text(bound) + what + ","
       : more_than ? std::string(" needs more ") + (rise > 0.0 ? "climb (" : "descent (") +
                         to_text(bound) + " will do)"
                   : " needs at least " + to_text(bound) + what) +
      " between these points and headings; got " + to_text(std::abs(rise));
  fault.quantity = "climb";
  fault.value = std::abs(rise);
  fault.bound = bound;
  return fault;
}

Result<ClimbPath> lift(const TurnLimitedPath& plan, const HeadedPoint& begin, double rise,
                       double ground_length) {
  // Over the plan's own length, which has the rounding of its spans: so the altitude is met.
  auto path = lifted(plan.path, begin.position.z, rise / plan.path.arc_length());
  if (!path) return path.fault();
  return ClimbPath{*std::move(path),   std::atan2(rise, ground_length),
                   ground_length,      plan.shape,
                   plan.whole_turns,   plan.arc_radius,
                   plan.most_curvature};
}

}  // namespace

Result<ClimbPath> climb_path(const HeadedPoint& begin, const HeadedPoint& end, double climb_angle,
                             double turn_radius) {
  // The faults of the data and of the angle are those of the single curve.
  const auto single = climb_curve(begin, end, climb_angle);
  if (!single && (single.fault().quantity != "climb" || turn_radius == 0.0 ||
                  end.position.z == begin.position.z ||
                  (end.position.z > begin.position.z) != (climb_angle > 0.0))) {
    return single.fault();
  }
  const double rise = end.position.z - begin.position.z;
  const double ground_length = rise / std::tan(climb_angle);
  auto plan = turn_limited_path(over_ground(begin), over_ground(end), ground_length, turn_radius);
  if (!plan) {
    return in_terms_of_climb(plan.fault(), begin, end, climb_angle, turn_radius);
  }
  return lift(*plan, begin, rise, ground_length);
}

Result<ClimbPath> climb_path(const HeadedPoint& begin, const HeadedPoint& end,
                             const ClimbLimits& limits, double most_detour) {
  if (auto fault = planar_detail::altitude_fault(begin, end)) return *std::move(fault);
  if (auto fault = limits_fault(limits)) return *std::move(fault);
  const double rise = end.position.z - begin.position.z;
  const double limit = rise > 0.0 ? limits.climb_angle : limits.descent_angle;
  const Vector3<double> way = end.position - begin.position;
  if (rise != 0.0 && limit == 0.0) {
    const double straight = std::atan2(std::abs(rise), std::hypot(way.x, way.y));
    return Fault{
        FaultCode::no_interpolant,
        std::string(rise > 0.0 ? "a climb" : "a descent") + " of " + to_text(std::abs(rise)) +
            " needs " + (rise > 0.0 ? "a climb angle" : "a descent angle") +
            " above 0; the vehicle's is 0 (the straight line has " + to_text(straight) + " rad)",
        std::nullopt,
        rise > 0.0 ? "climb angle" : "descent angle",
        0.0,
        straight};
  }
  // A little longer than the steepest angle asks for, so that rounding does not make it steeper.
  constexpr double safe = 1.0 + 8.0 * epsilon<double>();
  const double least = rise == 0.0 ? 0.0 : safe * (std::abs(rise) / std::tan(limit));
  auto plan = shortest_turn_limited_path(over_ground(begin), over_ground(end), limits.turn_radius,
                                         {least, most_detour});
  if (!plan) return plan.fault();
  const double ground_length = std::max(plan->path.arc_length(), least);
  return lift(*plan, begin, rise, ground_length);
}

Result<ClimbPath> climb_path_of_ground_length(const HeadedPoint& begin, const HeadedPoint& end,
                                              double ground_length, double turn_radius) {
  if (auto fault = planar_detail::altitude_fault(begin, end)) return *std::move(fault);
  auto plan = turn_limited_path(over_ground(begin), over_ground(end), ground_length, turn_radius);
  if (!plan) return plan.fault();
  return lift(*plan, begin, end.position.z - begin.position.z, ground_length);
}

Result<ClimbRoute> climb_route(std::span<const ClimbWaypoint> waypoints,
                               const ClimbRouteOptions& options) {
  if (waypoints.size() < 2) {
    return Fault{FaultCode::too_few,
                 "a route needs at least two waypoints; got " + std::to_string(waypoints.size()),
                 std::nullopt,
                 "waypoints",
                 static_cast<double>(waypoints.size()),
                 2.0};
  }
  std::vector<Vector2<double>> headings(waypoints.size());
  const bool missing = std::any_of(waypoints.begin(), waypoints.end(),
                                   [](const ClimbWaypoint& w) { return !w.heading; });
  if (missing) {
    std::vector<Vector2<double>> places;
    for (const auto& w : waypoints) places.push_back({w.position.x, w.position.y});
    WaypointOptions rule;
    rule.rule = options.headings;
    auto found = waypoint_tangents(places, rule);
    if (!found) {
      Fault fault = found.fault();
      fault.sentence += " (over ground; give the headings)";
      return fault;
    }
    headings = *std::move(found);
  }
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    if (waypoints[i].heading) headings[i] = *waypoints[i].heading;
  }
  std::vector<double> knots{0.0};
  std::vector<SpatialPhCurve<2>> curves;
  std::vector<ClimbSpan> spans;
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i) {
    const HeadedPoint begin{waypoints[i].position, headings[i]};
    const HeadedPoint end{waypoints[i + 1].position, headings[i + 1]};
    const ClimbWaypoint& from = waypoints[i];
    const double radius = options.limits.turn_radius;
    const bool by_angle =
        from.climb_angle && (*from.climb_angle != 0.0 || begin.position.z != end.position.z);
    const auto made = from.ground_length
                          ? climb_path_of_ground_length(begin, end, *from.ground_length, radius)
                      : by_angle ? climb_path(begin, end, *from.climb_angle, radius)
                                 : climb_path(begin, end, options.limits, options.most_detour);
    if (!made) {
      Fault fault = made.fault();
      fault.sentence = "span " + std::to_string(i) + ": " + fault.sentence;
      fault.index = i + fault.index.value_or(0);
      return fault;
    }
    const std::size_t first = curves.size();
    for (std::size_t k = 0; k < made->path.segment_count(); ++k) {
      const SpatialPhCurve<2>& curve = made->path.segment(k);
      const double knot = knots.back() + curve.parameter_step();
      const double step = knot - knots.back();  // rounded as the knots are
      const bool flip =
          !curves.empty() && dot(curves.back().preimage().back(), curve.preimage().front()) < 0.0;
      const double factor = (flip ? -1.0 : 1.0) * std::sqrt(curve.parameter_step() / step);
      curves.emplace_back(k == 0 ? begin.position : curves.back().end(),
                          curve.preimage().mapped([&](const auto& a) { return factor * a; }), step);
      knots.push_back(knot);
    }
    spans.push_back({first, curves.size() - 1, made->climb_angle, made->ground_length, made->shape,
                     made->whole_turns, made->most_ground_curvature});
  }
  auto path = SpatialPath<2>::create(std::move(knots), std::move(curves), false);
  if (!path) return path.fault();
  ClimbRoute route{*std::move(path), std::move(headings), std::move(spans), {}};
  for (std::size_t i = 1; i < route.spans.size(); ++i) {
    const std::size_t knot = route.spans[i].first;
    const auto jumps = jumps_at_knot(route.path, knot);
    const auto frame = frame_jumps_at_knot(route.path, knot);
    route.joints.push_back({i, knot, route.spans[i].climb_angle - route.spans[i - 1].climb_angle,
                            jumps.position.order(), jumps.preimage.order(), frame.frame.order(),
                            frame.angular_velocity.order()});
  }
  return route;
}

}  // namespace hodograph
