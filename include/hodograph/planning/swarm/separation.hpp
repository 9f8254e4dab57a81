// SPDX-License-Identifier: MIT
// How close two moving vehicles come: a rigorous enclosure of the least distance over all times at
// which both are there, not over samples.
//
// Method: on a time interval the difference of two motions is replaced by its chord. A motion of
// arc length ΔS between points |C| apart stays within ½√(ΔS² - |C|²) of its chord at proportional
// arc length (the ellipse of a string of that length), and within κΔS²/8 where |κ| ≤ κ; and s(t)
// within aΔt²/8 of its own chord where |s''| ≤ a. So the distance of the chord of the difference
// from zero, less both, bounds the least distance from below with an error of second order, and
// best-first bisection of the time closes in. All roundings are bounded beforehand and taken off.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "hodograph/foundation/answer.hpp"
#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/planning/swarm/timed_motion.hpp"

namespace hodograph {

/// Above it heights would drown what distances there are in the plane: 2^20 leaves them half of the
/// digits of a double.
inline constexpr double largest_vertical_scale = 0x1.0p20;

/// How a distance is measured and how far it is refined.
struct SeparationGoal {
  /// The enclosure's width over the shorter path's length. Rounding (some 1e-13 of the lengths and
  /// coordinates) and `most_evaluations` may end the refinement earlier; the enclosure holds all
  /// the same.
  double relative_width = 0x1.0p-30;  // not a tolerance: the accuracy asked for, 9.3e-10
  /// Heights count times this: 1/3 for rotorcraft whose downwash reaches three times as far as
  /// their sides, so that the distance is the ellipsoidal norm |(x, y, z/3)|. Positive, at most
  /// largest_vertical_scale.
  double vertical_scale = 1.0;
  std::size_t most_evaluations = 1000000;
};

/// The least distance of two motions.
struct Separation {
  Enclosure distance;                 ///< contains the minimum over all common times
  double time = 0.0;                  ///< at which a distance of at most distance.upper() occurs
  Enclosure time_range;               ///< contains every time at which the minimum is attained
  Vector3<double> first{}, second{};  ///< both places at `time`
  std::size_t evaluations = 0;        ///< times at which both motions were evaluated
};

/// The times at which both motions are there, an empty optional if there are none. Where one stands
/// before it starts or after it arrives, from the earlier start to the later arrival: outside, the
/// distance stays what it is there.
struct TimeWindow {
  double begin, end;
};
std::optional<TimeWindow> common_window(const TimedMotion& a, const TimedMotion& b);

/// The least distance. Faults: outside_domain (no common time, with both numbers; a goal that is
/// not positive). Cost: with the default goal some 60 evaluations for two quintics; for motions
/// that keep the same distance throughout, up to some ten thousand.
Result<Separation> least_separation(const TimedMotion& a, const TimedMotion& b,
                                    const SeparationGoal& goal = {});

/// Whether the motions keep at least `distance`: yes and no are certain. Undecided only where the
/// least distance is equal to it within the goal's width. Two motions without a common time do.
/// Stops as soon as it is known.
Answer separated_by(const TimedMotion& a, const TimedMotion& b, double distance,
                    const SeparationGoal& goal = {});

/// The method of "Path planning with Pythagorean-hodograph curves for unmanned or autonomous
/// vehicles", section 4: the distance at times `step` apart (and at the end of the common window).
/// The distance changes by at most v_a + v_b a unit of time, so the minimum is at least the sampled
/// one less (v_a + v_b) step/2 (times the vertical scale where that exceeds 1); with two unit
/// speeds that is the step.
struct SteppedSeparation {
  double sampled =
      0.0;  ///< the least of the samples: an upper bound of the minimum, up to rounding
  double time = 0.0;
  std::size_t index = 0;  ///< of the sample
  Enclosure distance;     ///< the minimum's enclosure that the samples prove
  std::size_t evaluations = 0;
};
/// Faults: those of least_separation, outside_domain (a step that is not positive, or one that asks
/// for more than 1e9 samples).
Result<SteppedSeparation> stepped_separation(const TimedMotion& a, const TimedMotion& b,
                                             double step, const SeparationGoal& goal = {});

/// A stretch of time at which two motions are, or may be, closer than a distance.
struct ClosePassage {
  double begin, end;  ///< closer than the distance at no time outside all passages
  bool certain;       ///< at some time within certainly closer, rounding included
};
/// All times at which the motions come closer than `distance`, to within `resolution` of time.
/// Faults: as stepped_separation. Empty where there is no common time.
Result<std::vector<ClosePassage>> close_passages(const TimedMotion& a, const TimedMotion& b,
                                                 double distance, double resolution,
                                                 const SeparationGoal& goal = {});

}  // namespace hodograph
