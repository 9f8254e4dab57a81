// SPDX-License-Identifier: MIT
// Random climb requests, harmless and nearly degenerate: each path is judged, and so is each
// refusal.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <string>

#include "hodograph/construction/climb_path.hpp"
#include "hodograph/path/bounds.hpp"
#include "hodograph/path/continuity.hpp"
#include "tests/support/dubins.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {

/// Above the rounding of lengths, angles and roots, some hundred ε.
inline constexpr double rounded_up = 1.0 + 0x1.0p-40;
/// What the finest arcs lose against circles, see construction/turn_limited.hpp.
inline constexpr double fine_arcs = 1.0 + 0x1.0p-20;
/// The inclination's deviation: some ε, in units of the largest |A_i|².
inline constexpr double inclination_rounding = 0x1.0p-44;
/// Directions that a straight line answers for are off it by rounding of the length.
inline constexpr double straight_slack = 0x1.0p-20;
/// How sharply the curvature is bounded again here.
inline constexpr double curvature_width = 0x1.0p-20;

struct ClimbRequest {
  HeadedPoint begin, end;
  bool angle_given = false;
  double climb_angle = 0.0;
  ClimbLimits limits;
};

struct ClimbCampaign {
  std::size_t met = 0, refused = 0, too_little = 0, between = 0;
  std::array<std::size_t, 4> shapes{};
  double worst_end = 0.0, worst_angle = 0.0;
};

/// Directions equal, mirrored, along the chord, opposite, 2 arccos(1/3) apart, or any, each exactly
/// or nearly so; climbs from hopeless to long.
inline ClimbRequest random_climb_request(Random& random) {
  const double pi = std::numbers::pi;
  ClimbRequest r;
  r.angle_given = random.chance(0.6);
  const double radius = random.chance(0.2) ? 0.0 : std::abs(random.spread(-4, 2));
  const double chord = random.chance(0.05) ? 0.0 : random.uniform(0.01, 8.0);
  const double along = random.chance(0.2) ? 0.0 : random.uniform(-pi, pi);
  const double special[] = {0.0, pi, -pi, pi / 2, random.uniform(-pi, pi)};
  const auto near = [&](double angle) {
    return random.chance(0.5) ? angle : angle + random.spread(-52, -3);
  };
  const double first = near(special[random.index(5)]);
  const double partner[] = {first, -first, first + pi, first + 2.0 * std::acos(1.0 / 3.0),
                            random.uniform(-pi, pi)};
  const double last = near(partner[random.index(5)]);
  const Vector3<double> at = random.chance(0.5) ? Vector3<double>{} : random.vector3(10.0);
  r.begin = {at, direction_of_angle(along + first)};
  const Vector2<double> way = chord * direction_of_angle(along);
  r.climb_angle = random.sign() * (random.chance(0.9) ? random.uniform(0.02, 1.4)
                                                      : std::abs(random.spread(-30, -1)));
  const double length = random.chance(0.7)   ? chord + random.uniform(0.0, 20.0)
                        : random.chance(0.5) ? chord + std::abs(random.spread(-50, 6))
                                             : chord * random.uniform(0.2, 1.0);
  double rise = length * std::tan(r.climb_angle);
  if (random.chance(0.03)) rise = -rise;
  if (!r.angle_given && random.chance(0.2)) rise = 0.0;
  r.end = {{at.x + way.x, at.y + way.y, at.z + rise}, direction_of_angle(along + last)};
  r.limits = {random.chance(0.03) ? 0.0 : random.uniform(0.02, 1.4),
              random.chance(0.03) ? 0.0 : random.uniform(0.02, 1.4), radius};
  return r;
}

/// What is wrong with the path for a request, or nothing.
inline std::string complaint_about(const ClimbPath& made, const ClimbRequest& r,
                                   ClimbCampaign& campaign) {
  const auto& path = made.path;
  double size = path.arc_length();
  for (const auto& curve : path.segments()) {
    size = std::max(size, curve.parameter_step() * curve.speed_bound());
  }
  size += made.arc_radius + largest_component(r.begin.position) + largest_component(r.end.position);
  const Vector3<double> gap = path.segments().back().end() - r.end.position;
  const double end = largest_component(gap) / (size * epsilon<double>());
  campaign.worst_end = std::max(campaign.worst_end, end);
  // 64 roundings for the problem's data and for every span.
  const double spans = 64.0 * (2.0 + static_cast<double>(path.segment_count()));
  if (!(end <= spans)) return "the end is missed by " + to_text(largest_component(gap));
  if (!(path.segments().front().start() == r.begin.position)) return "it starts elsewhere";
  if (r.limits.turn_radius > 0.0) {
    const double most = curvature_extremes(path, RangeGoal{curvature_width}).maximum.upper();
    if (!(most * r.limits.turn_radius <= 1.0 + 2.0 * curvature_width))
      return "it turns too sharply";
    if (!(made.most_ground_curvature * r.limits.turn_radius <= 1.0)) return "no certificate";
  }
  if (r.angle_given) {
    // The altitude's own rounding is the angle's.
    const double rise = r.end.position.z - r.begin.position.z;
    const double lost = 4.0 * epsilon<double>() * size / std::abs(rise);
    const double off = std::abs(made.climb_angle - r.climb_angle);
    if (!(off <= std::abs(r.climb_angle) * (inclination_rounding + lost))) return "another angle";
  } else if (!(made.climb_angle <= r.limits.climb_angle &&
               made.climb_angle >= -r.limits.descent_angle)) {
    return "an angle beyond the limits";
  }
  const double sine = std::sin(made.climb_angle);
  for (const auto& curve : path.segments()) {
    const auto hodograph = curve.hodograph();
    const auto speed = curve.speed_polynomial();
    for (std::size_t i = 0; i <= 4; ++i) {
      const double off = std::abs(hodograph[i].z - sine * speed[i]) / curve.speed_bound();
      campaign.worst_angle = std::max(campaign.worst_angle, off);
      if (!(off <= inclination_rounding)) return "the climb angle is not constant";
    }
  }
  const auto first = path.segments().front().hodograph().front();
  const auto last = path.segments().back().hodograph().back();
  for (const auto& [way, heading] : {std::pair{first, r.begin.heading}, {last, r.end.heading}}) {
    const Vector2<double> seen{way.x, way.y};
    const double off = std::abs(cross(seen, heading)) / (norm(seen) * norm(heading));
    if (!(dot(seen, heading) > 0.0 && off <= straight_slack)) return "another heading";
  }
  if (path.segment_count() > 1) {
    const auto joints = continuity(path);
    if (joints.position.order() < 1) return "a corner";
    if (joints.preimage.order() < 0) return "the preimage jumps";
  }
  return {};
}

/// Why a refusal is not justified, or nothing.
inline std::string complaint_about(const Fault& fault, const ClimbRequest& r,
                                   ClimbCampaign& campaign) {
  const double rise = r.end.position.z - r.begin.position.z;
  const Vector3<double> way = r.end.position - r.begin.position;
  const double chord = std::hypot(way.x, way.y);
  if (!r.angle_given) {
    const double limit = rise > 0.0 ? r.limits.climb_angle : r.limits.descent_angle;
    if (rise != 0.0 && limit == 0.0) return {};
    if (rise == 0.0 && chord == 0.0 && r.limits.turn_radius == 0.0) return {};
    return "refused within limits: " + fault.sentence;
  }
  if (rise == 0.0 || (rise > 0.0) != (r.climb_angle > 0.0)) return {};
  const double length = rise / std::tan(r.climb_angle);
  if (fault.quantity != "climb" || !fault.bound) return "no bound: " + fault.sentence;
  const DirectedPoint begin{{r.begin.position.x, r.begin.position.y}, r.begin.heading};
  const DirectedPoint end{{r.end.position.x, r.end.position.y}, r.end.heading};
  const double shortest = r.limits.turn_radius > 0.0
                              ? dubins_length(begin, end, fine_arcs * r.limits.turn_radius)
                              : chord * rounded_up;
  if (fault.sentence.find("met with less") == std::string::npos) {
    ++campaign.too_little;
    // Back to where it began: a path of no length, or a whole turn.
    const bool back = shortest < straight_slack * r.limits.turn_radius && chord == 0.0;
    if (!back && !(length <= rounded_up * shortest)) return "it could be met: " + fault.sentence;
  } else {
    ++campaign.between;
  }
  ClimbRequest higher = r;
  higher.end.position.z = r.begin.position.z + std::copysign(*fault.bound, rise);
  const auto met =
      climb_path(higher.begin, higher.end, higher.climb_angle, higher.limits.turn_radius);
  if (!met) return fault.sentence + "; but then: " + met.fault().sentence;
  const std::string complaint = complaint_about(*met, higher, campaign);
  return complaint.empty() ? complaint : fault.sentence + "; but then: " + complaint;
}

template <class Complain>
ClimbCampaign run_climb_campaign(Random& random, std::size_t requests, const Complain& complain) {
  ClimbCampaign campaign;
  for (std::size_t i = 0; i < requests; ++i) {
    const ClimbRequest r = random_climb_request(random);
    const auto made = r.angle_given
                          ? climb_path(r.begin, r.end, r.climb_angle, r.limits.turn_radius)
                          : climb_path(r.begin, r.end, r.limits);
    std::string complaint;
    if (made) {
      ++campaign.met;
      ++campaign.shapes[static_cast<std::size_t>(made->shape)];
      complaint = complaint_about(*made, r, campaign);
    } else {
      ++campaign.refused;
      complaint = complaint_about(made.fault(), r, campaign);
    }
    if (!complaint.empty()) complain("request " + std::to_string(i) + ": " + complaint);
  }
  return campaign;
}

inline void print_climb_campaign(const ClimbCampaign& c) {
  std::printf(
      "met %zu (one span %zu, arcs %zu, swerve %zu, loiter %zu), refused %zu (too little climb "
      "%zu, "
      "between lengths %zu); end within %.0f eps, inclination within %.1e\n",
      c.met, c.shapes[0], c.shapes[1], c.shapes[2], c.shapes[3], c.refused, c.too_little, c.between,
      c.worst_end, c.worst_angle);
}

}  // namespace hodograph::test
