// SPDX-License-Identifier: MIT
// One PH curve, by hand: numbers that can be worked out on paper, and the curvature and torsion
// against their textbook formulas. The laws that hold for every curve are in tests/conformance/.
#include "hodograph/curve/ph_curve.hpp"

#include <gtest/gtest.h>

#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

using test::Random;

TEST(PhCurve, ACubicInThePlane) {
  // w = 1 + i u over a step of 2: r' = (1 - u², 2u), r = 2 (u - u³/3, u²), s = 2 (u + u³/3).
  const BernsteinPolynomial<Complex<double>, 1> w({Complex<double>{1, 0}, {1, 1}});
  const PlanarPhCurve<1> curve({10, 20}, w, 2.0);
  EXPECT_EQ(curve.start(), (Vector2<double>{10, 20}));
  EXPECT_CLOSE(curve.end(), (Vector2<double>{10 + 4.0 / 3, 22}), 4.0, 22.0);
  EXPECT_CLOSE(curve.arc_length(), 8.0 / 3, 4.0, 1.0);
  EXPECT_CLOSE(curve.position(0.5), (Vector2<double>{10 + 11.0 / 12, 20.5}), 4.0, 22.0);
  EXPECT_CLOSE(curve.arc_length(0.5), 13.0 / 12, 4.0, 1.0);
  EXPECT_EQ(curve.speed(0.5), 1.25);
  const auto jet = curve.preimage_jet<2>(0.5);
  EXPECT_EQ(jet[0], (Complex<double>{1, 0.5}));
  EXPECT_EQ(jet[1], (Complex<double>{0, 0.5}));  // per unit ξ: the step is 2
  EXPECT_EQ(jet[2], (Complex<double>{0, 0}));
  // κ = 2 Im(w* w')/σ² = 2 · 0.5/1.5625, to the left.
  EXPECT_CLOSE(curvature(jet), 0.64, 4.0, 1.0);
}

TEST(PhCurve, TheStepStretchesTheParameterAlone) {
  Random random("curve step");
  const auto a = test::tame_preimage<Quaternion<double>, 4>(random);
  const SpatialPhCurve<4> one({}, a, 1.0), four({}, 0.5 * a, 4.0);
  EXPECT_EQ(one.end(), four.end());
  EXPECT_EQ(one.arc_length(), four.arc_length());
  EXPECT_EQ(one.speed(0.375), 4 * four.speed(0.375));
  EXPECT_CLOSE(curvature(one.preimage_jet<1>(0.375)), curvature(four.preimage_jet<1>(0.375)), 8.0,
               16.0);
}

TEST(PhCurve, AFarStartCostsNoDigitsOfTheShape) {
  Random random("curve far");
  const auto a = test::tame_preimage<Quaternion<double>, 8>(random);
  const double far = std::ldexp(1.0, 40);
  const SpatialPhCurve<8> near_curve({}, a, 1.0), far_curve({far, far, far}, a, 1.0);
  EXPECT_EQ(near_curve.displacement(), far_curve.displacement());
  EXPECT_EQ(near_curve.arc_length(), far_curve.arc_length());
  EXPECT_FALSE(near_curve == far_curve);
}

TEST(PreimageJet, CurvatureAndTorsionAreTheTextbooks) {
  Random random("curvature and torsion");
  for (int repeat = 0; repeat < 100; ++repeat) {
    const SpatialPhCurve<4> curve({}, test::tame_preimage<Quaternion<double>, 4>(random), 1.0);
    const auto jet = curve.preimage_jet<2>(random.unit());
    const auto r = hodograph_derivatives(jet);
    const auto b = cross(r[0], r[1]);
    const double speed = norm(r[0]), bend = norm(b);
    const double loss = speed * norm(r[1]) / bend;  // what the cross product cancels
    constexpr double tolerance = 64;                // two products and sums of n + 1 terms
    EXPECT_CLOSE(curvature(jet), bend / (speed * speed * speed), tolerance, loss * curvature(jet));
    ASSERT_TRUE(torsion(jet));
    EXPECT_CLOSE(*torsion(jet), dot(b, r[2]) / (bend * bend), tolerance,
                 loss * loss * norm(r[2]) / bend);
    EXPECT_CLOSE(tangent(jet), (1 / speed) * r[0], 8.0, 1.0);
  }
}

TEST(PreimageJet, PlanarCurvatureHasTheSignOfTheTurn) {
  Random random("planar curvature");
  for (int repeat = 0; repeat < 100; ++repeat) {
    const PlanarPhCurve<4> curve({}, test::tame_preimage<Complex<double>, 4>(random), 1.0);
    const auto jet = curve.preimage_jet<1>(random.unit());
    const auto r = hodograph_derivatives(jet);
    const double speed = norm(r[0]);
    EXPECT_CLOSE(curvature(jet), cross(r[0], r[1]) / (speed * speed * speed), 64.0,
                 norm(r[1]) / (speed * speed));
  }
}

TEST(PreimageJet, AStraightLineHasNoTorsion) {
  const std::array<Quaternion<double>, 3> jet{Quaternion<double>{1, 0, 0, 0}, {2, 0, 0, 0}, {}};
  EXPECT_EQ(curvature(jet), 0.0);
  EXPECT_FALSE(torsion(jet));
}

}  // namespace
}  // namespace hodograph
