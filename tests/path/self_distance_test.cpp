// SPDX-License-Identifier: MIT
// The distance of a path to itself and the largest tube round it: known shapes, Federer's quotient
// over all pairs of samples, moved and scaled paths, corners, standstills, refusals.
#include "hodograph/path/self_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/construction/hermite.hpp"
#include "hodograph/foundation/taylor.hpp"
#include "hodograph/path/operations.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/curves.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr RangeGoal fine{0x1.0p-20, 1 << 20};  // a millionth, and as much work as it takes
/// Where all points at the least separation are equally near, work grows like 1/relative_width.
constexpr RangeGoal rough{0x1.0p-10, 1 << 16};

/// The least of Federer's quotient |q - p|²/(2 dist(q, tangent cone at p)) over samples, and the
/// least distance of samples at least `separation` apart: both from above.
struct Sampled {
  double reach = infinity, distance = infinity;
};
template <class P>
Sampled sampled(const P& path, std::size_t count, double separation) {
  using Point = typename P::Point;
  std::vector<Point> points, tangents;
  std::vector<double> lengths;
  for (std::size_t i = 0; i <= count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count);
    const double xi = path.clamped(path.xi_begin() + share * (path.xi_end() - path.xi_begin()));
    const auto d = path.template position_derivatives<1>(xi);
    points.push_back(d[0]);
    tangents.push_back((1.0 / std::sqrt(dot(d[1], d[1]))) * d[1]);
    lengths.push_back(path.arc_length(xi));
  }
  Sampled result;
  for (std::size_t i = 0; i <= count; ++i) {
    for (std::size_t j = 0; j <= count; ++j) {
      if (i == j) continue;
      const Point chord = points[j] - points[i];
      const double square = dot(chord, chord), along = dot(chord, tangents[i]);
      double apart = std::abs(lengths[j] - lengths[i]);
      if (path.is_closed()) apart = std::min(apart, path.arc_length() - apart);
      // Near the diagonal the quotient is one of rounding; there the curvature bounds it.
      constexpr double near = 1e-3;
      if (apart < near * path.arc_length()) continue;
      const bool behind =
          !path.is_closed() && ((i == 0 && along < 0.0) || (i == count && along > 0.0));
      const double from_cone = behind ? square : std::max(0.0, square - along * along);
      if (from_cone > 0.0) {
        result.reach = std::min(result.reach, square / (2.0 * std::sqrt(from_cone)));
      }
      if (apart >= separation) result.distance = std::min(result.distance, std::sqrt(square));
    }
  }
  return result;
}

template <class P>
void expect_reach(const P& path, std::size_t count, double slack) {
  const TubeRadius tube = largest_tube_radius(path, fine);
  const Sampled judge = sampled(path, count, tube.distance ? tube.distance->separation : infinity);
  EXPECT_LE(tube.radius.lower(), judge.reach);
  const double local = 1.0 / tube.curvature.lower();
  EXPECT_LE(std::min(judge.reach, local), tube.radius.upper() * (1.0 + slack));
  EXPECT_LE(tube.radius.upper() - tube.radius.lower(),
            4 * fine.relative_width * tube.radius.upper());
  if (tube.distance) {
    EXPECT_LE(tube.distance->distance.lower(), judge.distance);
  }
}

/// The torus knot through its points and velocities.
SpatialPath<2> torus_knot(std::size_t count) {
  std::vector<double> knots;
  std::vector<HermitePoint<1>> points;
  for (std::size_t i = 0; i <= count; ++i) {
    const double xi = 2 * pi * static_cast<double>(i) / static_cast<double>(count);
    knots.push_back(xi);
    const auto series = TorusKnot{}(Taylor<double, 1>::variable(i == count ? 0.0 : xi));
    points.push_back({Vector3<double>{series.x[0], series.y[0], series.z[0]},
                      Vector3<double>{series.x[1], series.y[1], series.z[1]}});
  }
  return hermite_path<1, double>(knots, points, HermiteChoice::order_ten, true).value();
}

TEST(SelfDistance, OfRandomLoopsIsWhatFedererSays) {
  Random random("self-distance of loops");
  for (int i = 0; i < 40; ++i) {
    const LoopShape shape{random.uniform(-3.0, 3.0), random.uniform(-pi, pi)};
    SCOPED_TRACE(testing::Message() << "xi " << shape.xi << ", psi " << shape.psi);
    const auto path = closed_loop(shape, {std::abs(random.spread(-20, 20)), random.vector3(4.0),
                                          random.rotation()})
                          .value();
    expect_reach(path, 400, 0.01);
    const double share = random.uniform(0.3, 1.0);
    const auto open = subpath(path, 0.0, share).value();
    expect_reach(open, 400, 0.02);
  }
}

TEST(SelfDistance, OfAPlanarLoop) {
  const auto oval = closed_loop({0.0, pi}).value();
  const TubeRadius tube = largest_tube_radius(oval, fine);
  EXPECT_EQ(tube.limit, TubeLimit::curvature);
  EXPECT_GT(tube.radius.lower(), 0.1);
  const auto eight = closed_loop({0.0, 0.0}).value();
  const TubeRadius none = largest_tube_radius(eight, fine);
  EXPECT_EQ(none.limit, TubeLimit::distance);
  constexpr double rounding = 0x1.0p-40;  // of fifty levels of subdivision
  constexpr double place = 0x1.0p-36;     // where the distance is below that rounding
  EXPECT_EQ(none.radius.lower(), 0.0);
  EXPECT_LE(none.radius.upper(), rounding);
  ASSERT_TRUE(none.distance);
  const double t0 = 0.5 * (1.0 - std::sqrt((27.0 - std::sqrt(249.0)) / 30.0));
  EXPECT_NEAR(none.distance->xi[0], t0, place);
  EXPECT_NEAR(none.distance->xi[1], 1.0 - t0, place);
}

/// A polygon as a path of straight segments.
PlanarPath<0> polygon(const std::vector<Vector2<double>>& corners, bool closed) {
  std::vector<PlanarPhCurve<0>> sides;
  std::vector<double> knots{0.0};
  const std::size_t count = corners.size() - (closed ? 0 : 1);
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2<double> d = corners[(i + 1) % corners.size()] - corners[i];
    const double length = std::sqrt(dot(d, d));
    // w² = d/length with h = length; sides along the axes only.
    const Complex<double> w = d.x > 0.0   ? Complex<double>{1.0, 0.0}
                              : d.x < 0.0 ? Complex<double>{0.0, 1.0}
                              : d.y > 0.0 ? Complex<double>{std::sqrt(0.5), std::sqrt(0.5)}
                                          : Complex<double>{std::sqrt(0.5), -std::sqrt(0.5)};
    sides.emplace_back(corners[i], BernsteinPolynomial<Complex<double>, 0>({w}), length);
    knots.push_back(knots.back() + length);
  }
  return PlanarPath<0>::create(knots, sides, closed).value();
}

TEST(SelfDistance, OfASquareAndAHairpin) {
  const auto square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true);
  const auto expect = [](const SelfDistance& found, double distance) {
    EXPECT_LE(found.distance.lower(), distance * (1.0 + 8.0 * epsilon<double>()));
    EXPECT_GE(found.distance.upper(), distance * (1.0 - 8.0 * epsilon<double>()));
    EXPECT_LE(found.distance.width(), 2.0 * rough.relative_width * distance);
  };
  // Round a corner the nearest points 2a apart along the path are √2 a apart.
  expect(self_distance(square, 1.0, rough).value(), std::sqrt(0.5));
  expect(self_distance(square, 1.5, rough).value(), 1.0);  // opposite sides
  expect(self_distance(square, 2.0, rough).value(), 1.0);  // in the middle of opposite sides
  const auto hairpin = polygon({{0, 0}, {10, 0}, {10, 0.125}, {0, 0.125}}, false);
  expect(self_distance(hairpin, 1.0, rough).value(), 0.125);
  expect(self_distance(hairpin, 20.0, rough).value(), 0.125);  // its ends
  const TubeRadius tube = largest_tube_radius(hairpin, fine);
  EXPECT_EQ(tube.limit, TubeLimit::corner);
  EXPECT_EQ(tube.knot, 1U);
  EXPECT_EQ(tube.radius, Enclosure(0.0));
}

TEST(SelfDistance, OfAStraightPathIsNoLimit) {
  const auto line = polygon({{0, 0}, {10, 0}}, false);
  const TubeRadius tube = largest_tube_radius(line, fine);
  EXPECT_EQ(tube.radius.lower(), std::numeric_limits<double>::max());
  EXPECT_FALSE(tube.distance);
  const auto ends = self_distance(line, 4.0, rough).value();
  EXPECT_NEAR(ends.distance.middle(), 4.0, 4.0 * 2 * rough.relative_width);
}

TEST(SelfDistance, OfAKnotOnATorusInManySegments) {
  // (2 + cos 3ξ)(cos 2ξ, sin 2ξ), sin 3ξ: its strands pass each other on the torus.
  const auto path = torus_knot(48);
  expect_reach(path, 600, 0.02);
  const TubeRadius tube = largest_tube_radius(path, fine);
  EXPECT_EQ(tube.limit, TubeLimit::distance);
  EXPECT_LT(tube.distance->evaluations, 20000U);
}

TEST(SelfDistance, MovesAndScalesWithThePath) {
  constexpr double rounding = 1e-12;  // of the rotated and scaled preimage, and of the sums of it
  Random random("self-distance moved");
  const auto loop = closed_loop({1.0, 0.6 * pi}).value();
  const TubeRadius first = largest_tube_radius(loop, fine);
  for (int i = 0; i < 20; ++i) {
    const double c = std::abs(random.spread(-200, 200));
    const auto other = moved(scaled(loop, c).value(), random.rotation(), random.vector3(c)).value();
    const TubeRadius tube = largest_tube_radius(other, fine);
    EXPECT_LE(std::max(tube.radius.lower(), c * first.radius.lower()) * (1.0 - rounding),
              std::min(tube.radius.upper(), c * first.radius.upper()));
    EXPECT_EQ(tube.limit, first.limit);
  }
}

TEST(SelfDistance, SaysWhereTheSpeedVanishes) {
  const auto path = closed_loop({infinity, 1.0}).value();
  const TubeRadius tube = largest_tube_radius(path, fine);
  EXPECT_EQ(tube.limit, TubeLimit::standstill);
  EXPECT_EQ(tube.radius.lower(), 0.0);
}

TEST(SelfDistance, RefusesWhatHasNoAnswer) {
  const auto loop = closed_loop({1.0, 0.6 * pi}).value();
  EXPECT_EQ(self_distance(loop, 0.0, fine).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(self_distance(loop, -1.0, fine).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(self_distance(loop, infinity, fine).fault().code, FaultCode::not_finite);
  EXPECT_EQ(self_distance(loop, 0.51, fine).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(self_distance(loop, 0.51, fine).fault().sentence,
            "no two points of the path are 0.51 apart along it; at most " +
                to_text(0.5 * loop.arc_length()) + ", half of its length");
  EXPECT_TRUE(self_distance(loop, 0.49, fine));
  // Whatever the goal, the enclosure holds.
  const auto exact = self_distance(loop, 0.3, fine).value();
  for (const std::size_t most : {0U, 1U, 10U, 100U}) {
    const auto early = self_distance(loop, 0.3, {fine.relative_width, most}).value();
    EXPECT_LE(early.distance.lower(), exact.distance.upper());
    EXPECT_GE(early.distance.upper(), exact.distance.lower());
  }
}

}  // namespace
}  // namespace hodograph::test
