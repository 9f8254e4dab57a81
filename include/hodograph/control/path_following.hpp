// SPDX-License-Identifier: MIT
// Following a path as fast as a vehicle can, within a tube round it: an optimal control problem in
// the path's own coordinates (path_coordinates.hpp).
//
// In the plane the vehicle is a car, x = (ξ, η, ψ, v), u = (a, k):
//   ξ̇ = v cos ψ/h,  η̇ = v sin ψ,  ψ̇ = v k - ξ̇ χ,  v̇ = a
//   0 ≤ v ≤ speed,  -braking ≤ a ≤ acceleration,  |v² k| ≤ lateral acceleration,  |k| ≤ 1/turn
//   radius
// and in space a point, x = (ξ, η₂, η₃, v), u its acceleration: |v| ≤ speed, |u| ≤ acceleration.
// In both |η| ≤ offset, at the nodes of N equal intervals of constant control and, by keeping the
// nodes further in where it is needed, between them.
//
// With time independent, ξ is a state and the duration T is found (or given). With ξ independent,
// time is a state, t' = h/(v · e₁): singular where v · e₁ = 0, so it is asked to stay above a least
// value, and a start below that is refused.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "hodograph/control/reference_path.hpp"
#include "hodograph/control/solver.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/any_path.hpp"

namespace hodograph {

/// What the vehicle can; in the path's unit of length and in seconds.
struct FollowLimits {
  double speed = 0.0;         ///< > 0
  double acceleration = 0.0;  ///< > 0; in the plane forwards, in space in any direction
  double braking = 0.0;       ///< in the plane; 0: as the acceleration
  double lateral_acceleration = std::numeric_limits<double>::infinity();  ///< in the plane
  double turn_radius = 0.0;  ///< in the plane, the least; 0: any
  double offset = 0.0;       ///< > 0: how far it may be from the path
};

enum class FollowIndependent { time, progress };
enum class FollowAim {
  least_time,    ///< from the start to xi_end
  most_progress  ///< as far as possible within the duration; time independent
};

/// Where the vehicle is, and how it moves.
struct FollowStart {
  double xi = 0.0;
  std::array<double, 2> offset{};  ///< η, or (η₂, η₃)
  double heading = 0.0;            ///< in the plane: against the tangent, to the left
  double speed = 0.0;              ///< in space: along the tangent, where no velocity is given
  std::optional<Vector3<double>> velocity{};  ///< in space
};

/// The default of FollowOptions::effort: driving all the way at the limit of one control costs this
/// share of the duration; it settles the controls where the time does not depend on them.
inline constexpr double default_follow_effort = 0.01;
/// The default of FollowOptions::least_forward, as a share of the speed limit.
inline constexpr double default_least_forward = 0.02;

struct FollowOptions {
  FollowIndependent independent = FollowIndependent::time;
  FollowAim aim = FollowAim::least_time;
  std::optional<double> xi_end{};                ///< default: the end of the path
  std::optional<double> end_speed{};             ///< in the plane; default: any
  double duration = 0.0;                         ///< most_progress: > 0
  double effort = default_follow_effort;         ///< ≥ 0
  double least_forward = default_least_forward;  ///< v · e₁ over the speed limit, ξ independent
  std::size_t intervals = 200;                   ///< 2 ... 100000
  SolverOptions solver{};
};

/// The vehicle at one time; vectors have z = 0 in the plane.
struct FollowNode {
  double time = 0.0, xi = 0.0, arc_length = 0.0;
  std::array<double, 2> offset{};
  double heading = 0.0, speed = 0.0;
  Vector3<double> position{}, velocity{}, acceleration{};
  double along = 0.0, lateral = 0.0;  ///< acceleration along the velocity, and across it
  double stretch = 0.0;               ///< h > 0
};

struct Following {
  std::vector<FollowNode> nodes;  ///< N + 1
  double duration = 0.0, progress = 0.0;
  double tube = 0.0;  ///< the largest offset with h > 0, certified
  /// A bound of the offset over all the motion, between the nodes too, where the controls are held:
  /// from 16 or more steps between two nodes and the largest second derivative of the offset within
  /// each. Certain up to the error of those steps, 1/65536 of that of the program's own.
  double largest_offset = 0.0;
  double least_stretch = 0.0;    ///< h over σ at all those steps; certainly above 1 - offset/tube
  double largest_lateral = 0.0;  ///< in the plane: of v² |k| over all the motion, likewise a bound
  double objective = 0.0, constraint_error = 0.0, seconds = 0.0;
  std::size_t iterations = 0;  ///< of all rounds
};

/// The fastest motion along the path from a start. A local minimum, to the tolerances of the
/// solver. Between the nodes, too, the offset keeps its limit (largest_offset is a bound) and, as
/// the controls are held, a car its speed and its acceleration along, a point in space both; a
/// car's lateral acceleration is limited at the nodes, and largest_lateral tells how large it
/// becomes. Faults: outside_domain (a number out of its range; an offset at or above the tube's
/// largest radius, which the sentence names; a start outside the offset, or, with ξ independent,
/// with too small a v · e₁), unsupported (in space: lateral acceleration, turn radius, end speed;
/// most progress with ξ independent), zero_speed (a path that stands still), those of the solver.
Result<Following> follow(const AnyPath& path, const FollowLimits& limits, const FollowStart& start,
                         const FollowOptions& options = {});

}  // namespace hodograph
