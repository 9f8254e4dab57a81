// SPDX-License-Identifier: MIT
// Where planar paths meet themselves: all places, certain where they cross, none where segments
// only follow each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hodograph/path/intersections.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/planar_golden.hpp"

namespace hodograph::test {
namespace {

constexpr double pi = std::numbers::pi;

/// A path through random preimages that go on over the knots, which turn a lot.
template <std::size_t n>
PlanarPath<n> winding_path(Random& random, std::size_t segments) {
  std::vector<double> knots{0.0};
  std::vector<PlanarPhCurve<n>> curves;
  Vector2<double> start{};
  const auto next = [&](double angle) {
    const double size = random.uniform(0.6, 1.4);
    return Complex<double>{size * std::cos(angle), size * std::sin(angle)};
  };
  double angle = random.uniform(-pi, pi);
  Complex<double> last = next(angle);
  for (std::size_t k = 0; k < segments; ++k) {
    BernsteinPolynomial<Complex<double>, n> w;
    w[0] = last;
    for (std::size_t i = 1; i <= n; ++i) w[i] = next(angle += random.uniform(-1.3, 1.3));
    last = w[n];
    knots.push_back(knots.back() + random.uniform(0.5, 1.5));
    curves.emplace_back(start, w, knots[k + 1] - knots[k]);
    start = curves.back().end();
  }
  return PlanarPath<n>::create(std::move(knots), std::move(curves), false).value();
}

/// Crossings of the polyline through samples with itself, as parameters.
template <std::size_t n>
std::vector<std::array<double, 2>> crossings_of_polyline(const PlanarPath<n>& path, int count) {
  std::vector<Vector2<double>> points;
  const auto xi_at = [&](double t) {
    return path.xi_begin() + t / count * (path.xi_end() - path.xi_begin());
  };
  for (int i = 0; i <= count; ++i) points.push_back(path.position(path.clamped(xi_at(i))));
  std::vector<std::array<double, 2>> found;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    for (std::size_t k = i + 2; k + 1 < points.size(); ++k) {
      const auto d = points[i + 1] - points[i], e = points[k + 1] - points[k];
      const auto gap = points[k] - points[i];
      const double determinant = cross(d, e);
      if (determinant == 0.0) continue;
      const double s = cross(gap, e) / determinant, t = cross(gap, d) / determinant;
      if (s >= 0.0 && s < 1.0 && t >= 0.0 && t < 1.0) {
        found.push_back({xi_at(static_cast<double>(i) + s), xi_at(static_cast<double>(k) + t)});
      }
    }
  }
  return found;
}

template <std::size_t n>
std::size_t expect_as_sampled(const PlanarPath<n>& path) {
  constexpr int samples = 700;
  const auto found = self_intersections(path);
  const auto expected = crossings_of_polyline(path, samples);
  const double step = 3.0 * (path.xi_end() - path.xi_begin()) / samples;
  for (const auto& [first, second] : expected) {
    EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                            [&](const PathIntersection& at) {
                              return std::abs(at.xi_first - first) < step &&
                                     std::abs(at.xi_second - second) < step;
                            }))
        << first << " and " << second;
  }
  EXPECT_EQ(found.size(), expected.size());
  double before = path.xi_begin();
  for (const PathIntersection& at : found) {
    EXPECT_EQ(at.kind, IntersectionKind::crossing);
    EXPECT_LE(before, at.xi_first);
    before = at.xi_first;
    EXPECT_LT(at.xi_first, at.xi_second);
    EXPECT_LE(at.xi_first_range.lower(), at.xi_first);
    EXPECT_LE(at.xi_first, at.xi_first_range.upper());
    const double apart = norm(path.position(at.xi_first) - path.position(at.xi_second));
    EXPECT_LT(apart, 1e4 * epsilon<double>() * path.arc_length());
  }
  return expected.size();
}

TEST(SelfIntersections, AreThoseOfTheSampledPath) {
  Random random("paths that cross themselves");
  std::size_t crossings = 0;
  for (int trial = 0; trial < 20; ++trial) {
    crossings += expect_as_sampled(winding_path<1>(random, 6));
    crossings += expect_as_sampled(winding_path<2>(random, 5));
    crossings += expect_as_sampled(winding_path<4>(random, 2));
  }
  EXPECT_GT(crossings, 20U);
}

/// w = 1 + i c (u - 1/2): the cubic of Tschirnhausen turns by 4 atan(c/2) and crosses itself once
/// from 4π/3 on, at the parameters with x = 0: 1/2 ± √3/c.
TEST(SelfIntersections, OneSegmentMakesALoop) {
  using Linear = BernsteinPolynomial<Complex<double>, 1>;
  const auto curve = [](double c) {
    return path_of(Linear({Complex<double>{1.0, -0.5 * c}, {1.0, 0.5 * c}}));
  };
  EXPECT_TRUE(self_intersections(curve(3.0)).empty());
  for (const double c : {4.0, 8.0, 100.0}) {
    const auto found = self_intersections(curve(c));
    ASSERT_EQ(found.size(), 1U) << c;
    EXPECT_EQ(found[0].kind, IntersectionKind::crossing);
    EXPECT_NEAR(found[0].xi_first, 0.5 - std::sqrt(3.0) / c, 64 * epsilon<double>());
    EXPECT_NEAR(found[0].xi_second, 0.5 + std::sqrt(3.0) / c, 64 * epsilon<double>());
  }
}

PlanarPath<0> polyline(const std::vector<Vector2<double>>& points, bool closed) {
  std::vector<PlanarPhCurve<0>> curves;
  std::vector<double> knots{0.0};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto d = points[i + 1] - points[i];
    const double angle = 0.5 * std::atan2(d.y, d.x), size = std::sqrt(norm(d));
    BernsteinPolynomial<Complex<double>, 0> w;
    w[0] = {size * std::cos(angle), size * std::sin(angle)};
    if (d.y == 0.0 && d.x < 0.0) w[0] = {0.0, size};  // exactly back
    curves.emplace_back(points[i], w, 1.0);
    knots.push_back(knots.back() + 1.0);
  }
  return PlanarPath<0>::create(knots, curves, closed).value();
}

TEST(SelfIntersections, CornersAndClosingAreNone) {
  EXPECT_TRUE(self_intersections(polyline({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}, true)).empty());
  EXPECT_TRUE(self_intersections(polyline({{0, 0}, {1, 0}, {0.2, 0.1}}, false)).empty());
  // Open, and back at its start: that is a place where it meets itself.
  const auto back = self_intersections(polyline({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}, false));
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0].kind, IntersectionKind::undecided);
  const auto crossed =
      self_intersections(polyline({{0, 0}, {2, 0}, {2, 2}, {1, 2}, {1, -1}}, false));
  ASSERT_EQ(crossed.size(), 1U);
  EXPECT_EQ(crossed[0].kind, IntersectionKind::crossing);
  EXPECT_NEAR(crossed[0].xi_first, 0.5, 16 * epsilon<double>());
  // Through a knot of the path itself.
  const auto at_knot =
      self_intersections(polyline({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {1, -1}}, false));
  ASSERT_EQ(at_knot.size(), 1U);
  EXPECT_NEAR(at_knot[0].xi_first, 1.0, 64 * epsilon<double>());
}

TEST(SelfIntersections, SegmentsThatFollowEachOtherAreFoundToCrossToo) {
  // Two segments in a row that together turn by half a circle to one and a half: some of the second
  // ones cross the first, far from the join.
  Random random("segments in a row that cross");
  std::size_t crossings = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const double turn = random.uniform(1.6, 4.7);  // of the preimage: half that of the curve
    BernsteinPolynomial<Complex<double>, 2> a, b;
    for (std::size_t i = 0; i <= 2; ++i) {
      const double size = random.uniform(0.5, 1.5), share = 0.25 * static_cast<double>(i);
      a[i] = {size * std::cos(share * turn), size * std::sin(share * turn)};
      b[i] = {size * std::cos((0.5 + share) * turn), size * std::sin((0.5 + share) * turn)};
    }
    b[0] = a[2];
    const PlanarPhCurve<2> first({}, a, 1.0), second(first.end(), b, 1.0);
    crossings +=
        expect_as_sampled(PlanarPath<2>::create({0.0, 1.0, 2.0}, {first, second}, false).value());
  }
  EXPECT_GT(crossings, 5U);
}

TEST(SelfIntersections, WhatIsGoneThroughTwiceIsUndecided) {
  // To the end of a line and back on it.
  const auto there = self_intersections(polyline({{0, 0}, {1, 0}, {0, 0}}, false));
  ASSERT_FALSE(there.empty());
  double begin = 1.0, end = 1.0;
  for (const auto& at : there) {
    EXPECT_EQ(at.kind, IntersectionKind::undecided);
    begin = std::min(begin, at.xi_first_range.lower());
    end = std::max(end, at.xi_second_range.upper());
  }
  EXPECT_NEAR(begin, 0.0, 64 * epsilon<double>());
  EXPECT_NEAR(end, 2.0, 64 * epsilon<double>());
  // A square twice round.
  for (const auto& at : self_intersections(polyline(
           {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}, false))) {
    EXPECT_EQ(at.kind, IntersectionKind::undecided);
  }
}

}  // namespace
}  // namespace hodograph::test
