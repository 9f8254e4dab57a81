// SPDX-License-Identifier: MIT
// Balls contain the results of all their members, series of balls the derivatives, and what cannot
// be decided is not decided.
#include "hodograph/certify/ball.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "hodograph/foundation/taylor.hpp"
#include "tests/support/random.hpp"
#include "tests/support/true_error.hpp"

namespace hodograph {
namespace {

using test::Random;
using test::Wide;

static_assert(Scalar<Ball>);
static_assert(Scalar<Taylor<Ball, 4>>);

bool contains(const Ball& ball, const Wide& x) {
  const Enclosure e = ball.enclosure();
  return Wide(e.lower()) <= x && x <= Wide(e.upper());
}

TEST(Ball, HoldsDoublesExactly) {
  Random rng("ball, exact doubles");
  for (int i = 0; i < 2000; ++i) {
    const double x = rng.hostile();
    EXPECT_EQ(Ball(x).midpoint(), x);
    EXPECT_TRUE(Ball(x).enclosure().contains(x));
    EXPECT_TRUE(Ball(x) == Ball(x));
  }
  EXPECT_TRUE(Ball(7) == Ball(7.0));
  EXPECT_TRUE(Ball(-3L) == Ball(-3.0));
  EXPECT_TRUE(Ball(9007199254740993LL) == Ball(9007199254740992.0) + Ball(1));
  EXPECT_FALSE(is_finite(Ball(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_EQ(Ball(std::numeric_limits<double>::infinity()).enclosure(), Enclosure::whole_line());
  EXPECT_TRUE(Ball().is_zero());
  EXPECT_TRUE(Ball(0.0).is_zero());
  EXPECT_FALSE(Ball(1.0).is_zero());
  EXPECT_FALSE(Ball(std::numeric_limits<double>::denorm_min()).is_zero());
  EXPECT_FALSE(Ball(0.0).widened(Ball(1.0)).is_zero());
  EXPECT_FALSE(Ball(std::numeric_limits<double>::infinity()).is_zero());
}

TEST(Ball, EnclosuresRoundOutwards) {
  Random rng("ball, enclosures");
  for (int i = 0; i < 2000; ++i) {
    const double a = rng.hostile(), b = rng.hostile();
    const Enclosure given(std::min(a, b), std::max(a, b));
    const Enclosure back = Ball(given).enclosure();
    EXPECT_LE(back.lower(), given.lower());
    EXPECT_GE(back.upper(), given.upper());
  }
  EXPECT_FALSE(is_finite(Ball(Enclosure::whole_line())));
}

TEST(Ball, CopiesAndMoves) {
  std::vector<Ball> balls;
  for (int i = 0; i < 100; ++i) balls.push_back(sqrt(Ball(i)));
  const Ball copy = balls[2];
  Ball moved = std::move(balls[2]);
  EXPECT_TRUE(copy.enclosure() == moved.enclosure());
  moved = copy * copy;
  EXPECT_TRUE(contains(moved, Wide(2)));
  // Exponents that no longer fit the object are freed too (run under a leak checker).
  Ball huge = exp(exp(Ball(100.0)));
  for (int i = 0; i < 8; ++i) huge = huge * huge;
  EXPECT_EQ(huge.enclosure(), Enclosure::whole_line());
  Ball tiny = Ball(1) / huge;
  EXPECT_TRUE(tiny.enclosure().contains(0.0));
  EXPECT_FALSE(tiny.is_zero());
}

TEST(Ball, FunctionsContainTheTruth) {
  Random rng("ball, functions");
  for (int i = 0; i < 500; ++i) {
    const double x = rng.uniform(0.0625, 0.9375),
                 radius = std::ldexp(1.0, -static_cast<int>(rng.integer(5, 60)));
    const Ball ball = Ball(x).widened(Ball(radius));
    const Wide member = Wide(x) + Wide(rng.uniform(-1.0, 1.0)) * Wide(radius);
    EXPECT_TRUE(contains(sqrt(ball), sqrt(member)));
    EXPECT_TRUE(contains(exp(ball), exp(member)));
    EXPECT_TRUE(contains(log(ball), log(member)));
    EXPECT_TRUE(contains(sin(ball), sin(member)));
    EXPECT_TRUE(contains(cos(ball), cos(member)));
    EXPECT_TRUE(contains(tan(ball), tan(member)));
    EXPECT_TRUE(contains(sinh(ball), sinh(member)));
    EXPECT_TRUE(contains(cosh(ball), cosh(member)));
    EXPECT_TRUE(contains(tanh(ball), tanh(member)));
    EXPECT_TRUE(contains(atan(ball), atan(member)));
    EXPECT_TRUE(contains(asin(ball), asin(member)));
    EXPECT_TRUE(contains(acos(ball), acos(member)));
    EXPECT_TRUE(contains(atan2(ball, Ball(-0.5)), atan2(member, Wide(-0.5))));
    EXPECT_TRUE(contains(atan2(-ball, Ball(0.5)), atan2(Wide(-member), Wide(0.5))));
    EXPECT_TRUE(contains(pow(ball, 7), pow(member, 7)));
    EXPECT_TRUE(contains(pow(ball, -3), Wide(1) / pow(member, 3)));
    EXPECT_TRUE(contains(pow(ball, Ball(2.5)), pow(member, Wide(2.5))));
    EXPECT_TRUE(contains(abs(-ball), member));
    EXPECT_TRUE(contains((ball + Ball(3)) * (ball - Ball(2)) / ball,
                         Wide((member + 3) * (member - 2) / member)));
  }
}

TEST(Ball, KnowsWhatItDoesNotKnow) {
  const Ball around_zero = Ball(0.0).widened(Ball(0.5));
  EXPECT_FALSE(is_finite(Ball(1) / around_zero));
  EXPECT_FALSE(is_finite(sqrt(around_zero)));
  EXPECT_FALSE(is_finite(log(around_zero)));
  EXPECT_FALSE(is_finite(atan2(around_zero, Ball(-1))));
  EXPECT_TRUE(is_finite(atan2(around_zero, Ball(1))));
  EXPECT_TRUE(Ball(-1) < around_zero);
  EXPECT_TRUE(around_zero < Ball(1));
  EXPECT_FALSE(Ball(1) < around_zero);
  EXPECT_TRUE(Ball(1) <= Ball(1));
  EXPECT_FALSE(Ball(1) < Ball(1));
  EXPECT_THROW((void)(around_zero < Ball(0.25)), UndecidedComparison);
  EXPECT_THROW((void)(around_zero > Ball(0.25)), UndecidedComparison);
  EXPECT_THROW((void)(around_zero <= Ball(0.25)), UndecidedComparison);
  EXPECT_THROW((void)(around_zero == Ball(0.25)), UndecidedComparison);
  EXPECT_THROW((void)(Ball(std::numeric_limits<double>::quiet_NaN()) < Ball(1)),
               UndecidedComparison);
}

TEST(Ball, SeriesContainTheDerivatives) {
  // f = exp(sin(3ξ)) / (2 + cos ξ) + sqrt(ξ) log(ξ) - atan(ξ), against 60 digits, at members of a
  // ball.
  const auto f = [](const auto& xi) {
    using S = std::remove_cvref_t<decltype(xi)>;
    return exp(sin(S(3) * xi)) / (S(2) + cos(xi)) + sqrt(xi) * log(xi) - atan(xi);
  };
  Random rng("ball, series");
  for (int i = 0; i < 50; ++i) {
    const double x = rng.uniform(0.5, 3.0),
                 radius = std::ldexp(1.0, -static_cast<int>(rng.integer(4, 40)));
    const auto series = f(Taylor<Ball, 10>::variable(Ball(x).widened(Ball(radius))));
    const Wide member = Wide(x) + Wide(rng.uniform(-1.0, 1.0)) * Wide(radius);
    const auto truth = f(Taylor<Wide, 10>::variable(member));
    for (std::size_t k = 0; k <= 10; ++k) EXPECT_TRUE(contains(series[k], truth[k])) << k;
  }
}

}  // namespace
}  // namespace hodograph
