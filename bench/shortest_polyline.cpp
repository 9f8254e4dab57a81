// SPDX-License-Identifier: MIT
// How long does the shortest polyline among 10³, 10⁴ and 10⁵ vertices take, once the world is
// indexed, against building the full visibility graph first? And the index?
//
// The graph's pairs are tested by the same exact segment test in the same tree of boxes, which is
// kind to it; the pairs of some vertices, half a million, stand for all. A quarter of a minute.
#include <algorithm>
#include <cstdio>
#include <string>

#include "hodograph/planning/shortest_polyline.hpp"
#include "support/measure.hpp"
#include "support/worlds.hpp"

namespace {

using namespace hodograph;
using Point = Vector2<double>;

std::vector<Point> vertices_of(const World& world) {
  std::vector<Point> points;
  for (const Polygon& polygon : world.obstacles()) {
    points.insert(points.end(), polygon.outer.begin(), polygon.outer.end());
  }
  return points;
}

/// From the left to the right third of the world, between its obstacles.
std::vector<PolylineQuery> queries(const World& world, std::size_t count) {
  bench::Numbers numbers;
  const PlanarBox& box = *world.box();
  std::vector<PolylineQuery> result(count);
  for (PolylineQuery& query : result) {
    query.start = {std::floor(numbers.within(0.0, 0.3) * box.upper.x),
                   numbers.next() * box.upper.y};
    query.goal = {std::ceil(numbers.within(0.7, 1.0) * box.upper.x), numbers.next() * box.upper.y};
  }
  return result;
}

void run(std::size_t size, int repetitions) {
  const World world = bench::uniform_world(size);
  const std::string name = std::to_string(world.vertex_count()) + " vertices";
  constexpr double offset = 0.02;
  bench::compare("index of a world of " + name,
                 {{"World::create", [&] { bench::keep(World::create(world.obstacles())); }, 1.0},
                  {"MitredWorld::create, no offset",
                   [&] { bench::keep(MitredWorld::create(world, 0.0)); }, 1.0},
                  {"MitredWorld::create, offsets",
                   [&] { bench::keep(MitredWorld::create(world, offset)); }, 1.0}},
                 repetitions);

  const auto plain = MitredWorld::create(world, 0.0).value();
  const auto grown = MitredWorld::create(world, offset).value();
  const auto asked = queries(world, 20);
  const auto answer = [&](const MitredWorld& index) {
    return [&] {
      for (const PolylineQuery& query : asked) bench::keep(shortest_polyline(index, query));
    };
  };
  const std::vector<Point> vertices = vertices_of(world);
  const std::size_t sources = std::min<std::size_t>(vertices.size(), 500000 / vertices.size());
  const std::size_t stride = vertices.size() / sources;
  const auto graph = [&] {
    std::size_t edges = 0;
    for (std::size_t i = 0; i < sources; ++i) {
      for (std::size_t k = 0; k < vertices.size(); ++k) {
        if (k != i * stride && plain.sees(vertices[i * stride], vertices[k])) ++edges;
      }
    }
    bench::keep(edges);
  };
  // Each pair once: half of what the sources have.
  const double graphs = 2.0 * static_cast<double>(sources) / static_cast<double>(vertices.size());
  const auto items = static_cast<double>(asked.size());
  bench::compare("a query among " + name + "; the graph from " + std::to_string(sources) +
                     " of its vertices, scaled",
                 {{"the full visibility graph", graph, graphs},
                  {"shortest_polyline, no offset", answer(plain), items},
                  {"shortest_polyline, offsets", answer(grown), items}},
                 std::max(1, repetitions / 3));
}

}  // namespace

int main() {
  run(1000, 15);
  run(10000, 9);
  run(100000, 5);
}
