// SPDX-License-Identifier: MIT
// When a vehicle is where on its path: the arc length s as a monotone function of time. Geometry
// and time meet nowhere else.
//
// A law is a sequence of pieces of constant acceleration. On a piece of duration T, from s_i on,
// with u = (t - t_i)/T in [0, 1], it is the quadratic in Bernstein form
//   s(u) = s_i + 2u(1 - u) p + u² (p + q),   speed 2 (p (1 - u) + q u)/T,   p, q ≥ 0,
// increasing by p + q; so it is monotone whatever the rounding of p and q, and its inverse is
//   u = x/(p + √D),  x = s - s_i,  D = p² + x (q - p) = q² + (p + q - x)(p - q),
// D taken in the form without cancellation; the start and the end of a piece at rest included.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodograph/foundation/result.hpp"

namespace hodograph {

/// Speeds and longitudinal accelerations, in lengths and units of time of the caller's choice; all
/// positive but the speeds at the ends, which may be 0.
struct TrapezoidalSpeed {
  double cruise_speed = 1.0;
  double acceleration = 1.0;  ///< while getting faster
  double deceleration = 1.0;  ///< while getting slower, as a positive number
  double start_speed = 0.0, end_speed = 0.0;
};

/// s(t) on [start_time(), end_time()], from 0 to length(), with speed continuous in between.
/// A value, immutable but for its place in time.
class TimingLaw {
 public:
  /// One piece of constant acceleration; times count from the law's start.
  struct Piece {
    double begin, duration;  ///< t_i and T
    double arc_length;       ///< s_i
    double first, second;    ///< p and q
    friend bool operator==(const Piece&, const Piece&) = default;
  };

  /// s = speed · (t - start). Faults (as all that follow): not_finite, outside_domain (a length or
  /// speed that is not positive or leaves [1e-100, 1e100], with the number).
  static Result<TimingLaw> constant_speed(double length, double speed, double start_time = 0.0);

  /// The constant speed that covers the length between two times. Faults: not_increasing (arrival
  /// not after the start).
  static Result<TimingLaw> between(double length, double start_time, double arrival_time);

  /// The fastest law under the limits: accelerate, cruise, decelerate; without the cruise where the
  /// length is short (a triangle). Faults: outside_domain (a speed at an end above the cruise
  /// speed), no_interpolant (too short to change from start_speed to end_speed, with the length or
  /// the acceleration that would do).
  static Result<TimingLaw> trapezoidal(double length, const TrapezoidalSpeed& limits,
                                       double start_time = 0.0);

  /// The fastest law that stays below most_speeds[i] on [arc_lengths[i], arc_lengths[i + 1]] for
  /// every i (`cruise_speed` holds everywhere, too; a limit may be infinite). The limits hold for
  /// the law's exact s(t), up to four roundings of the speed.
  ///
  /// Method: with w = v², ds-slopes of w are at most 2a and at least -2d; a backward and a forward
  /// pass over the breakpoints give the largest w there, and trapezoids in between. Cost: linear.
  /// Faults: mismatched_size, not_increasing (arc lengths, from 0), no_interpolant (a limit of zero
  /// on a stretch, with its index; a start_speed above what limits and deceleration allow, or an
  /// end_speed that cannot be reached, with the speed that can).
  static Result<TimingLaw> under_limits(std::span<const double> arc_lengths,
                                        std::span<const double> most_speeds,
                                        const TrapezoidalSpeed& limits, double start_time = 0.0);

  /// From speeds at times: speeds[i] when durations[0] + ... + durations[i-1] have passed, linear
  /// in between; zero twice in a row is a stop. `length` is what they cover, to within rounding
  /// (accuracy::join_error), and is met exactly. Faults: mismatched_size (one speed more than
  /// durations), outside_domain (a negative speed, a duration that is not positive, a length that
  /// the speeds do not cover, with both numbers).
  static Result<TimingLaw> from_speeds(std::span<const double> durations,
                                       std::span<const double> speeds, double length,
                                       double start_time = 0.0);

  /// From the pieces() of another law: the law that has them, equal in every number.
  /// Faults: too_few (no piece), outside_domain (with the piece's index: durations that are not
  /// positive, distances that are negative, a piece that does not begin where and when the one
  /// before it ends, to within rounding).
  static Result<TimingLaw> from_pieces(std::span<const Piece> pieces, double length,
                                       double start_time = 0.0);

  double length() const { return length_; }
  double start_time() const { return start_; }
  double end_time() const { return start_ + duration_; }
  double duration() const { return duration_; }
  /// The largest speed and the largest |acceleration|, rounded up.
  double most_speed() const { return most_speed_; }
  double most_acceleration() const { return most_acceleration_; }
  const std::vector<Piece>& pieces() const { return pieces_; }

  /// The arc length at time t, within arc_length_error(). Domain: start_time() ≤ t ≤ end_time(),
  /// else Error outside_domain, as speed_at.
  double arc_length_at(double t) const;
  /// The speed at time t; at a knot the later piece's.
  double speed_at(double t) const;
  /// The first time at which the arc length s has been covered, to a few roundings of the duration
  /// (of s where the vehicle nearly stands). Domain: 0 ≤ s ≤ length(), else Error outside_domain.
  double time_at(double s) const;

  /// A bound of the rounding of arc_length_at: eight of the length and, as time itself is rounded,
  /// four of the duration times the largest speed.
  double arc_length_error() const;

  /// The same law, later by `delay` (earlier if negative). Domain: finite.
  TimingLaw delayed(double delay) const;

  /// Equal in every number.
  friend bool operator==(const TimingLaw&, const TimingLaw&) = default;

  /// The piece that holds a time counted from the start, and s there without a check of the domain:
  /// clamped to [0, length()].
  std::size_t piece_at(double local_time) const;
  double arc_length_within(std::size_t index, double local_time) const;
  /// |s''| on a piece, rounded up.
  double acceleration_bound(std::size_t index) const;

 private:
  TimingLaw() = default;
  friend class TimingLawBuilder;

  double start_ = 0.0, duration_ = 0.0, length_ = 0.0;
  double most_speed_ = 0.0, most_acceleration_ = 0.0;
  std::vector<Piece> pieces_;
};

}  // namespace hodograph
