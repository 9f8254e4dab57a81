// SPDX-License-Identifier: MIT
// The one table of requests.
#include <array>

#include "cli/requests/handlers.hpp"

namespace hodograph::cli {

std::span<const RequestKind> request_kinds() {
  static constexpr std::array kinds = {
      RequestKind{"hermite", "one curve from positions and derivatives at its ends",
                  answer_hermite},
      RequestKind{"hermite_path", "a path through points with their derivatives",
                  answer_hermite_path},
      RequestKind{"planar_hermite", "the planar quintic with given ends and end derivatives",
                  answer_planar_hermite},
      RequestKind{"prescribed_length", "the planar quintic between two directions, of given length",
                  answer_prescribed_length},
      RequestKind{"least_peak_curvature", "the planar quintic of least peak curvature",
                  answer_least_peak_curvature},
      RequestKind{"corner", "a corner of two lines, rounded with continuous curvature",
                  answer_corner},
      RequestKind{"rounded_polyline", "a polyline with every corner rounded",
                  answer_rounded_polyline},
      RequestKind{"waypoint_path", "a G1 path through waypoints, its tangents by T1 or T2",
                  answer_waypoint_path},
      RequestKind{"planar_spline", "the C2 path of planar quintics through points",
                  answer_planar_spline},
      RequestKind{"loop", "a closed loop of given length, as given or chosen for a purpose",
                  answer_loop},
      RequestKind{"climb", "a climb at a constant angle between two headed points, about any axis",
                  answer_climb},
      RequestKind{"climb_route",
                  "climbs through waypoints within a vehicle's angles and turn radius",
                  answer_climb_route},
      RequestKind{"helix", "the axis and the climb angles of a path in space", answer_helix},
      RequestKind{"plan", "a path among obstacles that keeps a turn radius and a clearance",
                  answer_plan},
      RequestKind{"swarm", "vehicles that arrive together or fly given paths, all pairs checked",
                  answer_swarm},
      RequestKind{"separation", "how close two vehicles come on their paths, at any time",
                  answer_separation},
      RequestKind{"fit", "a path within a tolerance of a formula, samples or an orbit", answer_fit},
      RequestKind{"orbit", "a periodic orbit, corrected", answer_orbit},
      RequestKind{"ascend", "an ascent from the Moon to its halo orbit, by optimal control",
                  answer_ascend, RequestRuns::one_at_a_time},
      RequestKind{"rational", "all rational PH curves of an indicatrix, a denominator and a degree",
                  answer_rational, RequestRuns::one_at_a_time},
      RequestKind{"rational_hermite",
                  "a rational PH curve without cusps between two points, or a proof of none",
                  answer_rational_hermite, RequestRuns::one_at_a_time},
      RequestKind{"frame", "an adapted frame along a path in space, and its twist", answer_frame},
      RequestKind{"evaluate", "everything at given points of a path", answer_evaluate},
      RequestKind{"sample", "points along a path", answer_sample},
      RequestKind{"nearest", "the points of a path that are nearest to a point", answer_nearest},
      RequestKind{"inspect", "lengths, bounds, continuity and holonomy of a path", answer_inspect},
      RequestKind{"analyse", "curvature, rotation, energy and area of a planar path, enclosed",
                  answer_analyse},
      RequestKind{"offset", "the exact rational offset of a planar path", answer_offset},
      RequestKind{"sweep", "a surface swept along a path: mesh facts, and a file", answer_sweep},
      RequestKind{"follow", "a path in least time within a tube round it", answer_follow,
                  RequestRuns::one_at_a_time},
      RequestKind{"codegen", "a path as C99 source text", answer_codegen},
      RequestKind{"mission", "waypoints along a path as a drone's mission", answer_mission},
      RequestKind{"intersections", "where a planar path meets another one, a line or a segment",
                  answer_intersections},
      RequestKind{"operate", "a path reversed, cut, joined, moved, scaled, ...", answer_operate},
  };
  return kinds;
}

}  // namespace hodograph::cli
