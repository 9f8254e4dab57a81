// SPDX-License-Identifier: MIT
// Sequences of points in the plane, from tame to hostile.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "hodograph/algebra/vector.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {

using Points = std::vector<Vector2<double>>;

/// A walk that turns by at most `turn` times 90° at a time; steps spread over a factor of
/// 2^evenness.
inline Points random_walk(Random& random, std::size_t count, double turn, double evenness = 1.0) {
  Points points;
  Vector2<double> at = random.vector2(1.0);
  double angle = random.uniform(0.0, 2 * std::numbers::pi);
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(at);
    angle += 0.5 * std::numbers::pi * random.uniform(-turn, turn);
    const double step = std::exp2(random.uniform(-0.5, 0.5) * evenness);
    at = at + Vector2<double>{step * std::cos(angle), step * std::sin(angle)};
  }
  return points;
}

}  // namespace hodograph::test
