// SPDX-License-Identifier: MIT
// The pieces of grown obstacles, the corners a path may turn at, and the trees over both.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "box_tree.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/planning/mitred_world.hpp"
#include "hodograph/planning/shortest_polyline.hpp"
#include "predicates.hpp"

namespace hodograph::planning_detail {

inline constexpr std::uint32_t nothing = 0xffffffff;

/// A ring in the flat list of vertices, the solid to its left. Points where its edges are touched
/// by vertices of the same polygon are vertices here, too.
struct RingSpan {
  std::uint32_t obstacle = 0, ring = 0;
  std::uint32_t begin = 0, size = 0;
  std::uint32_t world_begin = 0, world_size = 0;  ///< likewise, among the World's vertices
  double offset = 0.0;
};

/// What the solid does at a vertex.
enum class VertexKind : std::uint8_t {
  tip,         ///< sticks out: the strips beside it meet at the mitre tip
  inner_tip,   ///< does not: the strips are cut where their outer lines meet
  square_end,  ///< does not, and the edges are too short for that: the strips end squarely
};

/// A piece of a grown obstacle. With corners: a convex polygon, anticlockwise, whose inside
/// blocks; its first edge is the outer line of the strip. Without: the edge itself, with the solid
/// to its left.
struct Blocker {
  std::array<Point, 4> corner{};
  std::uint32_t edge = 0;  ///< the vertex that the edge starts from
  std::uint8_t corners = 0;
  bool is_first =
      false;  ///< of the pieces of its edge: stands for the edge itself where one counts
};

/// A point that a shortest path may turn at, and the solid's edges there.
struct Corner {
  Point at{}, before{}, after{};  ///< the solid is anticlockwise from `after` to `before`
  std::uint32_t vertex = 0;
};

/// Pieces and corners, each with its tree; items stand in the order of the tree.
struct Pieces {
  std::vector<Blocker> blockers;
  BoxTree blocker_tree;
  std::vector<Corner> corners;
  BoxTree corner_tree;

  /// The largest size of a coordinate.
  double reach() const;
};

/// A change of the world for one query.
struct Patch {
  std::vector<std::uint32_t> replaced_edges;     ///< sorted; their pieces in the index do not count
  std::vector<std::uint32_t> replaced_vertices;  ///< sorted; likewise their corners
  Pieces extra;
  double reach = 0.0;  ///< no coordinate of an extra piece is larger

  bool replaces_edge(std::uint32_t edge) const {
    return std::binary_search(replaced_edges.begin(), replaced_edges.end(), edge);
  }
  bool replaces_vertex(std::uint32_t vertex) const {
    return std::binary_search(replaced_vertices.begin(), replaced_vertices.end(), vertex);
  }
};

/// What stops a segment: the piece, in the index or (`is_extra`) in the patch; `nothing` as its
/// number where two pieces touch.
struct Obstruction {
  std::uint32_t blocker = nothing;
  bool is_extra = false;
};

class MitredIndex {
 public:
  static Result<std::shared_ptr<const MitredIndex>> create(World world, double offset,
                                                           double bounds_offset);

  const World& world() const { return world_; }
  double offset() const { return offset_; }
  double bounds_offset() const { return bounds_offset_; }
  const Pieces& pieces() const { return pieces_; }
  /// No coordinate of a piece is larger.
  double reach() const { return reach_; }

  std::size_t vertex_count() const { return points_.size(); }
  const Point& point(std::uint32_t v) const { return points_[v]; }
  const RingSpan& ring_of(std::uint32_t v) const { return rings_[ring_of_[v]]; }
  std::uint32_t next(std::uint32_t v) const {
    const RingSpan& ring = ring_of(v);
    return v + 1 == ring.begin + ring.size ? ring.begin : v + 1;
  }
  std::uint32_t previous(std::uint32_t v) const {
    const RingSpan& ring = ring_of(v);
    return (v == ring.begin ? ring.begin + ring.size : v) - 1;
  }
  VertexKind kind(std::uint32_t v) const { return kinds_[v]; }
  WorldVertex identity(std::uint32_t v) const { return identities_[v]; }
  /// The vertex before v along the border of the solid that the edge from v belongs to: where rings
  /// of a polygon touch, each sector of solid between two of their edges counts alone.
  std::uint32_t solid_before(std::uint32_t v) const { return solid_before_[v]; }
  /// Absent where there is no such vertex.
  std::optional<std::uint32_t> find(const WorldVertex& vertex) const;

  /// The point at distance d from the lines of both edges at a vertex, on their free sides.
  Point meeting_point(std::uint32_t v, double d) const;
  /// The outer ends of the strip of an edge, for the offsets of the index.
  const Point& outer_begin(std::uint32_t edge) const { return outer_ends_[edge].first; }
  const Point& outer_end(std::uint32_t edge) const { return outer_ends_[edge].second; }

  /// The pieces for other offsets.
  /// Faults: outside_domain, not_finite (an offset, a vertex that does not exist, a tip out of
  /// range).
  Result<Patch> patch(std::span<const ObstacleOffset> obstacles,
                      std::span<const CornerOffset> corners) const;

  /// What stops the open segment from a to b first found; absent where it is free.
  std::optional<Obstruction> obstruction(const Point& a, const Point& b, const Patch* patch) const;

  /// Where a point stands. Exact, but for the number `missing`.
  WorldPosition locate(const Point& p, const Patch* patch) const;

  /// The fault of an offset that is negative, not finite or too small.
  std::optional<Fault> unusable_offset(double offset, const char* quantity) const;

 private:
  class Builder;
  MitredIndex() = default;
  void flatten();
  void pair_touching_edges();
  /// The kinds of the vertices of a ring for an offset.
  std::vector<VertexKind> kinds_of(const RingSpan& ring, double d) const;

  World world_;
  double offset_ = 0.0, bounds_offset_ = 0.0, reach_ = 0.0;
  std::vector<RingSpan> rings_;
  std::vector<Point> points_;
  std::vector<std::uint32_t> ring_of_;
  std::vector<WorldVertex> identities_;
  std::vector<std::uint32_t> solid_before_;
  std::vector<std::uint32_t> flat_;  // the number here of each of the World's vertices
  std::vector<std::uint32_t> first_ring_of_obstacle_;
  std::vector<VertexKind> kinds_;
  std::vector<std::pair<Point, Point>> outer_ends_;
  Pieces pieces_;
  std::vector<Corner> hidden_corners_;  // inside a single piece: only a patch can free them
};

}  // namespace hodograph::planning_detail
