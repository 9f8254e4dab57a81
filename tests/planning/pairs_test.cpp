// SPDX-License-Identifier: MIT
// All pairs of a swarm: the same answers as pair by pair, whatever the number of threads.
#include "hodograph/planning/swarm/pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hodograph/construction/prescribed_length.hpp"
#include "hodograph/foundation/interruption.hpp"
#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

using test::Random;

enum class Times { equal, staggered, with_absent };

std::vector<Vehicle> random_swarm(Random& random, std::size_t count, Times times, bool spatial) {
  std::vector<Vehicle> swarm;
  while (swarm.size() < count) {
    const double start = times == Times::equal ? 0.0 : random.uniform(0.0, 1.5);
    Presence presence;
    if (times == Times::with_absent) presence = {random.chance(0.6), random.chance(0.6)};
    const double radius = random.chance(0.5) ? 0.0 : random.uniform(0.0, 0.05);
    const auto law = [&](double length) {
      if (random.chance(0.3)) {
        return TimingLaw::trapezoidal(length, {.cruise_speed = 1.3, .acceleration = 2.0}, start)
            .value();
      }
      return TimingLaw::constant_speed(length, 1.0, start).value();
    };
    if (spatial && random.chance(0.5)) {
      const auto path = test::random_path<SpatialPath<2>>(random, 2);
      swarm.push_back({"s" + std::to_string(swarm.size()),
                       TimedMotion::create(path, law(path.arc_length()), presence).value(),
                       radius});
      continue;
    }
    const auto curve = prescribed_length_curve({random.vector2(1.0), random.unit_vector2()},
                                               {random.vector2(1.0), random.unit_vector2()}, 3.0);
    if (!curve) continue;
    const auto path = PlanarPath<2>::create({0.0, 1.0}, {curve->curve}, false).value();
    swarm.push_back({"p" + std::to_string(swarm.size()),
                     TimedMotion::create(path, law(path.arc_length()), presence).value(), radius});
  }
  return swarm;
}

TEST(Pairs, AnswerAsPairByPair) {
  Random random("Pairs.AnswerAsPairByPair");
  for (int trial = 0; trial < 12; ++trial) {
    SCOPED_TRACE(trial);
    const auto times = static_cast<Times>(trial % 3);
    const std::vector<Vehicle> swarm = random_swarm(random, 2 + random.index(30), times, trial > 5);
    SwarmGoal goal;
    goal.clearance = random.uniform(0.0, 0.1);
    goal.separation.vertical_scale = random.chance(0.5) ? 1.0 : random.uniform(0.2, 2.0);
    goal.threads = 1;
    const auto matrix = separation_matrix(swarm, goal).value();
    const auto close = close_pairs(swarm, goal).value();
    ASSERT_EQ(matrix.size(), swarm.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < swarm.size(); ++i) {
      for (std::size_t j = i + 1; j < swarm.size(); ++j) {
        const TimedMotion &a = swarm[i].motion, &b = swarm[j].motion;
        const auto single = least_separation(a, b, goal.separation);
        const auto entry = matrix(i, j);
        ASSERT_EQ(single.has_value(), entry.has_value());
        if (single) {
          // Both contain the truth, and both are narrow.
          EXPECT_LE(entry->distance.lower(), single->distance.upper());
          EXPECT_GE(entry->distance.upper(), single->distance.lower());
          EXPECT_LE(entry->distance.width(),
                    1e-9 * std::min(a.length(), b.length()));  // not a tolerance: what is promised
          EXPECT_EQ(matrix(j, i)->distance, entry->distance);
        }
        const double required = swarm[i].radius + swarm[j].radius + goal.clearance;
        const Answer keeps = separated_by(a, b, required, goal.separation);
        const bool listed =
            next < close.size() && close[next].first == i && close[next].second == j;
        EXPECT_EQ(listed, keeps != Answer::yes);
        if (listed) {
          EXPECT_EQ(close[next].keeps, keeps);
          EXPECT_EQ(close[next].required, required);
          ++next;
        }
      }
    }
    EXPECT_EQ(next, close.size());
    // Any number of threads gives the same, bit by bit.
    for (const unsigned threads : {2U, 5U}) {
      goal.threads = threads;
      const auto again = separation_matrix(swarm, goal).value();
      for (std::size_t i = 0; i < swarm.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          ASSERT_EQ(again(i, j).has_value(), matrix(i, j).has_value());
          if (matrix(i, j)) {
            EXPECT_EQ(again(i, j)->distance, matrix(i, j)->distance);
            EXPECT_EQ(again(i, j)->time, matrix(i, j)->time);
          }
        }
      }
      EXPECT_EQ(close_pairs(swarm, goal).value().size(), close.size());
    }
  }
}

TEST(Pairs, TellWhenAndByHowMuch) {
  Random random("Pairs.TellWhenAndByHowMuch");
  const std::vector<Vehicle> swarm = random_swarm(random, 24, Times::staggered, true);
  SwarmGoal goal;
  goal.clearance = 0.3;
  const auto found = conflicts(swarm, goal).value();
  const auto close = close_pairs(swarm, goal).value();
  ASSERT_EQ(found.size(), close.size());
  ASSERT_GT(found.size(), 3u);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Conflict& c = found[i];
    EXPECT_EQ(c.pair.first, close[i].first);
    EXPECT_EQ(c.pair.second, close[i].second);
    if (c.pair.keeps == Answer::no) {
      EXPECT_LT(c.separation.distance.upper(), c.pair.required);
      EXPECT_GT(c.shortfall().lower(), 0.0);
      ASSERT_FALSE(c.passages.empty());
    }
    EXPECT_TRUE(std::any_of(c.passages.begin(), c.passages.end(), [&](const ClosePassage& p) {
      return p.begin <= c.separation.time && c.separation.time <= p.end;
    }));
  }
}

TEST(Pairs, RefuseBadSwarms) {
  Random random("Pairs.RefuseBadSwarms");
  std::vector<Vehicle> swarm = random_swarm(random, 3, Times::equal, false);
  EXPECT_EQ(close_pairs({}, {}).fault().code, FaultCode::too_few);
  SwarmGoal goal;
  goal.clearance = -1.0;
  EXPECT_EQ(conflicts(swarm, goal).fault().quantity, "clearance");
  swarm[1].radius = std::nan("");
  swarm[1].id = "b";
  const auto fault = separation_matrix(swarm, {}).fault();
  EXPECT_EQ(fault.code, FaultCode::not_finite);
  EXPECT_EQ(fault.index, 1u);
  EXPECT_NE(fault.sentence.find("vehicle 1 (b)"), std::string::npos);
  // One vehicle has no pairs.
  swarm.erase(swarm.begin() + 1, swarm.end());
  EXPECT_TRUE(close_pairs(swarm, {}).value().empty());
  EXPECT_EQ(separation_matrix(swarm, {}).value().size(), 1u);
}

TEST(Pairs, CanBeStoppedAtAnyQuestionWithAnyNumberOfThreads) {
  Random random("Pairs.CanBeStoppedAtAnyQuestionWithAnyNumberOfThreads");
  const std::vector<Vehicle> swarm = random_swarm(random, 12, Times::equal, true);
  SwarmGoal goal;
  goal.clearance = 0.1;
  const std::size_t close = close_pairs(swarm, goal).value().size();
  for (const unsigned threads : {1U, 4U}) {
    goal.threads = threads;
    bool stopped = true;
    for (std::size_t questions = 0; stopped; questions = 2 * questions + 1) {
      std::size_t asked = 0;
      const InterruptionScope scope([&] { return asked++ >= questions; });
      try {
        EXPECT_EQ(close_pairs(swarm, goal).value().size(), close);
        stopped = false;
      } catch (const Error& error) {
        EXPECT_EQ(error.fault().code, FaultCode::cancelled);
      }
    }
  }
}

}  // namespace
}  // namespace hodograph
