// SPDX-License-Identifier: MIT
// Deconfliction: choices that are certified, the same as trying all of them, and honest refusals.
#include "hodograph/planning/swarm/deconfliction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/random.hpp"

namespace hodograph {
namespace {

using test::Random;

Vehicle straight(const std::string& id, const Vector2<double>& from, const Vector2<double>& to,
                 Presence presence = {}, double radius = 0.0) {
  const ArrivingVehicle v{id, {from, to - from}, {to, to - from}, 1.0, 0.0, radius, {}, presence};
  return arrival_at(std::vector{v}, norm(to - from)).value().vehicles[0];
}

bool all_apart(std::span<const Vehicle> vehicles, SwarmGoal goal) {
  goal.threads = 1;
  return close_pairs(vehicles, goal).value().empty();
}

TEST(Deconfliction, DelaysTheSecondOfTwoThatCross) {
  const std::vector<Vehicle> vehicles{straight("east", {-1, 0}, {1, 0}),
                                      straight("north", {0, -1}, {0, 1})};
  SwarmGoal goal;
  goal.clearance = 0.25;
  ASSERT_FALSE(all_apart(vehicles, goal));
  const DelayMoves moves{.longest_delay = 1.0, .delays = 10};
  const DelayedSwarm found = deconflict_by_delays(vehicles, goal, moves).value();
  EXPECT_TRUE(all_apart(found.vehicles, goal));
  // Later by d they pass at d/√2: 0.3 gives 0.212, 0.4 gives 0.283.
  EXPECT_EQ(found.delays, (std::vector{0.0, 0.4}));
  EXPECT_EQ(found.vehicles[1].motion.start_time(), 0.4);
  // Nothing to do: nothing is done.
  goal.clearance = 0.0;
  const DelayedSwarm same = deconflict_by_delays(found.vehicles, goal, moves).value();
  EXPECT_EQ(same.delays, (std::vector{0.0, 0.0}));
  EXPECT_EQ(same.effort.choices, 0u);
}

TEST(Deconfliction, LeavesOthersAsTheyAre) {
  const Vehicle east = straight("east", {-1, 0}, {1, 0}),
                north = straight("north", {0, -1}, {0, 1});
  const Vehicle south = straight("south", {0, 1}, {0, -1});
  SwarmGoal goal;
  goal.clearance = 0.25;
  const DelayMoves moves{.longest_delay = 1.0, .delays = 10};
  // As above, but now it is the first that yields.
  const std::vector<Vehicle> yielding{east};
  const DelayedSwarm found =
      deconflict_by_delays(yielding, goal, moves, std::vector{north}).value();
  EXPECT_EQ(found.delays, std::vector{0.4});
  ASSERT_EQ(found.vehicles.size(), 1u);
  EXPECT_TRUE(all_apart(std::vector{found.vehicles[0], north}, goal));
  // Two others that meet each other are not this search's business.
  const std::vector<Vehicle> opposed{north, south};
  ASSERT_FALSE(all_apart(opposed, goal));
  const DelayedSwarm beside = deconflict_by_delays(yielding, goal, moves, opposed).value();
  EXPECT_EQ(beside.delays, std::vector{0.4});
  const Vehicle far = straight("far", {9, 9}, {9, 10});
  EXPECT_EQ(deconflict_by_delays(std::vector{far}, goal, moves, opposed).value().effort.choices,
            0u);
  // Where it cannot be done, the other is named after the vehicles.
  const auto stuck =
      deconflict_by_delays(yielding, goal, {.longest_delay = 0.0, .delays = 0}, opposed);
  ASSERT_FALSE(stuck);
  EXPECT_EQ(stuck.fault().code, FaultCode::not_separated);
  EXPECT_NE(stuck.fault().sentence.find("vehicle 1 (north)"), std::string::npos)
      << stuck.fault().sentence;
}

TEST(Deconfliction, MakesPathsAroundThoseThatAreGiven) {
  const Vehicle given = straight("given", {0.5, -0.625}, {0.5, 0.625});
  const ArrivingVehicle vehicle{"a", {{0, 0}, {1, 0}}, {{1, 0}, {1, 0}}};
  SwarmGoal goal;
  goal.clearance = 0.0625;
  const ArrivalMoves moves{.departure = {.longest_delay = 0.4, .delays = 8}};
  const std::vector<ArrivingVehicle> vehicles{vehicle};
  const auto alone = deconflict_arrival(vehicles, 1.25, goal, moves).value();
  EXPECT_EQ(alone.delays, std::vector{0.0});
  ASSERT_FALSE(all_apart(std::vector{alone.plan.vehicles[0], given}, goal));
  const auto beside = deconflict_arrival(vehicles, 1.25, goal, moves, std::vector{given});
  ASSERT_TRUE(beside) << beside.fault().sentence;
  EXPECT_EQ(beside->plan.vehicles.size(), 1u);
  EXPECT_TRUE(all_apart(std::vector{beside->plan.vehicles[0], given}, goal));
  // The least arrival that keeps away from it is later than without it.
  const double free = least_separated_arrival(vehicles, goal).value().arrival;
  const Vehicle meets = straight("meets", {0.25, -0.25}, {0.25, 0.25}, {false, false});
  goal.clearance = 0.0078125;
  const auto least = least_separated_arrival(vehicles, goal, {}, std::vector{meets});
  ASSERT_TRUE(least) << least.fault().sentence;
  EXPECT_GT(least->arrival, free);
  EXPECT_TRUE(all_apart(std::vector{least->vehicles[0], meets}, goal));
}

TEST(Deconfliction, ProvesThatNothingHelps) {
  // Both change places and stand there before and after: no delay helps.
  const std::vector<Vehicle> head_on{straight("a", {0, 0}, {1, 0}), straight("b", {1, 0}, {0, 0}),
                                     straight("c", {0, 5}, {1, 5})};
  SwarmGoal goal;
  goal.clearance = 0.125;
  const auto stuck = deconflict_by_delays(head_on, goal, {.longest_delay = 4.0, .delays = 8});
  ASSERT_FALSE(stuck);
  EXPECT_EQ(stuck.fault().code, FaultCode::not_separated);
  EXPECT_EQ(stuck.fault().index, 0u);
  EXPECT_EQ(stuck.fault().bound, 0.125);
  EXPECT_LT(*stuck.fault().value, 0.125);
  const std::string& sentence = stuck.fault().sentence;
  EXPECT_NE(
      sentence.find("no choice keeps all vehicles apart (all are ruled out): vehicle 0 (a) and "
                    "vehicle 1 (b) come within"),
      std::string::npos)
      << sentence;
  EXPECT_NE(sentence.find("in the best of all 81 combinations"), std::string::npos) << sentence;
  // Where they are absent before and after, a long enough delay does.
  const Presence absent{false, false};
  const std::vector<Vehicle> one_by_one{straight("a", {0, 0}, {1, 0}, absent),
                                        straight("b", {1, 0}, {0, 0}, absent)};
  const auto found =
      deconflict_by_delays(one_by_one, goal, {.longest_delay = 4.0, .delays = 8}).value();
  EXPECT_EQ(found.delays, (std::vector{0.0, 1.5}));
  // Cut short, it does not claim a proof.
  const auto cut = deconflict_by_delays(one_by_one, goal,
                                        {.longest_delay = 4.0, .delays = 8, .most_choices = 0});
  ASSERT_FALSE(cut);
  EXPECT_NE(cut.fault().sentence.find("the search gave up after"), std::string::npos)
      << cut.fault().sentence;
}

TEST(Deconfliction, FindsAChoiceWheneverThereIsOne) {
  Random random("Deconfliction.FindsAChoiceWheneverThereIsOne");
  int found_count = 0, impossible = 0;
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<Vehicle> vehicles;
    const std::size_t count = 2 + random.index(3);
    for (std::size_t i = 0; i < count; ++i) {
      const Presence presence{random.chance(0.3), random.chance(0.3)};
      const Vector2<double> from = random.unit_vector2();
      vehicles.push_back(straight(std::to_string(i), from, -1.0 * from + random.vector2(0.2),
                                  presence, random.uniform(0.0, 0.1)));
    }
    SwarmGoal goal;
    goal.clearance = random.uniform(0.0, 0.3);
    const DelayMoves moves{.longest_delay = 1.0, .delays = 3};
    const auto found = deconflict_by_delays(vehicles, goal, moves);
    bool exists = false;  // by trying all
    std::size_t all = 1;
    for (std::size_t i = 0; i < count; ++i) all *= 4;
    for (std::size_t code = 0; code < all && !exists; ++code) {
      std::vector<Vehicle> tried = vehicles;
      std::size_t rest = code;
      for (std::size_t i = 0; i < count; ++i, rest /= 4) {
        tried[i].motion = tried[i].motion.delayed(static_cast<double>(rest % 4) / 3.0);
      }
      exists = all_apart(tried, goal);
    }
    EXPECT_EQ(found.has_value(), exists);
    if (found) {
      ++found_count;
      EXPECT_TRUE(all_apart(found->vehicles, goal));
      const auto again = deconflict_by_delays(vehicles, goal, moves).value();
      EXPECT_EQ(again.delays, found->delays);
      EXPECT_EQ(again.effort.choices, found->effort.choices);
    } else {
      ++impossible;
      EXPECT_NE(found.fault().sentence.find("all are ruled out"), std::string::npos);
    }
  }
  EXPECT_GT(found_count, 5);
  EXPECT_GT(impossible, 1);
}

/// Vehicles that all cross the middle of a circle, to the places opposite.
std::vector<ArrivingVehicle> across(std::size_t count) {
  std::vector<ArrivingVehicle> vehicles;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    const Vector2<double> from = direction_of_angle(angle);
    vehicles.push_back({"v" + std::to_string(i),
                        {from, direction_of_angle(angle + std::numbers::pi - 0.4)},
                        {-1.0 * from, direction_of_angle(angle + std::numbers::pi + 0.5)}});
  }
  return vehicles;
}

TEST(Deconfliction, KeepsArrivalsSimultaneous) {
  std::vector<ArrivingVehicle> vehicles = across(3);
  for (ArrivingVehicle& v : vehicles) v.most_curvature = 20.0;
  vehicles[1].begin.direction = -1.0 * vehicles[1].begin.position;
  SwarmGoal goal;
  goal.clearance = 0.1;
  const ArrivalMoves moves{
      .departure = {.longest_delay = 0.4, .delays = 4}, .latest_excess = 0.5, .later_arrivals = 10};
  const double first = 2.1;
  const auto plain = arrival_at(vehicles, first).value();
  const auto found = deconflict_arrival(vehicles, first, goal, moves);
  ASSERT_TRUE(found) << found.fault().sentence;
  EXPECT_TRUE(all_apart(found->plan.vehicles, goal));
  EXPECT_GE(found->plan.arrival, first);
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    const ArrivingPath& p = found->plan.paths[i];
    EXPECT_EQ(p.departure, vehicles[i].departure + found->delays[i]);
    const double length = found->plan.arrival - p.departure;
    EXPECT_NEAR(p.path.arc_length(), length,
                64.0 * std::numeric_limits<double>::epsilon() * length);
    EXPECT_LE(p.largest_curvature.upper(), 20.0);
    EXPECT_EQ(found->plan.vehicles[i].motion.start_time(), p.departure);
  }
  const auto again = deconflict_arrival(vehicles, first, goal, moves).value();
  EXPECT_EQ(again.delays, found->delays);
  EXPECT_EQ(again.plan.arrival, found->plan.arrival);
}

TEST(Deconfliction, OfSwarmsOfManyAcrossACircle) {
  // Eight vehicles that would all meet in the middle.
  const std::vector<ArrivingVehicle> vehicles = across(8);
  SwarmGoal goal;
  goal.clearance = 0.05;
  const ArrivalMoves moves{
      .departure = {.longest_delay = 0.5, .delays = 5}, .latest_excess = 0.3, .later_arrivals = 6};
  const auto found = deconflict_arrival(vehicles, 2.2, goal, moves);
  ASSERT_TRUE(found) << found.fault().sentence;
  EXPECT_TRUE(all_apart(found->plan.vehicles, goal));
}

TEST(Deconfliction, RefusesBadRequests) {
  const std::vector<Vehicle> vehicles{straight("a", {0, 0}, {1, 0})};
  EXPECT_EQ(deconflict_by_delays(vehicles, {}, {.longest_delay = -1.0, .delays = 1}).fault().code,
            FaultCode::outside_domain);
  EXPECT_EQ(deconflict_by_delays({}, {}, {}).fault().code, FaultCode::too_few);
  EXPECT_EQ(deconflict_arrival(across(2), std::nan(""), {}, {}).fault().code,
            FaultCode::not_finite);
  const auto early = deconflict_arrival(across(2), 1.0, {}, {});
  EXPECT_EQ(early.fault().code, FaultCode::no_interpolant);
  EXPECT_EQ(early.fault().index, 0u);
  SwarmGoal goal;
  goal.clearance = std::nan("");
  EXPECT_EQ(deconflict_arrival(across(2), 2.5, goal, {}).fault().quantity, "clearance");
}

}  // namespace
}  // namespace hodograph
