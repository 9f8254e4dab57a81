// SPDX-License-Identifier: MIT
#include "separation_search.hpp"

#include "hodograph/foundation/interruption.hpp"

namespace hodograph::planning_detail {

namespace {

/// Where a motion begins, ends and, if there are few such times, changes its acceleration:
/// intervals that none of these divides have better bounds.
void add_events(const Clocked& motion, double span, std::vector<double>& times) {
  const auto add = [&](double time) {
    if (0.0 < time && time < span) times.push_back(time);
  };
  constexpr std::size_t few = 8;
  const auto& pieces = motion.law().pieces();
  for (std::size_t i = 0; i < (pieces.size() <= few ? pieces.size() : 1); ++i) {
    add(motion.clock_time(pieces[i].begin));
  }
  add(motion.clock_time(motion.law().duration()));
}

constexpr std::size_t first_intervals = 8;

}  // namespace

void first_times(const MovingPair& pair, std::vector<double>& times) {
  times.clear();
  times.push_back(0.0);
  const double span = pair.span();
  if (!(span > 0.0)) return;
  add_events(pair.a(), span, times);
  add_events(pair.b(), span, times);
  for (std::size_t i = 1; i < first_intervals; ++i) {
    times.push_back(span * (static_cast<double>(i) / static_cast<double>(first_intervals)));
  }
  times.push_back(span);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
}

void SeparationSearch::begin(double width, double cutoff) {
  width_ = width;
  cutoff_ = cutoff;
  floor_ = none;
  found_ = {};
  meetings_.clear();
  open_.clear();
  settled_.clear();
}

std::uint32_t SeparationSearch::add(const Meeting& meeting) {
  const std::size_t i = meetings_.size();
  meetings_.push_back(meeting);
  if (const double upper = meeting.size + meeting.error; upper < found_.upper) {
    found_.upper = upper;
    found_.nearest = i;
  }
  return static_cast<std::uint32_t>(i);
}

void SeparationSearch::keep(const Interval& interval) {
  if (interval.lower >= found_.upper - width_ || interval.lower >= cutoff_) {
    settled_.push_back(interval);
  } else {
    open_.push_back(interval);
    std::push_heap(open_.begin(), open_.end());
  }
}

SeparationSearch::Found SeparationSearch::run(const MovingPair& pair, double width, double cutoff,
                                              std::size_t most_evaluations) {
  begin(width, cutoff);
  first_times(pair, times_);
  for (const double time : times_) add(pair.at(time));
  if (meetings_.size() == 1) settled_.push_back({meetings_[0].size - meetings_[0].error, 0, 0});
  for (std::uint32_t i = 0; i + 1 < meetings_.size(); ++i) {
    add(i, i + 1, pair.least_between(meetings_[i], meetings_[i + 1]));
  }
  return finish(pair, most_evaluations);
}

SeparationSearch::Found SeparationSearch::finish(const MovingPair& pair,
                                                 std::size_t most_evaluations) {
  while (!open_.empty() && (cutoff_ == none || found_.upper >= cutoff_)) {
    check_interruption();
    const Interval top = open_.front();
    if (top.lower >= found_.upper - width_ || meetings_.size() >= most_evaluations) break;
    std::pop_heap(open_.begin(), open_.end());
    open_.pop_back();
    const double begin = meetings_[top.first].time, end = meetings_[top.last].time;
    const double middle = 0.5 * (begin + end);
    if (!(begin < middle && middle < end)) {
      settled_.push_back(top);
      continue;
    }
    const std::uint32_t added =
        add(pair.between(middle, meetings_[top.first], meetings_[top.last]));
    keep({std::max(top.lower, pair.least_between(meetings_[top.first], meetings_[added])),
          top.first, added});
    keep({std::max(top.lower, pair.least_between(meetings_[added], meetings_[top.last])), added,
          top.last});
  }
  found_.lower = std::min(floor_, open_.empty() ? found_.upper : open_.front().lower);
  for (const Interval& interval : settled_) found_.lower = std::min(found_.lower, interval.lower);
  found_.lower = std::max(0.0, std::min(found_.lower, found_.upper));
  found_.evaluations = meetings_.size();
  return found_;
}

TimeWindow SeparationSearch::times_of_minimum(const Found& found) const {
  const double at = meetings_[found.nearest].time;
  TimeWindow range{at, at};
  for (const auto* list : {&open_, &settled_}) {
    for (const Interval& interval : *list) {
      if (interval.lower > found.upper) continue;
      range.begin = std::min(range.begin, meetings_[interval.first].time);
      range.end = std::max(range.end, meetings_[interval.last].time);
    }
  }
  return range;
}

}  // namespace hodograph::planning_detail
