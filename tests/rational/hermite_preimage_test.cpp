// SPDX-License-Identifier: MIT
// Rational directions, and preimages between them.
#include "hodograph/rational/hermite_preimage.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "hodograph/rational/cusp_free.hpp"
#include "hodograph/rational/motion_polynomial.hpp"
#include "support/rational_golden.hpp"

namespace hodograph {
namespace {

using test::Random;

Rational small(Random& random) { return {random.integer(-9, 9), random.integer(1, 5)}; }
RationalVector small_vector(Random& random) {
  return {small(random), small(random), small(random)};
}
/// A random rational point of the unit sphere.
RationalVector unit_vector(Random& random) {
  const Rational p = small(random), q = small(random);
  const Rational scale = Rational(1) / (Rational(1) + p * p + q * q);
  return {(Rational(1) - p * p - q * q) * scale, Rational(2) * p * scale, Rational(2) * q * scale};
}
bool parallel(const RationalVector& a, const RationalVector& b) {
  return cross(a, b) == RationalVector{} && dot(a, b).sign() > 0;
}

TEST(RationalDirection, IsExactWhereTheLengthIsRational) {
  const RationalDirection d =
      rational_direction({Rational(1, 3), Rational(2, 3), Rational(-2, 3)}).value();
  EXPECT_TRUE(d.exact);
  EXPECT_EQ(d.length, Rational(1));
  EXPECT_EQ(d.deviation, 0.0);
  EXPECT_EQ(rational_direction({30, 40, 0}).value().unit,
            (RationalVector{Rational(3, 5), Rational(4, 5), 0}));
}

TEST(RationalDirection, ReplacesIrrationalOnesWithinTheBound) {
  Random random("irrational directions");
  for (int i = 0; i < 200; ++i) {
    const RationalVector v = small_vector(random);
    const auto bits = static_cast<long>(random.integer(1, 60));
    const auto d = rational_direction(v, bits);
    if (v == RationalVector{}) {
      EXPECT_EQ(d.fault().code, FaultCode::zero_speed);
      continue;
    }
    EXPECT_EQ(dot(d->unit, d->unit), Rational(1));
    EXPECT_GT(dot(d->unit, v).sign(), 0);
    EXPECT_EQ(d->exact, cross(d->unit, v) == RationalVector{});
    EXPECT_LE(d->deviation, std::ldexp(1.0, -static_cast<int>(bits)));
    EXPECT_EQ(d->deviation == 0.0, d->exact);
  }
  EXPECT_EQ(rational_direction({1, 1, 0}, 0).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(rational_direction({1, 1, 0}, 61).fault().code, FaultCode::outside_domain);
}

TEST(DirectionPreimage, TurnsTheTangentToTheDirection) {
  Random random("preimages of directions");
  for (int i = 0; i < 100; ++i) {
    const RationalVector unit = i == 0 ? RationalVector{-1, 0, 0} : unit_vector(random);
    const Quaternion<Rational> a = direction_preimage(unit);
    EXPECT_TRUE(parallel(sandwich(a, RationalVector{1, 0, 0}), unit));
    for (std::size_t c = 0; c < 4; ++c) EXPECT_TRUE(a[c].is_integer());
  }
}

TEST(DirectionPreimage, HasTheDirectionsAtTheEndsWhateverIsFree) {
  Random random("free factors");
  for (int i = 0; i < 100; ++i) {
    const RationalVector first = unit_vector(random), last = unit_vector(random);
    PreimageFreedom freedom{small(random), small(random), {}};
    if (freedom.factor_re.is_zero()) freedom.factor_re = 1;
    for (std::size_t k = random.index(4); k > 0; --k) {
      freedom.inner.push_back({small(random), small(random), small(random), small(random)});
    }
    const Rational begin = small(random), end = begin + Rational(random.integer(1, 9), 2);
    const auto a = preimage_between(first, last, freedom, begin, end).value();
    EXPECT_TRUE(parallel(value(indicatrix(a), begin), first));
    EXPECT_TRUE(parallel(value(indicatrix(a), end), last));
  }
  EXPECT_EQ(preimage_between({1, 0, 0}, {1, 0, 0}, {0, 0, {}}).fault().code,
            FaultCode::outside_domain);
  EXPECT_EQ(preimage_between({1, 0, 0}, {1, 0, 0}, {}, 1, 1).fault().code,
            FaultCode::not_increasing);
}

/// A curve between the ends, of any degree up to 12, in a space of polynomial or rational curves.
void expect_curve(const HermiteEnds& ends, bool derivatives) {
  const auto chosen = chosen_preimage(ends);
  ASSERT_TRUE(chosen) << chosen.fault().sentence;
  EXPECT_EQ(chosen->cone.outcome, ConeTest::Outcome::inside);
  RationalHermiteData data{{0, 0, 0}, ends.chord, {}, {}, ends.begin, ends.end};
  if (derivatives) {
    data.begin_derivative = *ends.begin_speed * ends.begin_direction;
    data.end_derivative = *ends.end_speed * ends.end_direction;
  }
  const SpaceSearch search{RationalPolynomial{Rational(1) - ends.begin, 1}, 0, 1, 16, {}};
  const DegreeSearch found = smallest_cusp_free(chosen->preimage, data, search).value();
  ASSERT_TRUE(found.found) << found.sentence;
  const RationalPhCurve& curve = *found.found->answer.curve;
  EXPECT_EQ(curve.position().value(ends.begin), (RationalVector{0, 0, 0}));
  EXPECT_EQ(curve.position().value(ends.end), ends.chord);
  EXPECT_TRUE(parallel(curve.position().derivative().value(ends.begin), ends.begin_direction));
  EXPECT_TRUE(parallel(curve.position().derivative().value(ends.end), ends.end_direction));
}

TEST(ChosenPreimage, LeadsToCuspFreeCurves) {
  Random random("chosen preimages");
  for (int i = 0; i < 25; ++i) {
    HermiteEnds ends{small_vector(random), unit_vector(random), unit_vector(random)};
    if (ends.chord == RationalVector{}) continue;
    SCOPED_TRACE(i);
    if (i % 3 == 0) {
      ends.begin_speed = ends.end_speed = taxicab_length(ends.chord);
    }
    expect_curve(ends, i % 3 == 0);
  }
}

TEST(ChosenPreimage, LeavesThePlaneWhereReplacedDirectionsAlmostLieInOne) {
  // (3, 1, 1) = 2 (1, 1, 0) + (1, -1, 1), two directions of irrational length.
  const HermiteEnds ends{{3, 1, 1},
                         rational_direction({1, 1, 0}).value().unit,
                         rational_direction({1, -1, 1}).value().unit};
  expect_curve(ends, false);
  const RationalHermiteData data{{}, ends.chord, {}, {}};
  const DegreeSearch found =
      smallest_cusp_free(chosen_preimage(ends).value().preimage, data, {1, 0, 0, 7, {}}).value();
  EXPECT_TRUE(found.found) << found.sentence;
}

TEST(ChosenPreimage, MeetsHostileData) {
  const RationalVector i{1, 0, 0}, j{0, 1, 0};
  // Straight, along i and against it; planar; tangents opposite to each other and to the chord.
  expect_curve({{3, 0, 0}, i, i}, false);
  expect_curve({{-3, 0, 0}, -i, -i}, false);
  expect_curve({{3, 1, 0}, i, i}, false);
  expect_curve({{3, 1, 0}, i, j}, false);
  expect_curve({{3, 1, 1}, i, -i}, false);
  expect_curve({{3, 1, 0}, -i, -i}, false);
  // A closed curve.
  expect_curve({{0, 0, 0}, i, j}, false);
  expect_curve({{0, 0, 0}, i, -i}, false);
  EXPECT_EQ(chosen_preimage({{1, 0, 0}, i, j, {}, {}, 2, 2}).fault().code,
            FaultCode::not_increasing);
  EXPECT_EQ(chosen_preimage({{1, 0, 0}, i, j, Rational(0), {}}).fault().code,
            FaultCode::zero_speed);
  const Rational huge = Rational::parse("1" + std::string(400, '0')).value();
  EXPECT_EQ(chosen_preimage({{huge, 0, 0}, i, j}).fault().code, FaultCode::outside_domain);
}

}  // namespace
}  // namespace hodograph
