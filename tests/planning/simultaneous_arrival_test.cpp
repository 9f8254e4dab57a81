// SPDX-License-Identifier: MIT
// Simultaneous arrival: golden families, a swarm of the kind of the paper's Figures 3 and 4, exact
// lengths for speeds and departures of every vehicle's own, curvature limits, and the least times.
#include "hodograph/planning/swarm/simultaneous_arrival.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/planar_golden.hpp"
#include "tests/support/random.hpp"

namespace hodograph {
namespace {

using test::Random;

constexpr double ulp = std::numeric_limits<double>::epsilon();

/// What holds of every answer.
void check_arrival(std::span<const ArrivingVehicle> vehicles, const SimultaneousArrival& found) {
  ASSERT_EQ(found.paths.size(), vehicles.size());
  ASSERT_EQ(found.vehicles.size(), vehicles.size());
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    const ArrivingVehicle& v = vehicles[i];
    const ArrivingPath& p = found.paths[i];
    const TimedMotion& motion = found.vehicles[i].motion;
    const double length = v.speed * (found.arrival - p.departure);
    EXPECT_NEAR(p.path.arc_length(), length, 64.0 * ulp * length);
    // The last time is the arrival, up to the rounding of start + duration.
    EXPECT_NEAR(motion.end_time(), found.arrival, 2.0 * ulp * std::abs(found.arrival));
    EXPECT_EQ(motion.start_time(), p.departure);
    EXPECT_NEAR(motion.law().most_speed(), v.speed, 64.0 * ulp * v.speed);
    EXPECT_EQ(p.path.segment(0).start(), v.begin.position);
    EXPECT_LE(norm(p.path.segment(0).end() - v.end.position),
              64.0 * ulp * (length + norm(v.end.position)));
    if (v.most_curvature) {
      EXPECT_LE(p.largest_curvature.upper(), *v.most_curvature);
    }
  }
}

TEST(SimultaneousArrival, AgreesWithTheGoldenFamilies) {
  const test::Json file = test::golden_file("planar_prescribed_length.json");
  ASSERT_EQ(file["arrival"].size(), 10u);
  for (const test::Json& entry : file["arrival"].list()) {
    SCOPED_TRACE(entry["name"].string());
    const test::Json &in = entry["input"], &expected = entry["expected"];
    const double tolerance = entry["rel_tol"].number(), length = in["S"].number();
    std::vector<ArrivingVehicle> vehicles;
    for (std::size_t i = 0; i < in["start"].size(); ++i) {
      const test::Json& angles = in["directions"][i];
      vehicles.push_back(
          {std::string(1, static_cast<char>('a' + i)),
           {test::vector2_of(in["start"][i]), direction_of_angle(angles[0].number())},
           {test::vector2_of(in["end"][i]), direction_of_angle(angles[1].number())}});
    }
    SimultaneousArrival found = arrival_at(vehicles, length).value();
    check_arrival(vehicles, found);
    for (std::size_t i = 0; i < vehicles.size(); ++i) {
      const test::Json& golden = expected["vehicles"][i];
      const auto other = arriving_path(vehicles[i], length, 1).value();
      if (other.rotation_index - found.paths[i].rotation_index < tolerance &&
          test::agrees(other.largest_curvature.middle(), golden["kappa_max"].number(), tolerance)) {
        found.paths[i] = other;  // of two equally good ones the reference took this one
        const TimingLaw law = TimingLaw::between(other.path.arc_length(), 0.0, length).value();
        found.vehicles[i].motion = TimedMotion::create(other.path, law).value();
      }
      EXPECT_TRUE(test::agrees(found.paths[i].rotation_index, golden["R_abs"].number(), tolerance));
      EXPECT_TRUE(test::agrees(found.paths[i].largest_curvature.middle(),
                               golden["kappa_max"].number(), tolerance));
    }
    const double step = length / in["n"].number();
    const auto matrix = separation_matrix(found.vehicles, {}).value();
    double least = std::numeric_limits<double>::infinity();
    for (const test::Json& pair : expected["pairs"].list()) {
      const auto i = static_cast<std::size_t>(pair["i"].number());
      const auto j = static_cast<std::size_t>(pair["j"].number());
      const auto stepped =
          stepped_separation(found.vehicles[i].motion, found.vehicles[j].motion, step).value();
      const double sampled = pair["min_sampled"].number();
      EXPECT_TRUE(test::agrees(stepped.sampled, sampled, tolerance)) << i << " " << j;
      EXPECT_TRUE(stepped.distance.lower() <= matrix(i, j)->distance.upper() &&
                  matrix(i, j)->distance.lower() <= stepped.distance.upper());
      least = std::min(least, stepped.sampled);
    }
    EXPECT_TRUE(test::agrees(least, expected["min_sampled"].number(), tolerance));
  }
}

/// Six vehicles between corresponding points of two circles, every one with directions of its own:
/// the kind of the paper's Figures 3 and 4.
std::vector<ArrivingVehicle> circle_to_circle() {
  std::vector<ArrivingVehicle> vehicles;
  const double leave[] = {0.5, 0.45, 0.3, -0.2, -0.4, -0.55};
  const double arrive[] = {-0.45, -0.3, -0.5, 0.45, 0.3, 0.5};
  for (std::size_t i = 0; i < 6; ++i) {
    const Vector2<double> place =
        0.1 * direction_of_angle(std::numbers::pi / 3.0 * static_cast<double>(i));
    vehicles.push_back({"v" + std::to_string(i),
                        {place, direction_of_angle(leave[i])},
                        {place + Vector2<double>{1.0, 0.0}, direction_of_angle(arrive[i])}});
  }
  return vehicles;
}

TEST(SimultaneousArrival, OfSixVehiclesOnCrossingPathsIsCertified) {
  const std::vector<ArrivingVehicle> vehicles = circle_to_circle();
  const SimultaneousArrival found = arrival_at(vehicles, 1.125).value();  // 12.5 % above the chord
  check_arrival(vehicles, found);
  SwarmGoal goal;
  goal.clearance = 0.01 * 1.125;  // 1 % of the length, as in the paper
  const auto matrix = separation_matrix(found.vehicles, goal).value();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, matrix(i, j)->distance.lower());
  }
  const auto close = close_pairs(found.vehicles, goal).value();
  EXPECT_EQ(close.empty(), least >= goal.clearance);
  // Every pair is apart on an initial circle of radius 0.1, and no sample disagrees.
  EXPECT_GT(least, 0.0);
}

TEST(SimultaneousArrival, KeepsSpeedsAndDeparturesOfEveryVehiclesOwn) {
  Random random("SimultaneousArrival.KeepsSpeedsAndDepartures");
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<ArrivingVehicle> vehicles;
    for (std::size_t i = 0; i < 1 + random.index(8); ++i) {
      ArrivingVehicle v;
      v.begin = {random.vector2(2.0), random.unit_vector2()};
      v.end = {random.vector2(2.0), random.unit_vector2()};
      v.speed = std::exp(random.uniform(-1.0, 1.0));
      v.departure = random.chance(0.5) ? 0.0 : random.uniform(-1.0, 1.0);
      vehicles.push_back(v);
    }
    const double earliest = earliest_arrival(vehicles);
    double longest = 0.0;
    for (const auto& v : vehicles) longest = std::max(longest, earliest - v.departure);
    check_arrival(vehicles,
                  arrival_at(vehicles, earliest + random.uniform(0.01, 1.0) * longest).value());
    const auto early = arrival_at(vehicles, earliest - 0.01 * longest);
    ASSERT_FALSE(early);
    ASSERT_TRUE(early.fault().index.has_value());
    EXPECT_NE(early.fault().sentence.find("vehicle " + std::to_string(*early.fault().index)),
              std::string::npos);
  }
}

TEST(SimultaneousArrival, NamesTheVehicleAndWhatWouldDo) {
  ArrivingVehicle a{"a", {{0, 0}, {1, 0}}, {{1, 0}, {1, 0}}};
  ArrivingVehicle b{"b", {{0, 1}, {1, 0}}, {{2, 1}, {1, 0}}};
  const auto early = arrival_at(std::vector{a, b}, 1.5);
  ASSERT_FALSE(early);
  EXPECT_EQ(early.fault().index, 1u);
  EXPECT_EQ(early.fault().code, FaultCode::no_interpolant);
  EXPECT_EQ(early.fault().sentence,
            "vehicle 1 (b): no path of length 1.5 joins points that are 2 apart; it needs at least "
            "that length; it can arrive at 2 at the earliest, not at 1.5");
  // Turning by a right angle at both ends within a little more than the chord.
  ArrivingVehicle c{"c", {{0, 0}, {0, 1}}, {{1, 0}, {0, -1}}};
  c.most_curvature = 4.0;
  const auto sharp = arrival_at(std::vector{a, c}, 1.1);
  ASSERT_FALSE(sharp);
  EXPECT_EQ(sharp.fault().index, 1u);
  EXPECT_EQ(sharp.fault().quantity, "curvature");
  EXPECT_NE(sharp.fault().sentence.find("would do"), std::string::npos) << sharp.fault().sentence;
  c.most_curvature = 0.5;  // a half circle over the chord has curvature 2
  const auto never = least_arrival(std::vector{a, c});
  ASSERT_FALSE(never);
  EXPECT_EQ(never.fault().index, 1u);
  EXPECT_NE(never.fault().sentence.find("vehicle 1 (c)"), std::string::npos);
  EXPECT_NE(never.fault().sentence.find("the least largest curvature is"), std::string::npos)
      << never.fault().sentence;
  EXPECT_EQ(arrival_at({}, 1.0).fault().code, FaultCode::too_few);
  a.speed = 0.0;
  EXPECT_EQ(arrival_at(std::vector{a}, 1.0).fault().code, FaultCode::outside_domain);
  a.speed = 1.0;
  EXPECT_EQ(arrival_at(std::vector{a}, -1.0).fault().quantity, "arrival");
  EXPECT_EQ(arriving_path(a, 2.0, 7).fault().quantity, "solution");
  ArrivalSearch search;
  search.steps = 0;
  EXPECT_EQ(least_arrival(std::vector{a}, search).fault().quantity, "steps");
}

TEST(SimultaneousArrival, IsAsEarlyAsTheLimitsAllow) {
  // Straight ahead: at once.
  ArrivingVehicle a{"a", {{0, 0}, {1, 0}}, {{1, 0}, {1, 0}}};
  EXPECT_EQ(least_arrival(std::vector{a}).value().arrival, 1.0);
  std::vector<ArrivingVehicle> vehicles = circle_to_circle();
  for (ArrivingVehicle& v : vehicles) v.most_curvature = 3.0;
  const SimultaneousArrival found = least_arrival(vehicles).value();
  check_arrival(vehicles, found);
  EXPECT_GT(found.arrival, earliest_arrival(vehicles));
  // Just before, some vehicle exceeds its limit.
  const ArrivalSearch search;
  EXPECT_FALSE(arrival_at(vehicles, found.arrival - 2.0 * search.resolution));
}

TEST(SimultaneousArrival, IsAsEarlyAsSeparationAllows) {
  std::vector<ArrivingVehicle> vehicles = circle_to_circle();
  for (ArrivingVehicle& v : vehicles) v.most_curvature = 6.0;
  const SimultaneousArrival any = least_arrival(vehicles).value();
  SwarmGoal goal;
  goal.clearance = 0.02;
  const auto found = least_separated_arrival(vehicles, goal);
  ASSERT_TRUE(found) << found.fault().sentence;
  check_arrival(vehicles, *found);
  EXPECT_GE(found->arrival, any.arrival);
  EXPECT_TRUE(close_pairs(found->vehicles, goal).value().empty());
  // Head-on at the same points: nothing helps, and the pair is named.
  ArrivingVehicle there{"there", {{0, 0}, {1, 0}}, {{1, 0}, {1, 0}}};
  ArrivingVehicle back{"back", {{1, 0}, {-1, 0}}, {{0, 0}, {-1, 0}}};
  goal.clearance = 2.0;
  const auto never = least_separated_arrival(std::vector{there, back}, goal);
  ASSERT_FALSE(never);
  EXPECT_EQ(never.fault().code, FaultCode::not_separated);
  EXPECT_EQ(never.fault().bound, 2.0);
  EXPECT_NE(never.fault().sentence.find("vehicle 0 (there) and vehicle 1 (back) come within"),
            std::string::npos)
      << never.fault().sentence;
  goal.clearance = -1.0;
  EXPECT_EQ(least_separated_arrival(vehicles, goal).fault().quantity, "clearance");
}

TEST(SimultaneousArrival, FliesAtAltitudes) {
  std::vector<ArrivingVehicle> vehicles{{"low", {{0, 0}, {1, 0}}, {{1, 0}, {1, 0}}},
                                        {"high", {{0, 0}, {1, 0}}, {{1, 0}, {1, 0}}}};
  vehicles[0].altitude = 2.0;
  vehicles[1].altitude = 2.375;
  const SimultaneousArrival plan = arrival_at(vehicles, 1.125).value();
  EXPECT_EQ(plan.vehicles[0].motion.position(0.5).z, 2.0);
  EXPECT_EQ(plan.vehicles[1].motion.position(0.5).z, 2.375);
  // They fly one above the other.
  const auto found = least_separation(plan.vehicles[0].motion, plan.vehicles[1].motion).value();
  EXPECT_LE(found.distance.lower(), 0.375);
  EXPECT_GE(found.distance.upper(), 0.375);
  vehicles[0].altitude = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(arrival_at(vehicles, 1.125).fault().quantity, "altitude");
}

}  // namespace
}  // namespace hodograph
