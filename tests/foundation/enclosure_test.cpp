// SPDX-License-Identifier: MIT
// Enclosure arithmetic: the true result, by ball arithmetic, is never outside.
#include "hodograph/foundation/enclosure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "support/arb_judge.hpp"
#include "support/random.hpp"

namespace hodograph {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double least_normal = std::numeric_limits<double>::min();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

TEST(Enclosure, IsTheWholeLineWhereItIsNoInterval) {
  for (const Enclosure& e : {Enclosure(not_a_number), Enclosure(infinity), Enclosure(-infinity),
                             Enclosure(1.0, 0.0), Enclosure(not_a_number, 1.0),
                             Enclosure(0.0, not_a_number), Enclosure(infinity, infinity)}) {
    EXPECT_EQ(e, Enclosure::whole_line());
    EXPECT_FALSE(is_finite(e));
    EXPECT_EQ(e.middle(), 0.0);
    EXPECT_EQ(e.mignitude(), 0.0);
    EXPECT_EQ(e.magnitude(), infinity);
  }
  EXPECT_TRUE(Enclosure(-largest, largest).is_bounded());
  EXPECT_EQ(Enclosure(-largest, largest).middle(), 0.0);
  EXPECT_EQ(Enclosure(1.0, infinity).middle(), 0.5 + largest / 2);
}

TEST(Enclosure, NeverHasAnEndThatIsNotANumber) {
  test::Random random("enclosure: unbounded operands");
  std::vector<Enclosure> operands = {Enclosure::whole_line(),
                                     {0.0, infinity},
                                     {-infinity, 0.0},
                                     {1.0, infinity},
                                     {-infinity, -1.0},
                                     {-largest, largest},
                                     {largest, largest},
                                     {-largest, -largest},
                                     {0.0, 0.0},
                                     {-smallest, smallest},
                                     {0.0, smallest},
                                     {largest, infinity},
                                     {-infinity, -largest},
                                     {1.0, 1.0}};
  for (int i = 0; i < 30; ++i) operands.push_back(Enclosure(random.hostile()));
  for (const Enclosure& a : operands) {
    for (const Enclosure& b : operands) {
      for (const Enclosure& e : {a + b, a - b, a * b, a / b, square(a), sqrt(a), abs(a), -a}) {
        EXPECT_LE(e.lower(), e.upper());
        EXPECT_LT(e.lower(), infinity);
        EXPECT_LT(-infinity, e.upper());
        EXPECT_FALSE(std::isnan(e.middle()));
        EXPECT_FALSE(std::isnan(e.width()));
      }
    }
  }
}

TEST(Enclosure, StepsOutwardsByOneOrTwoUlps) {
  test::Random random("enclosure: outward step");
  for (int i = 0; i < 100000; ++i) {
    const double x = random.hostile();
    const double above = std::nextafter(x, infinity), below = std::nextafter(x, -infinity);
    ASSERT_GE(Enclosure::up(x), above) << x;
    ASSERT_LE(Enclosure::down(x), below) << x;
    ASSERT_LE(Enclosure::up(x), std::nextafter(std::nextafter(above, infinity), infinity)) << x;
  }
  EXPECT_EQ(Enclosure::down(infinity), largest);
  EXPECT_EQ(Enclosure::up(-infinity), -largest);
}

TEST(Enclosure, KeepsExactZerosAndSigns) {
  const Enclosure zero(0.0), a(1.0, 3.0);
  EXPECT_EQ(zero + a, a);
  EXPECT_EQ(a - zero, a);
  EXPECT_EQ(zero - a, -a);
  EXPECT_EQ(zero * a, zero);
  EXPECT_EQ(zero / a, zero);
  EXPECT_EQ(square(zero), zero);
  EXPECT_EQ(sqrt(zero), zero);
  EXPECT_EQ(Enclosure(7.0) - Enclosure(7.0), zero);
  EXPECT_EQ((Enclosure(smallest) * Enclosure(smallest)).lower(), 0.0);
  EXPECT_GT((Enclosure(smallest) * Enclosure(smallest)).upper(), 0.0);
  EXPECT_EQ((Enclosure(0.0, 2.0) * Enclosure(-3.0, 0.0)).upper(), 0.0);
  EXPECT_EQ((Enclosure(-2.0, 0.0) / Enclosure(-3.0, -1.0)).lower(), 0.0);
  EXPECT_EQ(zero.width(), 0.0);
}

TEST(Enclosure, IsUnboundedOrWholeWhereTheResultOverflows) {
  const Enclosure big(largest);
  EXPECT_EQ((big + big).lower(), largest);
  EXPECT_EQ((big + big).upper(), infinity);
  EXPECT_EQ((big * big).lower(), largest);
  EXPECT_EQ((-big * big).upper(), -largest);
  EXPECT_EQ(big / Enclosure(0.0, 1.0), Enclosure::whole_line());
  EXPECT_EQ((big / Enclosure(least_normal)).lower(), largest);
  EXPECT_EQ(sqrt(Enclosure(-2.0, -1.0)), Enclosure::whole_line());
}

#if HODOGRAPH_TEST_HAS_ARB

using test::encloses;
using test::Judge;

/// A random interval and a number inside it.
struct Sample {
  Enclosure interval;
  double member;
};
Sample sample(test::Random& random) {
  const double a = random.hostile();
  if (random.chance(0.3)) return {Enclosure(a), a};
  const double b = random.chance(0.3) ? random.near(a, 4) : random.hostile();
  const double low = std::min(a, b), high = std::max(a, b);
  const double inside = 0.5 * low + 0.5 * high;
  const double choices[] = {low, high, std::clamp(inside, low, high)};
  return {Enclosure(low, high), choices[random.index(3)]};
}

TEST(Enclosure, ContainsTheTrueResultOnHostileNumbers) {
  test::Random random("enclosure: hostile operands");
  for (int i = 0; i < 200000; ++i) {
    const Sample a = sample(random), b = sample(random);
    const Judge x(a.member), y(b.member);
    ASSERT_TRUE(encloses(a.interval + b.interval, x + y)) << a.member << " + " << b.member;
    ASSERT_TRUE(encloses(a.interval - b.interval, x - y)) << a.member << " - " << b.member;
    ASSERT_TRUE(encloses(a.interval * b.interval, x * y)) << a.member << " * " << b.member;
    if (b.member != 0.0) {
      ASSERT_TRUE(encloses(a.interval / b.interval, x / y)) << a.member << " / " << b.member;
    }
    ASSERT_TRUE(encloses(square(a.interval), x * x)) << a.member;
    ASSERT_TRUE(encloses(abs(a.interval), abs(x))) << a.member;
    if (a.member >= 0.0) {
      ASSERT_TRUE(encloses(sqrt(a.interval), sqrt(x))) << a.member;
    }
  }
}

TEST(Enclosure, IsAFewUlpsWideOnOrdinaryNumbers) {
  test::Random random("enclosure: tightness");
  constexpr double width_in_ulps = 4.0;  // two steps of at most two ulps each
  constexpr double ulp = std::numeric_limits<double>::epsilon();
  for (int i = 0; i < 20000; ++i) {
    const double x = random.spread(-100, 100), y = random.spread(-100, 100);
    for (const Enclosure& e :
         {Enclosure(x) + Enclosure(y), Enclosure(x) - Enclosure(y), Enclosure(x) * Enclosure(y),
          Enclosure(x) / Enclosure(y), sqrt(Enclosure(std::abs(x))), square(Enclosure(x))}) {
      ASSERT_LE(e.width(), width_in_ulps * ulp * e.magnitude()) << x << " " << y;
    }
  }
}

TEST(Enclosure, ContainsTheResultOfLongRandomExpressions) {
  test::Random random("enclosure: expressions");
  for (int i = 0; i < 2000; ++i) {
    Enclosure e(random.spread(-3, 3));
    Judge x(e.lower());
    for (int step = 0; step < 40; ++step) {
      const double y = random.spread(-2, 2);
      switch (random.integer(0, 4)) {
        case 0:
          e = e + y;
          x = x + Judge(y);
          break;
        case 1:
          e = Enclosure(y) - e;
          x = Judge(y) - x;
          break;
        case 2:
          e = e * Enclosure(y);
          x = x * Judge(y);
          break;
        case 3:
          e = square(e);
          x = x * x;
          break;
        default:
          if (e.mignitude() > 0.0) {
            e = Enclosure(y) / e;
            x = Judge(y) / x;
          }
      }
      ASSERT_TRUE(encloses(e, x));
      if (!(e.magnitude() < 4096.0)) {
        e = e / Enclosure(4096.0);
        x = x / Judge(4096.0);
      }
    }
  }
}

#endif  // HODOGRAPH_TEST_HAS_ARB

}  // namespace
}  // namespace hodograph
