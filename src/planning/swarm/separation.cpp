// SPDX-License-Identifier: MIT
#include "hodograph/planning/swarm/separation.hpp"

#include <string>

#include "separation_search.hpp"

namespace hodograph {
namespace {

using planning_detail::Meeting;
using planning_detail::MovingPair;
using planning_detail::SeparationSearch;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::optional<Fault> positive_fault(const char* quantity, double value) {
  if (std::isfinite(value) && value > 0.0) return std::nullopt;
  return Fault{
      std::isfinite(value) ? FaultCode::outside_domain : FaultCode::not_finite,
      "the " + std::string(quantity) + " must be positive and finite; got " + to_text(value),
      std::nullopt,
      quantity,
      value,
      0.0};
}

std::optional<Fault> goal_fault(const SeparationGoal& goal) {
  if (auto fault = positive_fault("relative_width", goal.relative_width)) return fault;
  if (auto fault = positive_fault("vertical_scale", goal.vertical_scale)) return fault;
  return planning_detail::scale_fault(goal.vertical_scale);
}

Fault window_fault(const TimedMotion& a, const TimedMotion& b) {
  const bool a_first = a.end_time() < b.start_time();
  const double end = a_first ? a.end_time() : b.end_time();
  const double start = a_first ? b.start_time() : a.start_time();
  return {FaultCode::outside_domain,
          "the motions have no common time: one ends at " + to_text(end) +
              ", the other starts at " + to_text(start),
          std::nullopt,
          "time",
          end,
          start};
}

double width_of(const TimedMotion& a, const TimedMotion& b, const SeparationGoal& goal) {
  return goal.relative_width * std::min(a.length(), b.length());
}

SeparationSearch& thread_search() {
  thread_local SeparationSearch search;
  return search;
}

}  // namespace

std::optional<Enclosure> planning_detail::formation_distance(const TimedMotion& a,
                                                             const TimedMotion& b,
                                                             double vertical_scale) {
  const PathPlaces &p = a.places(), &q = b.places();
  if (p.shape() != q.shape() || !(a.law() == b.law()) || !p.has_shape_of(q)) return std::nullopt;
  std::optional<Enclosure> distance;
  for (std::size_t k = 0; k < p.segment_count(); ++k) {
    const Vector3<double> from = p.start_of(k), to = q.start_of(k);
    const Enclosure x = Enclosure(from.x) - Enclosure(to.x);
    const Enclosure y = Enclosure(from.y) - Enclosure(to.y);
    const Enclosure z = (Enclosure(from.z) - Enclosure(to.z)) * Enclosure(vertical_scale);
    const Enclosure here = sqrt(square(x) + square(y) + square(z));
    distance = distance ? Enclosure::hull(*distance, here) : here;
  }
  return distance;
}

std::optional<TimeWindow> common_window(const TimedMotion& a, const TimedMotion& b) {
  const auto begin_of = [](const TimedMotion& m) {
    return m.presence().before_start ? -infinity : m.start_time();
  };
  const auto end_of = [](const TimedMotion& m) {
    return m.presence().after_arrival ? infinity : m.end_time();
  };
  double begin = std::max(begin_of(a), begin_of(b)), end = std::min(end_of(a), end_of(b));
  if (begin > end) return std::nullopt;
  // Outside of all movement nothing changes: one end of that time stands for it.
  const double first = std::min(a.start_time(), b.start_time());
  const double last = std::max(a.end_time(), b.end_time());
  begin = std::max(begin, std::min(first, end));
  end = std::min(end, std::max(last, begin));
  return TimeWindow{begin, end};
}

Result<Separation> least_separation(const TimedMotion& a, const TimedMotion& b,
                                    const SeparationGoal& goal) {
  if (auto fault = goal_fault(goal)) return *std::move(fault);
  const auto window = common_window(a, b);
  if (!window) return window_fault(a, b);
  const MovingPair pair(a, b, *window, goal.vertical_scale);
  if (const auto distance = planning_detail::formation_distance(a, b, goal.vertical_scale)) {
    const Meeting meeting = pair.at(0.0);
    return Separation{*distance,
                      window->begin,
                      {window->begin, window->end},
                      meeting.a.place.point,
                      meeting.b.place.point,
                      1};
  }
  SeparationSearch& search = thread_search();
  const auto found =
      search.run(pair, width_of(a, b, goal), SeparationSearch::none, goal.most_evaluations);
  const Meeting& nearest = search.meeting(found.nearest);
  const TimeWindow range = search.times_of_minimum(found);
  Separation result;
  result.distance = {found.lower, found.upper};
  result.time_range = Enclosure(window->begin) + Enclosure(range.begin, range.end);
  result.time = std::clamp(window->begin + nearest.time, result.time_range.lower(),
                           result.time_range.upper());
  result.first = nearest.a.place.point;
  result.second = nearest.b.place.point;
  result.evaluations = found.evaluations;
  return result;
}

Answer separated_by(const TimedMotion& a, const TimedMotion& b, double distance,
                    const SeparationGoal& goal) {
  const auto window = common_window(a, b);
  if (!window || distance <= 0.0) return Answer::yes;
  if (goal_fault(goal) || !std::isfinite(distance)) return Answer::undecided;
  if (const auto known = planning_detail::formation_distance(a, b, goal.vertical_scale)) {
    if (known->upper() < distance) return Answer::no;
    return known->lower() >= distance ? Answer::yes : Answer::undecided;
  }
  const MovingPair pair(a, b, *window, goal.vertical_scale);
  const auto found =
      thread_search().run(pair, width_of(a, b, goal), distance, goal.most_evaluations);
  if (found.upper < distance) return Answer::no;
  return found.lower >= distance ? Answer::yes : Answer::undecided;
}

Result<SteppedSeparation> stepped_separation(const TimedMotion& a, const TimedMotion& b,
                                             double step, const SeparationGoal& goal) {
  if (auto fault = goal_fault(goal)) return *std::move(fault);
  if (auto fault = positive_fault("step", step)) return *std::move(fault);
  const auto window = common_window(a, b);
  if (!window) return window_fault(a, b);
  const MovingPair pair(a, b, *window, goal.vertical_scale);
  constexpr double most_samples = 1e9;
  if (pair.span() / step > most_samples) {
    return Fault{FaultCode::outside_domain,
                 "a step of " + to_text(step) + " asks for " + to_text(pair.span() / step) +
                     " samples; at most 1e9 are taken, a step of " +
                     to_text(pair.span() / most_samples),
                 std::nullopt,
                 "step",
                 step,
                 pair.span() / most_samples};
  }
  SteppedSeparation result;
  result.sampled = infinity;
  double error = 0.0;
  const auto sample = [&](double time, std::size_t index) {
    const Meeting meeting = pair.at(time);
    error = std::max(error, meeting.error);
    ++result.evaluations;
    if (meeting.size < result.sampled) {
      result.sampled = meeting.size;
      result.time = window->begin + time;
      result.index = index;
    }
  };
  std::size_t k = 0;
  for (; static_cast<double>(k) * step < pair.span(); ++k) sample(static_cast<double>(k) * step, k);
  sample(pair.span(), k);
  const double speed = a.law().most_speed() + b.law().most_speed();
  constexpr double rounded_up = 1.0 + 0x1.0p-40;  // not a tolerance: far more than the roundings
  const double change = 0.5 * pair.stretch() * speed * step * rounded_up;
  result.distance = {std::max(0.0, Enclosure::down(result.sampled - error - change)),
                     Enclosure::up(result.sampled + error)};
  return result;
}

Result<std::vector<ClosePassage>> close_passages(const TimedMotion& a, const TimedMotion& b,
                                                 double distance, double resolution,
                                                 const SeparationGoal& goal) {
  if (auto fault = goal_fault(goal)) return *std::move(fault);
  if (auto fault = positive_fault("resolution", resolution)) return *std::move(fault);
  std::vector<ClosePassage> passages;
  const auto window = common_window(a, b);
  if (!window) return passages;
  const MovingPair pair(a, b, *window, goal.vertical_scale);
  struct Stretch {
    Meeting first, last;
  };
  std::vector<double> times;
  planning_detail::first_times(pair, times);
  std::vector<Stretch> open;
  Meeting last = pair.at(times.back());
  if (times.size() == 1) open.push_back({last, last});
  for (std::size_t i = times.size() - 1; i-- > 0;) {
    const Meeting first = pair.at(times[i]);
    open.push_back({first, last});
    last = first;
  }
  const auto add = [&](const Stretch& s, bool certain) {
    const double begin = window->begin + s.first.time, end = window->begin + s.last.time;
    if (!passages.empty() && passages.back().end >= begin) {
      passages.back().end = end;
      passages.back().certain = passages.back().certain || certain;
    } else {
      passages.push_back({begin, end, certain});
    }
  };
  std::size_t evaluations = times.size();
  while (!open.empty()) {  // in the order of time
    const Stretch s = open.back();
    open.pop_back();
    if (pair.least_between(s.first, s.last) >= distance) continue;
    const auto is_close = [&](const Meeting& m) { return m.size + m.error < distance; };
    const double middle = 0.5 * (s.first.time + s.last.time);
    if (pair.most_between(s.first, s.last) < distance) {
      add(s, true);
    } else if (s.last.time - s.first.time <= resolution || evaluations >= goal.most_evaluations ||
               !(s.first.time < middle && middle < s.last.time)) {
      add(s, is_close(s.first) || is_close(s.last));
    } else {
      const Meeting between = pair.between(middle, s.first, s.last);
      ++evaluations;
      open.push_back({between, s.last});
      open.push_back({s.first, between});
    }
  }
  return passages;
}

}  // namespace hodograph
