// SPDX-License-Identifier: MIT
// Turn-limited paths: length, ends, certified curvature and joints on random data; refusals judged
// by the shortest path of bounded curvature; shapes; lengths that are free; bad input.
#include "hodograph/construction/turn_limited.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "hodograph/path/bounds.hpp"
#include "hodograph/path/continuity.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/dubins.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {
namespace {

constexpr double pi = std::numbers::pi;
/// What arcs lose against circles: at most this part of the radius.
constexpr double coarse_arcs = 1.0 + 0x1.0p-16, fine_arcs = 1.0 + 0x1.0p-20;
/// Above the rounding of lengths, angles and roots, some hundred ε.
constexpr double rounded_up = 1.0 + 0x1.0p-40;
/// The rounding of heading angles along tens of spans, and that of straight lines.
constexpr double heading_rounding = 0x1.0p-40;
/// How sharp the certificates are that are asked for again here.
constexpr RangeGoal curvature_goal{0x1.0p-20};  // not a tolerance: any will do

struct Task {
  DirectedPoint begin, end;
  double length, radius;
};

Task random_task(Random& random) {
  Task task;
  task.radius = std::abs(random.spread(-4, 2));
  const double chord = random.chance(0.1) ? 0.0 : random.uniform(0.0, 6.0);
  const double along = random.uniform(-pi, pi);
  task.begin = {random.vector2(1.0), direction_of_angle(random.uniform(-pi, pi))};
  if (random.chance(0.2)) task.begin.direction = direction_of_angle(along);
  task.end = {task.begin.position + chord * direction_of_angle(along),
              direction_of_angle(random.uniform(-pi, pi))};
  if (random.chance(0.3)) task.end.direction = random.sign() * task.begin.direction;
  task.length =
      chord + (random.chance(0.5) ? random.uniform(0.0, 10.0) : std::abs(random.spread(-20, 7)));
  return task;
}

void expect_path(const TurnLimitedPath& made, const Task& task) {
  const auto& path = made.path;
  const double size = task.length + 1.0 + static_cast<double>(path.segment_count());
  if (made.shape != TurnLimitedShape::one_span) {
    EXPECT_CLOSE(path.arc_length(), task.length, 64.0, size);
    EXPECT_CLOSE(path.segments().back().end(), task.end.position, 64.0, size);
    EXPECT_EQ(path.segments().front().start(), task.begin.position);
    EXPECT_GE(made.arc_radius, task.radius);
  } else {
    EXPECT_EQ(path.segment_count(), 1U);
  }
  const auto& first = path.segments().front().preimage();
  const auto& last = path.segments().back().preimage();
  EXPECT_GT(dot(hodograph_form(first.front(), first.front()), task.begin.direction), 0.0);
  EXPECT_LE(std::abs(cross(hodograph_form(first.front(), first.front()), task.begin.direction)),
            heading_rounding);
  EXPECT_GT(dot(hodograph_form(last.back(), last.back()), task.end.direction), 0.0);
  EXPECT_LE(std::abs(cross(hodograph_form(last.back(), last.back()), task.end.direction)),
            heading_rounding);
  EXPECT_LE(made.most_curvature * task.radius, 1.0);
  const Extremes curvature = curvature_extremes(path, curvature_goal);
  EXPECT_LE(std::max(-curvature.minimum.lower(), curvature.maximum.upper()), made.most_curvature);
  const auto joints = continuity(path);
  EXPECT_GE(joints.position.order(), 1);
  EXPECT_GE(joints.preimage.order(), 0);
}

TEST(TurnLimited, MeetsRandomTasksOrRefusesThemForATrueReason) {
  Random random("turn-limited paths");
  std::array<int, 4> shapes{};
  int below = 0, between = 0;
  for (int i = 0; i < 900; ++i) {
    const Task task = random_task(random);
    const auto made = turn_limited_path(task.begin, task.end, task.length, task.radius);
    if (made) {
      ++shapes[static_cast<std::size_t>(made->shape)];
      expect_path(*made, task);
      continue;
    }
    const Fault& fault = made.fault();
    ASSERT_EQ(fault.code, FaultCode::no_interpolant) << fault.sentence;
    ASSERT_TRUE(fault.bound) << fault.sentence;
    const double shortest = dubins_length(task.begin, task.end, fine_arcs * task.radius);
    EXPECT_LE(task.length, *fault.bound);
    if (fault.sentence.find("at least") != std::string::npos) {
      ++below;
      EXPECT_LE(task.length, rounded_up * shortest);
      EXPECT_LE(*fault.bound, rounded_up * shortest);
    } else {
      ++between;
    }
    Task longer = task;
    longer.length = *fault.bound;
    const auto met = turn_limited_path(task.begin, task.end, longer.length, task.radius);
    ASSERT_TRUE(met) << fault.sentence << " then " << met.fault().sentence;
    expect_path(*met, longer);
  }
  for (const int count : shapes) EXPECT_GT(count, 0);
  EXPECT_GT(below, 0);
  EXPECT_LT(between, below);
}

TEST(TurnLimited, FreeLengthsAlwaysFindAPath) {
  Random random("free lengths");
  for (int i = 0; i < 800; ++i) {
    Task task = random_task(random);
    if (random.chance(0.3)) task.length = 0.0;
    const auto made =
        shortest_turn_limited_path(task.begin, task.end, task.radius, {task.length, 0.25});
    ASSERT_TRUE(made) << made.fault().sentence;
    const double length = made->path.arc_length();
    EXPECT_GE(length, task.length / rounded_up);
    const double shortest = dubins_length(task.begin, task.end, task.radius);
    EXPECT_GE(rounded_up * length, shortest);
    const double loiter =
        std::max(shortest, task.length) + 3.0 * 2.0 * pi * coarse_arcs * task.radius;
    EXPECT_LE(length, 1.25 * rounded_up * loiter);
    task.length = length;
    expect_path(*made, task);
  }
}

TEST(TurnLimited, ArcsAreWithinTheMarginOfCircles) {
  // A twelfth of a turn: the curvature of its quintic exceeds the circle's by 1.04e-5.
  const double a = pi / 6;
  const auto made =
      turn_limited_path({{0.0, 0.0}, {1.0, 0.0}},
                        {{std::sin(a), 1.0 - std::cos(a)}, direction_of_angle(a)}, a, 0.0)
          .value();
  constexpr double digits = 0.01e-5;  // not a tolerance: those that the documents print
  EXPECT_NEAR(made.most_curvature, 1.0 + 1.034e-5, digits);
  EXPECT_LT(made.most_curvature, coarse_arcs);
}

TEST(TurnLimited, LoitersByWholeTurns) {
  const DirectedPoint begin{{0.0, 0.0}, {1.0, 0.0}}, end{{5.0, 0.0}, {1.0, 0.0}};
  const auto made = turn_limited_path(begin, end, 5.0 + 2.0 * pi * 10.4, 1.0).value();
  if (made.shape == TurnLimitedShape::loiter) {
    EXPECT_GE(made.whole_turns, 1U);
  }
  expect_path(made, {begin, end, 5.0 + 2.0 * pi * 10.4, 1.0});
  const auto same = turn_limited_path(begin, begin, 7.0, 1.0).value();
  expect_path(same, {begin, begin, 7.0, 1.0});
  const auto free = shortest_turn_limited_path(begin, begin, 1.0).value();
  EXPECT_CLOSE(free.path.arc_length(), 2.0 * pi, 1e12, 1.0);  // not a tolerance: 2^-13
}

TEST(TurnLimited, ScalesAndRefusesBadInput) {
  const DirectedPoint begin{{0.0, 0.0}, {1.0, 0.0}}, end{{2.0, 1.0}, {0.0, -1.0}};
  for (const int exponent : {-300, -40, 40, 300}) {
    const double size = std::ldexp(1.0, exponent);
    const auto made = turn_limited_path({size * begin.position, begin.direction},
                                        {size * end.position, end.direction}, 9.0 * size, size);
    ASSERT_TRUE(made) << made.fault().sentence;
    EXPECT_LE(made->most_curvature * size, 1.0);
  }
  const auto negative = turn_limited_path(begin, end, 9.0, -1.0);
  ASSERT_FALSE(negative);
  EXPECT_EQ(negative.fault().sentence,
            "the turn radius must be finite and not negative (0: none); got -1");
  const auto zero = turn_limited_path({begin.position, {0.0, 0.0}}, end, 9.0, 1.0);
  ASSERT_FALSE(zero);
  EXPECT_EQ(zero.fault().code, FaultCode::outside_domain);
  const auto nothing = turn_limited_path(begin, end, 0.0, 1.0);
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.fault().quantity, "length");
  const auto nan = shortest_turn_limited_path(begin, end, std::nan(""));
  ASSERT_FALSE(nan);
  EXPECT_EQ(nan.fault().code, FaultCode::not_finite);
  Random random("hostile turn-limited paths");
  for (int i = 0; i < 900; ++i) {
    double x[10];
    for (double& number : x) number = random.chance(0.6) ? random.uniform(-2, 2) : random.hostile();
    const auto made =
        turn_limited_path({{x[0], x[1]}, {x[2], x[3]}}, {{x[4], x[5]}, {x[6], x[7]}}, x[8], x[9]);
    if (made) {
      EXPECT_TRUE(is_finite(made->path.segments().back().end()));
    } else {
      EXPECT_FALSE(made.fault().sentence.empty());
    }
    const auto free = shortest_turn_limited_path({{x[0], x[1]}, {x[2], x[3]}},
                                                 {{x[4], x[5]}, {x[6], x[7]}}, x[9], {x[8], 0.25});
    if (free) {
      EXPECT_TRUE(is_finite(free->path.segments().back().end()));
    }
  }
}

}  // namespace
}  // namespace hodograph::test
