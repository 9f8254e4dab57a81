// SPDX-License-Identifier: MIT
// Polygons with holes as they are given: rings of points, nothing checked yet.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hodograph/algebra/vector.hpp"

namespace hodograph {

/// A closed ring of points: the last is joined to the first, which is not repeated.
using Ring = std::vector<Vector2<double>>;

/// A polygon: what its outer ring surrounds, without what its holes surround. Either direction of
/// a ring is right; a World turns outer rings anticlockwise and holes clockwise, so that the solid
/// is to the left of every edge.
struct Polygon {
  Ring outer{};
  std::vector<Ring> holes{};
  std::string name{};  ///< how reports call it; free text, may be empty

  friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// The index after i, round a ring of the given size (i < size).
constexpr std::size_t next_vertex(std::size_t i, std::size_t size) {
  return i + 1 == size ? 0 : i + 1;
}
/// The index before i, round a ring of the given size (i < size).
constexpr std::size_t previous_vertex(std::size_t i, std::size_t size) {
  return (i == 0 ? size : i) - 1;
}

/// An axis-parallel box; lower ≤ upper in both components.
struct PlanarBox {
  Vector2<double> lower{}, upper{};

  bool contains(const Vector2<double>& p) const {
    return lower.x <= p.x && p.x <= upper.x && lower.y <= p.y && p.y <= upper.y;
  }
  friend bool operator==(const PlanarBox&, const PlanarBox&) = default;
};

/// The box as a ring, anticlockwise from its lower left corner.
inline Ring to_ring(const PlanarBox& box) {
  return {box.lower, {box.upper.x, box.lower.y}, box.upper, {box.lower.x, box.upper.y}};
}

}  // namespace hodograph
