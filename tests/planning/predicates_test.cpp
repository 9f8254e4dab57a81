// SPDX-License-Identifier: MIT
// The exact predicates against rational arithmetic, where filters fail: nearly collinear points,
// lattices, the ends of the range of double.
#include "src/planning/predicates.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "src/planning/box_tree.hpp"
#include "tests/support/random.hpp"

namespace hodograph::planning_detail {
namespace {

using Exact = boost::multiprecision::cpp_rational;

int judged(const Point& a, const Point& b, const Point& c) {
  const Exact ax(a.x), ay(a.y), bx(b.x), by(b.y), cx(c.x), cy(c.y);
  const Exact value = (ax - cx) * (by - cy) - (ay - cy) * (bx - cx);
  return value.sign();
}

void expect_exact(const Point& a, const Point& b, const Point& c) {
  EXPECT_EQ(orientation(a, b, c), judged(a, b, c))
      << a.x << " " << a.y << ", " << b.x << " " << b.y << ", " << c.x << " " << c.y;
}

TEST(Orientation, IsExactOnNearlyCollinearPoints) {
  test::Random random("nearly collinear points");
  int collinear = 0;
  for (int round = 0; round < 4000; ++round) {
    const Point a = random.vector2(100.0), b = random.vector2(100.0);
    const double t = random.uniform(-2.0, 3.0);
    const Point on = a + t * (b - a);
    expect_exact(a, b, {random.near(on.x, 2), random.near(on.y, 2)});
    // Exactly on the line: midpoints of lattice points.
    const auto whole = [&] { return static_cast<double>(random.integer(-1000, 1000)); };
    const Point p{whole(), whole()}, q{whole(), whole()};
    const Point middle = 0.5 * (p + q);
    expect_exact(p, q, middle);
    if (orientation(p, q, middle) == 0) ++collinear;
    expect_exact(p, q, {random.near(middle.x, 1), middle.y});
    expect_exact(p, p, q);
  }
  EXPECT_EQ(collinear, 4000);
}

TEST(Orientation, IsExactOverTheRangeOfAWorld) {
  test::Random random("orientation of hostile points");
  for (int round = 0; round < 4000; ++round) {
    const auto coordinate = [&] {
      const double x = random.hostile();
      return std::fabs(x) <= 0x1p508 ? x : std::copysign(0x1p508, x);
    };
    const Point a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
    expect_exact(a, b, {coordinate(), coordinate()});
    expect_exact(a, b, {random.near(b.x, 1), random.near(b.y, 1)});
    expect_exact(b, a, 0.5 * a);
  }
}

TEST(Sectors, AgreeWithTheirAnglesOnALattice) {
  test::Random random("sectors");
  const auto whole = [&] { return static_cast<double>(random.integer(-3, 3)); };
  const auto direction = [&] {
    for (;;) {
      const Point p{whole(), whole()};
      if (p != Point{}) return p;
    }
  };
  // Angles of small lattice directions differ by far more than this.
  constexpr double same_angle = 1e-9;
  constexpr double full = 6.283185307179586;
  const auto angle = [&](const Point& from, const Point& to) {
    const double a = std::atan2(to.y, to.x) - std::atan2(from.y, from.x);
    const double turn = a < -same_angle ? a + full : a;
    return turn > full - same_angle ? 0.0 : std::fabs(turn);
  };
  const Point apex{};
  for (int round = 0; round < test::cases(20000); ++round) {
    const Point p = direction(), q = direction(), r = direction(), s = direction();
    const double to_q = angle(p, q), to_r = angle(p, r), to_s = angle(p, s);
    const int order = std::fabs(to_q - to_r) < same_angle ? 0 : to_q < to_r ? -1 : 1;
    EXPECT_EQ(compare_angles(apex, p, q, r), order);
    const double width = to_q < same_angle ? full : to_q;
    EXPECT_EQ(strictly_inside(apex, {p, q}, r), to_r > same_angle && to_r < width - same_angle)
        << p.x << " " << p.y << ", " << q.x << " " << q.y << ", " << r.x << " " << r.y;
    // Disjoint: the second sector, from r to s, begins at or after q and ends at or before p.
    const double other = angle(r, s) < same_angle ? full : angle(r, s);
    const bool apart = to_r > width - same_angle && to_r + other < full + same_angle;
    EXPECT_EQ(disjoint(apex, {p, q}, {r, s}), apart) << to_q << " " << to_r << " " << to_s;
  }
}

TEST(AreaSign, IsExact) {
  const auto sign = [](std::vector<Point> ring) {
    const std::array<const std::vector<Point>*, 1> one{&ring};
    return area_sign(one);
  };
  EXPECT_EQ(sign({{0, 0}, {1, 0}, {0, 1}}), 1);
  EXPECT_EQ(sign({{0, 0}, {0, 1}, {1, 0}}), -1);
  EXPECT_EQ(sign({{0, 0}, {1, 1}, {2, 2}}), 0);
  EXPECT_EQ(sign({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), 0);
  const double up = std::nextafter(1.0, 2.0);
  EXPECT_EQ(sign({{0.1, 0.1}, {1, 1}, {1, up}}), 1);
  EXPECT_EQ(sign({{0.1, 0.1}, {1, up}, {1, 1}}), -1);
  const double tiny = std::ldexp(1.0, -1000);
  EXPECT_EQ(sign({{0, 0}, {tiny, 0}, {0, tiny}}), 1);
}

TEST(BoxTree, FindsWhatAScanFinds) {
  test::Random random("box tree");
  for (const std::size_t count : {0U, 1U, 2U, 8U, 9U, 64U, 65U, 700U}) {
    std::vector<Box> boxes(count);
    for (Box& box : boxes) {
      box.include(random.vector2(10.0));
      box.include(Point{box.x0 + random.unit(), box.y0 + random.unit()});
    }
    const auto order = hilbert_order(boxes);
    std::vector<Box> sorted;
    for (const std::uint32_t i : order) sorted.push_back(boxes[i]);
    const BoxTree tree(sorted);
    for (int query = 0; query < 20; ++query) {
      Box wanted;
      wanted.include(random.vector2(10.0));
      wanted.include(random.vector2(10.0));
      std::vector<bool> found(count, false);
      tree.any([&](const Box& b) { return b.meets(wanted); },
               [&](std::uint32_t i) {
                 found[i] = true;
                 return false;
               });
      for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(found[i], sorted[i].meets(wanted));
    }
  }
}

}  // namespace
}  // namespace hodograph::planning_detail
