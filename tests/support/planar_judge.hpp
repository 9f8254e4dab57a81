// SPDX-License-Identifier: MIT
// What the tests of the planar constructions share: the sizes that rounding refers to, and golden
// preimages.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "hodograph/path/path.hpp"
#include "tests/support/json.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {

/// The largest displacement or length coefficient of a curve, what the rounding of its end is
/// relative to.
inline double reach(const PlanarPhCurve<2>& curve) {
  double size = curve.arc_length();
  for (const auto& c : curve.integral().coefficients()) {
    size = std::max({size, largest_component(c.displacement), std::abs(c.arc_length)});
  }
  // Where terms of the preimage cancel, their squares are what was rounded.
  for (const auto& w : curve.preimage().coefficients()) {
    size = std::max(size, curve.parameter_step() * dot(w, w));
  }
  return size;
}

/// w0, w1, w2 of a golden list [[re, im], ...].
inline std::array<Complex<double>, 3> golden_preimage(const Json& list) {
  std::array<Complex<double>, 3> w;
  for (std::size_t i = 0; i < 3; ++i) w[i] = {list[i][0].number(), list[i][1].number()};
  return w;
}

inline Vector2<double> golden_plane_point(const Json& list) {
  return {list[0].number(), list[1].number()};
}

/// The largest difference of two preimages, up to their common sign.
inline double preimage_difference(const std::array<Complex<double>, 3>& a,
                                  const std::array<Complex<double>, 3>& b) {
  double same = 0.0, opposite = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    same = std::max(same, largest_component(a[i] - b[i]));
    opposite = std::max(opposite, largest_component(a[i] + b[i]));
  }
  return std::min(same, opposite);
}

/// The largest component of a preimage.
inline double preimage_size(const std::array<Complex<double>, 3>& w) {
  return std::max({largest_component(w[0]), largest_component(w[1]), largest_component(w[2])});
}

/// A direction from harmless to hostile: any, nearly the given angle, or exactly so.
inline double random_angle(Random& random, double special) {
  if (random.chance(0.5)) return random.uniform(-3.14159265358979, 3.14159265358979);
  const double offset = random.chance(0.3) ? 0.0 : random.spread(-60, -2);
  return special + offset;
}

}  // namespace hodograph::test
