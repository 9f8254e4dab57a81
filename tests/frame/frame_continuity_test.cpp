// SPDX-License-Identifier: MIT
// Continuity of the frame at the knots, what is left over when it returns, and what takes that
// away.
#include "hodograph/frame/continuity.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "hodograph/frame/holonomy.hpp"
#include "hodograph/path/operations.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

using test::Random;
using test::random_path;
using test::ring;

constexpr double pi = std::numbers::pi;

template <class P>
class FrameContinuityOf : public testing::Test {};
using Paths = testing::Types<PlanarPath<8>, SpatialPath<4>, SpatialPath<8>>;
TYPED_TEST_SUITE(FrameContinuityOf, Paths);

TYPED_TEST(FrameContinuityOf, FollowsThePreimage) {
  Random random("frame continuity");
  for (int order = -1; order <= 3; ++order) {
    for (int repeat = 0; repeat < 20; ++repeat) {
      const auto path = random_path<TypeParam>(random, 4, order);
      const auto found = frame_continuity(path);
      EXPECT_EQ(found.frame.order(), order);
      EXPECT_EQ(found.angular_velocity.order(), std::max(order - 1, -1));
    }
  }
}

TEST(FrameContinuity, AConstantFactorOfThePreimageLeavesTheFrameSmooth) {
  Random random("frame continuity factor");
  const auto path = random_path<SpatialPath<4>>(random, 2, 3);
  const auto& second = path.segment(1);
  const SpatialPhCurve<4> faster(second.start(), -3.0 * second.preimage(), second.parameter_step());
  const auto jumping =
      SpatialPath<4>::create(path.knots(), {path.segment(0), faster}, false).value();
  EXPECT_EQ(continuity(jumping).preimage.order(), -1);
  EXPECT_EQ(frame_continuity(jumping).frame.order(), 3);
  EXPECT_EQ(frame_continuity(jumping).angular_velocity.order(), 2);
}

TEST(FrameContinuity, WhereThePathStandsStillThereIsNoFrame) {
  const BernsteinPolynomial<Quaternion<double>, 1> slowing({Quaternion<double>{1, 0, 0, 0}, {}});
  const BernsteinPolynomial<Quaternion<double>, 1> starting({Quaternion<double>{}, {1, 0, 0, 0}});
  const SpatialPhCurve<1> first({}, slowing, 1.0), second(first.end(), starting, 1.0);
  const auto path = SpatialPath<1>::create({0.0, 1.0, 2.0}, {first, second}, false).value();
  EXPECT_EQ(frame_continuity(path).frame.order(), -1);
  EXPECT_EQ(frame_continuity(path).angular_velocity.order(), -1);
}

/// A ring in space whose segments are rolled by k times `half_roll`.
SpatialPath<1> rolled_ring(std::size_t count, double half_roll) {
  const auto flat = lifted(ring(count)).value();
  std::vector<SpatialPhCurve<1>> segments;
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = half_roll * static_cast<double>(k);
    const Roll<double> roll{std::cos(angle), std::sin(angle)};
    const auto& curve = flat.segment(k);
    segments.emplace_back(curve.start(),
                          curve.preimage().mapped([&](const auto& a) { return a * roll; }), 1.0);
  }
  return SpatialPath<1>::create(flat.knots(), segments, true).value();
}

/// Sines and cosines of the ring and of the rolls, two products: a few roundings each.
constexpr double ring_tolerance = 32;

TEST(Holonomy, OfAFlatRingIsASignAlone) {
  const auto once = holonomy(lifted(ring(5)).value()).value();
  EXPECT_CLOSE(once.roll, 0.0, ring_tolerance, 1.0);
  EXPECT_EQ(once.sign, -1);
  const auto open = with_closure(ring(5), false).value();
  const auto twice = lifted(with_closure(joined(open, open).value(), true).value()).value();
  EXPECT_CLOSE(holonomy(twice).value().roll, 0.0, ring_tolerance, 1.0);
  EXPECT_EQ(holonomy(twice).value().sign, 1);
}

TEST(Holonomy, IsTheRollBetweenEndAndStart) {
  for (const double roll :
       {0.5, -0.5, 3.0, -3.0, 1e-7, 3.5, 6.0}) {  // not a tolerance: a small roll
    // The last segment of six is rolled by 5 half rolls.
    const auto path = rolled_ring(6, roll / 10);
    const auto found = holonomy(path).value();
    const double expected = roll > pi ? roll - 2 * pi : roll;
    EXPECT_CLOSE(found.roll, expected, ring_tolerance, 1.0);
    EXPECT_EQ(found.sign, roll > pi ? 1 : -1);

    const auto closing = closing_roll(path).value();
    const AdaptedFrame frame(path, closing);
    EXPECT_CLOSE(frame.at(path.xi_end()), frame.at(path.xi_begin()), ring_tolerance, 1.0);
    EXPECT_EQ(closing.angle(path.xi_begin()), 0.0);
    EXPECT_CLOSE(closing.angle(path.xi_end()), -expected, ring_tolerance, 1.0);
  }
}

TEST(Holonomy, HalfATurnIsPositive) {
  // conj(A_0) A_n = ±i exactly.
  const auto line_back = [](const Quaternion<double>& last) {
    const Quaternion<double> one{1, 0, 0, 0}, j{0, 0, 1, 0};
    const SpatialPhCurve<0> there({}, BernsteinPolynomial<Quaternion<double>, 0>({one}), 1.0);
    const SpatialPhCurve<0> back(there.end(), BernsteinPolynomial<Quaternion<double>, 0>({j}), 2.0);
    const SpatialPhCurve<0> again(back.end(), BernsteinPolynomial<Quaternion<double>, 0>({last}),
                                  1.0);
    return SpatialPath<0>::create({0.0, 1.0, 3.0, 4.0}, {there, back, again}, true).value();
  };
  const auto plus = holonomy(line_back({0, 1, 0, 0})).value();
  EXPECT_EQ(plus.roll, pi);
  EXPECT_EQ(plus.sign, 1);
  const auto minus = holonomy(line_back({0, -1, 0, 0})).value();
  EXPECT_EQ(minus.roll, pi);
  EXPECT_EQ(minus.sign, -1);
}

TEST(Holonomy, RefusesWhatDoesNotReturn) {
  Random random("holonomy refused");
  const auto open = random_path<SpatialPath<2>>(random, 2);
  ASSERT_FALSE(holonomy(open));
  EXPECT_EQ(holonomy(open).fault().code, FaultCode::unsupported);
  EXPECT_EQ(closing_roll(open).fault().code, FaultCode::unsupported);

  // There and back: it closes with the opposite tangent.
  const Quaternion<double> one{1, 0, 0, 0}, j{0, 0, 1, 0};
  const SpatialPhCurve<0> there({}, BernsteinPolynomial<Quaternion<double>, 0>({one}), 1.0);
  const SpatialPhCurve<0> back(there.end(), BernsteinPolynomial<Quaternion<double>, 0>({j}), 1.0);
  const auto cusp = SpatialPath<0>::create({0.0, 1.0, 2.0}, {there, back}, true).value();
  const auto found = holonomy(cusp);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.fault().code, FaultCode::not_continuous);
  EXPECT_EQ(found.fault().sentence.find("the end of the closed path meets its start at an angle of "
                                        "3.141592653589793 rad"),
            0U)
      << found.fault().sentence;
}

}  // namespace
}  // namespace hodograph
