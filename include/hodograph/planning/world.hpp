// SPDX-License-Identifier: MIT
// A world: the polygonal obstacles that a vehicle avoids and the bounds it stays in, checked once.
//
// Obstacles may be concave, have holes, touch, overlap and contain each other; what is solid is
// their union. Rings come out with the solid to the left of every edge: outer rings anticlockwise,
// holes clockwise. Repeated points are taken out and rings turned where needed; both are reported.
// Collinear points stay. A ring may touch itself or another ring of its polygon (also along an
// edge, as where a slit joins a hole to the outer ring), but not cross it. All decisions are exact
// on the coordinates as given.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hodograph/foundation/result.hpp"
#include "hodograph/planning/polygon.hpp"

namespace hodograph {

/// A vertex of a world: obstacle, ring (0 the outer one, k its hole k - 1) and vertex, counted in
/// the World's own rings (after cleaning and turning). World::source_vertex gives the index in the
/// data.
struct WorldVertex {
  /// The number of the bounds where an obstacle's is asked for.
  static constexpr std::uint32_t bounds = 0xffffffff;

  std::uint32_t obstacle = 0;
  std::uint32_t ring = 0;
  std::uint32_t vertex = 0;

  friend auto operator<=>(const WorldVertex&, const WorldVertex&) = default;
};

/// Something about the data that was mended.
struct WorldRepair {
  enum class Kind {
    repeated_point,  ///< `vertex` (of the data) equals the one before it and was taken out
    turned_ring,     ///< the ring went round the other way
  };
  Kind kind{};
  std::uint32_t obstacle = 0;  ///< WorldVertex::bounds for the bounds
  std::uint32_t ring = 0;      ///< in the data: 0 the outer one, k hole k - 1
  std::uint32_t vertex = 0;    ///< in the data

  friend bool operator==(const WorldRepair&, const WorldRepair&) = default;
};

/// A vertex that lies on an edge of its own polygon (or bounds), or on a vertex of it.
struct RingContact {
  WorldVertex vertex{};
  /// Where the edge starts that has the solid to its left; the vertex may be at that point, but not
  /// at the other end.
  WorldVertex edge{};

  friend bool operator==(const RingContact&, const RingContact&) = default;
};

/// The repair in words: "obstacle 3 ('shed'), outer ring: point 4 repeats the one before it".
std::string to_text(const WorldRepair& repair);

/// Coordinates of a world are at most this large, so that no product of two differences overflows.
inline constexpr double largest_world_coordinate = 0x1p500;

/// Obstacles and bounds that passed the checks. A value; cheap to move.
class World {
 public:
  /// A world without obstacles and bounds.
  World() = default;

  /// Checks and normalises.
  /// Faults: not_finite (a coordinate); outside_domain (one beyond largest_world_coordinate; a ring
  /// that crosses itself or another of its polygon, turns straight back, has no area or runs along
  /// another so that a wall without thickness remains; a hole outside its polygon or inside another
  /// hole); too_few (a ring with fewer than three different points).
  /// The sentence names obstacle, ring and vertices as in the data; Fault::index is the obstacle
  /// (none for the bounds). Cost: O(n log n) for rings whose edges meet few others.
  static Result<World> create(std::vector<Polygon> obstacles, std::optional<Ring> bounds = {});

  const std::vector<Polygon>& obstacles() const { return obstacles_; }
  /// Where the vehicle stays, anticlockwise; nothing outside is free.
  const std::optional<Ring>& bounds() const { return bounds_; }
  /// What was mended, in the order of the data.
  const std::vector<WorldRepair>& repairs() const { return repairs_; }

  /// Where rings touch themselves or others of their polygon.
  const std::vector<RingContact>& contacts() const { return contacts_; }

  /// All vertices of obstacles and bounds.
  std::size_t vertex_count() const { return vertex_count_; }
  /// The box about obstacles and bounds; absent where there are none.
  const std::optional<PlanarBox>& box() const { return box_; }

  /// The ring of a vertex. Domain: obstacle and ring exist.
  const Ring& ring(std::uint32_t obstacle, std::uint32_t ring) const;
  /// The coordinates of a vertex. Domain: it exists.
  const Vector2<double>& point(const WorldVertex& vertex) const {
    return ring(vertex.obstacle, vertex.ring)[vertex.vertex];
  }
  /// Index of a vertex in the ring of the data, repeated points counted. Domain: it exists.
  std::size_t source_vertex(const WorldVertex& vertex) const;
  /// How sentences call an obstacle: "obstacle 3 ('shed')", "the bounds".
  std::string name_of(std::uint32_t obstacle) const;

 private:
  std::vector<Polygon> obstacles_;
  std::optional<Ring> bounds_;
  std::vector<WorldRepair> repairs_;
  std::vector<RingContact> contacts_;
  std::optional<PlanarBox> box_;
  std::size_t vertex_count_ = 0;
};

}  // namespace hodograph
