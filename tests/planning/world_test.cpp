// SPDX-License-Identifier: MIT
// Worlds: what is accepted, what is mended and reported, what is refused and with which sentence.
#include "hodograph/planning/world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/random.hpp"

namespace hodograph {
namespace {

using P = Vector2<double>;

Polygon polygon(Ring outer, std::vector<Ring> holes = {}) {
  return {std::move(outer), std::move(holes), ""};
}

Ring square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

Ring reversed(Ring ring) { return {ring.rbegin(), ring.rend()}; }

Fault fault_of(Polygon obstacle) {
  const auto world = World::create({std::move(obstacle)});
  EXPECT_FALSE(world.has_value());
  return world.has_value() ? Fault{} : world.fault();
}

TEST(World, TurnsRingsAndReportsIt) {
  const auto world =
      World::create({polygon(reversed(square(0, 0, 4)), {square(1, 1, 1)})}, square(-9, -9, 20));
  ASSERT_TRUE(world);
  EXPECT_EQ(world->obstacles()[0].outer[0], (P{0, 4}));
  EXPECT_EQ(world->obstacles()[0].outer[1], (P{0, 0}));
  EXPECT_EQ(world->obstacles()[0].holes[0][1], (P{1, 2}));
  EXPECT_EQ(world->vertex_count(), 12U);
  EXPECT_EQ(*world->box(), (PlanarBox{{-9, -9}, {11, 11}}));
  using Kind = WorldRepair::Kind;
  EXPECT_EQ(world->repairs(),
            (std::vector<WorldRepair>{{Kind::turned_ring, 0, 0, 0}, {Kind::turned_ring, 0, 1, 0}}));
  EXPECT_EQ(to_text(world->repairs()[1]),
            "obstacle 0, hole 1 went round the other way and was turned");
}

TEST(World, TakesRepeatedPointsOutAndKnowsTheirNumbers) {
  const Ring data{{0, 0}, {0, 0}, {0, 2}, {2, 2}, {2, 2}, {2, 2}, {2, 0}, {0, 0}, {-0.0, 0}};
  const auto world = World::create({polygon(data)});
  ASSERT_TRUE(world);
  const Ring& ring = world->obstacles()[0].outer;
  EXPECT_EQ(ring, (Ring{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  ASSERT_EQ(world->repairs().size(), 6U);
  EXPECT_EQ(world->repairs()[0].vertex, 1U);
  EXPECT_EQ(world->repairs()[1].vertex, 4U);
  EXPECT_EQ(world->repairs()[4].vertex, 8U);
  EXPECT_EQ(to_text(world->repairs()[0]),
            "obstacle 0, outer ring: point 1 repeats the one before it");
  for (std::uint32_t i = 0; i < ring.size(); ++i) {
    EXPECT_EQ(data[world->source_vertex({0, 0, i})], ring[i]) << i;
  }
}

TEST(World, KeepsCollinearPointsAndAcceptsTouchingRings) {
  EXPECT_TRUE(World::create({polygon({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}})}));
  // An outer ring that touches itself at a point from inside (two lobes) and from outside.
  EXPECT_TRUE(World::create({polygon({{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}})}));
  EXPECT_TRUE(World::create({polygon(
      {{0, 0}, {6, 0}, {6, 6}, {3, 6}, {2, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {1, 6}, {0, 6}})}));
  // A slit from the outer ring to what would be a hole.
  EXPECT_TRUE(World::create({polygon({{0, 0},
                                      {4, 0},
                                      {4, 4},
                                      {0, 4},
                                      {0, 2},
                                      {1, 2},
                                      {1, 3},
                                      {3, 3},
                                      {3, 1},
                                      {1, 1},
                                      {1, 2},
                                      {0, 2}})}));
  // Holes that touch the outer ring and each other, at points and along an edge.
  EXPECT_TRUE(World::create({polygon(square(0, 0, 8), {{{0, 4}, {2, 2}, {2, 6}}})}));
  EXPECT_TRUE(World::create(
      {polygon(square(0, 0, 8), {{{1, 1}, {2, 2}, {1, 3}}, {{2, 2}, {3, 1}, {3, 3}}})}));
  // Different obstacles may do anything to each other.
  EXPECT_TRUE(World::create({polygon(square(0, 0, 2)), polygon(square(1, 1, 2)),
                             polygon(square(0, 0, 2)), polygon(square(2, 0, 2))}));
}

TEST(World, RefusesWhatBoundsNoRegion) {
  EXPECT_EQ(fault_of(polygon({{0, 0}, {2, 2}, {2, 0}, {0, 3}})).sentence,
            "obstacle 0, outer ring crosses itself between the edges from point 0 and from point 2 "
            "near (2, 0)");
  const auto kind_of = [](Polygon p) { return fault_of(std::move(p)).code; };
  // A figure of eight through a common vertex, with lobes of different size.
  EXPECT_EQ(kind_of(polygon({{0, 0}, {2, 2}, {5, 5}, {5, 0}, {2, 2}, {0, 4}})),
            FaultCode::outside_domain);
  // A crossing through the inside of an edge that a vertex lies on.
  EXPECT_EQ(kind_of(polygon({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {1, -3}, {0, 4}})),
            FaultCode::outside_domain);
  // Twice round, and twice along the same edge.
  EXPECT_EQ(kind_of(polygon({{0, 0}, {4, 0}, {0, 4}, {0, 0}, {3, 0}, {0, 3}})),
            FaultCode::outside_domain);
  EXPECT_EQ(fault_of(polygon({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 6}, {2, 4}, {0, 4}})).sentence,
            "obstacle 0, outer ring turns straight back at point 4");
  EXPECT_EQ(fault_of(polygon({{0, 0}, {1, 1}, {2, 2}})).sentence,
            "obstacle 0, outer ring surrounds no area: its points lie on one line, or what it "
            "surrounds to the left and to the right is equal");
  EXPECT_EQ(fault_of(polygon(square(0, 0, 4), {square(3, 1, 2)})).sentence.substr(0, 40),
            "obstacle 0, outer ring crosses hole 1 be");
  EXPECT_EQ(fault_of(polygon(square(0, 0, 4), {square(5, 1, 2)})).sentence,
            "obstacle 0, hole 1 lies outside the outer ring");
  EXPECT_EQ(fault_of(polygon(square(0, 0, 9), {square(1, 1, 5), square(2, 2, 1)})).sentence,
            "obstacle 0, hole 2 lies inside another hole");
  // Two holes outside that touch only each other; a hole that leaves a wall without thickness.
  EXPECT_EQ(kind_of(polygon(square(0, 0, 4), {square(5, 5, 1), square(6, 6, 1)})),
            FaultCode::outside_domain);
  EXPECT_NE(fault_of(polygon(square(0, 0, 4), {square(0, 1, 2)})).sentence.find("wall"),
            std::string::npos);
  EXPECT_NE(fault_of(polygon(square(0, 0, 4), {square(0, 0, 4)})).sentence.find("wall"),
            std::string::npos);
  EXPECT_NE(
      fault_of(polygon(square(0, 0, 9), {square(1, 1, 2), square(3, 1, 2)})).sentence.find("wall"),
      std::string::npos);
}

TEST(World, RefusesBadNumbersWithTheirPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Fault fault = fault_of(polygon({{0, 0}, {1, 0}, {1, nan}}));
  EXPECT_EQ(fault.code, FaultCode::not_finite);
  EXPECT_EQ(fault.index, 0U);
  fault = fault_of(polygon({{0, 0}, {1, 0}, {1, 1e200}}));
  EXPECT_EQ(fault.code, FaultCode::outside_domain);
  EXPECT_EQ(fault.value, 1e200);
  fault = fault_of(polygon({{0, 0}, {1, 0}, {0, 0}}));
  EXPECT_EQ(fault.code, FaultCode::too_few);
  EXPECT_EQ(fault.sentence,
            "obstacle 0, outer ring has 2 different points; a ring needs at least 3");
  fault = fault_of({{}, {}, "shed\nof\x1b[31m " + std::string(80, 'x')});
  EXPECT_EQ(fault.sentence,
            "obstacle 0 ('shed?of?[31m xxxxxxxxxxxxxxxxxxxxxxxxxxx…'), outer ring has 0 different "
            "points; a ring needs at least 3");
  const auto bounds = World::create({}, Ring{{0, 0}, {2, 2}, {2, 0}, {0, 3}});
  ASSERT_FALSE(bounds);
  EXPECT_EQ(bounds.fault().index, std::nullopt);
  EXPECT_EQ(bounds.fault().sentence.substr(0, 26), "the bounds crosses itself ");
}

// Rings of hostile numbers: a fault or a world, never a crash; what is accepted is normal.
TEST(World, SurvivesHostileRings) {
  test::Random random("hostile worlds");
  int accepted = 0;
  for (int round = 0; round < 4000; ++round) {
    const auto ring = [&] {
      Ring points;
      const auto count = random.integer(0, 7);
      for (std::int64_t i = 0; i < count; ++i) {
        points.push_back(round % 2 == 0 ? P{random.hostile(), random.hostile()}
                                        : P{static_cast<double>(random.integer(0, 4)),
                                            static_cast<double>(random.integer(0, 4))});
      }
      return points;
    };
    Polygon obstacle = polygon(ring());
    if (random.chance(0.3)) obstacle.holes.push_back(ring());
    const auto world = World::create({obstacle});
    if (!world) {
      EXPECT_FALSE(world.fault().sentence.empty());
      continue;
    }
    ++accepted;
    const auto again = World::create(world->obstacles());
    ASSERT_TRUE(again);
    EXPECT_TRUE(again->repairs().empty());
    EXPECT_EQ(again->obstacles(), world->obstacles());
  }
  EXPECT_GT(accepted, 100);
}

}  // namespace
}  // namespace hodograph
