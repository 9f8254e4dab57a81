// SPDX-License-Identifier: MIT
// Timing laws: the numbers of simple laws, exact ends, monotone, inverse to rounding, limits kept.
#include "hodograph/path/timing_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "tests/support/random.hpp"

namespace hodograph {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;
constexpr double ulp = std::numeric_limits<double>::epsilon();

/// The law's own definition in 50 digits, at a time counted from its start.
Wide exact_arc_length(const TimingLaw& law, double local) {
  const std::size_t i = law.piece_at(local);
  const TimingLaw::Piece& piece = law.pieces()[i];
  Wide u = (Wide(local) - Wide(piece.begin)) / Wide(piece.duration);
  u = std::min(Wide(1), std::max(Wide(0), u));
  return Wide(piece.arc_length) + 2 * u * (1 - u) * Wide(piece.first) +
         u * u * (Wide(piece.first) + Wide(piece.second));
}

/// What holds of every law.
void check_law(const TimingLaw& law, int samples = 400) {
  ASSERT_TRUE(std::isfinite(law.duration()) && law.duration() > 0.0);
  EXPECT_EQ(law.arc_length_at(law.start_time()), 0.0);
  EXPECT_EQ(law.arc_length_at(law.end_time()), law.length());
  EXPECT_EQ(law.time_at(0.0), law.start_time());
  const double error = law.arc_length_error();
  // Time itself is rounded where it is large beside the duration.
  const double late = 4.0 * ulp * std::max(std::abs(law.start_time()), std::abs(law.end_time()));
  double before = 0.0, time_before = law.start_time();
  for (int k = 0; k <= samples; ++k) {
    const double x = static_cast<double>(k) / samples;
    const double t = std::min(law.start_time() + x * law.duration(), law.end_time());
    const double s = law.arc_length_at(t);
    ASSERT_TRUE(0.0 <= s && s <= law.length());
    EXPECT_GE(s, before - error);
    before = s;
    EXPECT_LE(abs(exact_arc_length(law, t - law.start_time()) - Wide(s)), Wide(error));
    const double v = law.speed_at(t);
    EXPECT_TRUE(0.0 <= v && v <= law.most_speed());

    const double target = std::min(x * law.length(), law.length());
    const double time = law.time_at(target);
    ASSERT_TRUE(law.start_time() <= time && time <= law.end_time());
    EXPECT_GE(time, time_before - late - 8.0 * ulp * law.duration());
    time_before = time;
    EXPECT_LE(std::abs(law.arc_length_at(time) - target), 2.0 * error + late * law.most_speed());
  }
}

TEST(TimingLaw, OfConstantSpeed) {
  const TimingLaw law = TimingLaw::constant_speed(10.0, 4.0, 1.0).value();
  EXPECT_EQ(law.duration(), 2.5);
  EXPECT_EQ(law.arc_length_at(2.0), 4.0);
  EXPECT_EQ(law.speed_at(2.0), 4.0);
  EXPECT_EQ(law.time_at(6.0), 2.5);
  check_law(law);
  const TimingLaw later = law.delayed(3.0);
  EXPECT_EQ(later.start_time(), 4.0);
  EXPECT_EQ(later.arc_length_at(5.0), 4.0);
  const TimingLaw between = TimingLaw::between(10.0, -1.0, 4.0).value();
  EXPECT_EQ(between.speed_at(0.0), 2.0);
  EXPECT_EQ(between.end_time(), 4.0);
}

TEST(TimingLaw, AcceleratesCruisesAndDecelerates) {
  const TrapezoidalSpeed limits{.cruise_speed = 2.0, .acceleration = 1.0, .deceleration = 2.0};
  const TimingLaw law = TimingLaw::trapezoidal(10.0, limits).value();
  EXPECT_EQ(law.pieces().size(), 3u);
  EXPECT_EQ(law.duration(), 6.5);  // 2 s over 2, 3.5 s over 7, 1 s over 1
  EXPECT_EQ(law.arc_length_at(1.0), 0.5);
  EXPECT_EQ(law.arc_length_at(2.0), 2.0);
  EXPECT_EQ(law.arc_length_at(5.5), 9.0);
  EXPECT_EQ(law.arc_length_at(6.0), 9.75);
  EXPECT_EQ(law.speed_at(6.0), 1.0);
  EXPECT_EQ(law.time_at(0.5), 1.0);
  check_law(law);
}

TEST(TimingLaw, IsATriangleWhenShort) {
  const TimingLaw law = TimingLaw::trapezoidal(1.0, {.cruise_speed = 5.0}).value();
  EXPECT_EQ(law.pieces().size(), 2u);
  EXPECT_EQ(law.duration(), 2.0);
  EXPECT_EQ(law.speed_at(1.0), 1.0);
  check_law(law);
  // From 1 to 2 over just the length that takes: a single acceleration.
  const TimingLaw ramp =
      TimingLaw::trapezoidal(1.5, {.cruise_speed = 5.0, .start_speed = 1.0, .end_speed = 2.0})
          .value();
  EXPECT_EQ(ramp.duration(), 1.0);
  EXPECT_EQ(ramp.pieces().size(), 1u);
}

TEST(TimingLaw, RefusesWithTheNumberThatIsMissing) {
  const auto brake = TimingLaw::trapezoidal(
      1.0, {.cruise_speed = 5.0, .deceleration = 2.0, .start_speed = 4.0, .end_speed = 0.0});
  ASSERT_FALSE(brake);
  EXPECT_EQ(brake.fault().code, FaultCode::no_interpolant);
  EXPECT_EQ(brake.fault().quantity, "deceleration");
  EXPECT_EQ(brake.fault().bound, 8.0);
  EXPECT_EQ(brake.fault().sentence,
            "a change from speed 4 to 0 takes a length of 4 with deceleration 2; got 1, for which "
            "it takes deceleration 8");
  const auto fast = TimingLaw::trapezoidal(1.0, {.cruise_speed = 1.0, .start_speed = 2.0});
  ASSERT_FALSE(fast);
  EXPECT_EQ(fast.fault().code, FaultCode::outside_domain);
  EXPECT_EQ(fast.fault().bound, 1.0);
  EXPECT_FALSE(TimingLaw::constant_speed(0.0, 1.0));
  EXPECT_FALSE(TimingLaw::constant_speed(1.0, -1.0));
  EXPECT_FALSE(TimingLaw::constant_speed(1.0, 1.0, std::nan("")));
  EXPECT_EQ(TimingLaw::between(1.0, 2.0, 2.0).fault().code, FaultCode::not_increasing);
  const TimingLaw law = TimingLaw::constant_speed(1.0, 1.0).value();
  EXPECT_THROW((void)law.arc_length_at(-0.5), Error);
  EXPECT_THROW((void)law.speed_at(1.5), Error);
  EXPECT_THROW((void)law.time_at(std::nan("")), Error);

  const std::vector<double> at{0.0, 1.0, 2.0};
  EXPECT_EQ(TimingLaw::under_limits(at, std::vector{1.0}, {}).fault().code,
            FaultCode::mismatched_size);
  EXPECT_EQ(
      TimingLaw::under_limits(std::vector{0.0, 2.0, 1.0}, std::vector{1.0, 1.0}, {}).fault().code,
      FaultCode::not_increasing);
  const auto blocked = TimingLaw::under_limits(at, std::vector{1.0, 0.0}, {});
  EXPECT_EQ(blocked.fault().code, FaultCode::no_interpolant);
  EXPECT_EQ(blocked.fault().index, 1u);
  const auto entry =
      TimingLaw::under_limits(at, std::vector{4.0, 1.0}, {.cruise_speed = 9.0, .start_speed = 3.0});
  ASSERT_FALSE(entry);
  EXPECT_EQ(entry.fault().quantity, "start_speed");
  EXPECT_DOUBLE_EQ(*entry.fault().bound, std::sqrt(3.0));  // 1² + 2·1·1
  const auto exit =
      TimingLaw::under_limits(at, std::vector{4.0, 9.0}, {.cruise_speed = 9.0, .end_speed = 3.0});
  ASSERT_FALSE(exit);
  EXPECT_EQ(exit.fault().quantity, "end_speed");
  EXPECT_DOUBLE_EQ(*exit.fault().bound, 2.0);
}

TEST(TimingLaw, TakesSpeedsAtTimesAndStops) {
  // Faster for 1, constant for 2, a stop of 3 after braking, off again.
  const TimingLaw law = TimingLaw::from_speeds(std::vector{1.0, 2.0, 1.0, 3.0, 1.0},
                                               std::vector{0.0, 2.0, 2.0, 0.0, 0.0, 2.0}, 7.0, 10.0)
                            .value();
  EXPECT_EQ(law.duration(), 8.0);
  EXPECT_EQ(law.arc_length_at(14.0), 6.0);
  EXPECT_EQ(law.arc_length_at(16.0), 6.0);
  EXPECT_EQ(law.speed_at(16.0), 0.0);
  EXPECT_EQ(law.time_at(6.0), 14.0);  // the first time there
  EXPECT_EQ(law.arc_length_at(18.0), 7.0);
  check_law(law);
  const auto short_of = TimingLaw::from_speeds(std::vector{1.0}, std::vector{1.0, 1.0}, 2.0);
  EXPECT_EQ(short_of.fault().code, FaultCode::outside_domain);
  EXPECT_EQ(short_of.fault().bound, 2.0);
  EXPECT_FALSE(TimingLaw::from_speeds(std::vector{1.0}, std::vector{1.0}, 1.0));
  EXPECT_FALSE(TimingLaw::from_speeds(std::vector{-1.0}, std::vector{1.0, 1.0}, 1.0));
}

TEST(TimingLaw, KeepsRandomLimits) {
  test::Random random("TimingLaw.KeepsRandomLimits");
  for (int trial = 0; trial < 150; ++trial) {
    const std::size_t count = 1 + random.index(40);
    std::vector<double> at{0.0}, most;
    for (std::size_t i = 0; i < count; ++i) {
      at.push_back(at.back() + std::exp(random.uniform(-9.0, 2.0)));
      most.push_back(random.chance(0.1) ? std::numeric_limits<double>::infinity()
                                        : std::exp(random.uniform(-3.0, 3.0)));
    }
    TrapezoidalSpeed limits{.cruise_speed = std::exp(random.uniform(-2.0, 3.0)),
                            .acceleration = std::exp(random.uniform(-2.0, 2.0)),
                            .deceleration = std::exp(random.uniform(-2.0, 2.0))};
    const TimingLaw law =
        TimingLaw::under_limits(at, most, limits, random.uniform(-5.0, 5.0)).value();
    check_law(law, 50);
    // No piece exceeds its limit, no acceleration its bound (the change of speed over a piece
    // cancels: it is compared where the rounding of both speeds is taken off).
    double slow = 0.0;
    for (const auto& piece : law.pieces()) {
      const double v = 2.0 * piece.first / piece.duration, w = 2.0 * piece.second / piece.duration;
      const double middle = piece.arc_length + 0.5 * (piece.first + piece.second);
      const std::size_t i = static_cast<std::size_t>(
          std::upper_bound(at.begin(), at.end() - 1, middle) - at.begin() - 1);
      const double bound = std::min(most[i], limits.cruise_speed);
      // Below it by rounding; the piece may have been cut from its neighbour by rounding, too.
      EXPECT_LE(std::max(v, w), bound * (1.0 + 8.0 * ulp));
      const double noise = 16.0 * ulp * std::max(v, w) / piece.duration;
      EXPECT_LE((w - v) / piece.duration, limits.acceleration * (1.0 + 16.0 * ulp) + noise);
      EXPECT_LE((v - w) / piece.duration, limits.deceleration * (1.0 + 16.0 * ulp) + noise);
      // Speed is continuous: pieces meet, to rounding of a root of a difference of squares.
      EXPECT_NEAR(v, slow, 64.0 * ulp * limits.cruise_speed);
      slow = w;
    }
    EXPECT_EQ(slow, 0.0);
  }
}

TEST(TimingLaw, IsTheFastestUnderItsLimits) {
  // Against the two passes on a fine grid, whose speed is never below the fastest by more than
  // what a step changes.
  test::Random random("TimingLaw.IsTheFastestUnderItsLimits");
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<double> at{0.0}, most;
    for (int i = 0; i < 6; ++i) {
      at.push_back(at.back() + random.uniform(0.2, 1.0));
      most.push_back(random.uniform(0.5, 2.0));
    }
    const TrapezoidalSpeed limits{.cruise_speed = 1.8, .acceleration = 0.7, .deceleration = 1.3};
    const TimingLaw law = TimingLaw::under_limits(at, most, limits).value();
    constexpr int steps = 40000;
    const double h = at.back() / steps;
    std::vector<double> w(steps + 1);
    for (int k = 0; k <= steps; ++k) {
      const double s = k * h;
      std::size_t i = 0;
      while (i + 1 < most.size() && at[i + 1] <= s) ++i;
      double v = std::min(most[i], 1.8);
      if (i > 0 && s - at[i] < h) v = std::min(v, most[i - 1]);
      w[static_cast<std::size_t>(k)] = v * v;
    }
    w.front() = w.back() = 0.0;
    for (std::size_t k = steps; k-- > 0;) w[k] = std::min(w[k], w[k + 1] + 2 * 1.3 * h);
    for (std::size_t k = 0; k < steps; ++k) w[k + 1] = std::min(w[k + 1], w[k] + 2 * 0.7 * h);
    double time = 0.0;
    for (std::size_t k = 0; k < steps; ++k)
      time += 2.0 * h / (std::sqrt(w[k]) + std::sqrt(w[k + 1]));
    // Breakpoints fall between grid points: each costs at most a step at the least speed.
    const double allowed = 16.0 * h / 0.5;
    EXPECT_NEAR(law.duration(), time, allowed);
  }
}

TEST(TimingLaw, NeverGivesANumberThatIsNone) {
  test::Random random("TimingLaw.NeverGivesANumberThatIsNone");
  int made = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const auto number = [&] {
      return random.chance(0.3) ? random.hostile() : std::abs(random.spread(-12, 12));
    };
    const TrapezoidalSpeed limits{number(), number(), number(), random.chance(0.5) ? 0.0 : number(),
                                  random.chance(0.5) ? 0.0 : number()};
    const auto law = TimingLaw::trapezoidal(number(), limits, random.chance(0.2) ? number() : 0.0);
    if (!law) {
      EXPECT_FALSE(law.fault().sentence.empty());
      continue;
    }
    ++made;
    ASSERT_TRUE(std::isfinite(law->duration()) && law->duration() > 0.0);
    for (const double x : {0.0, 0.3, 0.7, 1.0}) {
      const double t = std::min(law->start_time() + x * law->duration(), law->end_time());
      ASSERT_TRUE(std::isfinite(law->arc_length_at(t)) && std::isfinite(law->speed_at(t)));
      ASSERT_TRUE(std::isfinite(law->time_at(x * law->length())));
    }
  }
  EXPECT_GT(made, 1000);
}

}  // namespace
}  // namespace hodograph
