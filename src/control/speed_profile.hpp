// SPDX-License-Identifier: MIT
// Private to control/: speeds along a path that keep an acceleration, for initial guesses.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace hodograph::control_detail {

/// Places in a row, the way between them, and the speed there: v_(i+1)² - v_i² = 2 a Δs.
class SpeedProfile {
 public:
  struct Point {
    double place = 0.0, time = 0.0, speed = 0.0, acceleration = 0.0;
  };

  /// The next place, how far it is from the one before, and the largest speed there.
  void add(double place, double way, double speed);
  /// Lowers the speeds until they begin at `start` (which stays), end at `end` if given, grow by at
  /// most `acceleration` and fall by at most `braking`; then the times are known. Beyond that a
  /// start that is too fast brakes as hard as it must.
  void limit(double start, std::optional<double> end, double acceleration, double braking);
  /// Ends it when the time is over; where it ends before, it waits at the end.
  void cut(double duration);

  double duration() const { return points_.back().time; }
  Point at_time(double time) const;
  Point at_place(double place) const;

 private:
  Point between(std::size_t i, double share) const;

  std::vector<Point> points_;
  std::vector<double> ways_;
};

}  // namespace hodograph::control_detail
