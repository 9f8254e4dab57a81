// SPDX-License-Identifier: MIT
// The path type itself: how one is made or refused, where its parameters lie, what a knot belongs
// to.
#include "hodograph/path/path.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

using test::Random;
using test::random_path;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

using Line = PlanarPath<0>;

/// A straight piece along x at speed 1.
PlanarPhCurve<0> piece(double x, double step) {
  return {{x, 0}, BernsteinPolynomial<Complex<double>, 0>({Complex<double>{1, 0}}), step};
}

void expect_refused(const Result<Line>& path, FaultCode code, const std::string& sentence) {
  ASSERT_FALSE(path);
  EXPECT_EQ(name_of(path.fault().code), name_of(code));
  EXPECT_EQ(path.fault().sentence, sentence);
}

TEST(Path, RefusesWhatIsNoPath) {
  expect_refused(Line::create({}, {}, false), FaultCode::too_few,
                 "a path needs at least one segment; got none");
  expect_refused(Line::create({0, 1}, {piece(0, 1), piece(1, 1)}, false),
                 FaultCode::mismatched_size, "2 segments need 3 knots; got 2");
  expect_refused(Line::create({0, not_a_number}, {piece(0, 1)}, false), FaultCode::not_finite,
                 "knot 1 is not a finite number");
  expect_refused(Line::create({0, 1, 1}, {piece(0, 1), piece(1, 1)}, false),
                 FaultCode::not_increasing, "knots must increase strictly; knot 2 is 1 after 1");
  expect_refused(Line::create({0, 2}, {piece(0, 1)}, false), FaultCode::not_increasing,
                 "segment 0 covers a parameter step of 1 between knots 2 apart");
  expect_refused(Line::create({0, 1}, {piece(infinity, 1)}, false), FaultCode::not_finite,
                 "segment 0 has a coefficient that is infinite or not a number");
  const auto torn = Line::create({0, 1, 2}, {piece(0, 1), piece(1.5, 1)}, false);
  ASSERT_FALSE(torn);
  EXPECT_EQ(torn.fault().code, FaultCode::not_continuous);
  EXPECT_EQ(torn.fault().index, 1U);
  EXPECT_EQ(torn.fault().value, 0.5);
  const auto not_closed = Line::create({0, 1}, {piece(0, 1)}, true);
  ASSERT_FALSE(not_closed);
  EXPECT_EQ(not_closed.fault().code, FaultCode::not_continuous);
  EXPECT_EQ(not_closed.fault().index, 0U);
}

TEST(Path, AGapOfRoundingIsNoGap) {
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_TRUE(Line::create({0, 1, 2}, {piece(0, 1), piece(next, 1)}, false));
  // Seen from far away a larger gap is rounding.
  const double far = std::ldexp(1.0, 40);
  EXPECT_TRUE(
      Line::create({0, 1, 2}, {piece(far, 1), piece(far + 1 + std::ldexp(1.0, -10), 1)}, false));
}

TEST(Path, AKnotBelongsToTheLaterSegmentAndTheLastToTheLast) {
  const auto path = Line::create({0, 1, 3}, {piece(0, 1), piece(1, 2)}, false).value();
  EXPECT_EQ(path.locate(0).segment, 0U);
  EXPECT_EQ(path.locate(1).segment, 1U);
  EXPECT_EQ(path.locate(1).u, 0.0);
  EXPECT_EQ(path.locate(3).segment, 1U);
  EXPECT_EQ(path.locate(3).u, 1.0);
  EXPECT_EQ(path.segment_at_arc_length(1), 1U);
  EXPECT_EQ(path.knot_arc_lengths(), (std::vector<double>{0, 1, 3}));
}

TEST(Path, LocatesLikeALinearSearchOnAnyKnots) {
  Random random("locate");
  for (int repeat = 0; repeat < 20; ++repeat) {
    // Steps over 12 powers of two.
    std::vector<double> knots{random.uniform(-4.0, 4.0)};
    std::vector<PlanarPhCurve<0>> pieces;
    double x = 0.0;
    for (int k = 0; k < 60; ++k) {
      knots.push_back(knots.back() + std::abs(random.spread(-8, 4)));
      pieces.push_back(piece(x, knots.back() - knots[knots.size() - 2]));
      x = pieces.back().end().x;
    }
    const auto path = Line::create(knots, pieces, false).value();
    for (int draw = 0; draw < 200; ++draw) {
      const double any = random.uniform(knots.front(), knots.back());
      const double xi = path.clamped(draw % 4 == 0 ? random.near(knots[random.index(61)]) : any);
      std::size_t k = 0;
      while (k + 2 < knots.size() && knots[k + 1] <= xi) ++k;
      const auto at = path.locate(xi);
      EXPECT_EQ(at.segment, k);
      EXPECT_GE(at.u, 0.0);
      EXPECT_LE(at.u, 1.0);
      // u is rounded twice, and carries the step.
      EXPECT_CLOSE(path.xi_of(at), xi, 2.0, std::abs(xi) + path.segment(k).parameter_step());
    }
  }
}

TEST(Path, OutsideTheKnotsIsAnErrorUnlessClampedOrWrapped) {
  const auto path = Line::create({1, 2, 4}, {piece(0, 1), piece(1, 2)}, false).value();
  for (const double xi : {0.5, 4.5, not_a_number, infinity, -infinity}) {
    EXPECT_THROW((void)path.position(xi), Error);
    EXPECT_THROW((void)path.arc_length(xi), Error);
    EXPECT_THROW((void)path.preimage(xi), Error);
  }
  EXPECT_THROW((void)path.segment_at_arc_length(-1), Error);
  try {
    (void)path.position(0.5);
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "path parameter xi 0.5 is outside [1, 4]");
    EXPECT_EQ(error.fault().bound, 1.0);
  }
  EXPECT_EQ(path.clamped(0.5), 1.0);
  EXPECT_EQ(path.clamped(9), 4.0);
  EXPECT_EQ(path.clamped(3), 3.0);
  EXPECT_EQ(path.wrapped(4), 1.0);
  EXPECT_EQ(path.wrapped(5.5), 2.5);
  EXPECT_EQ(path.wrapped(-0.5), 2.5);
  EXPECT_EQ(path.wrapped(2.5), 2.5);
}

TEST(Path, ManyShortSegmentsAddUpToTheLength) {
  // A hundred thousand tenths: plain summation would miss by about 1e-8.
  const std::size_t count = 100000;
  std::vector<double> knots{0.0};
  std::vector<PlanarPhCurve<0>> pieces;
  long double expected = 0.0L;
  double x = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    knots.push_back(0.1 * static_cast<double>(k + 1));
    pieces.push_back(piece(x, knots[k + 1] - knots[k]));
    expected += pieces.back().arc_length();
    x = pieces.back().end().x;
  }
  const auto path = Line::create(knots, pieces, false).value();
  EXPECT_CLOSE(path.arc_length(), expected, 1.0, 10000.0L);
}

TEST(Path, IsAValue) {
  Random random("path value");
  const auto path = random_path<SpatialPath<2>>(random, 2);
  auto copy = path;
  EXPECT_EQ(copy, path);
  copy = random_path<SpatialPath<2>>(random, 2);
  EXPECT_FALSE(copy == path);
  EXPECT_FALSE(path.is_closed());
  EXPECT_TRUE(test::ring(5).is_closed());
  EXPECT_GT(path.memory(), path.coefficient_memory());
}

}  // namespace
}  // namespace hodograph
