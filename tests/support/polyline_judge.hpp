// SPDX-License-Identifier: MIT
// Shortest polylines against the full visibility graph on random worlds: what the tests sample and
// the campaign runs in full.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>

#include "hodograph/planning/shortest_polyline.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_worlds.hpp"
#include "tests/support/visibility_graph.hpp"

namespace hodograph::test {

__extension__ using Int128 = __int128;
using WholeGraph = VisibilityGraph<Int128>;

/// What the issue asks: equal to an independent solver's length to this fraction.
constexpr double length_tolerance = 1e-12;

/// The promises that every answer keeps: its legs are free, it turns where it says, towards the
/// solid, and its length is that of its legs.
inline void expect_sound(const Polyline& line, const WholeGraph& graph) {
  ASSERT_GE(line.points.size(), 2U);
  ASSERT_EQ(line.corners.size() + 2, line.points.size());
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const Vector2<double> d = line.points[i + 1] - line.points[i];
    length += std::hypot(d.x, d.y);
    EXPECT_TRUE(graph.is_free(line.points[i], line.points[i + 1])) << "leg " << i;
    if (i == 0) continue;
    const Vector2<double> before = line.points[i] - line.points[i - 1];
    EXPECT_EQ(line.corners[i - 1].point, line.points[i]);
    EXPECT_GT(cross(before, d) * static_cast<double>(line.corners[i - 1].side), 0.0);
  }
  EXPECT_NEAR(line.length, length, length_tolerance * length);
}

/// Compares with the graph; returns true where there is a path.
inline bool expect_shortest(const World& world, const Vector2<double>& start,
                            const Vector2<double>& goal) {
  const WholeGraph graph(solids_of(world), 1.0);
  const double expected = graph.shortest(start, goal);
  const auto found =
      shortest_polyline(MitredWorld::create(world, 0.0).value(), {.start = start, .goal = goal});
  if (!std::isfinite(expected)) {
    EXPECT_FALSE(found.has_value());
    return false;
  }
  if (!found) {
    ADD_FAILURE() << found.fault().sentence << "; a path of length " << expected << " exists";
    return false;
  }
  EXPECT_NEAR(found->length, expected, length_tolerance * expected);
  expect_sound(*found, graph);
  return true;
}

inline void compare_with_graph(const char* name, double size, std::size_t most_obstacles,
                               int worlds) {
  Random random(name);
  int paths = 0, turning = 0;
  for (int round = 0; round < worlds && !testing::Test::HasFailure(); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const World world =
        random_world(random, size,
                     static_cast<std::size_t>(random.integer(1, static_cast<int>(most_obstacles))));
    for (int query = 0; query < 3; ++query) {
      const Vector2<double> start = random_place(random, world, size);
      const Vector2<double> goal = random_place(random, world, size);
      if (start == goal) continue;
      if (expect_shortest(world, start, goal)) ++paths;
      ++turning;
    }
  }
  EXPECT_GT(3 * paths, turning);
}

}  // namespace hodograph::test
