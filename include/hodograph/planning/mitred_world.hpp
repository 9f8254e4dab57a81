// SPDX-License-Identifier: MIT
// A world whose obstacles are grown by a distance, with mitred corners, indexed for queries.
//
// The obstacle grown by d is the union of the closed polygon, of the strip of width d along the
// free side of each edge, and at each corner that sticks out (less than a straight angle of solid)
// of the wedge between the two strips: up to the mitre tip, where the lines at distance d from
// both edges meet, however far that is. No mitre is ever truncated. Everything nearer than d to the
// obstacle is covered, and the wedges are more than that. The bounds are grown inwards likewise.
//
// The tips are rounded to doubles, each coordinate to a few units in its last place; from then on
// they are the exact data. With U the union of all grown obstacles, what is *free* is the closure
// of the complement of U: a path may touch U and run along it, and pass a point in which grown
// obstacles merely touch; it may not pass between two that touch along a stretch (a corridor of
// width zero). No union is computed: a segment is blocked exactly where it runs through the inside
// of a piece, or has pieces on both sides along a stretch. Shortest paths turn at mitre tips only.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "hodograph/foundation/result.hpp"
#include "hodograph/planning/world.hpp"

namespace hodograph {

namespace planning_detail {
class MitredIndex;
}

/// An offset, unless it is 0, is at least this fraction of the world's largest coordinate: 2^12
/// units in the last place of a coordinate, so that strips are not lost in rounding.
inline constexpr double least_offset_ratio = 0x1p-40;

/// Where a point stands.
struct WorldPosition {
  enum class Kind {
    free,           ///< in the closed free space
    in_obstacle,    ///< inside an obstacle, or between two that touch
    in_band,        ///< outside, but inside a grown obstacle
    out_of_bounds,  ///< outside the bounds
  };
  Kind kind = Kind::free;
  std::uint32_t obstacle = 0;  ///< whose: the one with the largest `missing`; WorldVertex::bounds
  /// in_band: by how much the offset had to be smaller for the point to be free of every grown
  /// obstacle; the distance to the obstacle is offset - missing where the strip of an edge covers
  /// the point, and more in the wedge of a corner. Correct to a few roundings.
  double missing = 0.0;
};

/// A value; copies share the index, which never changes. Safe to use from several threads.
class MitredWorld {
 public:
  /// Grows and indexes. `bounds_offset` (the same as `offset` unless given) is that of the bounds.
  /// Units: those of the coordinates. Faults: not_finite, outside_domain (an offset that is
  /// negative, below least_offset_ratio, or whose mitre at some vertex leaves the range of
  /// coordinates; Fault::index is the obstacle).
  /// Cost: O(n log n).
  static Result<MitredWorld> create(World world, double offset,
                                    std::optional<double> bounds_offset = std::nullopt);

  const World& world() const;
  double offset() const;
  double bounds_offset() const;

  /// The mitre tips that a shortest path may turn at (those that no single strip covers).
  std::size_t corner_count() const;
  /// The tip of a vertex for an offset d ≥ 0 there (unless given, that of its obstacle); absent
  /// where the solid angle is not less than a straight one. Domain: the vertex exists.
  std::optional<Vector2<double>> mitre_tip(const WorldVertex& vertex,
                                           std::optional<double> d = std::nullopt) const;

  /// Where a finite point stands; exact (but for the number `missing`).
  WorldPosition locate(const Vector2<double>& point) const;
  /// True where the closed segment stays in free space. Exact. Domain: finite ends.
  bool sees(const Vector2<double>& a, const Vector2<double>& b) const;

  const planning_detail::MitredIndex& index() const { return *index_; }

 private:
  explicit MitredWorld(std::shared_ptr<const planning_detail::MitredIndex> index)
      : index_(std::move(index)) {}
  std::shared_ptr<const planning_detail::MitredIndex> index_;
};

}  // namespace hodograph
