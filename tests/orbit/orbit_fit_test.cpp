// SPDX-License-Identifier: MIT
// Fits of the near-rectilinear halo orbit: errors and segment counts against those known for C⁴
// data from the equations of motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>

#include "hodograph/construction/fit.hpp"
#include "hodograph/frame/holonomy.hpp"
#include "hodograph/orbit/orbit_curve.hpp"
#include "hodograph/path/continuity.hpp"

namespace hodograph {
namespace {

// Tolerances in LU.
constexpr std::array<double, 3> tolerances{1e-6, 1e-9, 1e-12};

/// One row of the table: the error of 256 uniform segments, and the segments that each tolerance
/// takes, uniform and by bisection.
struct Row {
  OrbitFrame frame;
  std::size_t revolutions;
  HermiteChoice choice;
  double error_of_256;  // LU, to three digits
  std::array<std::size_t, 3> uniform, adaptive;
};

/// Computed independently (Python, C⁴ data from the equations of motion, parameter = time).
constexpr std::array<Row, 5> rows{{
    {OrbitFrame::rotating, 1, HermiteChoice::order_six, 8.65e-10, {102, 252, 714}, {16, 32, 96}},
    {OrbitFrame::rotating, 4, HermiteChoice::order_six, 1.82e-5, {408, 1008, 2856}, {64, 128, 384}},
    {OrbitFrame::earth_centred_inertial,
     1,
     HermiteChoice::order_six,
     1.02e-9,
     {106, 258, 578},
     {14, 34, 78}},
    {OrbitFrame::earth_centred_inertial,
     4,
     HermiteChoice::order_six,
     2.20e-5,  // not a tolerance: a known error
     {424, 1032, 2312},
     {56, 136, 312}},
    {OrbitFrame::rotating, 1, HermiteChoice::order_ten, 8.38e-10, {102, 252, 528}, {14, 30, 60}},
}};

class OrbitFit : public ::testing::TestWithParam<std::size_t> {};

OrbitCurve curve_of(const Row& row) {
  static const PeriodicOrbit orbit = lunar_gateway_nrho().value();
  return OrbitCurve::make(orbit, row.frame, OrbitParameter::time, row.revolutions).value();
}

TEST_P(OrbitFit, MeetsOrBeatsTheKnownCounts) {
  const Row& row = rows[GetParam()];
  const OrbitCurve curve = curve_of(row);
  const DerivativeCurve gamma = [&curve](double xi) { return curve(xi); };
  FitOptions options;
  options.choice = row.choice;
  options.closed = row.frame == OrbitFrame::rotating;

  options.segments = 256;
  const auto fixed = fit(gamma, 0.0, curve.end(), options).value();
  EXPECT_FALSE(fixed.error.certified);
  // Half a unit of the last digit given.
  EXPECT_LE(fixed.error.error.upper(), row.error_of_256 * (1.0 + 0.5 / 100.0));
  EXPECT_GE(fixed.error.error.upper(), row.error_of_256 * (1.0 - 0.5 / 100.0));

  options.segments = 0;
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    options.tolerance = tolerances[i];
    options.knots = FitKnots::adaptive;
    const auto adaptive = fit(gamma, 0.0, curve.end(), options);
    ASSERT_TRUE(adaptive) << adaptive.fault().sentence;
    EXPECT_LE(adaptive->path.segment_count(), row.adaptive[i]) << tolerances[i];
    EXPECT_LE(adaptive->error.error.upper(), tolerances[i]);
    const auto orders = continuity(adaptive->path);
    EXPECT_EQ(orders.position.order(), 4);
    EXPECT_EQ(orders.preimage.order(), 3);
    // Judged more finely than the fit looked, whose estimate is good to a few per cent.
    double worst = 0.0;
    for (std::size_t k = 0; k < adaptive->path.segment_count(); ++k) {
      for (int j = 0; j <= 200; ++j) {
        const double u = j / 200.0;
        const double xi = adaptive->path.xi_of({k, u});
        worst = std::max(worst, norm(curve(xi)[0] - adaptive->path.segment(k).position(u)));
      }
    }
    EXPECT_LE(worst, 1.05 * tolerances[i]);
    options.knots = FitKnots::uniform;
    const auto uniform = fit(gamma, 0.0, curve.end(), options);
    ASSERT_TRUE(uniform) << uniform.fault().sentence;
    EXPECT_LE(uniform->path.segment_count(), row.uniform[i]) << tolerances[i];
    if (::testing::Test::HasFailure()) {
      std::printf("row %zu, %g LU: uniform %zu (%zu), adaptive %zu (%zu)\n", GetParam(),
                  tolerances[i], uniform->path.segment_count(), row.uniform[i],
                  adaptive->path.segment_count(), row.adaptive[i]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, OrbitFit, ::testing::Range<std::size_t>(0, rows.size()));

TEST(OrbitFitFacts, FrameReturnsAndPreimageReturnsToItsNegative) {
  const OrbitCurve curve = curve_of(rows[4]);
  FitOptions options;
  options.tolerance = tolerances[2];
  options.closed = true;
  const auto fitted =
      fit([&curve](double xi) { return curve(xi); }, 0.0, curve.end(), options).value();
  EXPECT_TRUE(fitted.path.is_closed());
  EXPECT_TRUE(continuity(fitted.path).antiperiodic);
  const auto left_over = holonomy(fitted.path).value();
  EXPECT_EQ(left_over.sign, -1);
  // The orbit is its own mirror image, so the roll of one half undoes that of the other, to the
  // rounding of some sixty segments.
  EXPECT_LE(std::abs(left_over.roll), 1024.0 * epsilon<double>());
}

TEST(OrbitFitFacts, FourRevolutionsWithAtMost256AdaptiveSegments) {
  // Errors in LU known for the paper's choice.
  constexpr double known_rotating = 7.1e-12, known_inertial = 2.6e-12;
  struct Case {
    OrbitFrame frame;
    double reached;
  };
  for (const Case& known : {Case{OrbitFrame::rotating, known_rotating},
                            Case{OrbitFrame::earth_centred_inertial, known_inertial}}) {
    for (const HermiteChoice choice : {HermiteChoice::order_six, HermiteChoice::order_ten}) {
      const OrbitCurve curve = curve_of({known.frame, 4, choice, 0.0, {}, {}});
      FitOptions options;
      options.choice = choice;
      options.tolerance = known.reached;
      options.most_segments = 256;
      options.closed = known.frame == OrbitFrame::rotating;
      const auto fitted = fit([&curve](double xi) { return curve(xi); }, 0.0, curve.end(), options);
      EXPECT_TRUE(fitted) << fitted.fault().sentence;
    }
  }
}

}  // namespace
}  // namespace hodograph
