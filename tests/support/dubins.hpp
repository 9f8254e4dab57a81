// SPDX-License-Identifier: MIT
// The length of the shortest path of bounded curvature between two directed points, by the six
// words of Dubins in the normalised form of Shkel and Lumelsky: a judge of what no path can do.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "hodograph/construction/prescribed_length.hpp"

namespace hodograph::test {

/// Up to rounding; angles within 2^-46 of a full turn count as none, so it may be too short by
/// that.
inline double dubins_length(const DirectedPoint& begin, const DirectedPoint& end, double radius) {
  using std::acos, std::atan2, std::cos, std::sin, std::sqrt;
  const double turn = 2.0 * std::numbers::pi;
  constexpr double no_turn = 0x1.0p-46;   // rounding of angles
  constexpr double touching = 0x1.0p-40;  // rounding of squared distances of some radii
  const auto mod = [&](double x) {
    const double wrapped = x - turn * std::floor(x / turn);
    return wrapped > turn - no_turn ? 0.0 : wrapped;
  };
  const Vector2<double> way = end.position - begin.position;
  const double d = std::hypot(way.x, way.y) / radius;
  const double along = d > 0.0 ? atan2(way.y, way.x) : 0.0;
  const double a = mod(atan2(begin.direction.y, begin.direction.x) - along);
  const double b = mod(atan2(end.direction.y, end.direction.x) - along);
  const double sa = sin(a), sb = sin(b), ca = cos(a), cb = cos(b), cab = cos(a - b);
  double best = std::numeric_limits<double>::infinity();
  const auto take = [&](double t, double p, double q) { best = std::min(best, t + p + q); };
  if (const double s = 2 + d * d - 2 * cab + 2 * d * (sa - sb); s > -touching) {
    const double w = atan2(cb - ca, d + sa - sb);
    take(mod(w - a), sqrt(std::max(0.0, s)), mod(b - w));
  }
  if (const double s = 2 + d * d - 2 * cab + 2 * d * (sb - sa); s > -touching) {
    const double w = atan2(ca - cb, d - sa + sb);
    take(mod(a - w), sqrt(std::max(0.0, s)), mod(w - b));
  }
  if (const double s = d * d - 2 + 2 * cab + 2 * d * (sa + sb); s >= 0.0) {
    const double p = sqrt(s), w = atan2(-ca - cb, d + sa + sb) - atan2(-2.0, p);
    take(mod(w - a), p, mod(w - b));
  }
  if (const double s = d * d - 2 + 2 * cab - 2 * d * (sa + sb); s >= 0.0) {
    const double p = sqrt(s), w = atan2(ca + cb, d - sa - sb) - atan2(2.0, p);
    take(mod(a - w), p, mod(b - w));
  }
  if (const double c = (6 - d * d + 2 * cab + 2 * d * (sa - sb)) / 8; std::abs(c) <= 1.0) {
    const double p = mod(turn - acos(c)), t = mod(a - atan2(ca - cb, d - sa + sb) + p / 2);
    take(t, p, mod(a - b - t + p));
  }
  if (const double c = (6 - d * d + 2 * cab + 2 * d * (sb - sa)) / 8; std::abs(c) <= 1.0) {
    const double p = mod(turn - acos(c)), t = mod(-a - atan2(ca - cb, d + sa - sb) + p / 2);
    take(t, p, mod(b - a - t + p));
  }
  return radius * best;
}

}  // namespace hodograph::test
