// SPDX-License-Identifier: MIT
// The rotation index: exact cases, the closed form and subdivision against a sum of small steps in
// extended precision, enclosures that hold, and invariance.
#include "hodograph/path/rotation_index.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/compare.hpp"
#include "tests/support/json.hpp"
#include "tests/support/random.hpp"

namespace hodograph {
namespace {

using test::cases;
using test::Random;
constexpr double pi = std::numbers::pi;

template <std::size_t n>
PlanarPhCurve<n> curve_of(const std::array<Complex<double>, n + 1>& w, double h = 1.0) {
  return {{}, BernsteinPolynomial<Complex<double>, n>(w), h};
}

template <std::size_t n>
PlanarPhCurve<n> random_curve(Random& random) {
  std::array<Complex<double>, n + 1> w;
  for (auto& c : w) c = random.complex(1.0);
  return curve_of<n>(w, random.uniform(0.5, 2.0));
}

struct Reference {
  long double absolute = 0, signed_index = 0, least = 1;
};

/// Twice the sum of |Δ arg w| over small steps in long double; the sign of Im(w* w') splits the
/// steps that hold an inflection.
template <std::size_t n>
Reference by_small_steps(const PlanarPhCurve<n>& curve) {
  using L = long double;
  BernsteinPolynomial<Complex<L>, n> w;
  for (std::size_t i = 0; i <= n; ++i) w[i] = {curve.preimage()[i].re, curve.preimage()[i].im};
  const auto rate = [&](L u) {
    const auto jet = w.template jet<1>(u);
    return body_rate_form(jet[0], jet[1]);
  };
  const auto turn = [](const Complex<L>& a, const Complex<L>& b) {
    return std::atan2(body_rate_form(a, b), dot(a, b));
  };
  constexpr int steps = 4096;
  Reference result;
  for (int i = 0; i < steps; ++i) {
    const L a = L(i) / steps, b = L(i + 1) / steps;
    const Complex<L> at_a = w.value(a), at_b = w.value(b);
    result.signed_index += 2 * turn(at_a, at_b);
    result.least = std::min(result.least, std::sqrt(dot(at_a, at_a)));
    L low = a, high = b;
    if (rate(a) * rate(b) < 0) {
      for (int k = 0; k < 60; ++k) {
        const L middle = (low + high) / 2;
        (rate(middle) * rate(a) < 0 ? high : low) = middle;
      }
    } else {
      low = b;
    }
    const Complex<L> split = w.value(low);
    result.absolute += 2 * (std::abs(turn(at_a, split)) + std::abs(turn(split, at_b)));
  }
  return result;
}

TEST(ArcTangent, IsCorrectToTwoEpsilonInEveryQuadrant) {
  Random random("angles");
  for (int i = 0; i < 200000; ++i) {
    const double x = random.chance(0.3) ? random.spread(-300, 300) : random.uniform(-1, 1);
    const double y = random.chance(0.3) ? random.nearly(x) : random.uniform(-1, 1);
    const long double expected = std::atan2(static_cast<long double>(y), x);
    EXPECT_CLOSE(path_detail::angle_of(y, x), expected, 2.0, expected) << y << " " << x;
  }
  EXPECT_EQ(path_detail::angle_of(0.0, 0.0), 0.0);
  EXPECT_EQ(path_detail::angle_of(0.0, 1.0), 0.0);
  EXPECT_EQ(path_detail::angle_of(0.0, -1.0), pi);
  EXPECT_EQ(path_detail::angle_of(1.0, 0.0), pi / 2);
}

TEST(ArcTangent, EnclosuresHoldTheTrueValueAndAreNarrow) {
  Random random("arc tangent enclosures");
  for (int i = 0; i < 100000; ++i) {
    const double t = random.chance(0.5) ? random.uniform(-3, 3) : random.spread(-60, 60);
    const Enclosure angle = path_detail::arc_tangent(t);
    const long double expected = std::atan(static_cast<long double>(t));
    EXPECT_LE(static_cast<long double>(angle.lower()), expected) << t;
    EXPECT_GE(static_cast<long double>(angle.upper()), expected) << t;
    EXPECT_LE(angle.width(), 64 * epsilon<double>() * std::abs(static_cast<double>(expected)));
  }
  const Enclosure everything = path_detail::arc_tangent(Enclosure::whole_line());
  EXPECT_LE(everything.lower(), -pi / 2);
  EXPECT_GE(everything.upper(), pi / 2);
  EXPECT_LE(static_cast<long double>(path_detail::pi_enclosure().lower()),
            std::numbers::pi_v<long double>);
  EXPECT_GE(static_cast<long double>(path_detail::pi_enclosure().upper()),
            std::numbers::pi_v<long double>);
}

TEST(RotationIndex, OfSimpleCurves) {
  // A line; a line with a cusp, whose jump is not counted; a corner curve with w1 = 0.
  EXPECT_EQ(absolute_rotation_index(curve_of<2>({{{1, 2}, {2, 4}, {0.5, 1}}})), 0.0);
  EXPECT_EQ(absolute_rotation_index(curve_of<2>({{{1, 0}, {0.5, 0}, {-1, 0}}})), 0.0);
  EXPECT_CLOSE(absolute_rotation_index(curve_of<2>({{{1, 0}, {0, 0}, {0, 1}}})), pi, 2.0, pi);
  // It turns to the left twice by 90°.
  EXPECT_CLOSE(absolute_rotation_index(curve_of<2>({{{1, 0}, {1, 1}, {0, 1}}})), pi, 4.0, pi);
  EXPECT_CLOSE(rotation_index(curve_of<2>({{{1, 0}, {1, 1}, {0, 1}}})), pi, 4.0, pi);
  EXPECT_CLOSE(rotation_index(curve_of<2>({{{1, 0}, {1, -1}, {0, -1}}})), -pi, 4.0, pi);
  // A start at rest: the direction there is that of w1.
  EXPECT_CLOSE(absolute_rotation_index(curve_of<2>({{{0, 0}, {1, 0}, {0, 1}}})), pi, 2.0, pi);
  EXPECT_EQ(absolute_rotation_index(curve_of<2>({{{0, 0}, {0, 0}, {0, 1}}})), 0.0);
  EXPECT_EQ(absolute_rotation_index(curve_of<2>({{{0, 0}, {0, 0}, {0, 0}}})), 0.0);
  // Nearly two full turns of w's factors, to the left.
  const double turned = absolute_rotation_index(curve_of<2>({{{1, 0}, {-1, 0.125}, {1, -0.125}}}));
  EXPECT_GT(turned, 2 * pi);
  EXPECT_LT(turned, 4 * pi);
  EXPECT_EQ(absolute_rotation_index(curve_of<0>({{{1, 2}}})), 0.0);
  EXPECT_CLOSE(absolute_rotation_index(curve_of<1>({{{1, 0}, {0, -3}}})), pi, 4.0, pi);
  EXPECT_CLOSE(rotation_index(curve_of<1>({{{1, 0}, {0, -3}}})), -pi, 4.0, pi);
}

TEST(RotationIndex, OfQuinticsEqualsTheSumOfSmallSteps) {
  Random random("rotation index of quintics");
  for (int i = 0; i < cases(1500); ++i) {
    const auto curve = random_curve<2>(random);
    const Reference expected = by_small_steps(curve);
    if (expected.least < 0.02) continue;  // where the steps are not small
    const double scale = 1.0 / static_cast<double>(expected.least);
    const double index = absolute_rotation_index(curve), turn = rotation_index(curve);
    EXPECT_CLOSE(index, expected.absolute, 32.0, scale);
    EXPECT_CLOSE(turn, expected.signed_index, 32.0, scale);
    const Enclosure enclosed = absolute_rotation_index_enclosure(curve);
    const Enclosure enclosed_turn = rotation_index_enclosure(curve);
    const double slack = 16 * epsilon<double>() * scale;  // of the reference
    EXPECT_LE(enclosed.lower() - slack, expected.absolute);
    EXPECT_GE(enclosed.upper() + slack, expected.absolute);
    EXPECT_LE(enclosed_turn.lower() - slack, expected.signed_index);
    EXPECT_GE(enclosed_turn.upper() + slack, expected.signed_index);
    EXPECT_LE(enclosed.width(), 2048 * epsilon<double>() * scale);
    EXPECT_LE(enclosed_turn.width(), 2048 * epsilon<double>() * scale);
  }
}

template <std::size_t n>
void expect_sums_of_small_steps(Random& random, int count) {
  for (int i = 0; i < cases(count); ++i) {
    const auto curve = random_curve<n>(random);
    const Reference expected = by_small_steps(curve);
    if (expected.least < 0.02) continue;
    const double scale = static_cast<double>(n) / static_cast<double>(expected.least);
    EXPECT_CLOSE(absolute_rotation_index(curve), expected.absolute, 64.0, scale) << n;
    EXPECT_CLOSE(rotation_index(curve), expected.signed_index, 64.0, scale) << n;
    const double slack = 64 * epsilon<double>() * scale;
    const Enclosure enclosed = absolute_rotation_index_enclosure(curve);
    EXPECT_LE(enclosed.lower() - slack, expected.absolute);
    EXPECT_GE(enclosed.upper() + slack, expected.absolute);
    EXPECT_TRUE(rotation_index_enclosure(curve).contains(rotation_index(curve)) ||
                rotation_index_enclosure(curve).width() < slack);
  }
}

TEST(RotationIndex, OfOtherDegreesEqualsTheSumOfSmallSteps) {
  Random random("rotation index of other degrees");
  expect_sums_of_small_steps<1>(random, 100);
  expect_sums_of_small_steps<3>(random, 200);
  expect_sums_of_small_steps<4>(random, 200);
  expect_sums_of_small_steps<8>(random, 100);
}

TEST(RotationIndex, ClosedFormAndSubdivisionAgree) {
  Random random("closed form of the turn");
  for (int i = 0; i < 50000; ++i) {
    auto curve = random_curve<2>(random);
    if (random.chance(0.3)) {  // near the degenerate cases
      auto w = curve.preimage();
      w[random.index(3)] = random.spread(-40, 0) * w[random.index(3)];
      curve = {curve.start(), w, 1.0};
    }
    double least = 1.0, size = 0.0;
    for (int k = 0; k <= 256; ++k) least = std::min(least, std::sqrt(curve.speed(k / 256.0)));
    size = std::sqrt(curve.speed_bound());
    if (least < 0.01 * size) continue;
    EXPECT_CLOSE(absolute_rotation_index(curve), absolute_rotation_index(curve.elevated<3>()),
                 128.0, size / least);
  }
}

TEST(RotationIndex, DoesNotDependOnPlaceScaleOrDirection) {
  Random random("invariance of the rotation index");
  for (int i = 0; i < cases(2000); ++i) {
    const auto curve = random_curve<2>(random);
    const double index = absolute_rotation_index(curve);
    for (const int exponent : {-249, 249}) {
      const auto scaled = curve.preimage().mapped([&](const Complex<double>& c) {
        return Complex<double>{std::ldexp(c.re, exponent), std::ldexp(c.im, exponent)};
      });
      EXPECT_EQ(absolute_rotation_index(PlanarPhCurve<2>({}, scaled, 1.0)), index);
    }
    const auto reference = by_small_steps(curve);
    if (reference.least < 0.02) continue;
    const PlanarPhCurve<2> reversed({}, curve.preimage().reversed(), 1.0);
    const double scale = 1.0 / static_cast<double>(reference.least);
    EXPECT_CLOSE(absolute_rotation_index(reversed), index, 64.0, scale);
    EXPECT_CLOSE(rotation_index(reversed), -rotation_index(curve), 64.0, scale);
    const double half = random.uniform(0.1, 0.9);
    const auto path = PlanarPath<2>::create(
        {0.0, half, 1.0},
        {PlanarPhCurve<2>(curve.start(), curve.preimage(), 1.0).restricted(0.0, half),
         PlanarPhCurve<2>(curve.start(), curve.preimage(), 1.0).restricted(half, 1.0)},
        false);
    if (!path) continue;  // 1 - half is not always the step
    EXPECT_CLOSE(absolute_rotation_index(*path), index, 128.0, scale);
    EXPECT_CLOSE(rotation_index(*path), rotation_index(curve), 128.0, scale);
    EXPECT_LE(absolute_rotation_index_enclosure(*path).lower(),
              index + 64 * epsilon<double>() * scale);
    EXPECT_GE(rotation_index_enclosure(*path).upper(),
              rotation_index(curve) - 64 * epsilon<double>() * scale);
  }
}

TEST(RotationIndex, NeverFailsOnHostilePreimages) {
  Random random("hostile rotation index");
  for (int i = 0; i < cases(20000); ++i) {
    BernsteinPolynomial<Complex<double>, 2> w;
    for (std::size_t k = 0; k < 3; ++k) {
      // Squares of components stay finite.
      w[k] = {std::ldexp(random.uniform(-1, 1), static_cast<int>(random.integer(-1000, 500))),
              random.chance(0.2) ? 0.0 : random.spread(-500, 500)};
      if (random.chance(0.2) && k > 0) w[k] = random.near(1.0) * w[k - 1];
    }
    const PlanarPhCurve<2> curve({}, w, 1.0);
    for (const double index : {absolute_rotation_index(curve), std::abs(rotation_index(curve))}) {
      EXPECT_GE(index, 0.0);
      EXPECT_LE(index, 4 * pi * (1 + 16 * epsilon<double>()));
    }
    const Enclosure enclosed = absolute_rotation_index_enclosure(curve);
    EXPECT_TRUE(enclosed.is_bounded());
    EXPECT_GE(enclosed.upper(), 0.0);
  }
}

TEST(RotationIndex, OfTheGoldenHermiteSolutions) {
  const test::Json golden = test::golden_file("planar_hermite.json");
  for (const test::Json& item : golden["hermite"].list()) {
    for (const test::Json& solution : item["expected"]["solutions"].list()) {
      std::array<Complex<double>, 3> w;
      for (std::size_t i = 0; i < 3; ++i) {
        w[i] = {solution["w"][i][0].number(), solution["w"][i][1].number()};
      }
      const double index = absolute_rotation_index(curve_of<2>(w));
      const Enclosure enclosed = absolute_rotation_index_enclosure(curve_of<2>(w));
      const double expected = solution["R_abs"].number();
      const double tolerance = item["rel_tol"].number() * std::max(1.0, expected);
      if (enclosed.width() > tolerance) continue;  // a cusp within rounding
      EXPECT_NEAR(index, expected, tolerance) << item["name"].string();
    }
  }
}

}  // namespace
}  // namespace hodograph
