// SPDX-License-Identifier: MIT
#include "time_slices.hpp"

#include "parallel.hpp"

namespace hodograph::planning_detail {

TimeSlices::TimeSlices(std::span<const Vehicle> vehicles, double vertical_scale, unsigned threads)
    : vertical_scale_(vertical_scale), stretch_(std::max(1.0, vertical_scale)) {
  window_ = {vehicles[0].motion.start_time(), vehicles[0].motion.end_time()};
  for (const Vehicle& v : vehicles) {
    window_.begin = std::min(window_.begin, v.motion.start_time());
    window_.end = std::max(window_.end, v.motion.end_time());
  }
  const double span = window_.end - window_.begin;
  for (std::size_t k = 0; k <= count; ++k) {
    times_.push_back(span * (static_cast<double>(k) / static_cast<double>(count)));
  }
  vehicles_.reserve(vehicles.size());
  for (const Vehicle& v : vehicles) {
    SlicedVehicle sliced{Clocked(v.motion, window_.begin, span), {}, {}, {}, {}, {}, {}};
    sliced.start = sliced.clock.clock_time(0.0);
    sliced.arrival = sliced.clock.clock_time(v.motion.law().duration());
    // Borders are widened by the rounding of the clock.
    const double late = 4.0 * rounding_unit * (std::abs(sliced.start) + span);
    sliced.there_from = v.motion.presence().before_start ? 0.0 : sliced.start - late;
    sliced.there_to = v.motion.presence().after_arrival ? span : sliced.arrival + late;
    sliced.always_there = sliced.there_from <= 0.0 && span <= sliced.there_to;
    vehicles_.push_back(std::move(sliced));
  }
  constexpr std::size_t chunk = 16;
  in_parallel(vehicles_.size(), chunk, threads,
              [&](std::size_t begin, std::size_t end, std::size_t) {
                for (std::size_t i = begin; i < end; ++i) sample(vehicles_[i]);
              });
}

void TimeSlices::sample(SlicedVehicle& v) const {
  v.points.resize(count + 1);
  for (auto* row : {&v.x, &v.y, &v.z}) row->reserve(count + 1);
  for (auto* row : {&v.deviation, &v.half_reach}) row->reserve(count);
  v.points.front() = v.clock.at(times_.front());
  v.points.back() = v.clock.at(times_.back());
  for (std::size_t step = count / 2; step > 0; step /= 2) {  // each between two that are known
    for (std::size_t k = step; k < count; k += 2 * step) {
      v.points[k] = v.clock.between(times_[k], v.points[k - step], v.points[k + step]);
    }
  }
  for (const MovingPoint& point : v.points) {
    const Vector3<double>& p = point.place.point;
    v.x.push_back(p.x);
    v.y.push_back(p.y);
    v.z.push_back(vertical_scale_ * p.z);
    v.error = std::max(v.error, stretch_ * v.clock.error_of(point));
  }
  for (std::size_t k = 0; k < count; ++k) {
    const double begin = times_[k], end = times_[k + 1];
    const auto inside = [&](double time) { return begin < time && time < end; };
    const bool loose = inside(v.start) || inside(v.arrival);
    const double h = end - begin;
    const double off = stretch_ * (loose ? v.clock.loose_deviation(v.points[k], v.points[k + 1], h)
                                         : v.clock.deviation(v.points[k], v.points[k + 1], h));
    const Vector3<double> chord{v.x[k + 1] - v.x[k], v.y[k + 1] - v.y[k], v.z[k + 1] - v.z[k]};
    constexpr double rounded_up = 1.0 + 8.0 * rounding_unit;
    v.deviation.push_back(off);
    v.half_reach.push_back(0.5 * norm(chord) * rounded_up + off);
  }
}

}  // namespace hodograph::planning_detail
