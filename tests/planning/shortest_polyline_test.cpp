// SPDX-License-Identifier: MIT
// Shortest polylines against the full visibility graph; refusals; prohibitions; offsets.
#include "hodograph/planning/shortest_polyline.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

#include "tests/support/polyline_judge.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_worlds.hpp"
#include "tests/support/visibility_graph.hpp"

namespace hodograph {
namespace {

using P = Vector2<double>;
using Graph = test::WholeGraph;
using test::expect_sound;
using test::length_tolerance;

Ring square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

MitredWorld mitred(std::vector<Polygon> obstacles, double offset,
                   std::optional<Ring> bounds = std::nullopt) {
  return MitredWorld::create(World::create(std::move(obstacles), std::move(bounds)).value(), offset)
      .value();
}

TEST(ShortestPolyline, EqualsTheVisibilityGraphOnGenericWorlds) {
  test::compare_with_graph("generic worlds", 2000.0, 8, 150);
}
TEST(ShortestPolyline, EqualsTheVisibilityGraphOnCoarseLattices) {
  test::compare_with_graph("coarse lattices", 12.0, 9, 250);
  test::compare_with_graph("very coarse lattices", 6.0, 6, 250);
}

// ---- grown obstacles ----------------------------------------

/// Rectilinear obstacles and the rectangles that they are the union of.
struct Blocks {
  std::vector<Polygon> polygons;
  std::vector<PlanarBox> boxes;
};

Blocks random_blocks(test::Random& random, double size, std::int64_t count) {
  Blocks blocks;
  const auto number = [&](double low, double high) {
    return test::lattice(random.uniform(low, high));
  };
  for (std::int64_t i = 0; i < count; ++i) {
    const double x = number(0, size), y = number(0, size), w = number(2, 6), h = number(2, 6);
    const PlanarBox box{{x, y}, {x + w, y + h}};
    switch (random.integer(0, 2)) {
      case 0:
        blocks.polygons.push_back({to_ring(box), {}, ""});
        blocks.boxes.push_back(box);
        break;
      case 1: {  // an L
        const double u = number(1, w - 1), v = number(1, h - 1);
        blocks.polygons.push_back(
            {{{x, y}, {x + w, y}, {x + w, y + v}, {x + u, y + v}, {x + u, y + h}, {x, y + h}},
             {},
             ""});
        blocks.boxes.push_back({{x, y}, {x + w, y + v}});
        blocks.boxes.push_back({{x, y}, {x + u, y + h}});
        break;
      }
      default: {  // a frame round the block
        const PlanarBox outer{{x - 1, y - 1}, {x + w + 1, y + h + 1}};
        blocks.polygons.push_back({to_ring(outer), {to_ring(box)}, ""});
        blocks.boxes.push_back({outer.lower, {x, outer.upper.y}});
        blocks.boxes.push_back({{x + w, outer.lower.y}, outer.upper});
        blocks.boxes.push_back({outer.lower, {outer.upper.x, y}});
        blocks.boxes.push_back({{outer.lower.x, y + h}, outer.upper});
      }
    }
  }
  return blocks;
}

/// The boxes grown by d, as solids in units of 1/4.
std::vector<test::Solid> grown(const std::vector<PlanarBox>& boxes, double d) {
  std::vector<test::Solid> solids;
  for (const PlanarBox& b : boxes) {
    solids.push_back({{to_ring({{b.lower.x - d, b.lower.y - d}, {b.upper.x + d, b.upper.y + d}})}});
  }
  return solids;
}

// Mitred offsets of rectilinear polygons are unions of grown rectangles, exactly: with gaps of
// width zero, tips on edges, edges too short for their offsets.
TEST(ShortestPolyline, EqualsTheVisibilityGraphOnGrownBlocks) {
  test::Random random("grown blocks");
  int paths = 0, refused = 0;
  for (int round = 0; round < 200 && !HasFailure(); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const double size = random.chance(0.5) ? 20.0 : 35.0;
    const double d = 0.25 * static_cast<double>(random.integer(1, 8));
    const Blocks blocks = random_blocks(random, size, random.integer(1, 8));
    const World world = World::create(blocks.polygons).value();
    const MitredWorld mitred_world = MitredWorld::create(world, d).value();
    const Graph graph(grown(blocks.boxes, d), 4.0);
    for (int query = 0; query < 4; ++query) {
      const auto place = [&] {
        return P{0.25 * test::lattice(random.uniform(-8.0, 4.0 * size + 16.0)),
                 0.25 * test::lattice(random.uniform(-8.0, 4.0 * size + 16.0))};
      };
      const P start = place(), goal = place();
      if (start == goal) continue;
      const double expected = graph.shortest(start, goal);
      const auto found = shortest_polyline(mitred_world, {.start = start, .goal = goal});
      EXPECT_EQ(found.has_value(), std::isfinite(expected))
          << (found ? "" : found.fault().sentence);
      if (!found) {
        ++refused;
        continue;
      }
      ++paths;
      EXPECT_NEAR(found->length, expected, length_tolerance * expected);
      expect_sound(*found, graph);
      for (const PolylineCorner& corner : found->corners) {
        EXPECT_EQ(mitred_world.mitre_tip(corner.vertex), corner.point);
      }
    }
  }
  EXPECT_GT(paths, 200);
  EXPECT_GT(refused, 50);
}

using WholeNumber = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    512, 512, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked, void>>;

/// The strips and wedges of a world, straight from their definition, the tips as nodes.
struct PlainOffset {
  std::vector<test::Solid> solids;
  std::vector<P> tips;
};

PlainOffset plain_offset(const World& world, double d) {
  PlainOffset result;
  // The judge's pieces are a little smaller, so that the rounding of its points does not matter.
  constexpr double shrunk = 1.0 - 0x1p-20;
  result.solids = test::solids_of(world);
  for (const test::Solid& solid : test::solids_of(world)) {
    for (const Ring& ring : solid.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const P a = ring[previous_vertex(i, ring.size())], v = ring[i],
                b = ring[next_vertex(i, ring.size())];
        const auto normal = [](const P& p, const P& q) {
          const P t = q - p;
          return (1.0 / std::hypot(t.x, t.y)) * P{t.y, -t.x};
        };
        const P n = normal(a, v), m = normal(v, b);
        const auto out = [&](const P& p, const P& along) { return p + (shrunk * d) * along; };
        result.solids.push_back({{{v, out(v, m), out(b, m), b}}});
        if (cross(v - a, b - v) <= 0.0) continue;
        const P mitre = (1.0 / (1.0 + dot(n, m))) * (n + m);
        result.solids.push_back({{{v, out(v, n), out(v, mitre), out(v, m)}}});
        result.tips.push_back(v + d * mitre);
      }
    }
  }
  return result;
}

TEST(ShortestPolyline, EqualsTheVisibilityGraphOnStripsAndWedges) {
  test::Random random("strips and wedges");
  int turning = 0;
  for (int round = 0; round < 25 && !HasFailure(); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    std::vector<Polygon> obstacles;
    while (obstacles.size() < 6) {
      const P centre{random.uniform(0.0, 100.0), random.uniform(0.0, 100.0)};
      Polygon polygon{
          test::random_star(random, centre, 16.0, static_cast<std::size_t>(random.integer(3, 7))),
          {},
          ""};
      if (World::create({polygon})) obstacles.push_back(std::move(polygon));
    }
    const World world = World::create(obstacles).value();
    const double d = random.uniform(0.1, 6.0);
    const PlainOffset plain = plain_offset(world, d);
    test::VisibilityGraph<WholeNumber> graph(plain.solids, 0x1p40, false);
    for (const P& tip : plain.tips) graph.add_node(tip);
    const P start{-30.0, random.uniform(0.0, 100.0)}, goal{130.0, random.uniform(0.0, 100.0)};
    const auto found =
        shortest_polyline(MitredWorld::create(world, d).value(), {.start = start, .goal = goal});
    const double expected = graph.shortest(start, goal);
    EXPECT_EQ(found.has_value(), std::isfinite(expected)) << (found ? "" : found.fault().sentence);
    if (!found) continue;
    if (!found->corners.empty()) ++turning;
    EXPECT_NEAR(found->length, expected, length_tolerance * expected);
  }
  EXPECT_GT(turning, 15);
}

TEST(MitredWorld, PutsTipsWhereTheLinesMeetHoweverFar) {
  const auto world = mitred({{{{0, 0}, {4, 0}, {4, 3}}, {}, ""}}, 1.0);
  EXPECT_EQ(world.corner_count(), 3U);
  EXPECT_EQ(world.mitre_tip({0, 0, 1}), (P{5, -1}));
  // tan of half the angle at the origin is 1/3, at (4, 3) it is 1/2.
  EXPECT_DOUBLE_EQ(world.mitre_tip({0, 0, 0})->x, -3.0);
  EXPECT_DOUBLE_EQ(world.mitre_tip({0, 0, 0})->y, -1.0);
  EXPECT_DOUBLE_EQ(world.mitre_tip({0, 0, 2})->x, 5.0);
  EXPECT_DOUBLE_EQ(world.mitre_tip({0, 0, 2}, 2.0)->y, 7.0);
  // A needle of 2^-30 radians: the tip is 2^30 away, to rounding.
  const double half = std::ldexp(1.0, -31);
  const auto needle = mitred({{{{0, 0}, {1, -half}, {1, half}}, {}, ""}}, 0.5);
  EXPECT_DOUBLE_EQ(needle.mitre_tip({0, 0, 0})->x, -std::ldexp(1.0, 30));
  EXPECT_DOUBLE_EQ(needle.mitre_tip({0, 0, 0})->y, 0.0);
  // A notch has no tip there; a collinear point has none.
  const auto notch = mitred({{{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}, {}, ""}}, 0.1);
  EXPECT_FALSE(notch.mitre_tip({0, 0, 1}));
  EXPECT_FALSE(notch.mitre_tip({0, 0, 4}));
  EXPECT_EQ(notch.corner_count(), 4U);
}

TEST(MitredWorld, LocatesPoints) {
  using Kind = WorldPosition::Kind;
  const auto world =
      mitred({{square(0, 0, 4), {}, ""}, {square(4, 0, 4), {}, ""}}, 0.5, square(-10, -10, 30));
  const auto at = [&](double x, double y) { return world.locate({x, y}); };
  EXPECT_EQ(at(2, 2).kind, Kind::in_obstacle);
  EXPECT_EQ(at(6, 2).obstacle, 1U);
  EXPECT_EQ(at(4, 2).kind, Kind::in_band);  // on the common border
  EXPECT_EQ(at(-0.5, 2).kind, Kind::free);
  EXPECT_EQ(at(-0.5, -0.5).kind, Kind::free);
  EXPECT_EQ(at(-0.25, 2).kind, Kind::in_band);
  EXPECT_DOUBLE_EQ(at(-0.25, 2).missing, 0.25);
  EXPECT_DOUBLE_EQ(at(-0.375, -0.4375).missing, 0.0625);
  EXPECT_EQ(at(-0.4375, -0.4375).kind, Kind::in_band);  // in the wedge, further than 0.5 away
  EXPECT_EQ(at(0, 2).kind, Kind::in_band);
  EXPECT_DOUBLE_EQ(at(0, 2).missing, 0.5);
  EXPECT_EQ(at(-10, 0).kind, Kind::in_band);
  EXPECT_EQ(at(-10, 0).obstacle, WorldVertex::bounds);
  EXPECT_EQ(at(-9.5, 0).kind, Kind::free);
  EXPECT_EQ(at(-10.5, 0).kind, Kind::out_of_bounds);
  EXPECT_TRUE(world.sees({-0.5, -5}, {-0.5, 9}));
  EXPECT_FALSE(world.sees({-0.25, -5}, {-0.25, 9}));
  const auto touching = mitred({{square(0, 0, 4), {}, ""}, {square(4, 1, 4), {}, ""}}, 0.0);
  EXPECT_EQ(touching.locate({4, 2}).kind, Kind::in_obstacle);
  EXPECT_EQ(touching.locate({4, 1}).kind, Kind::free);
  EXPECT_EQ(touching.locate({4, 0.5}).kind, Kind::free);
  EXPECT_FALSE(touching.sees({4, 0}, {4, 4}));
  EXPECT_TRUE(touching.sees({4, 0}, {4, 1}));
}

// ---- refusals ----------------------------------------

TEST(ShortestPolyline, RefusesWithNames) {
  const auto world =
      mitred({{square(0, 0, 4), {}, "shed"}, {square(20, 20, 8), {square(21, 21, 6)}, "yard"}}, 0.5,
             square(-10, -10, 50));
  const auto sentence = [&](const P& start, const P& goal) {
    const auto found = shortest_polyline(world, {.start = start, .goal = goal});
    EXPECT_FALSE(found.has_value());
    return found ? std::string() : found.fault().sentence;
  };
  EXPECT_EQ(sentence({1, 1}, {9, 9}), "the start (1, 1) lies inside obstacle 0 ('shed')");
  EXPECT_EQ(sentence({9, 9}, {40, 41}), "the goal (40, 41) lies outside the bounds");
  EXPECT_EQ(sentence({9, 9}, {4.125, 2}),
            "the goal (4.125, 2) is too near to obstacle 0 ('shed'): it has a clearance of 0.125, "
            "0.375 less than the 0.5 needed (to the mitred outline)");
  EXPECT_EQ(sentence({9, 9}, {39.75, 0}).substr(0, 47),
            "the goal (39.75, 0) is too near to the bounds: ");
  EXPECT_EQ(sentence({24, 24}, {9, 9}),
            "there is no route: the start (24, 24) is walled in from the goal");
  EXPECT_EQ(sentence({std::nan(""), 0}, {9, 9}),
            "the start has the coordinate nan; coordinates are finite and at most 2^500");
  const auto found = shortest_polyline(world, {.start = {24, 24}, .goal = {9, 9}});
  EXPECT_EQ(found.fault().code, FaultCode::no_route);
  const auto near = shortest_polyline(world, {.start = {4.125, 2}, .goal = {9, 9}});
  EXPECT_EQ(near.fault().index, 0U);
  EXPECT_EQ(near.fault().quantity, "start");
  EXPECT_DOUBLE_EQ(*near.fault().value, 0.125);
  EXPECT_DOUBLE_EQ(*near.fault().bound, 0.5);
  EXPECT_FALSE(
      shortest_polyline(world, {.start = {9, 9}, .goal = {8, 8}, .obstacle_offsets = {{7, 1.0}}}));
  EXPECT_FALSE(shortest_polyline(
      world, {.start = {9, 9}, .goal = {8, 8}, .corner_offsets = {{{0, 1, 0}, 1.0}}}));
  EXPECT_FALSE(shortest_polyline(
      world, {.start = {9, 9}, .goal = {8, 8}, .corner_offsets = {{{0, 0, 0}, -1.0}}}));
  EXPECT_FALSE(shortest_polyline(
      world,
      {.start = {9, 9}, .goal = {8, 8}, .forbidden_corners = {{{0, 0, 4}, TurnSide::left}}}));
  for (const double bad : {-1.0, std::nan(""), 1e300, std::ldexp(1.0, -900)}) {
    EXPECT_FALSE(MitredWorld::create(world.world(), bad)) << bad;
  }
}

// A walled-in goal among very many corners is found out from its own side.
TEST(ShortestPolyline, FindsASmallPrisonQuickly) {
  std::vector<Polygon> obstacles{{square(-20, 0, 10), {square(-19, 1, 8)}, ""}};
  for (int i = 0; i < 60; ++i) {
    for (int k = 0; k < 60; ++k)
      obstacles.push_back({square(2 * i, 2 * k + 0.5 * (i % 2), 1), {}, ""});
  }
  const auto world = mitred(obstacles, 0.0);
  const auto found = shortest_polyline(world, {.start = {60, -1}, .goal = {-15, 5}});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.fault().sentence,
            "there is no route: the goal (-15, 5) is walled in from the start");
}

// ---- size ----------------------------------------

// What a query visits grows no faster than n log n on uniform worlds: corners and legs, counted.
TEST(ShortestPolyline, VisitsNoMoreThanItsShareOfALargeWorld) {
  test::Random random("uniform worlds");
  const auto work = [&](int side) {
    std::vector<Polygon> obstacles;
    for (int i = 0; i < side; ++i) {
      for (int k = 0; k < side; ++k) {
        const double x = i + random.uniform(0.0, 0.3), y = k + random.uniform(0.0, 0.3);
        obstacles.push_back({square(x, y, random.uniform(0.3, 0.6)), {}, ""});
      }
    }
    const auto world = mitred(std::move(obstacles), 0.01);
    double visited = 0.0;
    for (int query = 0; query < 10; ++query) {
      const double start = random.uniform(0.0, side), goal = random.uniform(0.0, side);
      const auto found =
          shortest_polyline(world, {.start = {-1.0, start}, .goal = {side + 1.0, goal}});
      if (!found) {
        ADD_FAILURE() << found.fault().sentence;
        break;
      }
      visited += static_cast<double>(found->expanded + found->visibility_tests);
      EXPECT_LT(found->expanded, world.corner_count() / 4);
    }
    return visited;
  };
  const double small = work(25), large = work(100);
  const auto n_log_n = [](double side) { return side * side * std::log(4.0 * side * side); };
  RecordProperty("growth", std::to_string(large / small));
  EXPECT_LT(large / small, n_log_n(100.0) / n_log_n(25.0));
}

// ---- choices ----------------------------------------

TEST(ShortestPolyline, HandlesTheSmallestQuestions) {
  const auto empty = MitredWorld::create(World(), 1.0).value();
  auto line = shortest_polyline(empty, {.start = {0, 0}, .goal = {3, 4}});
  ASSERT_TRUE(line);
  EXPECT_EQ(line->length, 5.0);
  EXPECT_TRUE(line->corners.empty());
  line = shortest_polyline(empty, {.start = {1, 2}, .goal = {1, 2}});
  ASSERT_TRUE(line);
  EXPECT_EQ(line->points, (std::vector<P>{{1, 2}, {1, 2}}));
  EXPECT_EQ(line->length, 0.0);
}

TEST(ShortestPolyline, BreaksTiesTheSameWayEveryTime) {
  const auto world = mitred({{square(-1, -1, 2), {}, ""}, {square(4, -1, 2), {}, ""}}, 0.25);
  const PolylineQuery query{.start = {-5, 0}, .goal = {10, 0}};
  const auto first = shortest_polyline(world, query).value();
  EXPECT_EQ(first.corners.size(), 2U);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(shortest_polyline(world, query)->points, first.points);
  }
  // Straight past corners is no turn.
  const auto along = shortest_polyline(world, {.start = {-5, 1.25}, .goal = {10, 1.25}}).value();
  EXPECT_TRUE(along.corners.empty());
}

TEST(ShortestPolyline, MovesOneTipAlone) {
  const World data = World::create({{square(0, 0, 4), {}, ""}}).value();
  const auto world = MitredWorld::create(data, 1.0).value();
  PolylineQuery query{.start = {2, -1}, .goal = {5, 2}};
  auto line = shortest_polyline(world, query).value();
  ASSERT_EQ(line.corners.size(), 1U);
  EXPECT_EQ(line.corners[0].point, (P{5, -1}));
  EXPECT_EQ(line.corners[0].vertex, (WorldVertex{0, 0, 1}));
  EXPECT_EQ(line.corners[0].side, TurnSide::left);
  query = {.start = {0, -1.5}, .goal = {5.5, 4}, .corner_offsets = {{{0, 0, 1}, 2.0}}};
  line = shortest_polyline(world, query).value();
  ASSERT_EQ(line.corners.size(), 1U);
  EXPECT_EQ(line.corners[0].point, (P{6, -2}));
  query.corner_offsets = {{{0, 0, 1}, 0.5}};  // the strips taper: their other ends stay at 1
  line = shortest_polyline(world, query).value();
  EXPECT_EQ(line.corners[0].point, (P{4.5, -0.5}));
  query.corner_offsets = {{{0, 0, 1}, 0.0}};
  line = shortest_polyline(world, query).value();
  EXPECT_EQ(line.corners[0].point, (P{4, 0}));
  // A start in the band is free where its corner gives way.
  EXPECT_FALSE(shortest_polyline(world, {.start = {4.25, -0.25}, .goal = {9, 9}}));
  EXPECT_TRUE(shortest_polyline(
      world, {.start = {4.25, -0.25}, .goal = {9, 9}, .corner_offsets = {{{0, 0, 1}, 0.125}}}));
}

// Offsets of obstacles in a query are those of a world made with them.
TEST(ShortestPolyline, ReplacesOffsetsAsIfTheWorldHadThem) {
  test::Random random("replaced offsets");
  int paths = 0;
  for (int round = 0; round < 60 && !HasFailure(); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const World world = test::random_world(random, 60.0, 5);
    const auto pick = [&] { return random.chance(0.3) ? 0.0 : random.uniform(0.1, 6.0); };
    const double before = pick(), after = pick();
    const auto changed = MitredWorld::create(world, before, 0.5).value();
    const auto made = MitredWorld::create(world, after, 0.5).value();
    PolylineQuery query{.start = test::random_place(random, world, 60.0), .goal = {-20, 70}};
    const auto expected = shortest_polyline(made, query);
    for (std::uint32_t k = 0; k < world.obstacles().size(); ++k) {
      query.obstacle_offsets.push_back({k, after});
    }
    const auto found = shortest_polyline(changed, query);
    ASSERT_EQ(found.has_value(), expected.has_value())
        << (found ? expected.fault().sentence : found.fault().sentence);
    if (!found) continue;
    ++paths;
    EXPECT_NEAR(found->length, expected->length, length_tolerance * expected->length);
  }
  EXPECT_GT(paths, 5);
}

/// The shortest polyline that keeps the prohibitions, by Dijkstra over all directed legs.
class LegGraph {
 public:
  LegGraph(const World& world, const std::vector<ForbiddenCorner>& forbidden, const Graph& graph)
      : forbidden_(forbidden), graph_(graph) {
    for (std::uint32_t k = 0; k < world.obstacles().size(); ++k) {
      const Ring& ring = world.obstacles()[k].outer;
      for (std::uint32_t i = 0; i < ring.size(); ++i) {
        nodes_.push_back({ring[i],
                          ring[previous_vertex(i, ring.size())],
                          ring[next_vertex(i, ring.size())],
                          {k, 0, i}});
      }
    }
  }
  double shortest(const P& start, const P& goal) {
    std::vector<P> points{start, goal};
    for (const Node& node : nodes_) points.push_back(node.at);
    const std::size_t n = points.size();
    std::vector<char> free(n * n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < n; ++k) {
        free[i * n + k] = points[i] != points[k] && graph_.is_free(points[i], points[k]) ? 1 : 0;
      }
    }
    const double infinite = std::numeric_limits<double>::infinity();
    const auto leg = [&](std::size_t i, std::size_t k) {
      return std::hypot(points[k].x - points[i].x, points[k].y - points[i].y);
    };
    std::vector<double> length(n * n, infinite);
    std::vector<char> settled(n * n, 0);
    for (std::size_t k = 1; k < n; ++k) {
      if (free[k] != 0) length[k] = leg(0, k);
    }
    double best = infinite;
    for (;;) {
      std::size_t next = n * n;
      for (std::size_t e = 0; e < n * n; ++e) {
        if (settled[e] == 0 && std::isfinite(length[e]) &&
            (next == n * n || length[e] < length[next])) {
          next = e;
        }
      }
      if (next == n * n) return best;
      settled[next] = 1;
      const std::size_t from = next / n, at = next % n;
      if (at == 1) return length[next];
      for (std::size_t to = 1; to < n && at > 1; ++to) {
        if (free[at * n + to] == 0 || !may_turn(nodes_[at - 2], points[from], points[to])) continue;
        length[at * n + to] = std::min(length[at * n + to], length[next] + leg(at, to));
      }
    }
  }

 private:
  struct Node {
    P at, before, after;
    WorldVertex vertex;
  };
  bool may_turn(const Node& node, const P& from, const P& to) const {
    const auto side = [&](const P& p, const P& q, const P& r) { return cross(q - p, r - p); };
    const double turn = side(from, node.at, to);
    if (turn == 0.0 || side(node.before, node.at, node.after) <= 0.0) return false;
    const double sign = turn > 0.0 ? 1.0 : -1.0;
    for (const P& p : {node.before, node.after}) {
      if (sign * side(from, node.at, p) < 0.0 || sign * side(node.at, to, p) < 0.0) return false;
    }
    for (const ForbiddenCorner& corner : forbidden_) {
      if (corner.vertex == node.vertex && sign == static_cast<double>(corner.side)) return false;
    }
    return true;
  }
  const std::vector<ForbiddenCorner>& forbidden_;
  const Graph& graph_;
  std::vector<Node> nodes_;
};

TEST(ShortestPolyline, KeepsProhibitions) {
  test::Random random("prohibitions");
  int other_ways = 0, none = 0;
  for (int round = 0; round < 60 && !HasFailure(); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    std::vector<Polygon> obstacles;
    while (obstacles.size() < 4) {
      const P corner{random.uniform(0.0, 30.0), random.uniform(0.0, 30.0)};
      obstacles.push_back({test::random_block(random, corner, 12.0), {}, ""});
    }
    const World world = World::create(obstacles).value();
    const auto index = MitredWorld::create(world, 0.0).value();
    const Graph graph(test::solids_of(world), 1.0);
    PolylineQuery query{.start = test::random_place(random, world, 40.0),
                        .goal = test::random_place(random, world, 40.0)};
    if (query.start == query.goal) continue;
    double shortest = 0.0;
    for (int step = 0; step < 4; ++step) {  // forbid one corner of the answer after the other
      const auto found = shortest_polyline(index, query);
      const double expected =
          LegGraph(world, query.forbidden_corners, graph).shortest(query.start, query.goal);
      ASSERT_EQ(found.has_value(), std::isfinite(expected)) << expected;
      if (!found) {
        ++none;
        break;
      }
      EXPECT_NEAR(found->length, expected, length_tolerance * expected);
      EXPECT_GE(found->length, shortest * (1.0 - length_tolerance));
      expect_sound(*found, graph);
      if (step > 0) ++other_ways;
      shortest = found->length;
      if (found->corners.empty()) break;
      const PolylineCorner& corner = found->corners[random.index(found->corners.size())];
      query.forbidden_corners.push_back({corner.vertex, corner.side});
    }
  }
  EXPECT_GT(other_ways, 20);
  EXPECT_GT(none, 0);
}

TEST(ShortestPolyline, KeepsOffForbiddenLegs) {
  const auto world = mitred({{square(0, 0, 4), {}, ""}}, 0.0);
  PolylineQuery query{.start = {2, -1}, .goal = {2, 6}};
  const auto first = shortest_polyline(world, query).value();
  ASSERT_EQ(first.corners.size(), 2U);
  query.forbidden_legs = {{first.corners[0].vertex, first.corners[1].vertex}};
  const auto second = shortest_polyline(world, query).value();
  EXPECT_NE(second.corners[0].vertex, first.corners[0].vertex);
  EXPECT_DOUBLE_EQ(second.length, first.length);
  query.forbidden_legs.push_back({std::nullopt, second.corners[0].vertex});
  EXPECT_EQ(shortest_polyline(world, query).fault().sentence,
            "no route from start to goal is left beside what is forbidden");
  query = {.start = {-1, -1}, .goal = {5, -1}, .forbidden_legs = {{}}};
  const auto around = shortest_polyline(world, query).value();
  EXPECT_EQ(around.points, (std::vector<P>{{-1, -1}, {0, 4}, {4, 4}, {5, -1}}));
}

// Whatever the numbers: an answer or a sentence.
TEST(ShortestPolyline, SurvivesHostileNumbers) {
  test::Random random("hostile queries");
  int answered = 0;
  for (int round = 0; round < 1500; ++round) {
    std::vector<Polygon> obstacles;
    for (int i = 0; i < 3; ++i) {
      Polygon polygon;
      for (int k = 0; k < 4; ++k) polygon.outer.push_back({random.hostile(), random.hostile()});
      if (World::create({polygon})) obstacles.push_back(std::move(polygon));
    }
    const auto world = MitredWorld::create(World::create(obstacles).value(),
                                           random.chance(0.3) ? 0.0 : std::fabs(random.hostile()));
    if (!world) {
      EXPECT_FALSE(world.fault().sentence.empty());
      continue;
    }
    const auto found = shortest_polyline(*world, {.start = {random.hostile(), random.hostile()},
                                                  .goal = {random.hostile(), random.hostile()}});
    if (!found) {
      EXPECT_FALSE(found.fault().sentence.empty());
      continue;
    }
    ++answered;
    EXPECT_TRUE(std::isfinite(found->length));
  }
  EXPECT_GT(answered, 100);
}

}  // namespace
}  // namespace hodograph
