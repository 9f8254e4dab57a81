// SPDX-License-Identifier: MIT
// Least peak curvature: the published and golden minimisers, no better sample anywhere, active
// bounds, straight lines, and refusals.
#include "hodograph/construction/least_peak_curvature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "hodograph/path/planar_curvature.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/planar_judge.hpp"

namespace hodograph::test {
namespace {

constexpr double pi = std::numbers::pi;
/// How far a minimum found by golden sections may lie above the least sample, relatively: the
/// square of 2^-20, far above their 2^-30.
constexpr double search_slack = 0x1.0p-30;

double peak(const PlanarPhCurve<2>& curve) {
  constexpr RangeGoal goal{search_slack / 16};
  const auto extremes = curvature_extremes(curve, goal);
  return std::max(extremes.maximum.upper(), -extremes.minimum.lower());
}

DirectedPoint at(const Vector2<double>& position, double angle) {
  return {position, direction_of_angle(angle)};
}

TEST(LeastPeakCurvature, OfEqualSpeedsAgreesWithTheGoldenMinimisers) {
  const Json golden = golden_file("planar_peak_curvature.json");
  for (const Json& item : golden["lstar"].list()) {
    const Json &in = item["input"], &expected = item["expected"];
    const SpeedRange range{in["l_range"][0].number(), in["l_range"][1].number()};
    const auto found = least_peak_curvature_of_equal_speeds(
        at(golden_plane_point(in["q0"]), in["theta0"].number()),
        at(golden_plane_point(in["q1"]), in["theta1"].number()), 10.0, range);
    ASSERT_TRUE(found) << found.fault().sentence;
    const double tolerance = item["rel_tol"].number();
    EXPECT_NEAR(found->begin_speed, expected["l"].number(), tolerance * expected["l"].number());
    EXPECT_EQ(found->kind, PeakMinimum::interior);
    EXPECT_NEAR(found->peak_curvature.middle(), expected["kappa_max"].number(),
                tolerance * expected["kappa_max"].number());
    EXPECT_LE(found->peak_curvature.width(), search_slack * found->peak_curvature.upper());
    EXPECT_NEAR(found->curve.arc_length(), expected["S"].number(), tolerance);
    ASSERT_TRUE(found->interior);
    EXPECT_NEAR(found->interior->parameter, expected["l"].number(),
                tolerance * expected["l"].number());
  }
}

TEST(LeastPeakCurvature, OfTheLengthFindsTheLocalMinimumAndTheBound) {
  // Figures 5 and 6: κmax decreases up to S = 1.6 and beyond, has a local minimum 3.4206 near S =
  // 2.26 and falls again for long paths.
  const auto begin = at({0, 0}, pi / 3), end = at({1, 0}, -3 * pi / 4);
  const auto shown = least_peak_curvature_of_length(begin, end, 1.6);
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->kind, PeakMinimum::at_length_bound);
  EXPECT_FALSE(shown->interior);
  EXPECT_CLOSE(shown->curve.arc_length(), 1.6, 64.0, 2.0);
  constexpr double printed_digits = 0.5e-4;  // of 3.4206, rounded
  EXPECT_NEAR(shown->peak_curvature.middle(), 4.337433134206455, 4.337 * search_slack);
  const auto wider = least_peak_curvature_of_length(begin, end, 2.5);
  ASSERT_TRUE(wider);
  EXPECT_EQ(wider->kind, PeakMinimum::interior);
  EXPECT_NEAR(wider->peak_curvature.middle(), 3.4206, printed_digits);
  EXPECT_NEAR(wider->curve.arc_length(), 2.26, 100 * printed_digits);
  const auto far = least_peak_curvature_of_length(begin, end, 100.0);
  ASSERT_TRUE(far);
  EXPECT_EQ(far->kind, PeakMinimum::at_length_bound);
  ASSERT_TRUE(far->interior);
  EXPECT_NEAR(far->interior->peak_curvature, 3.4206, printed_digits);
}

TEST(LeastPeakCurvature, IsNotAboveAnySample) {
  Random random("least peak curvature");
  for (int i = 0; i < 12; ++i) {
    const double theta0 = random.uniform(-2, 2), theta1 = random.uniform(-2, 2);
    const auto begin = at({0, 0}, theta0), end = at({1, 0}, theta1);
    const double most = random.uniform(1.4, 4.0);
    const auto equal = least_peak_curvature_of_equal_speeds(begin, end, most);
    const auto by_length = least_peak_curvature_of_length(begin, end, most);
    ASSERT_TRUE(by_length);
    EXPECT_LE(by_length->curve.arc_length(), most * (1 + search_slack));
    for (int k = 1; k <= 300; ++k) {
      const double length = 1 + (most - 1) * k / 300;
      const auto curve = prescribed_length_curve(begin, end, length);
      ASSERT_TRUE(curve);
      EXPECT_GE(peak(curve->curve), by_length->peak_curvature.lower() * (1 - search_slack));
    }
    if (!equal) continue;
    EXPECT_LE(equal->curve.arc_length(), most);
    for (int k = 0; k <= 300; ++k) {
      const double speed = std::exp2(-4 + 8.0 * k / 300);
      const auto curve =
          planar_hermite({{0, 0}, speed * begin.direction}, {{1, 0}, speed * end.direction});
      ASSERT_TRUE(curve);
      if (curve->curve.arc_length() > most) continue;
      EXPECT_GE(peak(curve->curve), equal->peak_curvature.lower() * (1 - search_slack));
    }
  }
}

TEST(LeastPeakCurvature, OfTwoSpeedsIsNotAboveThatOfEqualOnes) {
  Random random("two end speeds");
  for (int i = 0; i < 4; ++i) {
    const auto begin = at({0, 0}, random.uniform(-1.5, 1.5));
    const auto end = at({1, 0}, random.uniform(-1.5, 1.5));
    const double most = 2.0;
    const auto equal = least_peak_curvature_of_equal_speeds(begin, end, most);
    const auto both = least_peak_curvature_of_speeds(begin, end, most);
    ASSERT_TRUE(equal && both);
    EXPECT_LE(both->peak_curvature.lower(), equal->peak_curvature.upper() * (1 + search_slack));
    EXPECT_LE(both->curve.arc_length(), most);
    for (int k = 0; k < 4000; ++k) {
      const double l0 = std::exp2(random.uniform(-3, 3)), l1 = std::exp2(random.uniform(-3, 3));
      const auto curve =
          planar_hermite({{0, 0}, l0 * begin.direction}, {{1, 0}, l1 * end.direction});
      ASSERT_TRUE(curve);
      if (curve->curve.arc_length() > most) continue;
      EXPECT_GE(peak(curve->curve), both->peak_curvature.lower() * (1 - search_slack));
    }
    for (const double nudge : {1 - 1.0 / 1024, 1 + 1.0 / 1024}) {
      for (const bool first : {true, false}) {
        const auto curve =
            planar_hermite({{0, 0}, (first ? nudge : 1.0) * both->begin_speed * begin.direction},
                           {{1, 0}, (first ? 1.0 : nudge) * both->end_speed * end.direction});
        ASSERT_TRUE(curve);
        if (curve->curve.arc_length() > most) continue;
        EXPECT_GE(peak(curve->curve), both->peak_curvature.lower() * (1 - search_slack));
      }
    }
  }
}

TEST(LeastPeakCurvature, OfAlignedDirectionsIsTheLine) {
  const auto found = least_peak_curvature_of_length(at({0, 0}, 0), at({2, 0}, 0), 5.0);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, PeakMinimum::straight_line);
  EXPECT_EQ(found->peak_curvature.upper(), 0.0);
  EXPECT_CLOSE(found->curve.arc_length(), 2.0, 4.0, 2.0);
  const auto speeds = least_peak_curvature_of_equal_speeds(at({0, 0}, 0), at({2, 0}, 0), 5.0);
  ASSERT_TRUE(speeds);
  EXPECT_EQ(speeds->kind, PeakMinimum::straight_line);
}

TEST(LeastPeakCurvature, BoundsTheLengthOfSpeedsToo) {
  const auto begin = at({0, 0}, pi / 6), end = at({1, 0}, pi / 4);
  // The minimiser of Figure 8 is 1.0642... long.
  const auto found = least_peak_curvature_of_equal_speeds(begin, end, 1.05);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, PeakMinimum::at_length_bound);
  EXPECT_LE(found->curve.arc_length(), 1.05);
  const auto short_range = least_peak_curvature_of_equal_speeds(begin, end, 5.0, {2.0, 4.0});
  ASSERT_TRUE(short_range);
  EXPECT_EQ(short_range->kind, PeakMinimum::at_range_end);
  EXPECT_FALSE(short_range->interior);
}

TEST(LeastPeakCurvature, RefusesWhatItCannotDo) {
  const auto begin = at({0, 0}, 1.0), end = at({1, 0}, 1.0);
  const auto below = least_peak_curvature_of_length(begin, end, 0.5);
  ASSERT_FALSE(below);
  EXPECT_EQ(below.fault().code, FaultCode::no_interpolant);
  EXPECT_EQ(below.fault().value, 0.5);
  EXPECT_EQ(below.fault().bound, 1.0);
  EXPECT_EQ(least_peak_curvature_of_length(begin, end, 1.0).fault().code,
            FaultCode::no_interpolant);
  EXPECT_EQ(least_peak_curvature_of_equal_speeds(begin, end, 1.5, {3.0, 2.0}).fault().code,
            FaultCode::outside_domain);
  EXPECT_EQ(least_peak_curvature_of_equal_speeds(begin, end, 1.1, {8.0, 9.0}).fault().code,
            FaultCode::no_interpolant);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(least_peak_curvature_of_speeds(begin, end, nan).fault().code,
            FaultCode::outside_domain);
  EXPECT_EQ(least_peak_curvature_of_speeds({{nan, 0}, {1, 0}}, end, 2.0).fault().code,
            FaultCode::not_finite);
  EXPECT_EQ(least_peak_curvature_of_speeds({{0, 0}, {0, 0}}, end, 2.0).fault().code,
            FaultCode::outside_domain);
}

}  // namespace
}  // namespace hodograph::test
