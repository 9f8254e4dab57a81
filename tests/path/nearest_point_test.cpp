// SPDX-License-Identifier: MIT
// Stationary points of the distance: none is missed, and the nearest is the nearest.
#include "hodograph/path/nearest_point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/arb_judge.hpp"
#include "support/random.hpp"

namespace hodograph {
namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon();

template <class A, std::size_t n>
Path<A, n> path_of(const std::vector<double>& knots,
                   const std::vector<typename PhCurve<A, n>::Preimage>& preimages,
                   point_t<A> start = {}, bool closed = false) {
  std::vector<PhCurve<A, n>> segments;
  for (std::size_t k = 0; k < preimages.size(); ++k) {
    segments.push_back({start, preimages[k], knots[k + 1] - knots[k]});
    start = segments.back().end();
  }
  return Path<A, n>::create(knots, std::move(segments), closed).value();
}

using Line = PlanarPhCurve<0>::Preimage;

/// A line of direction (1, 0) along ξ, or turned by 90° steps.
Line direction(double angle) {
  return Line({Complex<double>{std::cos(angle / 2), std::sin(angle / 2)}});
}

TEST(NearestPoint, RefusesAQueryThatIsNotFinite) {
  const auto path = path_of<Complex<double>, 0>({0.0, 1.0}, {direction(0.0)});
  const Vector2<double> bad{0.0, std::numeric_limits<double>::quiet_NaN()};
  const auto nearest = nearest_point(path, bad);
  ASSERT_FALSE(nearest);
  EXPECT_EQ(nearest.fault().code, FaultCode::not_finite);
  EXPECT_EQ(nearest.fault().index, 1u);
  EXPECT_FALSE(stationary_points(path, bad));
}

TEST(NearestPoint, OfALineAreItsFootAndItsEnds) {
  const auto path = path_of<Complex<double>, 0>({0.0, 4.0}, {direction(0.0)});
  const auto points = stationary_points(path, {1.0, 2.0}).value();
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0].kind, StationaryKind::maximum);
  EXPECT_EQ(points[0].xi, 0.0);
  EXPECT_EQ(points[1].kind, StationaryKind::minimum);
  EXPECT_TRUE(points[1].xi_range.contains(1.0));
  EXPECT_EQ(points[2].kind, StationaryKind::maximum);
  EXPECT_EQ(points[2].xi, 4.0);
  const auto nearest = nearest_point(path, {1.0, 2.0}).value();
  EXPECT_TRUE(nearest.distance.contains(2.0));
  EXPECT_LT(nearest.distance.width(), 64 * ulp);
  EXPECT_EQ(nearest.at.kind, StationaryKind::minimum);
  // Beyond the end: the end is a minimum.
  const auto beyond = stationary_points(path, {5.0, 0.0}).value();
  ASSERT_EQ(beyond.size(), 2u);
  EXPECT_EQ(beyond[1].kind, StationaryKind::minimum);
  EXPECT_EQ(nearest_point(path, {5.0, 0.0}).value().at.xi, 4.0);
  // The foot is an end: one entry, not two.
  const auto foot = stationary_points(path, {0.0, 1.0}).value();
  ASSERT_EQ(foot.size(), 2u);
  EXPECT_EQ(foot[0].kind, StationaryKind::minimum);
  // On the line: distance 0.
  EXPECT_TRUE(nearest_point(path, {3.0, 0.0}).value().distance.contains(0.0));
}

TEST(NearestPoint, IncludesCornersWhereTheOneSidedDerivativesBracketZero) {
  // Right along x, then up along y; from inside the corner it is a maximum, from outside a minimum.
  const auto path = path_of<Complex<double>, 0>({0.0, 1.0, 2.0},
                                                {direction(0.0), direction(std::numbers::pi / 2)});
  const auto inside = stationary_points(path, {0.5, 0.5}).value();
  ASSERT_EQ(inside.size(), 5u);  // end, foot, corner, foot, end
  EXPECT_EQ(inside[2].xi, 1.0);
  EXPECT_EQ(inside[2].kind, StationaryKind::maximum);
  const auto outside = stationary_points(path, {1.5, -0.5}).value();
  ASSERT_EQ(outside.size(), 3u);
  EXPECT_EQ(outside[1].xi, 1.0);
  EXPECT_EQ(outside[1].kind, StationaryKind::minimum);
  EXPECT_TRUE(nearest_point(path, {1.5, -0.5}).value().distance.contains(std::sqrt(0.5)));
}

TEST(NearestPoint, CountsAZeroAtASmoothKnotOnce) {
  // A line cut at 1 (and at a third, which is no double).
  const auto path =
      path_of<Complex<double>, 0>({0.0, 1.0 / 3, 1.0, 2.0}, std::vector<Line>(3, direction(0.7)));
  for (const std::size_t knot : {1u, 2u}) {
    const auto at = path.segment(knot).start();
    for (const double off : {0.0, 1.0, 1e-8}) {  // not a tolerance: distances from the line
      const Vector2<double> normal{-std::sin(0.7), std::cos(0.7)};
      const auto points = stationary_points(path, at + off * normal).value();
      EXPECT_EQ(points.size(), 3u) << knot << " " << off;
      EXPECT_EQ(points[1].kind, StationaryKind::minimum) << knot << " " << off;
    }
  }
}

TEST(NearestPoint, AnswersAtTheCentreOfAnArc) {
  // Not moving at all: every parameter is equally near, and there is one answer.
  const SpatialPhCurve<1> rest({1.0, 0.0, 0.0}, {}, 1.0);
  const auto still = SpatialPath<1>::create({0.0, 1.0}, {rest}, false).value();
  const auto stretch = stationary_points(still, {0.0, 0.0, 0.0}).value();
  ASSERT_EQ(stretch.size(), 1u);
  EXPECT_EQ(stretch[0].kind, StationaryKind::undecided);
  EXPECT_EQ(stretch[0].xi_range, Enclosure(0.0, 1.0));
  const auto nearest = nearest_point(still, {0.0, 0.0, 0.0}).value();
  EXPECT_TRUE(nearest.distance.contains(1.0));
  EXPECT_LT(nearest.distance.width(), 64 * ulp);

  // w = e^{iφu/2} truncated: a nearly circular arc, so short that it is one within rounding.
  constexpr std::size_t n = 6;
  constexpr double angle = 0.0625;
  PlanarPhCurve<n>::Preimage preimage;
  for (std::size_t i = 0; i <= n; ++i) {
    // Bernstein coefficients of the Taylor polynomial of exp(iφu/2).
    Complex<double> term{1.0, 0.0};
    for (std::size_t k = 0; k <= i; ++k) {
      const double weight =
          static_cast<double>(binomial(i, k)) / static_cast<double>(binomial(n, k));
      preimage[i] = preimage[i] + weight * term;
      term = (1.0 / static_cast<double>(k + 1)) * (Complex<double>{0.0, angle / 2} * term);
    }
  }
  // It starts at (0, 0) in direction (1, 0) with radius 1/angle in units of the step.
  const auto arc = path_of<Complex<double>, n>({0.0, 1.0}, {preimage});
  const Vector2<double> centre{0.0, 1.0 / angle};
  const auto points = stationary_points(arc, centre).value();
  ASSERT_FALSE(points.empty());
  EXPECT_LE(points.size(), 8u);
  const auto found = nearest_point(arc, centre).value();
  EXPECT_LE(found.distance.lower(), found.distance.upper());
  EXPECT_LT(std::abs(found.distance.middle() - 1.0 / angle), 64 * ulp / angle);
  EXPECT_LT(found.distance.width(), 256 * ulp / angle);
}

TEST(NearestPoint, OfAClosedPathHasNoEnds) {
  const double quarter = std::numbers::pi / 2;
  const auto square = path_of<Complex<double>, 0>(
      {0.0, 1.0, 2.0, 3.0, 4.0},
      {direction(0.0), direction(quarter), direction(2 * quarter), direction(3 * quarter)}, {},
      true);
  const auto points = stationary_points(square, {0.5, 0.5}).value();
  ASSERT_EQ(points.size(), 8u);  // four corners, four feet
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(points[i].kind, i % 2 == 0 ? StationaryKind::maximum : StationaryKind::minimum);
  }
  // The corner at the knot that closes the path is the nearest point from outside it.
  const auto nearest = nearest_point(square, {-1.0, -1.0}).value();
  EXPECT_TRUE(nearest.at.xi == 0.0 || nearest.at.xi == 4.0);
}

#if HODOGRAPH_TEST_HAS_ARB

using test::Judge;

Complex<Judge> judged(const Complex<double>& a) { return {Judge(a.re), Judge(a.im)}; }
Quaternion<Judge> judged(const Quaternion<double>& a) {
  return {Judge(a.w), Judge(a.x), Judge(a.y), Judge(a.z)};
}
Vector2<Judge> judged(const Vector2<double>& a) { return {Judge(a.x), Judge(a.y)}; }
Vector3<Judge> judged(const Vector3<double>& a) { return {Judge(a.x), Judge(a.y), Judge(a.z)}; }

/// The distance and its derivative's sign on a grid, exactly; returns the least distance seen.
template <class A, std::size_t n>
void check(const Path<A, n>& path, const point_t<A>& q) {
  const auto points = stationary_points(path, q).value();
  const auto nearest = nearest_point(path, q).value();
  double least_listed = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_TRUE(points[i].xi_range.contains(points[i].xi));
    if (i > 0) {
      EXPECT_LE(points[i - 1].xi_range.upper(), points[i].xi_range.lower());
    }
    least_listed = std::min(least_listed, points[i].distance);
  }
  EXPECT_GE(nearest.at.distance, nearest.distance.lower() * (1 - 256 * ulp));
  EXPECT_LE(std::abs(nearest.at.distance - least_listed), 4096 * ulp * (1 + least_listed));

  constexpr int grid = 100;
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const auto& curve = path.segment(k);
    BernsteinPolynomial<decltype(judged(A{})), n> preimage;
    for (std::size_t i = 0; i <= n; ++i) preimage[i] = judged(curve.preimage()[i]);
    const PhCurve<decltype(judged(A{})), n> exact(judged(curve.start()), preimage,
                                                  Judge(curve.parameter_step()));
    int before = 0;
    for (int i = 0; i <= grid; ++i) {
      const Judge u = Judge(static_cast<double>(i)) / Judge(static_cast<double>(grid));
      const auto offset = exact.position(u) - judged(q);
      const auto a = exact.preimage().value(u);
      EXPECT_FALSE(sqrt(dot(offset, offset)) < Judge(nearest.distance.lower()));
      const Judge slope = dot(offset, hodograph_form(a, a));
      const int sign = Judge(0.0) < slope ? 1 : slope < Judge(0.0) ? -1 : 0;
      if (before * sign < 0) {
        // An entry between the two, of the right kind where it is the only one.
        const double low = path.knots()[k] + curve.parameter_step() * (i - 1) / grid;
        const double high = path.knots()[k] + curve.parameter_step() * i / grid;
        int inside = 0;
        StationaryKind kind = StationaryKind::undecided;
        for (const auto& p : points) {
          if (p.xi_range.upper() < low - ulp || p.xi_range.lower() > high + ulp) continue;
          ++inside;
          kind = p.kind;
        }
        EXPECT_GE(inside, 1) << "a zero of segment " << k << " is missing";
        if (inside == 1) {
          EXPECT_EQ(kind, sign > 0 ? StationaryKind::minimum : StationaryKind::maximum);
        }
      }
      if (sign != 0) before = sign;
    }
  }
  // The distance is attained: the point given is on the path and as near as its upper end says.
  EXPECT_LE(nearest.distance.lower(), nearest.distance.upper());
  EXPECT_LE(nearest.at.distance, nearest.distance.upper() * (1 + 1024 * ulp) + 1024 * ulp);
}

template <class A, std::size_t n>
void check_random(test::Random& random) {
  std::vector<double> knots{random.uniform(-1.0, 1.0)};
  std::vector<typename PhCurve<A, n>::Preimage> preimages(
      static_cast<std::size_t>(random.integer(1, 4)));
  for (auto& preimage : preimages) {
    for (std::size_t i = 0; i <= n; ++i) preimage[i] = random.components<A>(1.0);
    knots.push_back(knots.back() + random.uniform(0.1, 2.0));
  }
  const auto path = path_of<A, n>(knots, preimages, random.components<point_t<A>>(1.0));
  check(path, random.components<point_t<A>>(2.0));
  // On the path, and at one of its knots.
  check(path, path.position(random.uniform(knots.front(), knots.back())));
  check(path, path.position(knots[random.index(knots.size())]));
}

TEST(NearestPoint, MissesNothingOnRandomPaths) {
  test::Random random("nearest point: random paths");
  for (int i = 0; i < 5; ++i) {
    check_random<Complex<double>, 0>(random);
    check_random<Complex<double>, 2>(random);
    check_random<Complex<double>, 4>(random);
    check_random<Quaternion<double>, 2>(random);
    check_random<Quaternion<double>, 4>(random);
    check_random<Quaternion<double>, 8>(random);
  }
}

#endif  // HODOGRAPH_TEST_HAS_ARB

TEST(NearestPoint, DoesNotDependOnScale) {
  test::Random random("nearest point: scales");
  SpatialPhCurve<2>::Preimage preimage;
  for (std::size_t i = 0; i < 3; ++i) preimage[i] = random.quaternion(1.0);
  const Vector3<double> q = random.vector3(1.0);
  const auto path = path_of<Quaternion<double>, 2>({0.0, 1.0}, {preimage});
  const auto expected = nearest_point(path, q).value();
  for (const int exponent : {-240, -100, 100, 240}) {
    SpatialPhCurve<2>::Preimage moved;
    for (std::size_t i = 0; i < 3; ++i) moved[i] = std::ldexp(1.0, exponent) * preimage[i];
    const double scale = std::ldexp(1.0, 2 * exponent);
    const auto scaled_path = path_of<Quaternion<double>, 2>({0.0, 1.0}, {moved});
    const auto found = nearest_point(scaled_path, scale * q).value();
    EXPECT_EQ(found.at.xi, expected.at.xi) << exponent;
    EXPECT_LT(std::abs(found.distance.middle() / scale - expected.distance.middle()), 64 * ulp);
    EXPECT_LT(found.distance.width(), 256 * ulp * scale);
  }
  // Far away and on top of each other: finite answers.
  for (const double far : {1e150, 1e300}) {
    const auto found = nearest_point(path, {far, 0.0, 0.0}).value();
    EXPECT_TRUE(found.distance.is_bounded());
    EXPECT_TRUE(found.distance.contains(far) ||
                std::abs(found.distance.middle() / far - 1) < 8 * ulp);
  }
}

}  // namespace
}  // namespace hodograph
