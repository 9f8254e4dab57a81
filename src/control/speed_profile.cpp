// SPDX-License-Identifier: MIT
#include "speed_profile.hpp"

#include <algorithm>
#include <cmath>

namespace hodograph::control_detail {

void SpeedProfile::add(double place, double way, double speed) {
  points_.push_back({place, 0.0, speed, 0.0});
  ways_.push_back(way);
}

void SpeedProfile::limit(double start, std::optional<double> end, double acceleration,
                         double braking) {
  points_.front().speed = start;
  if (end) points_.back().speed = std::min(points_.back().speed, *end);
  for (std::size_t i = points_.size() - 1; i-- > 1;) {
    const double after = points_[i + 1].speed;
    points_[i].speed =
        std::min(points_[i].speed, std::sqrt(after * after + 2.0 * braking * ways_[i + 1]));
  }
  for (std::size_t i = 1; i < points_.size(); ++i) {
    Point& before = points_[i - 1];
    Point& here = points_[i];
    here.speed = std::min(here.speed,
                          std::sqrt(before.speed * before.speed + 2.0 * acceleration * ways_[i]));
    const double mean = 0.5 * (before.speed + here.speed);
    const double lasts = mean > 0.0 ? ways_[i] / mean : std::sqrt(2.0 * ways_[i] / acceleration);
    here.time = before.time + lasts;
    before.acceleration = lasts > 0.0 ? (here.speed - before.speed) / lasts : 0.0;
  }
}

void SpeedProfile::cut(double duration) {
  if (points_.back().time <= duration) {
    const Point last{points_.back().place, duration, 0.0, 0.0};
    points_.push_back(last);
    ways_.push_back(0.0);
    return;
  }
  const Point last = at_time(duration);
  while (points_.size() > 1 && points_.back().time >= duration) {
    points_.pop_back();
    ways_.pop_back();
  }
  points_.push_back(last);
  ways_.push_back(0.0);
}

SpeedProfile::Point SpeedProfile::between(std::size_t i, double share) const {
  const Point& a = points_[i];
  const Point& b = points_[i + 1];
  const auto mixed = [share](double from, double to) { return from + share * (to - from); };
  return {mixed(a.place, b.place), mixed(a.time, b.time), mixed(a.speed, b.speed), a.acceleration};
}

SpeedProfile::Point SpeedProfile::at_time(double time) const {
  const auto after = std::upper_bound(points_.begin() + 1, points_.end() - 1, time,
                                      [](double t, const Point& p) { return t < p.time; });
  const auto i = static_cast<std::size_t>(after - points_.begin()) - 1;
  const double lasts = points_[i + 1].time - points_[i].time;
  return between(i, lasts > 0.0 ? std::clamp((time - points_[i].time) / lasts, 0.0, 1.0) : 0.0);
}

SpeedProfile::Point SpeedProfile::at_place(double place) const {
  const auto after = std::upper_bound(points_.begin() + 1, points_.end() - 1, place,
                                      [](double x, const Point& p) { return x < p.place; });
  const auto i = static_cast<std::size_t>(after - points_.begin()) - 1;
  const double way = points_[i + 1].place - points_[i].place;
  return between(i, way > 0.0 ? std::clamp((place - points_[i].place) / way, 0.0, 1.0) : 0.0);
}

}  // namespace hodograph::control_detail
