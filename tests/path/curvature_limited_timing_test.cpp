// SPDX-License-Identifier: MIT
// Parts with curvature bounds hold the curvature of every point; a timing built on them keeps the
// lateral acceleration, also next to cusps.
#include "hodograph/path/curvature_limited_timing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hodograph/construction/corner.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random.hpp"

namespace hodograph {
namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon();

/// |κ| at u, in long double.
template <class A, std::size_t n>
long double curvature(const PhCurve<A, n>& curve, double u) {
  using Wide = std::conditional_t<A::dimension == 2, Complex<long double>, Quaternion<long double>>;
  BernsteinPolynomial<Wide, n> preimage;
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j < A::dimension; ++j) {
      preimage[i][j] = static_cast<long double>(curve.preimage()[i][j]);
    }
  }
  const auto jet = preimage.template jet<1>(static_cast<long double>(u));
  const long double sigma = speed_form(jet[0], jet[0]);
  const auto rate = body_rate_form(jet[0], jet[1]);
  long double turning = 0;
  if constexpr (A::dimension == 2) {
    turning = std::abs(rate);
  } else {
    turning = std::hypot(rate.y, rate.z);
  }
  return 2.0L * turning / (static_cast<long double>(curve.parameter_step()) * sigma * sigma);
}

template <class A, std::size_t n>
void check_path(const Path<A, n>& path, std::size_t per_segment, double lateral) {
  const CurvatureParts parts = curvature_parts(path, per_segment);
  ASSERT_EQ(parts.most_curvature.size(), path.segment_count() * per_segment);
  ASSERT_EQ(parts.arc_lengths.size(), parts.most_curvature.size() + 1);
  EXPECT_EQ(parts.arc_lengths.back(), path.arc_length());
  constexpr int samples = 24;
  bool bounded = true;
  for (std::size_t i = 0; i < parts.most_curvature.size(); ++i) {
    const auto& curve = path.segment(i / per_segment);
    long double largest = 0;
    for (int k = 0; k <= samples; ++k) {
      const double u = (static_cast<double>(i % per_segment) + static_cast<double>(k) / samples) /
                       static_cast<double>(per_segment);
      largest = std::max(largest, curvature(curve, u));
    }
    EXPECT_LE(largest, static_cast<long double>(parts.most_curvature[i]) * (1 + 64 * ulp));
    bounded = bounded && parts.most_curvature[i] < std::numeric_limits<double>::infinity();
  }
  const LateralLimit limit{.lateral_acceleration = lateral,
                           .along = {.cruise_speed = 3.0, .acceleration = 0.8, .deceleration = 1.1},
                           .parts_per_segment = per_segment};
  const auto law = curvature_limited_timing(path, limit);
  if (!bounded) {
    EXPECT_EQ(law.fault().code, FaultCode::no_interpolant);
    return;
  }
  ASSERT_TRUE(law) << law.fault().sentence;
  EXPECT_EQ(law->length(), path.arc_length());
  for (int k = 0; k <= 2000; ++k) {
    const double t = std::min(law->duration() * k / 2000.0, law->end_time());
    const double s = law->arc_length_at(t), v = law->speed_at(t);
    const std::size_t segment = path.segment_at_arc_length(s);
    const double target = s - path.knot_arc_lengths()[segment];
    double low = 0.0, high = 1.0;  // no use is made of the library's inverse
    for (int step = 0; step < 60; ++step) {
      const double u = 0.5 * (low + high);
      (path.segment(segment).arc_length(u) < target ? low : high) = u;
    }
    // The point itself is off by rounding of s, in which the curvature may change.
    const long double kappa =
        std::min(curvature(path.segment(segment), low), curvature(path.segment(segment), high));
    constexpr double rounding = 1.0 + 0x1.0p-36;  // not a tolerance: s is rounded, κ follows it
    EXPECT_LE(static_cast<long double>(v) * v * kappa, lateral * rounding) << t;
  }
}

TEST(CurvatureParts, BoundEveryPoint) {
  test::Random random("CurvatureParts.BoundEveryPoint");
  for (int trial = 0; trial < 12; ++trial) {
    check_path(test::random_path<PlanarPath<2>>(random, 3), 16, 0.7);
    check_path(test::random_path<PlanarPath<1>>(random, 2), 8, 0.7);
    check_path(test::random_path<PlanarPath<5>>(random, 2), 16, 2.0);
    check_path(test::random_path<SpatialPath<2>>(random, 3), 16, 0.7);
    check_path(test::random_path<SpatialPath<8>>(random, 1), 16, 0.3);
  }
}

TEST(CurvatureParts, ComeCloseToTheLargestCurvatureWithTheirNumber) {
  test::Random random("CurvatureParts.ComeClose");
  for (int trial = 0; trial < 20; ++trial) {
    const auto path = test::random_path<PlanarPath<2>>(random, 1);
    long double largest = 0;
    for (int k = 0; k <= 1000; ++k) {
      largest = std::max(largest, curvature(path.segment(0), k / 1000.0));
    }
    const auto excess = [&](std::size_t count) {
      const CurvatureParts parts = curvature_parts(path, count);
      return *std::max_element(parts.most_curvature.begin(), parts.most_curvature.end()) /
                 static_cast<double>(largest) -
             1.0;
    };
    // Linear in the length of a part at least: σ' and σ'' are bounded by those of the preimage.
    EXPECT_LT(excess(64), 0.25);
    EXPECT_LT(excess(256), 0.07);
  }
}

TEST(CurvatureParts, OfLinesAreZeroAndOfCuspsInfinite) {
  const auto line =
      PlanarPath<0>::create(
          {0.0, 2.0}, {{{0.0, 0.0}, PlanarPhCurve<0>::Preimage({Complex<double>{1.0, 1.0}}), 2.0}},
          false)
          .value();
  EXPECT_EQ(curvature_parts(line, 2).most_curvature, (std::vector{0.0, 0.0}));
  // w = (1 - 2u) + i (1 - 2u)(...): speed zero in the middle.
  const PlanarPhCurve<2>::Preimage cusp(
      {Complex<double>{1.0, 0.5}, Complex<double>{0.0, -0.5}, Complex<double>{-1.0, 0.5}});
  const auto path = PlanarPath<2>::create({0.0, 1.0}, {{{0.0, 0.0}, cusp, 1.0}}, false).value();
  const CurvatureParts parts = curvature_parts(path, 4);
  EXPECT_EQ(parts.most_curvature[1], std::numeric_limits<double>::infinity());
  EXPECT_LT(parts.most_curvature[0], std::numeric_limits<double>::infinity());
  EXPECT_FALSE(curvature_limited_timing(path, LateralLimit{}));
  EXPECT_EQ(curvature_limited_timing(path, LateralLimit{.lateral_acceleration = -1.0}).fault().code,
            FaultCode::outside_domain);
}

TEST(CurvatureLimitedTiming, SlowsDownForCorners) {
  const std::vector<Vector2<double>> points{{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}};
  const auto path = rounded_polyline(points, CornerRule{.most_curvature = 1.0}).value();
  const LateralLimit limit{.lateral_acceleration = 1.0,
                           .along = {.cruise_speed = 4.0, .acceleration = 2.0, .deceleration = 2.0},
                           .parts_per_segment = 64};
  const TimingLaw law = curvature_limited_timing(path, limit).value();
  EXPECT_EQ(law.length(), path.arc_length());
  // At the middle of the first corner κ = 1: the speed is 1, less what the parts' bounds exceed.
  const double middle = 0.5 * (path.knot_arc_lengths()[1] + path.knot_arc_lengths()[2]);
  const double speed = law.speed_at(law.time_at(middle));
  EXPECT_LE(speed, 1.0);
  EXPECT_GT(speed, 0.97);
  EXPECT_GT(law.speed_at(law.time_at(0.4 * path.knot_arc_lengths()[1])), 3.0);
}

}  // namespace
}  // namespace hodograph
