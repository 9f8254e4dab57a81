// SPDX-License-Identifier: MIT
// A path for a vehicle among obstacles: the shortest polyline, its corners rounded so that the turn
// radius and the clearance hold at every point, and the proof of both.
//
// Source: "Path planning with Pythagorean-hodograph curves for unmanned or autonomous vehicles",
// section 7. Beyond it: every corner has the offset that its own turning angle asks (21), not one
// for all; where corners have no room the next polyline is tried; clearance and curvature are
// certified.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/path.hpp"
#include "hodograph/planning/clearance.hpp"
#include "hodograph/planning/corner_sizes.hpp"
#include "hodograph/planning/shortest_polyline.hpp"
#include "hodograph/planning/world.hpp"

namespace hodograph {

/// What the vehicle asks of its path; lengths in the units of the world.
struct VehicleLimits {
  double turn_radius = 0.0;  ///< the least radius of curvature; > 0
  double clearance = 0.0;  ///< the least distance from obstacles and bounds, beyond half the width
  double width = 0.0;      ///< of the vehicle

  /// How far its middle stays from obstacles and bounds.
  double distance() const { return clearance + 0.5 * width; }
};

/// What is proven of a path in a world.
struct PlanCertificate {
  Enclosure arc_length;     ///< contains the length
  Enclosure curvature;      ///< contains the largest |κ|
  PathClearance clearance;  ///< of every obstacle the path comes near, and of the bounds

  /// True where they prove the limits: |κ| ≤ 1/turn_radius, and the distance from every obstacle at
  /// least limits.distance(), up to planning_tolerance of the largest coordinate.
  bool proves(const VehicleLimits& limits, double largest_coordinate) const;
};

/// The part of the largest coordinate within which a clearance is kept: the width of an enclosure
/// (clearance_width) and the rounding of the path's points are below it. Paths are planned with
/// twice as much to spare, but for a start or goal that is exactly at the clearance.
inline constexpr double planning_tolerance = 0x1p-36;

/// The largest |κ| of a path, enclosed to 2^-40 of it.
Enclosure largest_curvature(const PlanarPath<2>& path);

/// Length, curvature and clearance of any planar path in a world, enclosed; obstacles further than
/// `reach` are not listed. Faults: those of ClearanceIndex::clearance.
Result<PlanCertificate> certify_plan(const PlanarPath<2>& path, const ClearanceIndex& index,
                                     double reach);

/// What a planner is asked.
struct PlanRequest {
  Vector2<double> start{}, goal{};
  /// What the corners' sizes are chosen for.
  CornerAim aim = CornerAim::smallest;
  /// By how much more than limits.distance() all obstacles are grown, so that corners have room to
  /// cut into. Absent: with `smallest`, every corner has what its own angle asks; with the other
  /// aims all have what the sharpest corner asks, as in the paper, and the others may be larger.
  std::optional<double> corner_offset{};
  /// How many polylines are tried where corners have no room.
  std::size_t most_attempts = 64;
};

/// A corner that could not be made: why a polyline was given up.
struct CrowdedCorner {
  Vector2<double> point{};
  WorldVertex vertex{};
  double turning_angle = 0.0;  ///< of the polyline there, positive to the left
  double turn_radius = 0.0;    ///< about the largest radius that the lines beside it have room for
};

/// A path that keeps its limits, with the proof.
struct Plan {
  PlanarPath<2> path;  ///< lines and corners in turn, G²; ξ is the arc length, see corner.hpp
  Polyline polyline;   ///< what was rounded
  std::vector<double> legs;     ///< L of every corner
  std::vector<double> offsets;  ///< the offset of every corner's vertex
  PlanCertificate certificate;
  std::size_t attempts = 0;               ///< polylines tried, this one included
  std::vector<CrowdedCorner> given_up{};  ///< one for every attempt that was given up
};

/// Plans in one world for one vehicle. A value; copies share what does not change. Safe to use from
/// several threads.
class Planner {
 public:
  /// Indexes the world. Faults: outside_domain (limits that are negative or not finite, or a turn
  /// radius of 0), those of MitredWorld::create. Cost: O(n log n).
  static Result<Planner> create(World world, const VehicleLimits& limits);

  const World& world() const;
  const VehicleLimits& limits() const;

  /// The path of the shortest polyline that can be rounded, among those tried in ascending order of
  /// their length. Nothing is returned that the certificate does not prove.
  ///
  /// Method: the polyline is shortest among obstacles grown by limits.distance(); each of its
  /// corners takes an offset of (21) for its own turning angle, and the polyline is found anew,
  /// until the offsets suffice. Then the legs are chosen (corner_sizes) between (20) and what the
  /// offset allows. Where a line is too short for its two corners, three things are tried: larger
  /// offsets at one of them alone, at both, and another polyline without that line.
  ///
  /// Faults: those of shortest_polyline; no_route where nothing tried can be rounded: the sentence
  /// names the corner of the shortest polyline that has no room, and the radius that would have
  /// (Fault::value the turn radius, Fault::bound that radius).
  Result<Plan> plan(const PlanRequest& request) const;

 private:
  struct Indexes;
  explicit Planner(std::shared_ptr<const Indexes> indexes) : indexes_(std::move(indexes)) {}
  std::shared_ptr<const Indexes> indexes_;
};

}  // namespace hodograph
