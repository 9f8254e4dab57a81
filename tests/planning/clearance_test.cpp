// SPDX-License-Identifier: MIT
// The clearance of a path: it holds at every sampled point, and is as narrow as promised.
#include "hodograph/planning/clearance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "hodograph/construction/corner.hpp"
#include "hodograph/construction/planar_spline.hpp"
#include "tests/support/random.hpp"
#include "tests/support/star_worlds.hpp"

namespace hodograph {
namespace {

using test::Random;
using P = Vector2<double>;

PlanarPath<2> random_path(Random& random) {
  std::vector<P> points;
  for (int k = 0; k < 6; ++k) points.push_back({random.uniform(-12, 12), random.uniform(-12, 12)});
  return planar_spline(points).value().path;
}

long double distance(const P& p, const P& a, const P& b) {
  const long double dx = static_cast<long double>(b.x) - a.x,
                    dy = static_cast<long double>(b.y) - a.y;
  const long double px = static_cast<long double>(p.x) - a.x,
                    py = static_cast<long double>(p.y) - a.y;
  const long double t = std::clamp((px * dx + py * dy) / (dx * dx + dy * dy), 0.0L, 1.0L);
  return std::hypot(px - t * dx, py - t * dy);
}

struct Sampled {
  double distance = std::numeric_limits<double>::infinity();
  bool inside = false;
};
/// The least distance over points along the path from the boundary of one obstacle.
Sampled sampled(const PlanarPath<2>& path, const Ring& ring, int count, bool bounds = false) {
  Sampled result;
  for (int k = 0; k <= count; ++k) {
    const double xi = path.xi_begin() + (path.xi_end() - path.xi_begin()) * k / count;
    const P p = path.position(path.clamped(xi));
    bool odd = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const P &a = ring[i], &b = ring[next_vertex(i, ring.size())];
      result.distance = std::min(result.distance, static_cast<double>(distance(p, a, b)));
      if ((a.y <= p.y) != (b.y <= p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
        odd = !odd;
      }
    }
    result.inside = result.inside || odd != bounds;
  }
  return result;
}

TEST(Clearance, HoldsAtEverySampledPoint) {
  Random random("clearance");
  constexpr int samples = 2000;
  int met = 0, missed = 0;
  for (int round = 0; round < 40; ++round) {
    std::optional<Ring> bounds;
    if (round % 2 == 0) bounds = Ring{{-30, -30}, {30, -30}, {30, 30}, {-30, 30}};
    const World world = test::star_world(random, 8, 0.2, 2.0, bounds);
    const ClearanceIndex index(world);
    const auto path = random_path(random);
    const double reach = random.uniform(0.5, 20.0);
    const auto clearance = index.clearance(path, reach);
    ASSERT_TRUE(clearance) << clearance.fault().sentence;
    const double step = 0.5 * path.arc_length() / samples * 4.0;  // the speed varies
    const double width = clearance_width * 40.0;
    auto found = clearance->near.begin();
    const auto judge = [&](std::uint32_t obstacle, const Ring& ring) {
      const Sampled s = sampled(path, ring, samples, obstacle == WorldVertex::bounds);
      if (found == clearance->near.end() || found->obstacle != obstacle) {
        EXPECT_GE(s.distance, reach);
        EXPECT_FALSE(s.inside);
        return;
      }
      EXPECT_LE(found->distance.width(), width);
      EXPECT_LE(found->distance.lower(), s.distance);
      if (s.inside) {
        ++met;
        EXPECT_EQ(found->distance.lower(), 0.0);
      } else {
        ++missed;
        EXPECT_GE(found->distance.upper(), s.distance - step);
        // The place is what it is said to be.
        const P at = path.position(path.clamped(found->xi)) - found->nearest;
        EXPECT_NEAR(std::hypot(at.x, at.y), found->distance.upper(), step);
      }
      ++found;
    };
    for (std::uint32_t k = 0; k < world.obstacles().size(); ++k) {
      judge(k, world.obstacles()[k].outer);
    }
    if (world.bounds()) judge(WorldVertex::bounds, *world.bounds());
    EXPECT_EQ(found, clearance->near.end());
  }
  EXPECT_GT(met, 20);
  EXPECT_GT(missed, 20);
}

TEST(Clearance, IsKnownInClosedForm) {
  // A large corner of turning angle 90° at (1, -1) about a spike whose tip is (0, 0): the middle is
  // nearest, at √2 less the deviation.
  const auto world = World::create({{{{0, 0}, {-5, 5.1}, {-5.1, 5}}, {}, "spike"}}).value();
  const ClearanceIndex index(world);
  const std::vector<P> points{{-9, -1}, {1, -1}, {1, 9}};
  for (const double leg : {5.0, 6.0, 7.0}) {
    const auto path = rounded_polyline_of_legs(points, std::vector<double>{leg}).value();
    const auto corner = corner_of_leg({points[0], points[1], points[2]}, leg).value();
    const auto clearance = index.clearance(path, 10.0);
    ASSERT_TRUE(clearance);
    ASSERT_EQ(clearance->near.size(), 1U);
    const double expected = std::sqrt(2.0) - corner.shape.deviation;
    const Enclosure& found = clearance->near[0].distance;
    EXPECT_NEAR(found.lower(), expected, clearance_width * 10.0);
    EXPECT_NEAR(found.upper(), expected, clearance_width * 10.0);
    EXPECT_EQ(clearance->near[0].nearest, (P{0, 0}));
    EXPECT_EQ(clearance->least(), found);
  }
}

TEST(Clearance, WithinAnObstacleOrOutOfBoundsIsNone) {
  const auto world =
      World::create(
          {{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{2, 2}, {7, 2}, {7, 7}, {2, 7}}}, "wall"}},
          Ring{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}})
          .value();
  const ClearanceIndex index(world);
  const auto line = [](const P& a, const P& b) {
    return rounded_polyline(std::vector<P>{a, b}, CornerRule{}).value();
  };
  const auto in_wall = index.clearance(line({1, 1}, {1, 8}), 0.0);
  ASSERT_EQ(in_wall->near.size(), 1U);
  EXPECT_EQ(in_wall->near[0].distance, Enclosure(0.0));
  const auto in_hole = index.clearance(line({3, 4}, {6, 4}), 5.0);
  ASSERT_EQ(in_hole->near.size(), 1U);
  EXPECT_NEAR(in_hole->near[0].distance.lower(), 1.0, clearance_width * 20.0);
  const auto out = index.clearance(line({30, 0}, {31, 0}), 1.0);
  ASSERT_EQ(out->near.size(), 1U);
  EXPECT_EQ(out->near[0].obstacle, WorldVertex::bounds);
  EXPECT_EQ(out->near[0].distance, Enclosure(0.0));
  const auto far = index.clearance(line({-15, -15}, {-15, 15}), 2.0);
  EXPECT_TRUE(far->near.empty());
  EXPECT_EQ(far->least().lower(), 2.0);
  // Along the wall: the distance is 0 and the enclosure says so.
  const auto along = index.clearance(line({-3, 9}, {12, 9}), 0.0);
  ASSERT_EQ(along->near.size(), 1U);
  EXPECT_EQ(along->near[0].distance.lower(), 0.0);

  const auto bad = index.clearance(line({0, 0}, {1, 1}), -1.0);
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.fault().code, FaultCode::outside_domain);
}

}  // namespace
}  // namespace hodograph
