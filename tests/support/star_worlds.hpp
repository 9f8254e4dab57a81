// SPDX-License-Identifier: MIT
// Star-shaped obstacles anywhere in a square about the origin; they may overlap.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "hodograph/planning/world.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {

/// 3 to 10 corners, each at 0.3 to 1 of the radius.
inline Ring star(Random& random, const Vector2<double>& middle, double radius) {
  Ring ring;
  const std::size_t count = 3 + random.index(8);
  for (std::size_t k = 0; k < count; ++k) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
    const double r = radius * random.uniform(0.3, 1.0);
    ring.push_back({middle.x + r * std::cos(angle), middle.y + r * std::sin(angle)});
  }
  return ring;
}

/// `count` stars with middles within 10 of the origin in both coordinates, radii from `smallest` to
/// `largest`.
inline World star_world(Random& random, std::size_t count, double smallest, double largest,
                        std::optional<Ring> bounds = {}) {
  std::vector<Polygon> obstacles;
  for (std::size_t k = 0; k < count; ++k) {
    const Vector2<double> middle{random.uniform(-10, 10), random.uniform(-10, 10)};
    obstacles.push_back({star(random, middle, random.uniform(smallest, largest)), {}, ""});
  }
  return World::create(std::move(obstacles), std::move(bounds)).value();
}

}  // namespace hodograph::test
