// SPDX-License-Identifier: MIT
// Two motions on one clock: what they are at a time, and how close they may come within an
// interval.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "hodograph/planning/swarm/separation.hpp"

namespace hodograph::planning_detail {

constexpr double rounding_unit = std::numeric_limits<double>::epsilon();

/// One of the two at one time.
struct MovingPoint {
  Place place;
  std::uint32_t piece = 0;  ///< of the timing law
};

/// A motion on a clock that starts at `base`.
class Clocked {
 public:
  Clocked(const TimedMotion& motion, double base, double span)
      : places_(&motion.places()), law_(&motion.law()), offset_(base - motion.start_time()) {
    // Every place is off by its own error; besides, s by the rounding of the law and of the clock
    // (offset and its sum with the time), and by the path's and the law's lengths not being equal.
    // Where s is off, the point is by no more, but for the gap of a join in between.
    const double clock = 2.0 * (std::abs(offset_) + span) * rounding_unit * law_->most_speed();
    along_ = law_->arc_length_error() + clock + std::abs(law_->length() - places_->length());
    beside_ = along_ + places_->largest_gap();
  }

  MovingPoint at(double time) const {
    const Where where = place_of(time);
    return {places_->at(where.s), where.piece};
  }
  MovingPoint between(double time, const MovingPoint& a, const MovingPoint& b) const {
    const Where where = place_of(time);
    if (where.s == a.place.arc_length) return {a.place, where.piece};
    if (where.s == b.place.arc_length) return {b.place, where.piece};
    return {places_->between(where.s, a.place, b.place), where.piece};
  }

  /// The rounding of s, and that of the point besides its place's own.
  double along() const { return along_; }
  double error_of(const MovingPoint& p) const { return p.place.error + beside_; }

  /// No further than this is the motion from the chord of its computed points, at proportional
  /// time, during the time h from a to b.
  double deviation(const MovingPoint& a, const MovingPoint& b, double h) const {
    // The chord of the exact points is off from that of the computed ones by at_ends at most. The
    // bounds below are those of the exact curve between the computed parameters, whose ends are
    // apart from the exact ones by at_ends, too: that moves a point, and its place on the chord.
    const double at_a = error_of(a), at_b = error_of(b), at_ends = 3.0 * std::max(at_a, at_b);
    // A motion that begins or ends within rounding of the interval's ends moves on by at most this
    // while its speed jumps.
    const double jump = 2.0 * along_;
    const double length = std::max(0.0, b.place.arc_length - a.place.arc_length);
    if (length == 0.0) return at_ends + jump;
    const Bend bend = places_->bend(a.place, b.place);
    const double longest = length + 2.0 * (along_ + bend.gap);
    const double chord = std::max(0.0, norm(b.place.point - a.place.point) - (at_a + at_b));
    const double string =
        0.5 * std::sqrt(std::max(0.0, (longest - chord) + 8.0 * rounding_unit * longest) *
                        (longest + chord));
    const double bow = longest * (0.125 * bend.curvature * longest + 0.25 * bend.turn) + bend.gap;
    const double pace = 0.125 * acceleration(a.piece, b.piece) * h * h;
    constexpr double rounded_up = 1.0 + 16.0 * rounding_unit;
    return (std::min(string, bow) + pace + bend.gap) * rounded_up + at_ends + jump;
  }

  /// The same for a motion that may start or arrive in between: s may be anywhere between its ends.
  double loose_deviation(const MovingPoint& a, const MovingPoint& b, double h) const {
    return deviation(a, b, h) + std::max(0.0, b.place.arc_length - a.place.arc_length);
  }

  const TimingLaw& law() const { return *law_; }
  /// The clock's time at the law's own.
  double clock_time(double local) const { return local - offset_; }

 private:
  struct Where {
    double s;
    std::uint32_t piece;
  };
  Where place_of(double time) const {
    const double local = std::clamp(time + offset_, 0.0, law_->duration());
    const std::size_t piece = law_->piece_at(local);
    return {std::min(law_->arc_length_within(piece, local), places_->length()),
            static_cast<std::uint32_t>(piece)};
  }
  double acceleration(std::size_t first, std::size_t last) const {
    constexpr std::size_t most = 8;
    if (last - first >= most) return law_->most_acceleration();
    double largest = law_->acceleration_bound(first);
    for (std::size_t i = first + 1; i <= last; ++i) {
      largest = std::max(largest, law_->acceleration_bound(i));
    }
    return largest;
  }

  const PathPlaces* places_;
  const TimingLaw* law_;
  double offset_, along_ = 0.0, beside_ = 0.0;
};

/// Both at one time, and their difference as it counts (heights scaled).
struct Meeting {
  double time;
  MovingPoint a, b;
  Vector3<double> apart;
  double size;   ///< |apart|
  double error;  ///< bounds | |apart| - the exact distance |
};

/// The distance of the segment from p to q from zero, up to 16 ε (|p| + |q|) below it: the place of
/// the foot is off by at most 8 ε |p| along the segment, the rest are the roundings of its norm.
inline double segment_distance_from_zero(const Vector3<double>& p, const Vector3<double>& q,
                                         double size_p, double size_q) {
  const Vector3<double> along = q - p;
  const double square = dot(along, along), toward = -dot(p, along);
  double distance = size_p;
  if (toward > 0.0) {
    distance = toward >= square ? size_q : norm(p + (toward / square) * along);
  }
  return distance - 16.0 * rounding_unit * (size_p + size_q);
}

class MovingPair {
 public:
  MovingPair(const TimedMotion& a, const TimedMotion& b, const TimeWindow& window,
             double vertical_scale)
      : window_(window),
        span_(window.end - window.begin),
        scale_(vertical_scale),
        stretch_(std::max(1.0, vertical_scale)),
        a_(a, window.begin, span_),
        b_(b, window.begin, span_) {}
  /// Both on the clock of the window already.
  MovingPair(const Clocked& a, const Clocked& b, const TimeWindow& window, double vertical_scale)
      : window_(window),
        span_(window.end - window.begin),
        scale_(vertical_scale),
        stretch_(std::max(1.0, vertical_scale)),
        a_(a),
        b_(b) {}

  double span() const { return span_; }
  double begin() const { return window_.begin; }
  double stretch() const { return stretch_; }
  const Clocked& a() const { return a_; }
  const Clocked& b() const { return b_; }

  Meeting at(double time) const { return met(time, a_.at(time), b_.at(time)); }
  Meeting between(double time, const Meeting& first, const Meeting& last) const {
    return met(time, a_.between(time, first.a, last.a), b_.between(time, first.b, last.b));
  }
  /// A meeting from points known already.
  Meeting met(double time, const MovingPoint& a, const MovingPoint& b) const {
    Meeting result{time, a, b, a.place.point - b.place.point, 0.0, 0.0};
    result.apart.z = scale_ * result.apart.z;
    result.size = norm(result.apart);
    result.error = stretch_ * (a_.error_of(a) + b_.error_of(b)) + 8.0 * rounding_unit * result.size;
    return result;
  }
  /// A lower bound of the distance between two meetings. Between them neither motion starts or
  /// arrives.
  double least_between(const Meeting& first, const Meeting& last) const {
    const double h = last.time - first.time;
    const double chord = segment_distance_from_zero(first.apart, last.apart, first.size, last.size);
    return chord - stretch_ * (a_.deviation(first.a, last.a, h) + b_.deviation(first.b, last.b, h));
  }
  /// An upper bound of the largest distance between two meetings.
  double most_between(const Meeting& first, const Meeting& last) const {
    const double h = last.time - first.time;
    return std::max(first.size + first.error, last.size + last.error) +
           stretch_ * (a_.deviation(first.a, last.a, h) + b_.deviation(first.b, last.b, h));
  }

 private:
  TimeWindow window_;
  double span_, scale_, stretch_;
  Clocked a_, b_;
};

/// The distance of two motions that differ in where their paths start alone: it is that of the
/// starts, segment by segment, at all times. Empty where they differ otherwise.
std::optional<Enclosure> formation_distance(const TimedMotion& a, const TimedMotion& b,
                                            double vertical_scale);

}  // namespace hodograph::planning_detail
