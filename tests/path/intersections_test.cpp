// SPDX-License-Identifier: MIT
// Intersections of planar paths: all of them, certain where they cross, bounded work everywhere.
#include "hodograph/path/intersections.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hodograph/path/nearest_point.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/planar_golden.hpp"

namespace hodograph {
namespace {

using test::path_of;
using test::Random;
using Linear = BernsteinPolynomial<Complex<double>, 1>;
using Constant = BernsteinPolynomial<Complex<double>, 0>;

constexpr double epsilon_double = std::numeric_limits<double>::epsilon();

/// w = 1 + i u: x = u - u³/3, y = u², u from 0 to 1.
PlanarPath<1> parabola() { return path_of(Linear({Complex<double>{1, 0}, {1, 1}})); }

/// A straight path along the x axis through `start`, of length `length`.
PlanarPath<0> level(const Vector2<double>& start, double length) {
  return path_of(Constant({Complex<double>{1, 0}}), start, length);
}

/// Crossings of polylines through samples, by brute force, as parameters of both.
template <std::size_t n, std::size_t m>
std::vector<std::array<double, 2>> crossings_of_polylines(const PlanarPath<n>& p,
                                                          const PlanarPath<m>& q, int count) {
  const auto samples = [count](const auto& path) {
    std::vector<Vector2<double>> points;
    for (int i = 0; i <= count; ++i) {
      const double t = static_cast<double>(i) / count;
      points.push_back(path.position(path.clamped((1 - t) * path.xi_begin() + t * path.xi_end())));
    }
    return points;
  };
  const auto a = samples(p), b = samples(q);
  std::vector<std::array<double, 2>> found;
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < count; ++k) {
      const auto d = a[i + 1] - a[i], e = b[k + 1] - b[k], gap = b[k] - a[i];
      const double determinant = cross(d, e);
      if (determinant == 0) continue;
      const double s = cross(gap, e) / determinant, t = cross(gap, d) / determinant;
      if (s >= 0 && s < 1 && t >= 0 && t < 1) {
        found.push_back({p.xi_begin() + (i + s) / count * (p.xi_end() - p.xi_begin()),
                         q.xi_begin() + (k + t) / count * (q.xi_end() - q.xi_begin())});
      }
    }
  }
  return found;
}

TEST(Intersections, OfAParabolaWithLevelLines) {
  const auto path = parabola();
  const auto found = intersections(path, level({-1.0, 0.25}, 3.0));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, IntersectionKind::crossing);
  EXPECT_TRUE(found[0].xi_first_range.contains(0.5));
  EXPECT_LE(found[0].xi_first_range.width(), 16 * epsilon_double);
  EXPECT_CLOSE(found[0].xi_second, 1.0 + 0.5 - 0.125 / 3, 8, 3.0);
  EXPECT_CLOSE(found[0].point.y, 0.25, 8, 1.0);
  EXPECT_TRUE(intersections(path, level({-1.0, -0.25}, 3.0)).empty());
  EXPECT_TRUE(intersections(path, level({0.6, 0.25}, 3.0)).empty());
}

TEST(Intersections, ContactAndEndsAreUndecided) {
  // The parabola touches the x axis at its start: make it start before, w = 1 + i (u - 1/2).
  const auto path = path_of(Linear({Complex<double>{1, -0.5}, {1, 0.5}}), {0.0, 0.25});
  const auto touching = intersections(path, level({-1.0, 0.0}, 3.0));
  ASSERT_EQ(touching.size(), 1U);
  EXPECT_EQ(touching[0].kind, IntersectionKind::undecided);
  EXPECT_TRUE(touching[0].xi_first_range.contains(0.5));
  EXPECT_LT(touching[0].xi_first_range.width(), 64 * std::sqrt(epsilon_double));
  // The end (2/3, 1) of the parabola lies on a line.
  const auto ends = intersections(parabola(), level({0.0, 1.0}, 3.0));
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_EQ(ends[0].kind, IntersectionKind::undecided);
  EXPECT_TRUE(ends[0].xi_first_range.contains(1.0));
}

TEST(Intersections, StretchesInCommonAreOneEntry) {
  Random random("intersections: stretches");
  const auto path = path_of(test::tame_preimage<Complex<double>, 2>(random));
  const auto all = intersections(path, path);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].kind, IntersectionKind::undecided);
  EXPECT_EQ(all[0].xi_first_range, Enclosure(0.0, 1.0));
  EXPECT_EQ(all[0].xi_second_range, Enclosure(0.0, 1.0));
  // A part of it.
  const auto part = path.segment(0).restricted(0.25, 0.5);
  const auto shorter = PlanarPath<2>::create({0.0, 0.25}, {part}, false).value();
  const auto some = intersections(path, shorter);
  ASSERT_EQ(some.size(), 1U);
  EXPECT_EQ(some[0].kind, IntersectionKind::undecided);
  EXPECT_LE(some[0].xi_first_range.lower(), 0.25);
  EXPECT_GE(some[0].xi_first_range.upper(), 0.5);
  EXPECT_LT(some[0].xi_first_range.width(), 0.26);
  const auto twice = test::random_path<PlanarPath<2>>(random, 4, 1);
  for (const auto& at : intersections(twice, twice)) {
    EXPECT_EQ(at.kind, IntersectionKind::undecided);
  }
}

template <std::size_t n, std::size_t m>
void compare_with_polylines(const PlanarPath<n>& p, const PlanarPath<m>& q) {
  const auto found = intersections(p, q);
  constexpr int count = 300;
  const auto rough = crossings_of_polylines(p, q, count);
  const double reach = 4.0 / count;  // in parameters over the whole path
  const auto lengths = [&](const auto& path) { return path.xi_end() - path.xi_begin(); };
  for (const auto& r : rough) {
    const bool near = std::any_of(found.begin(), found.end(), [&](const PathIntersection& at) {
      return at.xi_first_range.lower() - reach * lengths(p) <= r[0] &&
             r[0] <= at.xi_first_range.upper() + reach * lengths(p) &&
             at.xi_second_range.lower() - reach * lengths(q) <= r[1] &&
             r[1] <= at.xi_second_range.upper() + reach * lengths(q);
    });
    EXPECT_TRUE(near) << r[0] << " " << r[1];
  }
  double previous = -std::numeric_limits<double>::infinity();
  for (const PathIntersection& at : found) {
    EXPECT_LE(previous, at.xi_first_range.lower());
    previous = at.xi_first_range.lower();
    EXPECT_TRUE(at.xi_first_range.contains(at.xi_first));
    EXPECT_TRUE(at.xi_second_range.contains(at.xi_second));
    if (at.kind != IntersectionKind::crossing) continue;
    // The enclosures are as wide as rounding over the angle of the tangents.
    const double size = 1.0 + p.arc_length() + q.arc_length();
    const double miss = 4 * (at.xi_first_range.width() * p.speed(at.xi_first) +
                             at.xi_second_range.width() * q.speed(at.xi_second)) +
                        256 * epsilon_double * size;
    EXPECT_LE(largest_component(p.position(at.xi_first) - q.position(at.xi_second)), miss);
  }
}

TEST(Intersections, AreAllFound) {
  Random random("intersections: all");
  std::size_t crossings = 0;
  for (int i = 0; i < 60; ++i) {
    // One after the other through the origin, or nearly.
    const auto through_origin = [&] {
      const auto w = test::wild_preimage<Complex<double>, 2>(random);
      const auto middle = path_of(w).position(0.5);
      return path_of(w, random.vector2(0.01) - middle);
    };
    const auto p = through_origin(), q = through_origin();
    compare_with_polylines(p, q);
    for (const auto& at : intersections(p, q)) {
      crossings += at.kind == IntersectionKind::crossing ? 1U : 0U;
    }
    compare_with_polylines(p, path_of(test::wild_preimage<Complex<double>, 3>(random)));
    compare_with_polylines(test::random_path<PlanarPath<2>>(random, 5, 1),
                           test::random_path<PlanarPath<1>>(random, 7, 0));
  }
  EXPECT_GT(crossings, 30U);
}

TEST(Intersections, OfRingsWithinOneAnother) {
  const auto ring = test::ring(12);
  std::vector<PlanarPhCurve<1>> moved;
  for (const auto& c : ring.segments()) {
    moved.emplace_back(c.start() + Vector2<double>{0.3, 0.4}, c.preimage(), c.parameter_step());
  }
  const auto other = PlanarPath<1>::create(ring.knots(), moved, true).value();
  const auto found = intersections(ring, other);
  ASSERT_EQ(found.size(), 2U);
  for (const auto& at : found) EXPECT_EQ(at.kind, IntersectionKind::crossing);
  // Lines through knots, the seam among them: two crossings each.
  for (const auto& curve : ring.segments()) {
    const Vector2<double> at = curve.start();
    const auto through = line_intersections(ring, at, Vector2<double>{0.1, 1.0}).value();
    ASSERT_EQ(through.size(), 2U);
    for (const auto& p : through) EXPECT_EQ(p.kind, IntersectionKind::crossing);
    const auto cut = intersections(ring, path_of(Constant({Complex<double>{1.0, 0.25}}),
                                                 at - Vector2<double>{0.9375, 0.5}, 2.0));
    EXPECT_EQ(std::count_if(cut.begin(), cut.end(),
                            [&](const PathIntersection& p) {
                              return largest_component(p.point - at) < 0.01;
                            }),
              1)
        << at.x << " " << at.y;
  }
}

TEST(Intersections, AtKnotsAreOneCrossing) {
  Random random("intersections: knots");
  for (int i = 0; i < 100; ++i) {
    // Both paths pass through the origin at a knot.
    const auto through_origin = [&] {
      auto a = test::tame_preimage<Complex<double>, 2>(random);
      const auto turn = random.unit_vector2();
      for (std::size_t k = 0; k <= 2; ++k) a[k] = Complex<double>{turn.x, turn.y} * a[k];
      const PlanarPhCurve<2> whole({}, a, 1.0);
      const auto middle = whole.position(0.5);
      const PlanarPhCurve<2> left({-1.0 * middle}, a.restricted(0.0, 0.5), 0.5);
      const PlanarPhCurve<2> right(left.end(), a.restricted(0.5, 1.0), 0.5);
      return PlanarPath<2>::create({0.0, 0.5, 1.0}, {left, right}, false).value();
    };
    const auto p = through_origin(), q = through_origin();
    const auto tp = p.preimage(0.5), tq = q.preimage(0.5);
    const auto dp = hodograph_form(tp, tp), dq = hodograph_form(tq, tq);
    // A clear angle.
    if (std::abs(cross(dp, dq)) < 0.1 * p.speed(0.5) * q.speed(0.5)) continue;
    const auto found = intersections(p, q);
    const auto here = std::count_if(found.begin(), found.end(), [](const PathIntersection& at) {
      return largest_component(at.point) < std::sqrt(epsilon_double);
    });
    EXPECT_EQ(here, 1);
    for (const auto& at : found) EXPECT_EQ(at.kind, IntersectionKind::crossing);
  }
}

TEST(LineIntersections, AgreeWithPathsAndKnowTheirEnds) {
  Random random("intersections: lines");
  for (int i = 0; i < 100; ++i) {
    const auto path = test::random_path<PlanarPath<2>>(random, 4, 0);
    const auto a =
        path.position(random.uniform(path.xi_begin(), path.xi_end())) + random.vector2(0.3);
    const Vector2<double> d = random.vector2(2.0);
    const auto line = line_intersections(path, a, d).value();
    for (const auto& at : line) {
      const Vector2<double> on_line = a + at.t.middle() * d;
      EXPECT_CLOSE(on_line, at.point, 4096, 1.0 + path.arc_length() + largest_component(a));
      EXPECT_TRUE(at.xi_range.contains(at.xi));
    }
    const auto segment = segment_intersections(path, a, a + d).value();
    const auto inside = std::count_if(line.begin(), line.end(), [](const LineIntersection& at) {
      return 0 <= at.t.middle() && at.t.middle() <= 1;
    });
    EXPECT_EQ(segment.size(), static_cast<std::size_t>(inside));
  }
}

TEST(LineIntersections, OfAParabola) {
  const auto path = parabola();
  const auto found = line_intersections(path, {0.0, 0.25}, {2.0, 0.0}).value();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, IntersectionKind::crossing);
  EXPECT_TRUE(found[0].xi_range.contains(0.5));
  EXPECT_CLOSE(found[0].t.middle(), (0.5 - 0.125 / 3) / 2, 8, 1.0);
  EXPECT_TRUE(line_intersections(path, {0.0, -1.0}, {1.0, 0.0}).value().empty());
  // Contact at the start, where the path begins.
  const auto contact = line_intersections(path, {0.0, 0.0}, {1.0, 0.0}).value();
  ASSERT_EQ(contact.size(), 1U);
  EXPECT_EQ(contact[0].kind, IntersectionKind::undecided);
  // A segment that ends on the curve.
  const double x = 0.5 - 0.125 / 3;
  const auto ending = segment_intersections(path, {x - 1.0, 0.25}, {x, 0.25}).value();
  ASSERT_EQ(ending.size(), 1U);
  EXPECT_EQ(ending[0].kind, IntersectionKind::undecided);
  EXPECT_TRUE(segment_intersections(path, {x - 1.0, 0.25}, {x - 0.5, 0.25}).value().empty());
  // A line on a line.
  const auto along = line_intersections(level({0.0, 1.0}, 2.0), {5.0, 1.0}, {1.0, 0.0}).value();
  ASSERT_EQ(along.size(), 1U);
  EXPECT_EQ(along[0].kind, IntersectionKind::undecided);
  EXPECT_TRUE(along[0].xi_range.contains(0.0) && along[0].xi_range.contains(2.0));
  EXPECT_TRUE(along[0].t.contains(-5.0) && along[0].t.contains(-3.0));
}

TEST(LineIntersections, RefuseWhatIsNoLine) {
  const auto path = parabola();
  EXPECT_EQ(line_intersections(path, {0, 0}, {0, 0}).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(line_intersections(path, {0, 0}, {std::nan(""), 0}).fault().code,
            FaultCode::not_finite);
  EXPECT_EQ(segment_intersections(path, {1, 1}, {1, 1}).fault().code, FaultCode::outside_domain);
}

TEST(Intersections, EndOnHostileData) {
  Random random("intersections: hostile");
  for (int i = 0; i < 200; ++i) {
    const auto hostile = [&]() -> std::optional<PlanarPath<2>> {
      BernsteinPolynomial<Complex<double>, 2> w;
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t j = 0; j < 2; ++j) {
          w[k][j] = random.chance(0.3) ? random.hostile() : random.uniform(-1.0, 1.0);
        }
      }
      auto made = PlanarPath<2>::create({0.0, 1.0}, {{{}, w, 1.0}}, false);
      if (!made) return std::nullopt;
      return *made;
    };
    const auto p = hostile(), q = hostile();
    if (!p || !q) continue;
    for (const auto& at : intersections(*p, *q)) {
      EXPECT_TRUE(at.xi_first_range.contains(at.xi_first));
      EXPECT_TRUE(at.xi_second_range.contains(at.xi_second));
    }
    const auto line = line_intersections(*p, {random.hostile(), random.hostile()},
                                         {random.hostile(), random.hostile()});
    if (!line) continue;
    for (const auto& at : *line) EXPECT_TRUE(at.xi_range.contains(at.xi));
  }
}

TEST(Intersections, NearestPointOfAPlanarPathIsItsFoot) {
  // The nearest point of a common point of two paths is that point, at distance 0 within rounding.
  Random random("intersections: nearest");
  for (int i = 0; i < 50; ++i) {
    const auto p = test::random_path<PlanarPath<2>>(random, 3, 1);
    const double xi = random.uniform(p.xi_begin(), p.xi_end());
    const auto foot = p.position(xi);
    const auto jet = p.position_derivatives<1>(xi);
    constexpr double side = 0x1.0p-4;  // nearer than the centre of curvature, mostly
    const Vector2<double> beside =
        foot + (side / p.speed(xi)) * Vector2<double>{-jet[1].y, jet[1].x};
    const auto nearest = nearest_point(p, beside).value();
    EXPECT_LE(nearest.distance.lower(), side * (1 + 64 * epsilon_double));
    const auto stationary = stationary_points(p, beside).value();
    EXPECT_TRUE(std::any_of(stationary.begin(), stationary.end(), [&](const auto& at) {
      return std::abs(at.xi - xi) < std::sqrt(epsilon_double) &&
             std::abs(at.distance - side) < std::sqrt(epsilon_double);
    }));
  }
}

}  // namespace
}  // namespace hodograph
