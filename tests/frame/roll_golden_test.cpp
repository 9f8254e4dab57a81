// SPDX-License-Identifier: MIT
// Rolls and twist against reference values: rotation-minimising frames of helical quintics,
// periodic frames of closed loops with their twist, inflections, C¹ and least-twist γ (Examples 1
// to 4).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/frame/roll.hpp"
#include "hodograph/frame/twist.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/json.hpp"

namespace hodograph::test {
namespace {

/// The preimage (24) of the helical paper, of a planar quintic's w and the climb angle, in our
/// convention: right-multiplied by (1 - j)/√2.
SpatialPath<2> helical_path(const Json& input) {
  const double t = std::tan(0.5 * input["theta"].number());
  const double f = std::sqrt((1.0 + t) / (2.0 * (1.0 - t)));
  std::array<Quaternion<double>, 3> preimage;
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = input["w"][i][0].number(), b = input["w"][i][1].number();
    const Quaternion<double> theirs{f * a, -b / (2.0 * f), a / (2.0 * f), f * b};
    preimage[i] =
        theirs * Quaternion<double>{std::numbers::sqrt2 / 2, 0, -std::numbers::sqrt2 / 2, 0};
  }
  const SpatialPhCurve<2> curve({}, BernsteinPolynomial<Quaternion<double>, 2>(preimage), 1.0);
  return SpatialPath<2>::create({0.0, 1.0}, {curve}, false).value();
}

SpatialPath<3> loop_path(const Json& input) {
  return closed_loop({input["xi"].number(), input["psi"].number()}).value();
}

/// What the golden file allows, relative to max(1, size).
void expect_near(double actual, double expected, double tolerance) {
  EXPECT_NEAR(actual, expected, tolerance * std::max(1.0, std::abs(expected)));
}

TEST(RollGolden, RotationMinimisingFramesOfHelicalPaths) {
  const Json golden = golden_file("frames.json");
  ASSERT_EQ(golden["rmf"].size(), 11U);
  for (const Json& item : golden["rmf"].list()) {
    SCOPED_TRACE(item["name"].string());
    const double tolerance = item["rel_tol"].number();
    const auto path = helical_path(item["input"]);
    const FrameRoll roll = rotation_minimising_roll(path).value();
    EXPECT_EQ(roll.method(0), RollMethod::argument);
    const AdaptedFrame frame(path, roll);
    for (const Json& sample : item["expected"]["samples"].list()) {
      const double xi = sample["xi"].number();
      expect_near(roll.angle(xi), sample["Phi"].number(), tolerance);
      const auto f = frame.at(xi);
      EXPECT_LE(largest_component(f.e1 - sample["e3"].vector()), tolerance);
      EXPECT_LE(largest_component(f.e2 - sample["f2"].vector()), tolerance);
      EXPECT_LE(largest_component(f.e3 + sample["f1"].vector()), tolerance);
    }
    // (33) with the continuous argument.
    const double turn = item["expected"]["turn"].number();
    expect_near(roll.angle(1.0), -std::sin(item["input"]["theta"].number()) * turn * 2.0,
                tolerance);
  }
}

TEST(RollGolden, TwistAndFramesOfClosedLoops) {
  const Json golden = golden_file("frames.json");
  ASSERT_EQ(golden["twist"].size(), 12U);
  for (const Json& item : golden["twist"].list()) {
    SCOPED_TRACE(item["name"].string());
    const double tolerance = item["rel_tol"].number();
    const Json& expected = item["expected"];
    const auto path = loop_path(item["input"]);
    const auto erf = frame_twist(path, FrameRoll::none(path)).value();
    expect_near(erf.total.middle(), expected["T_ERF"].number(), tolerance);
    EXPECT_LE(erf.total.width(), tolerance);
    const auto closed = erf_twist_in_closed_form(path);
    ASSERT_TRUE(closed);
    EXPECT_NEAR(closed->value, expected["T_ERF"].number(), tolerance);

    const auto smooth = smooth_periodic_gammas(path).value();
    const double sine = std::sin(item["input"]["psi"].number());
    const double minus = expected["gamma_minus"].number(), plus = expected["gamma_plus"].number();
    expect_near(smooth.negative, sine < 0.0 ? plus : minus, tolerance);
    expect_near(smooth.positive, sine < 0.0 ? minus : plus, tolerance);
    const auto absolute = [&](double gamma) {
      return frame_twist(path, periodic_roll(path, gamma).value()).value().absolute;
    };
    const double first = sine < 0.0 ? smooth.positive : smooth.negative;
    const double second = sine < 0.0 ? smooth.negative : smooth.positive;
    expect_near(absolute(first).middle(), expected["T_abs_gamma_minus"].number(), tolerance);
    expect_near(absolute(second).middle(), expected["T_abs_gamma_plus"].number(), tolerance);

    for (const Json& one : expected["per_gamma"].list()) {
      const double gamma = one["gamma"].number();
      SCOPED_TRACE("gamma " + std::to_string(gamma));
      const FrameRoll roll = periodic_roll(path, gamma).value();
      EXPECT_EQ(roll.gamma(), gamma);
      const FrameTwist twist = frame_twist(path, roll).value();
      expect_near(twist.total.middle(), one["T"].number(), tolerance);
      expect_near(twist.absolute.middle(), one["T_abs"].number(), tolerance);
      std::vector<double> inside;
      for (const auto& inflection : twist.inflections) {
        EXPECT_EQ(inflection.kind, RootKind::simple);
        inside.push_back(inflection.xi.middle());
      }
      ASSERT_EQ(inside.size(), one["inflections"].size());
      for (std::size_t i = 0; i < inside.size(); ++i) {
        EXPECT_NEAR(inside[i], one["inflections"][i].number(), tolerance);
      }
      const AdaptedFrame frame(path, roll);
      for (const Json& sample : one["frames"].list()) {
        const double t = sample["t"].number();
        const auto f = frame.at(t);
        EXPECT_LE(largest_component(f.e2 - sample["f2"].vector()), tolerance);
        EXPECT_LE(largest_component(f.e3 - sample["f3"].vector()), tolerance);
        expect_near(frame.body_rate_per_arc_length(t).x, sample["Omega1"].number(), tolerance);
      }
    }
  }
}

TEST(RollGolden, LeastAbsoluteTwistOfPeriodicFrames) {
  const Json golden = golden_file("frames.json");
  ASSERT_EQ(golden["twist_min"].size(), 8U);
  for (const Json& item : golden["twist_min"].list()) {
    SCOPED_TRACE(item["name"].string());
    const double tolerance = item["rel_tol"].number();
    const auto path = loop_path(item["input"]);
    const LeastTwistGamma least = least_twist_gamma(path).value();
    expect_near(least.absolute_twist, item["expected"]["T_abs"].number(), tolerance);
    EXPECT_EQ(least.plateau, item["expected"].has("plateau"));
    if (least.plateau) {
      EXPECT_EQ(least.gamma, 1.0);
    } else {
      expect_near(least.gamma, item["expected"]["gamma"].number(), tolerance);
    }
  }
}

/// The corrected constants of the paper's Examples 1 to 4, to the digits that stand there.
TEST(RollGolden, ExamplesOfThePaper) {
  const auto first = closed_loop({1.0, 0.6 * std::numbers::pi}).value();
  const auto absolute = [](const auto& path, double gamma) {
    return frame_twist(path, periodic_roll(path, gamma).value()).value().absolute;
  };
  constexpr double ten_digits = 0.5e-9;  // not a tolerance: half of the last digit that is stated
  EXPECT_NEAR(absolute(first, -1.0).middle(), 1.146287015, ten_digits);
  EXPECT_NEAR(absolute(first, -0.46209).middle(), 0.651700210, ten_digits);
  const auto least = least_twist_gamma(first).value();
  EXPECT_NEAR(least.gamma, -0.462949157, ten_digits);
  EXPECT_NEAR(least.absolute_twist, 0.651693178, ten_digits);
  const auto smooth = smooth_periodic_gammas(first).value();
  EXPECT_NEAR(absolute(first, smooth.negative).middle(), 0.817156375, ten_digits);
  const auto fourth = closed_loop({-1.0, 0.1 * std::numbers::pi}).value();
  const auto smooth_fourth = smooth_periodic_gammas(fourth).value();
  EXPECT_NEAR(absolute(fourth, smooth_fourth.negative).middle(), 5.360198966, ten_digits);
}

}  // namespace
}  // namespace hodograph::test
