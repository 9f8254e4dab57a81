// SPDX-License-Identifier: MIT
// Plans judged by dense samples: no point too near, no bend too sharp. What the tests sample and
// the campaign runs in full.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "hodograph/planning/plan.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_worlds.hpp"

namespace hodograph::test {

inline double point_distance(const Vector2<double>& p, const Vector2<double>& a,
                             const Vector2<double>& b) {
  const Vector2<double> d = b - a;
  const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
  const Vector2<double> off = p - a - t * d;
  return std::hypot(off.x, off.y);
}

/// The least distance of sampled points from the edges of the world, and the largest |κ| of them.
inline void expect_limits_at_samples(const Plan& plan, const World& world,
                                     const VehicleLimits& limits, double size = 15.0) {
  constexpr int samples = 3000;
  for (int k = 0; k <= samples; ++k) {
    const double xi = plan.path.clamped(plan.path.xi_begin() +
                                        (plan.path.xi_end() - plan.path.xi_begin()) * k / samples);
    const Vector2<double> p = plan.path.position(xi);
    const double curvature = std::abs(hodograph::curvature(plan.path.preimage_jet<1>(xi)));
    EXPECT_LE(curvature * limits.turn_radius, 1.0 + planning_tolerance);
    const auto keep = [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        ASSERT_GE(point_distance(p, ring[i], ring[next_vertex(i, ring.size())]),
                  limits.distance() - 2.0 * planning_tolerance * size);
      }
    };
    for (const Polygon& polygon : world.obstacles()) {
      keep(polygon.outer);
      for (const Ring& hole : polygon.holes) keep(hole);
    }
    if (world.bounds()) keep(*world.bounds());
  }
}

/// Worlds on coarse and fine lattices: obstacles that touch, overlap, repeat, lie in line, with
/// holes and bounds. What is planned keeps its limits at samples; what is not is refused with
/// reason.
inline void plan_in_degenerate_worlds(const char* name, int worlds) {
  Random random(name);
  int planned = 0, rounded = 0;
  for (int round = 0; round < worlds && !testing::Test::HasFailure(); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const double size = round % 3 == 0 ? 12.0 : round % 3 == 1 ? 30.0 : 2000.0;
    const World world = random_world(random, size, static_cast<std::size_t>(random.integer(1, 9)));
    VehicleLimits limits;
    limits.turn_radius = size * std::exp(random.uniform(-7.0, -1.5));
    limits.clearance = random.chance(0.3) ? 0.0 : size * random.uniform(0.0, 0.03);
    limits.width = random.chance(0.5) ? 0.0 : size * random.uniform(0.0, 0.02);
    const auto planner = Planner::create(world, limits);
    ASSERT_TRUE(planner) << planner.fault().sentence;
    PlanRequest request;
    request.start = random_place(random, world, size);
    request.goal = random_place(random, world, size);
    request.aim = static_cast<CornerAim>(round % 4);
    const auto plan = planner->plan(request);
    if (!plan) {
      EXPECT_FALSE(plan.fault().sentence.empty());
      continue;
    }
    ++planned;
    if (!plan->legs.empty()) ++rounded;
    EXPECT_TRUE(plan->certificate.proves(limits, 1.1 * size + 3.0));
    expect_limits_at_samples(*plan, world, limits, 1.1 * size + 3.0);
  }
  EXPECT_GT(6 * planned, worlds);
  EXPECT_GT(rounded, 0);
}

}  // namespace hodograph::test
