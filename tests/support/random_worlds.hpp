// SPDX-License-Identifier: MIT
// Random worlds on a lattice of whole numbers: generic on a fine one; touching, overlapping,
// collinear and repeated on a coarse one.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "hodograph/planning/world.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {

inline double lattice(double x) { return std::round(x); }

/// A star-shaped ring, rounded to the lattice (which may make it cross itself).
inline Ring random_star(Random& random, const Vector2<double>& centre, double radius,
                        std::size_t corners) {
  Ring ring;
  const double first = random.unit();
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle =
        2.0 * std::numbers::pi * (static_cast<double>(k) + first) / static_cast<double>(corners);
    const double r = random.uniform(0.3, 1.0) * radius;
    ring.push_back(
        {lattice(centre.x + r * std::cos(angle)), lattice(centre.y + r * std::sin(angle))});
  }
  return ring;
}

/// A rectangle, sometimes with a corner cut out (an L) or extra points on its sides.
inline Ring random_block(Random& random, const Vector2<double>& corner, double size) {
  const double w = lattice(random.uniform(1.0, size)), h = lattice(random.uniform(1.0, size));
  const double x = lattice(corner.x), y = lattice(corner.y);
  if (w >= 2 && h >= 2 && random.chance(0.3)) {
    const double u = lattice(random.uniform(1.0, w - 1.0)),
                 v = lattice(random.uniform(1.0, h - 1.0));
    return {{x, y}, {x + w, y}, {x + w, y + v}, {x + u, y + v}, {x + u, y + h}, {x, y + h}};
  }
  if (w >= 2 && random.chance(0.2)) {
    return {{x, y}, {x + 1, y}, {x + w, y}, {x + w, y + h}, {x + w - 1, y + h}, {x, y + h}};
  }
  return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
}

/// A world in the square [0, size]² of whole numbers with about `obstacles` obstacles.
inline World random_world(Random& random, double size, std::size_t obstacles) {
  std::vector<Polygon> polygons;
  while (polygons.size() < obstacles) {
    Polygon polygon;
    const Vector2<double> place{random.uniform(0.0, size), random.uniform(0.0, size)};
    const double reach = size * random.uniform(0.08, 0.3);
    switch (random.integer(0, 4)) {
      case 0:
      case 1:
        polygon.outer =
            random_star(random, place, reach, static_cast<std::size_t>(random.integer(3, 8)));
        break;
      case 2: {  // a frame with a hole, which may touch it
        const double x = lattice(place.x), y = lattice(place.y);
        const double w = 2.0 + lattice(reach), t = random.chance(0.3) ? 0.0 : 1.0;
        polygon.outer = {{x, y}, {x + w, y}, {x + w, y + w}, {x, y + w}};
        polygon.holes = {
            {{x + 1, y + t}, {x + w - 1, y + 1}, {x + w - 1, y + w - 1}, {x + 1, y + w - 1}}};
        break;
      }
      case 3:
        if (!polygons.empty() && random.chance(0.3)) {  // a copy, the same or moved
          polygon = polygons[random.index(polygons.size())];
          const double dx = lattice(random.uniform(-1.5, 1.5));
          for (auto& p : polygon.outer) p.x += dx;
          for (auto& hole : polygon.holes) {
            for (auto& p : hole) p.x += dx;
          }
          break;
        }
        [[fallthrough]];
      default:
        polygon.outer = random_block(random, place, 2.0 + reach);
    }
    if (World::create({polygon})) polygons.push_back(std::move(polygon));
  }
  std::optional<Ring> bounds;
  if (random.chance(0.3)) {
    bounds = to_ring(PlanarBox{{-1.0, -1.0}, {size + 1.0, size + 1.0}});
    if (random.chance(0.5)) (*bounds)[2] = {lattice(0.8 * size), lattice(0.8 * size)};
  }
  return World::create(std::move(polygons), std::move(bounds)).value();
}

/// A point of the lattice; often a vertex or on an edge of the world.
inline Vector2<double> random_place(Random& random, const World& world, double size) {
  if (!world.obstacles().empty() && random.chance(0.3)) {
    const Ring& ring = world.obstacles()[random.index(world.obstacles().size())].outer;
    return ring[random.index(ring.size())];
  }
  return {lattice(random.uniform(-0.1 * size, 1.1 * size)),
          lattice(random.uniform(-0.1 * size, 1.1 * size))};
}

}  // namespace hodograph::test
