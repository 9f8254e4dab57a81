// SPDX-License-Identifier: MIT
// Helices recognised from their preimages: golden axes and pitches, axes of every direction,
// preimages that roll and stretch, paths of several climb angles, planar and straight paths, and
// what is no helix; the plan that a helix is a lifting of.
#include "hodograph/path/helix.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/compare.hpp"
#include "tests/support/json.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {
namespace {

Quaternion<double> quaternion_of(const Json& json) {
  return {json[0].number(), json[1].number(), json[2].number(), json[3].number()};
}

template <std::size_t n>
SpatialPath<n> path_of(const BernsteinPolynomial<Quaternion<double>, n>& preimage,
                       double step = 1.0) {
  return SpatialPath<n>::create({0.0, step}, {{{}, preimage, step}}, false).value();
}

/// c + d j, the factor that pitches a level curve up by θ.
Quaternion<double> pitched(double theta) {
  const double c = std::sqrt(0.5 + 0.5 / std::cos(theta));
  return {c, 0.0, -0.5 * std::tan(theta) / c, 0.0};
}

/// U* (w) (c + d j) (cos + i sin).
template <std::size_t n>
BernsteinPolynomial<Quaternion<double>, n> helix(
    const BernsteinPolynomial<Complex<double>, n>& plan, const Quaternion<double>& upright,
    double theta, double roll) {
  return plan.mapped([&](const Complex<double>& w) {
    return conjugate(upright) * Quaternion<double>{w.re, 0.0, 0.0, w.im} * pitched(theta) *
           Roll<double>{std::cos(0.5 * roll), std::sin(0.5 * roll)};
  });
}

template <std::size_t n>
BernsteinPolynomial<Complex<double>, n> random_plan(Random& random) {
  std::array<Complex<double>, n + 1> w;
  for (auto& c : w) c = random.complex(1.0);
  return BernsteinPolynomial<Complex<double>, n>(w);
}

TEST(Helix, TurnsEveryAxisUpright) {
  Random random("axes turned upright");
  const auto expect_upright = [](const Vector3<double>& axis) {
    const Quaternion<double> turn = turn_upright(axis);
    EXPECT_CLOSE(dot(turn, turn), 1.0, 4.0, 1.0);
    EXPECT_CLOSE(sandwich(turn, unit_axis(axis)), (Vector3<double>{0.0, 0.0, 1.0}), 8.0, 1.0);
  };
  for (int i = 0; i < 2000; ++i) {
    Vector3<double> axis = random.unit_vector3();
    if (i % 3 == 0) axis = {random.spread(-600, 0), random.spread(-600, 0), -1.0};
    if (i % 5 == 0) axis = {random.spread(-600, 0), 0.0, random.sign()};
    expect_upright(std::ldexp(1.0, static_cast<int>(random.integer(-300, 300))) * axis);
  }
  EXPECT_EQ(turn_upright({0.0, 0.0, 1.0}), (Quaternion<double>{1.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(turn_upright({0.0, 0.0, -2.0}), (Quaternion<double>{0.0, 1.0, 0.0, 0.0}));
  EXPECT_EQ(turn_upright({0.0, 0.0, 5e-324}),  // not a tolerance: the least number there is
            (Quaternion<double>{1.0, 0.0, 0.0, 0.0}));
}

TEST(Helix, FindsTheGoldenAxesAndPitches) {
  const Json golden = golden_file("climb.json");
  for (const Json& item : golden["helix_from_quaternion"].list()) {
    const Json& in = item["input"];
    // From r' = A k A* to r' = A i A*.
    const double root = std::sqrt(0.5);
    const Quaternion<double> convert{root, 0.0, -root, 0.0};
    const Quaternion<double> first = quaternion_of(in["A0"]) * convert;
    const Quaternion<double> last = quaternion_of(in["A2"]) * convert;
    const BernsteinPolynomial<Quaternion<double>, 2> preimage(
        {first, in["c0"].number() * first + in["c2"].number() * last, last});
    const HelixFit fit = recognised_helix(path_of(preimage));
    EXPECT_TRUE(fit.is_helix());
    EXPECT_EQ(fit.freedom, 1U);
    Vector3<double> axis{item["expected"]["axis"][0].number(), item["expected"]["axis"][1].number(),
                         item["expected"]["axis"][2].number()};
    double sine = item["expected"]["sin_climb"].number();
    if (axis.z < 0.0) {
      axis = -axis;
      sine = -sine;
    }
    const double tolerance = item["rel_tol"].number();
    EXPECT_LE(largest_component(fit.axis - axis), tolerance) << item["name"].string();
    EXPECT_NEAR(fit.stretches[0].sine, sine, tolerance);
    EXPECT_TRUE(fit.stretches[0].sine_range.contains(fit.stretches[0].sine));
    // Some roundings, times the 256 by which the speed may vary on the parts that are bounded.
    constexpr double width = 0x1.0p-36;  // some hundred ε times 256
    EXPECT_LE(fit.stretches[0].sine_range.upper() - fit.stretches[0].sine_range.lower(), width);
  }
}

TEST(Helix, FindsWhatWasMade) {
  Random random("helices");
  for (int i = 0; i < 500; ++i) {
    Vector3<double> axis = random.unit_vector3();
    if (i % 4 == 0) axis = {random.spread(-40, -1), random.spread(-40, -1), -1.0};
    if (i % 7 == 0) axis = {0.0, 0.0, random.sign()};
    axis = unit_axis(axis);
    const double theta = random.uniform(-1.4, 1.4), roll = random.uniform(-3.1, 3.1);
    const double size = std::ldexp(1.0, static_cast<int>(random.integer(-200, 200)));
    const auto plan = random_plan<2>(random).mapped([&](const auto& w) { return size * w; });
    const auto preimage = helix(plan, turn_upright(axis), theta, roll);
    const HelixFit fit = recognised_helix(path_of(preimage));
    ASSERT_TRUE(fit.is_helix());
    const double sign = dot(fit.axis, axis) < 0.0 ? -1.0 : 1.0;
    // The tangent's circle has the radius cos θ, and a random plan turns through a part of it.
    const double digits = 0x1.0p20;
    EXPECT_CLOSE(sign * fit.axis, axis, digits, 1.0);
    EXPECT_CLOSE(sign * fit.stretches[0].sine, std::sin(theta), digits, 1.0);

    const auto found = helical_decomposition(SpatialPhCurve<2>({}, preimage, 1.0), axis);
    ASSERT_TRUE(found) << found.fault().sentence;
    EXPECT_CLOSE(found->sine, std::sin(theta), 16.0, 1.0);
    EXPECT_CLOSE(found->cosine, std::cos(theta), 16.0, 1.0);
    const double flip = dot(found->plan[0], plan[0]) < 0.0 ? -1.0 : 1.0;
    const double scale = std::sqrt(dot(preimage[0], preimage[0]) + dot(preimage[1], preimage[1]) +
                                   dot(preimage[2], preimage[2]));
    for (std::size_t j = 0; j <= 2; ++j) EXPECT_CLOSE(flip * found->plan[j], plan[j], 64.0, scale);
    const auto again = helix(found->plan, found->upright, theta, found->roll);
    const double common = dot(again[0], preimage[0]) < 0.0 ? -1.0 : 1.0;
    for (std::size_t j = 0; j <= 2; ++j) {
      EXPECT_CLOSE(common * again[j], preimage[j], 64.0, scale);
    }
  }
}

TEST(Helix, SeesThroughFactorsThatRollAndStretch) {
  Random random("rolling preimages of helices");
  for (int i = 0; i < 50; ++i) {
    const Vector3<double> axis = random.unit_vector3();
    const double theta = random.uniform(-1.2, 1.2);
    const auto reduced = helix(random_plan<2>(random), turn_upright(axis), theta, 0.3);
    const auto roll = random_plan<1>(random);
    const auto preimage =
        product(reduced, roll, [](const Quaternion<double>& a, const Complex<double>& q) {
          return a * Quaternion<double>{q.re, q.im, 0.0, 0.0};
        });
    const HelixFit fit = recognised_helix(path_of(preimage));
    EXPECT_TRUE(fit.is_helix());
    const double digits = 0x1.0p20;
    EXPECT_CLOSE(std::abs(dot(fit.axis, axis)), 1.0, digits, 1.0);
    const auto found = helical_decomposition(SpatialPhCurve<3>({}, preimage, 1.0), axis);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.fault().code, FaultCode::unsupported);
  }
}

TEST(Helix, OfPathsWithSeveralClimbAngles) {
  Random random("helical splines");
  std::vector<SpatialPhCurve<2>> curves;
  Vector3<double> at{1.0, 2.0, 3.0};
  for (const double theta : {0.2, 0.2, -0.5}) {
    curves.emplace_back(at, helix(random_plan<2>(random), {1.0, 0.0, 0.0, 0.0}, theta, 0.0), 1.0);
    at = curves.back().end();
  }
  const auto path = SpatialPath<2>::create({0.0, 1.0, 2.0, 3.0}, curves, false).value();
  const HelixFit fit = recognised_helix(path);
  EXPECT_TRUE(fit.is_helical());
  EXPECT_FALSE(fit.is_helix());
  EXPECT_EQ(fit.axis, (Vector3<double>{0.0, 0.0, 1.0}));
  ASSERT_EQ(fit.stretches.size(), 2U);
  EXPECT_EQ(fit.stretches[0].last, 1U);
  EXPECT_CLOSE(fit.stretches[0].sine, std::sin(0.2), 8.0, 1.0);
  EXPECT_CLOSE(fit.stretches[1].sine, std::sin(-0.5), 8.0, 1.0);
}

TEST(Helix, OfPlanarAndStraightPathsAndOfNone) {
  Random random("no helices");
  const auto plan = random_plan<2>(random);
  const HelixFit level = recognised_helix(path_of(helix(plan, {1.0, 0.0, 0.0, 0.0}, 0.0, 1.0)));
  EXPECT_TRUE(level.is_helix());
  EXPECT_EQ(level.axis, (Vector3<double>{0.0, 0.0, 1.0}));
  EXPECT_CLOSE(level.stretches[0].sine, 0.0, 8.0, 1.0);

  const BernsteinPolynomial<Complex<double>, 2> straight(
      {Complex<double>{1.0, 0.5}, Complex<double>{1.0, 0.5}, Complex<double>{1.0, 0.5}});
  const HelixFit line = recognised_helix(path_of(helix(straight, {1.0, 0.0, 0.0, 0.0}, 0.3, 0.0)));
  EXPECT_EQ(line.freedom, 3U);
  EXPECT_EQ(line.axis, (Vector3<double>{0.0, 0.0, 1.0}));
  EXPECT_CLOSE(line.stretches[0].sine, std::sin(0.3), 8.0, 1.0);

  const BernsteinPolynomial<Quaternion<double>, 2> any(
      {random.quaternion(1.0), random.quaternion(1.0), random.quaternion(1.0)});
  const HelixFit none = recognised_helix(path_of(any));
  EXPECT_FALSE(none.is_helical());
  constexpr double clearly = 0x1.0p-10;  // far above rounding
  EXPECT_GT(none.residual, clearly);
  EXPECT_TRUE(none.stretches[0].sine_range.contains(none.stretches[0].sine));

  const auto along = helical_decomposition(
      SpatialPhCurve<1>({},
                        BernsteinPolynomial<Quaternion<double>, 1>(
                            {Quaternion<double>{1.0, 0.0, 0.0, 0.0}, {2.0, 0.0, 0.0, 0.0}}),
                        1.0),
      {1.0, 0.0, 0.0});
  ASSERT_FALSE(along);
  EXPECT_EQ(along.fault().code, FaultCode::outside_domain);
  const auto zero = helical_decomposition(SpatialPhCurve<2>({}, any, 1.0), {0.0, 0.0, 0.0});
  ASSERT_FALSE(zero);
  EXPECT_EQ(zero.fault().sentence, "the helix axis is zero; give it a vector with a length");
}

}  // namespace
}  // namespace hodograph::test
