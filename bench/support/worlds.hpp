// SPDX-License-Identifier: MIT
// Worlds for benchmarks: star-shaped polygons with eight vertices on a jittered grid.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "hodograph/planning/world.hpp"
#include "measure.hpp"

namespace hodograph::bench {

/// About `vertices` vertices; obstacles stand one a cell of side 1 and cover about a third of the
/// plane. From (0, 0) to (side, side), where side² is the number of obstacles.
inline World uniform_world(std::size_t vertices) {
  Numbers numbers;
  constexpr std::size_t corners = 8;
  constexpr double turn = 6.283185307179586;
  const auto side =
      static_cast<std::size_t>(std::sqrt(static_cast<double>(vertices) / corners) + 0.5);
  std::vector<Polygon> obstacles;
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      const double x = static_cast<double>(column) + 0.5 + numbers.within(-0.1, 0.1);
      const double y = static_cast<double>(row) + 0.5 + numbers.within(-0.1, 0.1);
      const double first = numbers.next();
      Ring ring;
      for (std::size_t k = 0; k < corners; ++k) {
        const double angle = turn * (static_cast<double>(k) + first) / corners;
        const double radius = numbers.within(0.2, 0.38);
        ring.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
      }
      obstacles.push_back({std::move(ring), {}, ""});
    }
  }
  return World::create(std::move(obstacles)).value();
}

}  // namespace hodograph::bench
