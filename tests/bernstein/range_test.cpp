// SPDX-License-Identifier: MIT
// Extremes of polynomials, norms and quotients: refined as asked, and never past a true value.
#include "hodograph/bernstein/range.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/arb_judge.hpp"
#include "support/random.hpp"

namespace hodograph {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double ulp = std::numeric_limits<double>::epsilon();

TEST(Range, IsExactForAConstantAndALine) {
  EXPECT_EQ(extremes(BernsteinPolynomial<double, 0>({3.0}), {0.0}).range(), Enclosure(3.0));
  EXPECT_EQ(extremes(BernsteinPolynomial<double, 1>({-1.0, 2.0}), {0.0}),
            (Extremes{Enclosure(-1.0), Enclosure(2.0)}));
  EXPECT_EQ(coefficient_hull(BernsteinPolynomial<double, 2>({1.0, -5.0, 2.0})),
            Enclosure(-5.0, 2.0));
}

TEST(Range, IsRefinedAsFarAsAsked) {
  // (2u - 1)² + 1: minimum 1, maximum 2; coefficients 2, 0, 2.
  const BernsteinPolynomial<double, 2> f({2.0, 0.0, 2.0});
  for (int bits = 4; bits <= 44; bits += 4) {
    const double width = std::exp2(-bits);
    const Extremes found = extremes(f, {width});
    EXPECT_TRUE(found.minimum.contains(1.0));
    EXPECT_LE(found.minimum.width(), 2 * width) << bits;
    EXPECT_TRUE(found.maximum.contains(2.0));
  }
  // Width 0 ends at rounding.
  EXPECT_LE(extremes(f, {0.0}).minimum.width(), 64 * ulp);
  // A double zero.
  const BernsteinPolynomial<double, 2> square({1.0, -1.0, 1.0});
  const Enclosure zero = extremes(square, {0.0}).minimum;
  EXPECT_TRUE(zero.contains(0.0));
  EXPECT_LE(zero.width(), 64 * ulp);
}

TEST(Range, StopsAtTheWorkLimit) {
  const BernsteinPolynomial<double, 2> f({2.0, 0.0, 2.0});
  const Extremes none = extremes(f, {0.0, 0});
  EXPECT_EQ(none.minimum, Enclosure(0.0, 2.0));
  const Extremes one = extremes(f, {0.0, 1});
  EXPECT_TRUE(one.minimum.contains(1.0));
}

TEST(Range, OfANormAndAQuotient) {
  // (cos, sin)-like: |(1 - u², 2u)| = 1 + u².
  const BernsteinPolynomial<Vector2<double>, 2> v(
      {Vector2<double>{1.0, 0.0}, {1.0, 1.0}, {0.0, 2.0}});
  const double width = std::numeric_limits<float>::epsilon();
  const Extremes norm = norm_extremes(v, {width});
  EXPECT_TRUE(norm.minimum.contains(1.0) && norm.maximum.contains(2.0));
  EXPECT_LE(norm.minimum.width(), width);
  // u/(1 + u²) has its largest value 1/2 at 1.
  const BernsteinPolynomial<double, 1> u({0.0, 1.0});
  const BernsteinPolynomial<double, 2> g({1.0, 1.0, 2.0});
  const auto quotient = [&](std::size_t) { return BernsteinQuotient::of(u, g).times(4.0); };
  const Extremes found = extremes(1, quotient, RangeMeasure::value, {width});
  EXPECT_TRUE(found.minimum.contains(0.0) && found.maximum.contains(2.0));
  EXPECT_LE(found.maximum.width(), 4 * width);
}

TEST(Range, IsInfiniteWhereTheDenominatorVanishes) {
  const BernsteinPolynomial<double, 2> one({1.0, 1.0, 1.0}), touching({1.0, -1.0, 1.0});
  const auto quotient = [&](std::size_t) { return BernsteinQuotient::of(one, touching); };
  for (const RangeMeasure measure : {RangeMeasure::value, RangeMeasure::norm}) {
    const Extremes found = extremes(1, quotient, measure, {0.125});
    EXPECT_EQ(found.maximum.upper(), infinity);
    EXPECT_GT(found.maximum.lower(), 1.0);
  }
  // Coefficients that are no numbers: everything is possible, nothing is NaN.
  const BernsteinPolynomial<double, 1> bad({std::numeric_limits<double>::quiet_NaN(), 1.0});
  EXPECT_EQ(extremes(bad, {0.125}).range(), Enclosure::whole_line());
}

#if HODOGRAPH_TEST_HAS_ARB

using test::encloses;
using test::Judge;

template <std::size_t n>
Judge exact_value(const BernsteinPolynomial<double, n>& f, double u) {
  const Judge t(u), v = Judge(1.0) - t;
  std::vector<Judge> point;
  for (std::size_t i = 0; i <= n; ++i) point.push_back(Judge(f[i]));
  for (std::size_t left = n; left > 0; --left) {
    for (std::size_t i = 0; i < left; ++i) point[i] = v * point[i] + t * point[i + 1];
  }
  return point[0];
}

template <std::size_t n>
void check_random(test::Random& random) {
  BernsteinPolynomial<double, n> f;
  for (std::size_t i = 0; i <= n; ++i) {
    f[i] = random.chance(0.1) ? random.hostile() : random.uniform(-1.0, 1.0);
  }
  const double width = std::exp2(-static_cast<double>(random.integer(1, 50)));
  const Extremes found = extremes(f, {width});
  double least = infinity, greatest = -infinity;
  for (int i = 0; i <= 50; ++i) {
    const double u = i == 50 ? 1.0 : random.unit();
    const Judge value = exact_value(f, u);
    EXPECT_TRUE(encloses(found.range(), value)) << "degree " << n << " at " << u;
    least = std::min(least, value.approximately());
    greatest = std::max(greatest, value.approximately());
  }
  // What is said to be attained is not beyond what is possible.
  EXPECT_LE(found.minimum.lower(), least);
  EXPECT_GE(found.maximum.upper(), greatest);
  EXPECT_GE(found.maximum.lower(), found.minimum.lower());
}

TEST(Range, HoldsEveryValueOfRandomAndHostilePolynomials) {
  test::Random random("range: random");
  for (int i = 0; i < test::cases(60); ++i) {
    check_random<1>(random);
    check_random<4>(random);
    check_random<17>(random);
    check_random<33>(random);
  }
}

#endif  // HODOGRAPH_TEST_HAS_ARB

}  // namespace
}  // namespace hodograph
