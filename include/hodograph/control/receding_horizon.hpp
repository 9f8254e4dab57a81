// SPDX-License-Identifier: MIT
// Following a path in real time: the same problem solved again and again, each time from where the
// vehicle is found to be, starting from the answer before.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "hodograph/control/path_following.hpp"

namespace hodograph {

/// To what a plan is solved, SolverOptions::tolerance and constraint_tolerance: the next plan comes
/// before more digits would matter.
inline constexpr double horizon_tolerance = 1e-5;

/// How far ahead is planned, and how it is solved.
struct HorizonOptions {
  double step = 0.1;                      ///< seconds between two plans; > 0
  std::size_t intervals = 30;             ///< of one step each
  double effort = default_follow_effort;  ///< as FollowOptions
  /// How much a second at the offset's limit costs, in seconds; > 0 keeps the vehicle near the
  /// path.
  double centre = 0.05;
  double time_limit_s = 0.0;  ///< of one plan; what is reached by then is used. 0: none
  std::size_t max_iterations = 200;
  /// For a car: offset and lateral acceleration as hard limits. A plan then may not exist, and a
  /// measured offset beyond the limit is moved to it.
  bool hard = false;
};

/// One plan.
struct HorizonPlan {
  Following following;     ///< what is planned; its first control is the one to apply
  double latency_s = 0.0;  ///< from the measured state to the plan, all included
  std::size_t iterations = 0;
  bool warm = false;       ///< started from the plan before
  bool finished = true;    ///< solved to the tolerances
  bool recovered = false;  ///< the warm start failed, or the vehicle was out of bounds: solved anew
};

/// Plans for one path and one vehicle (a car in the plane, a point in space): as far along the path
/// as possible within intervals · step seconds. Time is the independent variable.
///
/// A horizon ends at a speed that the path's sharpest bend allows, so that the next plan exists; it
/// should be as long as braking to that takes. For a car the offset and the lateral acceleration
/// are soft: each may be exceeded in proportion to the other, at a cost that nothing else
/// outweighs, so that a plan exists wherever the car was pushed to inside the path's own tube; the
/// largest offset planned stands in the answer. A measured state out of its bounds otherwise
/// (speed, heading; in space also the offset) is moved to the nearest that keeps them, and
/// `recovered` is set. Not for several threads at once; what is computed is deterministic, but for
/// the time limit.
class RecedingHorizon {
 public:
  /// Faults: those of follow().
  static Result<RecedingHorizon> make(const AnyPath& path, const FollowLimits& limits,
                                      const HorizonOptions& options = {});
  RecedingHorizon(RecedingHorizon&&) noexcept;
  RecedingHorizon& operator=(RecedingHorizon&&) noexcept;
  ~RecedingHorizon();

  /// The plan from a measured state. The first is solved from a guess along the path, the others
  /// from the plan before, moved on by one interval.
  /// Faults: outside_domain (a state that is not finite, or not on the path), those of the solver.
  Result<HorizonPlan> plan(const FollowStart& measured);

  /// Where the vehicle is after one step of the last plan's first control, by the model. Needs a
  /// plan (contract).
  FollowStart predicted() const;

 private:
  struct State;
  explicit RecedingHorizon(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace hodograph
