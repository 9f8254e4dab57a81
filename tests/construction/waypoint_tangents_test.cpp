// SPDX-License-Identifier: MIT
#include "hodograph/construction/waypoint_tangents.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "hodograph/path/continuity.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/planar_points.hpp"
#include "tests/support/random.hpp"

namespace hodograph {
namespace {

using test::Points;
using test::Random;

WaypointOptions options_of(TangentRule rule, bool closed) {
  WaypointOptions options;
  options.rule = rule;
  options.closed = closed;
  return options;
}

// A unit vector made by some ten operations on unit vectors.
constexpr double roundings = 8.0;

TEST(WaypointTangents, T1WeighsEachChordByTheOther) {
  // Chords (3, 0) and (0, 1): unit vectors weighted 1 and 3.
  const Points points{{0, 0}, {3, 0}, {3, 1}};
  const auto tangents = waypoint_tangents(points, options_of(TangentRule::t1, false)).value();
  const double size = std::sqrt(10.0);
  const Vector2<double> middle{1 / size, 3 / size};
  EXPECT_CLOSE(tangents[1], middle, roundings, 1.0);
  // The ends: the middle one mirrored in the chords.
  EXPECT_CLOSE(tangents[0], (Vector2<double>{middle.x, -middle.y}), roundings, 1.0);
  EXPECT_CLOSE(tangents[2], (Vector2<double>{-middle.x, middle.y}), roundings, 1.0);
}

TEST(WaypointTangents, T1IsExactOnACircle) {
  // However the points are spaced: the chord's angle to a tangent is half its arc.
  Random random("waypoints on a circle");
  Points points;
  std::vector<Vector2<double>> expected;
  for (double t = 0; t < 5; t += random.uniform(0.01, 0.05)) {
    points.push_back({std::cos(t), std::sin(t)});
    expected.push_back({-std::sin(t), std::cos(t)});
  }
  const auto tangents = waypoint_tangents(points, options_of(TangentRule::t1, false)).value();
  // Lengths as weights in place of arcs: exact to second order, third derivatives count
  // h² / 24 of a step.
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT(largest_component(tangents[i] - expected[i]), 0.05 * 0.05 / 24);
  }
}

TEST(WaypointTangents, TwoPointsGiveTheChord) {
  for (const auto rule : {TangentRule::t1, TangentRule::t2}) {
    const Points points{{1, 1}, {4, 5}};
    const auto tangents = waypoint_tangents(points, options_of(rule, false)).value();
    for (const auto& t : tangents) EXPECT_CLOSE(t, (Vector2<double>{0.6, 0.8}), roundings, 1.0);
    const auto path = waypoint_path(points, options_of(rule, false)).value();
    EXPECT_CLOSE(path.arc_length(), 5.0, roundings, 5.0);
  }
}

TEST(WaypointTangents, T2IsTheDirectionOfTheSpline) {
  Random random("waypoints of a spline");
  for (int repeat = 0; repeat < 20; ++repeat) {
    const bool closed = repeat % 2 == 1;
    const Points points = test::random_walk(random, 12, 0.6);
    PlanarSplineOptions spline_options;
    spline_options.closed = closed;
    const auto spline = planar_spline(points, spline_options).value().path;
    const auto tangents = waypoint_tangents(points, options_of(TangentRule::t2, closed)).value();
    ASSERT_EQ(tangents.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto rate = spline.position_derivatives<1>(spline.knots()[i])[1];
      const double speed = std::hypot(rate.x, rate.y);
      // The path settles its stored coefficients by another step: a few ε more.
      EXPECT_CLOSE(tangents[i], (1 / speed) * rate, 8 * roundings, 1.0);
    }
  }
}

TEST(WaypointPath, IsC1ThroughTheWaypoints) {
  Random random("waypoint paths");
  for (int repeat = 0; repeat < 100; ++repeat) {
    for (const auto rule : {TangentRule::t1, TangentRule::t2}) {
      WaypointOptions options = options_of(rule, repeat % 2 == 1);
      options.speed = random.uniform(0.7, 1.3);
      const Points points = test::random_walk(random, 3 + random.index(10), 0.8, 2.0);
      const auto path = waypoint_path(points, options).value();
      ASSERT_EQ(path.segment_count(), options.closed ? points.size() : points.size() - 1);
      EXPECT_GE(continuity(path).position.order(), 1);
      const auto tangents = waypoint_tangents(points, options).value();
      for (std::size_t i = 0; i < path.segment_count(); ++i) {
        EXPECT_EQ(path.segment(i).start(), points[i]);
        const auto rate = path.position_derivatives<1>(path.knots()[i])[1];
        // The square of a square root, and the sum that gives w at the end.
        EXPECT_CLOSE(rate, options.speed * tangents[i], 8 * roundings, options.speed);
      }
    }
  }
}

TEST(WaypointPath, TakesUpTheClosingPointOrNot) {
  const Points open{{0, 0}, {2, 0}, {2, 1}, {0.5, 2}};
  Points repeated = open;
  repeated.push_back(open.front());
  for (const auto rule : {TangentRule::t1, TangentRule::t2}) {
    const auto options = options_of(rule, true);
    EXPECT_EQ(waypoint_path(open, options).value(), waypoint_path(repeated, options).value());
    EXPECT_EQ(waypoint_tangents(open, options).value().size(), 4U);
    EXPECT_EQ(waypoint_tangents(repeated, options).value().size(), 5U);
  }
}

TEST(WaypointTangents, ScaleWithThePoints) {
  Random random("waypoint scales");
  const Points points = test::random_walk(random, 10, 0.5);
  for (const auto rule : {TangentRule::t1, TangentRule::t2}) {
    const auto options = options_of(rule, false);
    const auto tangents = waypoint_tangents(points, options).value();
    for (const int exponent : {-498, 498}) {  // 1e-150, 1e150
      Points scaled = points;
      for (auto& q : scaled) q = std::ldexp(1.0, exponent) * q;
      EXPECT_EQ(waypoint_tangents(scaled, options).value(), tangents);
      EXPECT_TRUE(waypoint_path(scaled, options).has_value());
    }
  }
}

TEST(WaypointTangents, RefuseWhatTheyCannotUse) {
  const auto fault = [](const Points& points, const WaypointOptions& options) {
    return waypoint_path(points, options).fault();
  };
  const auto t1 = options_of(TangentRule::t1, false), t2 = options_of(TangentRule::t2, false);
  EXPECT_EQ(fault({{0, 0}}, t1).code, FaultCode::too_few);
  EXPECT_EQ(fault({{0, 0}, {1, NAN}}, t2).index, 1U);
  for (const auto& options : {t1, t2}) {
    const Fault repeated = fault({{0, 0}, {1, 1}, {1, 1}}, options);
    EXPECT_EQ(repeated.code, FaultCode::outside_domain);
    EXPECT_EQ(repeated.index, 2U);
  }
  const Fault back = fault({{0, 0}, {1, 1}, {0, 0}, {3, 0}}, t1);
  EXPECT_EQ(back.code, FaultCode::zero_speed);
  EXPECT_EQ(back.index, 1U);
  EXPECT_TRUE(waypoint_path(Points{{0, 0}, {1, 1}, {0, 0}, {3, 0}}, t2).has_value());
  WaypointOptions still = t1;
  still.speed = 0.0;
  EXPECT_EQ(fault({{0, 0}, {1, 1}}, still).quantity, "speed");
}

}  // namespace
}  // namespace hodograph
