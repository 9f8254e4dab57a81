// SPDX-License-Identifier: MIT
// Sequences of points in the plane, from tame to hostile.
#pragma once

#include <array>
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

/// The kinds of hostile_points.
inline constexpr std::array<const char*, 11> kinds_of_points{
    "tame walk",     "walk that turns back", "anywhere in a square",  "spiral",
    "star polygon",  "nearly double points", "collinear runs",        "to and fro on a line",
    "steps 1e-9..9", "on a small grid",      "right angles and cusps"};

/// `count` points of one of the kinds; points equal to their predecessor occur in some of them.
inline Points points_of_kind(Random& random, std::size_t kind, std::size_t count) {
  Points points;
  switch (kind) {
    case 0:
      return random_walk(random, count, 0.6);
    case 1:
      return random_walk(random, count, 2.0, 4.0);
    case 2:
      for (std::size_t i = 0; i < count; ++i) points.push_back(random.vector2(1.0));
      return points;
    case 3: {
      const double turn = random.uniform(0.05, 2.5), growth = random.uniform(0.9, 1.2);
      for (std::size_t i = 0; i < count; ++i) {
        const double k = static_cast<double>(i), r = std::pow(growth, k);
        points.push_back({r * std::cos(turn * k), r * std::sin(turn * k)});
      }
      return points;
    }
    case 4: {
      const auto skip = static_cast<double>(random.integer(1, static_cast<std::int64_t>(count)));
      for (std::size_t i = 0; i < count; ++i) {
        const double t =
            2 * std::numbers::pi * skip * static_cast<double>(i) / static_cast<double>(count);
        points.push_back({std::cos(t), std::sin(t)});
      }
      return points;
    }
    case 5: {
      points = random_walk(random, count, 0.8);
      for (std::size_t i = 1; i < count; ++i) {
        const double near = 1e-9;  // not a tolerance: the distance asked for
        if (random.chance(0.3)) points[i] = points[i - 1] + random.vector2(near);
      }
      return points;
    }
    case 6: {
      points = random_walk(random, count, 1.0);
      for (std::size_t i = 2; i < count; ++i) {
        if (random.chance(0.7)) {
          points[i] = points[i - 1] + random.uniform(0.5, 2.0) * (points[i - 1] - points[i - 2]);
        }
      }
      return points;
    }
    case 7: {
      const Vector2<double> unit =
          random.chance(0.5) ? Vector2<double>{1, 0} : random.unit_vector2();
      for (std::size_t i = 0; i < count; ++i) points.push_back(random.uniform(-1.0, 1.0) * unit);
      return points;
    }
    case 8: {
      Vector2<double> at{};
      for (std::size_t i = 0; i < count; ++i) {
        points.push_back(at);
        at = at + std::pow(10.0, random.uniform(-9.0, 9.0)) * random.unit_vector2();
      }
      return points;
    }
    case 9:
      for (std::size_t i = 0; i < count; ++i) {
        points.push_back({static_cast<double>(random.integer(-2, 2)),
                          static_cast<double>(random.integer(-2, 2))});
      }
      return points;
    default: {
      Vector2<double> at{}, step{1, 0};
      for (std::size_t i = 0; i < count; ++i) {
        points.push_back(at);
        const auto turn = random.integer(0, 3);
        if (turn == 1) step = {-step.y, step.x};
        if (turn == 2) step = {step.y, -step.x};
        if (turn == 3) step = {-step.x, -step.y};
        at = at + step;
      }
      return points;
    }
  }
}

}  // namespace hodograph::test
