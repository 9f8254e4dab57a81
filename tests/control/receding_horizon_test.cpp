// SPDX-License-Identifier: MIT
// Plans made again and again, with the vehicle pushed about between them.
#include "hodograph/control/receding_horizon.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

FollowLimits car() {
  FollowLimits limits;
  limits.speed = 1.0;
  limits.acceleration = 1.0;
  limits.lateral_acceleration = 1.0;
  limits.offset = 0.1;
  return limits;
}

TEST(RecedingHorizon, StaysInTheTubeAndMovesOnThoughItIsPushed) {
  test::Random random("pushed about");
  const auto ring = test::ring(6);
  HorizonOptions options;
  options.intervals = 12;
  options.step = 0.2;
  RecedingHorizon horizon = RecedingHorizon::make(ring, car(), options).value();
  FollowStart state;
  const std::size_t steps = 12;
  for (std::size_t i = 0; i < steps; ++i) {
    const HorizonPlan plan = horizon.plan(state).value();
    EXPECT_EQ(plan.warm, i > 0);
    EXPECT_TRUE(plan.finished);
    EXPECT_GE(plan.latency_s, 0.0);
    for (const FollowNode& node : plan.following.nodes) {
      EXPECT_LE(std::abs(node.offset[0]), 0.11);  // soft: by as much as it is pushed
      EXPECT_LE(node.speed, 1.0 + horizon_tolerance);
    }
    const double before = state.xi;
    state = horizon.predicted();
    EXPECT_GT(state.xi, before);
    state.offset[0] += random.uniform(-0.01, 0.01);
    state.heading += random.uniform(-0.05, 0.05);
    state.speed += random.uniform(-0.05, 0.05);
  }
}

// Round a closed path it goes on.
TEST(RecedingHorizon, GoesOverTheEndOfAClosedPath) {
  const auto ring = test::ring(6);
  HorizonOptions options;
  options.intervals = 8;
  RecedingHorizon horizon = RecedingHorizon::make(ring, car(), options).value();
  FollowStart state;
  state.xi = ring.xi_end() - 0.05;
  state.speed = 0.9;
  const HorizonPlan plan = horizon.plan(state).value();
  EXPECT_GT(plan.following.nodes.back().xi, ring.xi_end());
}

// Plans go on from there, the first one too.
TEST(RecedingHorizon, PlansFromBeyondTheEndOfAClosedPath) {
  const auto ring = test::ring(6);
  HorizonOptions options;
  options.intervals = 8;
  RecedingHorizon horizon = RecedingHorizon::make(ring, car(), options).value();
  FollowStart state;
  state.xi = ring.xi_end() + 0.3 * (ring.xi_end() - ring.xi_begin());
  state.speed = 0.9;
  const HorizonPlan plan = horizon.plan(state).value();
  EXPECT_GT(plan.following.progress, 0.5);
}

TEST(RecedingHorizon, AHardTubeIsNotLeft) {
  const auto ring = test::ring(6);
  HorizonOptions options;
  options.intervals = 12;
  options.step = 0.2;
  options.hard = true;
  RecedingHorizon horizon = RecedingHorizon::make(ring, car(), options).value();
  FollowStart state;
  state.offset[0] = 0.15;  // moved to the limit
  const HorizonPlan first = horizon.plan(state).value();
  EXPECT_TRUE(first.recovered);
  for (const FollowNode& node : first.following.nodes) EXPECT_LE(std::abs(node.offset[0]), 0.1);
  for (int i = 0; i < 5; ++i) {
    state = horizon.predicted();
    const HorizonPlan plan = horizon.plan(state).value();
    EXPECT_TRUE(plan.warm);
    for (const FollowNode& node : plan.following.nodes) {
      EXPECT_LE(std::abs(node.offset[0]), 0.1 + horizon_tolerance);
    }
  }
}

TEST(RecedingHorizon, ComesBackFromOutsideTheTubeAndSaysWhenAStateWasMoved) {
  RecedingHorizon horizon = RecedingHorizon::make(test::ring(6), car(), {}).value();
  FollowStart state;
  state.offset[0] = 0.15;
  state.speed = 0.5;
  HorizonPlan plan = horizon.plan(state).value();
  EXPECT_FALSE(plan.recovered);
  EXPECT_EQ(plan.following.nodes.front().offset[0], 0.15);
  EXPECT_LE(std::abs(plan.following.nodes.back().offset[0]), 0.1 + horizon_tolerance);
  state.speed = 1.2;
  plan = horizon.plan(state).value();
  EXPECT_TRUE(plan.recovered);
  EXPECT_EQ(plan.following.nodes.front().speed, 1.0);
}

TEST(RecedingHorizon, RefusesWhatIsNotPossible) {
  const auto ring = test::ring(6);
  HorizonOptions options;
  options.step = 0.0;
  EXPECT_EQ(RecedingHorizon::make(ring, car(), options).fault().code, FaultCode::outside_domain);
  options.step = 0.1;
  options.intervals = 1;
  EXPECT_EQ(RecedingHorizon::make(ring, car(), options).fault().code, FaultCode::outside_domain);
  FollowLimits wide = car();
  wide.offset = 100.0;
  EXPECT_EQ(RecedingHorizon::make(ring, wide, {}).fault().code, FaultCode::outside_domain);
  RecedingHorizon horizon = RecedingHorizon::make(ring, car(), {}).value();
  FollowStart state;
  state.heading = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(horizon.plan(state).fault().code, FaultCode::outside_domain);
}

}  // namespace
}  // namespace hodograph
