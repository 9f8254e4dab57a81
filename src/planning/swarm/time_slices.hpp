// SPDX-License-Identifier: MIT
// A swarm on one clock, sampled at the ends of equal slices of time, with bounds of what happens in
// between.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "moving_pair.hpp"

namespace hodograph::planning_detail {

/// One vehicle at the ends of all slices. Coordinates as they count (heights scaled), row by row,
/// so that loops over slices go into lanes.
struct SlicedVehicle {
  Clocked clock;
  std::vector<MovingPoint> points;          // one a time
  std::vector<double> x, y, z;              // likewise
  std::vector<double> deviation;            // one a slice: from the chord at proportional time
  std::vector<double> half_reach;           // one a slice: half the chord, and the deviation
  double error = 0.0;                       // bounds every point's
  double start = 0.0, arrival = 0.0;        // on the clock
  bool always_there = true;                 // over the whole span
  double there_from = 0.0, there_to = 0.0;  // on the clock
};

class TimeSlices {
 public:
  static constexpr std::size_t count = 64;

  TimeSlices(std::span<const Vehicle> vehicles, double vertical_scale, unsigned threads);

  const TimeWindow& window() const { return window_; }
  double time(std::size_t k) const { return times_[k]; }
  const SlicedVehicle& vehicle(std::size_t i) const { return vehicles_[i]; }
  double stretch() const { return stretch_; }
  /// Whether the vehicle is there at some time of slice k.
  bool is_there(std::size_t i, std::size_t k) const {
    const SlicedVehicle& v = vehicles_[i];
    return v.there_from <= times_[k + 1] && times_[k] <= v.there_to;
  }
  MovingPair pair(std::size_t i, std::size_t j) const {
    return {vehicles_[i].clock, vehicles_[j].clock, window_, vertical_scale_};
  }

 private:
  void sample(SlicedVehicle& v) const;

  TimeWindow window_{};
  double vertical_scale_, stretch_;
  std::vector<double> times_;
  std::vector<SlicedVehicle> vehicles_;
};

}  // namespace hodograph::planning_detail
