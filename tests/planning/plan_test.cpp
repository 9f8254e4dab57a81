// SPDX-License-Identifier: MIT
// Plans: the limits hold at every sampled point, and what cannot be made is refused with numbers.
#include "hodograph/planning/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hodograph/path/planar_curvature.hpp"
#include "tests/support/plan_judge.hpp"
#include "tests/support/random.hpp"
#include "tests/support/star_worlds.hpp"

namespace hodograph {
namespace {

using test::Random;
using P = Vector2<double>;

using test::expect_limits_at_samples;

TEST(Planner, KeepsItsLimitsInRandomWorlds) {
  Random random("plans in random worlds");
  int planned = 0, rounded = 0;
  for (int round = 0; round < 60; ++round) {
    VehicleLimits limits;
    limits.turn_radius = std::exp(random.uniform(-3.0, 1.0));
    limits.clearance = random.uniform(0.0, 0.4);
    limits.width = round % 3 == 0 ? 0.0 : random.uniform(0.0, 0.2);
    const World world = test::star_world(random, 14, 0.6, 2.2);
    const auto planner = Planner::create(world, limits);
    ASSERT_TRUE(planner) << planner.fault().sentence;
    PlanRequest request;
    request.start = {-14, random.uniform(-12, 12)};
    request.goal = {14, random.uniform(-12, 12)};
    request.aim = static_cast<CornerAim>(round % 4);
    const auto plan = planner->plan(request);
    if (!plan) {
      EXPECT_EQ(plan.fault().code, FaultCode::no_route) << plan.fault().sentence;
      continue;
    }
    ++planned;
    if (!plan->legs.empty()) ++rounded;
    EXPECT_TRUE(plan->certificate.proves(limits, 15.0));
    expect_limits_at_samples(*plan, world, limits);
    const P first = plan->path.position(plan->path.xi_begin());
    const P last = plan->path.position(plan->path.xi_end());
    EXPECT_EQ(first, request.start);
    EXPECT_NEAR(last.x, request.goal.x, 1024.0 * epsilon<double>() * 20.0);
    EXPECT_NEAR(last.y, request.goal.y, 1024.0 * epsilon<double>() * 20.0);
    EXPECT_LE(plan->path.arc_length(), plan->polyline.length * (1.0 + 64.0 * epsilon<double>()));
    EXPECT_TRUE(plan->certificate.arc_length.contains(plan->path.arc_length()));
  }
  EXPECT_GE(planned, 40);
  EXPECT_GE(rounded, 30);
}

/// A block in the way, whose shortest way round has two corners of 4 apart.
World block() { return World::create({{{{0, -2}, {4, -2}, {4, 2}, {0, 2}}, {}, "block"}}).value(); }

TEST(Planner, KeepsItsLimitsInDegenerateWorlds) {
  test::plan_in_degenerate_worlds("plans in degenerate worlds", 40);
}

TEST(Planner, GivesEveryCornerTheOffsetOfItsAngle) {
  const VehicleLimits limits{0.5, 0.25, 0.5};
  const auto planner = Planner::create(block(), limits).value();
  const auto plan = planner.plan({{-6, 0}, {10, 0.5}});
  ASSERT_TRUE(plan) << plan.fault().sentence;
  ASSERT_EQ(plan->legs.size(), 2U);
  EXPECT_EQ(plan->attempts, 1U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_GT(plan->offsets[k], limits.distance());
    EXPECT_LT(plan->offsets[k], limits.distance() + 32.0 / 15.0 * limits.turn_radius);
  }
  // Both corners have the least radius: the certified curvature is the limit's, but for 2^-30 that
  // is planned to spare.
  constexpr double spared = 0x1p-30;
  EXPECT_NEAR(plan->certificate.curvature.upper(), 2.0 * (1.0 - spared), 0.5 * spared);
  // With room for larger corners the path gets gentler, and with the right aim shorter.
  const auto with_aim = [&](CornerAim aim) {
    PlanRequest request{{-6, 0}, {10, 0.5}, aim, 1.0, 64};
    return planner.plan(request).value();
  };
  const auto small = with_aim(CornerAim::smallest), large = with_aim(CornerAim::largest);
  const auto quick = with_aim(CornerAim::least_length);
  const auto gentle = with_aim(CornerAim::least_peak_curvature);
  EXPECT_LT(quick.path.arc_length(), small.path.arc_length());
  EXPECT_LE(quick.path.arc_length(), large.path.arc_length());
  EXPECT_LT(gentle.certificate.curvature.upper(), small.certificate.curvature.lower());
  EXPECT_LE(gentle.certificate.curvature.lower(), large.certificate.curvature.upper());
  for (const Plan* one : {&small, &large, &quick, &gentle}) {
    EXPECT_TRUE(one->certificate.proves(limits, 10.0));
    expect_limits_at_samples(*one, planner.world(), limits);
  }
}

TEST(Planner, GoesRoundWhereAGapHasNoRoomToTurn) {
  // Two walls with staggered gaps close to each other: an S turn that a small vehicle can make.
  const World world = World::create({{{{0, -8}, {0.5, -8}, {0.5, 1}, {0, 1}}, {}, "west"},
                                     {{{1.5, -1}, {2, -1}, {2, 8}, {1.5, 8}}, {}, "east"}})
                          .value();
  const P start{-4, 0}, goal{6, 0};
  const auto small = Planner::create(world, {0.1, 0.1, 0.0}).value().plan({start, goal});
  ASSERT_TRUE(small) << small.fault().sentence;
  const auto large = Planner::create(world, {2.0, 0.1, 0.0}).value().plan({start, goal});
  ASSERT_TRUE(large) << large.fault().sentence;
  EXPECT_GT(large->attempts, 1U);
  EXPECT_GE(large->given_up.size(), 1U);
  EXPECT_LT(large->given_up.size(), large->attempts);
  EXPECT_GT(large->path.arc_length(), small->path.arc_length());
  EXPECT_TRUE(large->certificate.proves({2.0, 0.1, 0.0}, 8.0));
}

TEST(Planner, RefusesAndSaysWhy) {
  const World world = block();
  const auto radius = Planner::create(world, {0.0, 0.0, 0.0});
  ASSERT_FALSE(radius);
  EXPECT_EQ(radius.fault().quantity, "turn_radius");
  const auto nan = Planner::create(world, {1.0, std::numeric_limits<double>::quiet_NaN(), 0.0});
  ASSERT_FALSE(nan);
  EXPECT_EQ(nan.fault().quantity, "clearance");

  const auto planner = Planner::create(world, {1.0, 0.5, 0.0}).value();
  const auto inside = planner.plan({{1, 0}, {10, 0}});
  ASSERT_FALSE(inside);
  EXPECT_EQ(inside.fault().code, FaultCode::outside_domain);
  EXPECT_NE(inside.fault().sentence.find("block"), std::string::npos);
  const auto near = planner.plan({{-0.25, 0}, {10, 0}});
  ASSERT_FALSE(near);
  EXPECT_EQ(near.fault().code, FaultCode::outside_domain);
  EXPECT_NE(near.fault().sentence.find("0.25"), std::string::npos) << near.fault().sentence;
  // Exactly at the clearance is allowed.
  const auto at = planner.plan({{-0.5, 0}, {-0.5, 1}});
  EXPECT_TRUE(at) << at.fault().sentence;

  // A start right before the block, for a vehicle that turns like a ship: there is no room.
  const auto ship = Planner::create(world, {50.0, 0.5, 0.0}).value().plan({{-1, 0}, {5, 0}});
  ASSERT_FALSE(ship);
  EXPECT_EQ(ship.fault().code, FaultCode::no_route) << ship.fault().sentence;
  EXPECT_EQ(ship.fault().value, 50.0);
  ASSERT_TRUE(ship.fault().bound);
  EXPECT_GT(*ship.fault().bound, 0.0);
  EXPECT_LT(*ship.fault().bound, 50.0);
}

}  // namespace
}  // namespace hodograph
