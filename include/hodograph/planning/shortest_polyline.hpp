// SPDX-License-Identifier: MIT
// The shortest polyline from start to goal in the closed free space of a mitred world.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hodograph/foundation/result.hpp"
#include "hodograph/planning/mitred_world.hpp"

namespace hodograph {

/// To which side a path turns at a corner; the obstacle is on that side.
enum class TurnSide : std::int8_t { right = -1, left = 1 };

/// Another offset at one vertex: its mitre tip moves, the strips beside it taper towards it.
/// Vertices that do not stick out have no tip, and nothing changes.
struct CornerOffset {
  WorldVertex vertex{};
  double offset = 0.0;
};

/// Another offset of a whole obstacle (or WorldVertex::bounds).
struct ObstacleOffset {
  std::uint32_t obstacle = 0;
  double offset = 0.0;
};

/// A corner not to be turned at, to that side. Passing it straight is allowed.
struct ForbiddenCorner {
  WorldVertex vertex{};
  TurnSide side = TurnSide::left;
};

/// A leg not to be used, in this direction; absent stands for the start, or the goal.
struct ForbiddenLeg {
  std::optional<WorldVertex> from{}, to{};
};

/// What is asked. Offsets replace those of the world for this query alone (a corner's goes before
/// its obstacle's, the last of several counts).
struct PolylineQuery {
  Vector2<double> start{}, goal{};
  std::vector<CornerOffset> corner_offsets{};
  std::vector<ObstacleOffset> obstacle_offsets{};
  std::vector<ForbiddenCorner> forbidden_corners{};
  std::vector<ForbiddenLeg> forbidden_legs{};
};

/// A point where the polyline turns.
struct PolylineCorner {
  Vector2<double> point{};
  WorldVertex vertex{};  ///< whose mitre tip it is
  TurnSide side = TurnSide::left;
};

/// A polyline from start over the corners to goal.
struct Polyline {
  std::vector<Vector2<double>> points{};  ///< start, corners, goal
  std::vector<PolylineCorner> corners{};  ///< strictly turning, in order
  double length = 0.0;                    ///< of the legs, summed; correct to some roundings
  std::size_t expanded = 0;               ///< corners from which the search went on
  std::size_t visibility_tests = 0;       ///< segments that were tested
};

/// The shortest polyline in free space whose corners and legs are not forbidden. Without
/// prohibitions that is the shortest path of all; its length exceeds the least by rounding alone.
/// With them it is the shortest of the polylines that turn at tips only, towards the solid, and
/// never where or along what is forbidden: a next candidate, of another homotopy class or not.
/// Of several of equal length (within rounding) always the same one is returned, for the same
/// world and query.
///
/// Faults: not_finite, outside_domain (start or goal: beyond the range of coordinates; inside an
/// obstacle, named by Fault::index and the sentence; nearer than the offset, with the clearance
/// there in Fault::value, the offset in Fault::bound and the missing distance in the sentence; out
/// of bounds; an offset or vertex in the query that does not exist or fit); no_route where start
/// or goal is walled in (the sentence says which) or everything left is forbidden.
///
/// Method: A* over the corners. From a corner the path goes on only within the taut wedge between
/// its direction of arrival and the edge of the solid, and arrives only tangentially. Corners are
/// found in a tree of boxes whose lower bounds |path so far| + |to the box| + |box to goal| wait in
/// the queue beside the legs themselves; a leg's visibility is tested when its turn comes, and
/// what blocks it hides boxes behind it. Memory grows with what is visited, never with n².
Result<Polyline> shortest_polyline(const MitredWorld& world, const PolylineQuery& query);

}  // namespace hodograph
