// SPDX-License-Identifier: MIT
#include "hodograph/planning/swarm/pairs.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "parallel.hpp"
#include "separation_search.hpp"
#include "time_slices.hpp"

namespace hodograph {
namespace {

using planning_detail::in_parallel;
using planning_detail::Meeting;
using planning_detail::MovingPair;
using planning_detail::SeparationSearch;
using planning_detail::SlicedVehicle;
using planning_detail::TimeSlices;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::optional<Fault> number_fault(const char* quantity, double value, bool may_be_zero,
                                  std::optional<std::size_t> index, const std::string& whose) {
  if (std::isfinite(value) && (value > 0.0 || (may_be_zero && value == 0.0))) return std::nullopt;
  return Fault{std::isfinite(value) ? FaultCode::outside_domain : FaultCode::not_finite,
               "the " + std::string(quantity) + whose + " must be " +
                   (may_be_zero ? "zero or positive" : "positive") + " and finite; got " +
                   to_text(value),
               index,
               quantity,
               value,
               0.0};
}

std::optional<Fault> swarm_fault(std::span<const Vehicle> vehicles, const SwarmGoal& goal) {
  if (vehicles.empty()) {
    return Fault{FaultCode::too_few,
                 "a swarm needs at least one vehicle; got none",
                 std::nullopt,
                 "vehicles",
                 0.0,
                 1.0};
  }
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    const std::string whose = " of vehicle " + std::to_string(i) +
                              (vehicles[i].id.empty() ? "" : " (" + vehicles[i].id + ")");
    if (auto fault = number_fault("radius", vehicles[i].radius, true, i, whose)) return fault;
  }
  const SeparationGoal& separation = goal.separation;
  if (auto fault = number_fault("clearance", goal.clearance, true, std::nullopt, "")) return fault;
  if (auto fault =
          number_fault("relative_width", separation.relative_width, false, std::nullopt, "")) {
    return fault;
  }
  if (auto fault =
          number_fault("vertical_scale", separation.vertical_scale, false, std::nullopt, "")) {
    return fault;
  }
  return planning_detail::scale_fault(separation.vertical_scale);
}

double required_of(const Vehicle& a, const Vehicle& b, const SwarmGoal& goal) {
  return a.radius + b.radius + goal.clearance;
}

/// A pair of vehicles, first < second, and a slice whose bounds leave open whether they keep their
/// distance there.
struct OpenSlice {
  std::uint32_t first, second, slice;
  friend auto operator<=>(const OpenSlice&, const OpenSlice&) = default;
};

/// The pairs that a slice leaves open.
class Sweep {
 public:
  Sweep(std::span<const Vehicle> vehicles, const TimeSlices& slices, const SwarmGoal& goal)
      : vehicles_(vehicles), slices_(slices), goal_(goal) {}

  void run(std::size_t k, std::vector<OpenSlice>& found) {
    collect(k);
    const std::size_t axis = widest_axis();
    std::sort(boxes_.begin(), boxes_.end(), [&](const Box& a, const Box& b) {
      return a.low[axis] != b.low[axis] ? a.low[axis] < b.low[axis] : a.vehicle < b.vehicle;
    });
    const std::size_t other = axis == 0 ? 1 : 0, third = axis == 2 ? 1 : 2;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const Box& a = boxes_[i];
      for (std::size_t j = i + 1; j < boxes_.size() && boxes_[j].low[axis] <= a.high[axis]; ++j) {
        const Box& b = boxes_[j];
        if (b.low[other] > a.high[other] || a.low[other] > b.high[other]) continue;
        if (b.low[third] > a.high[third] || a.low[third] > b.high[third]) continue;
        const auto [low, high] = std::minmax(a.vehicle, b.vehicle);
        if (!is_apart(low, high, k)) found.push_back({low, high, static_cast<std::uint32_t>(k)});
      }
    }
  }

 private:
  struct Box {
    std::array<double, 3> low, high;
    std::uint32_t vehicle;
  };

  void collect(std::size_t k) {
    boxes_.clear();
    for (std::size_t i = 0; i < vehicles_.size(); ++i) {
      if (!slices_.is_there(i, k)) continue;
      const SlicedVehicle& v = slices_.vehicle(i);
      const double margin = v.deviation[k] + vehicles_[i].radius + 0.5 * goal_.clearance;
      Box box;
      box.vehicle = static_cast<std::uint32_t>(i);
      const std::vector<double>* rows[] = {&v.x, &v.y, &v.z};
      for (std::size_t c = 0; c < 3; ++c) {
        const double p = (*rows[c])[k], q = (*rows[c])[k + 1];
        box.low[c] = Enclosure::down(std::min(p, q) - margin);
        box.high[c] = Enclosure::up(std::max(p, q) + margin);
      }
      boxes_.push_back(box);
    }
  }

  std::size_t widest_axis() const {
    std::size_t best = 0;
    double most = -1.0;
    for (std::size_t c = 0; c < 3; ++c) {
      double low = infinity, high = -infinity;
      for (const Box& box : boxes_) {
        low = std::min(low, box.low[c]);
        high = std::max(high, box.high[c]);
      }
      if (high - low > most) {
        most = high - low;
        best = c;
      }
    }
    return best;
  }

  bool is_apart(std::size_t i, std::size_t j, std::size_t k) const {
    const SlicedVehicle &a = slices_.vehicle(i), &b = slices_.vehicle(j);
    const Vector3<double> p{a.x[k] - b.x[k], a.y[k] - b.y[k], a.z[k] - b.z[k]};
    const Vector3<double> q{a.x[k + 1] - b.x[k + 1], a.y[k + 1] - b.y[k + 1],
                            a.z[k + 1] - b.z[k + 1]};
    const double least = planning_detail::segment_distance_from_zero(p, q, norm(p), norm(q)) -
                         (a.deviation[k] + b.deviation[k]);
    return least >= required_of(vehicles_[i], vehicles_[j], goal_);
  }

  std::span<const Vehicle> vehicles_;
  const TimeSlices& slices_;
  const SwarmGoal& goal_;
  std::vector<Box> boxes_;
};

/// All that the slices leave open, in order.
std::vector<OpenSlice> open_slices(std::span<const Vehicle> vehicles, const TimeSlices& slices,
                                   const SwarmGoal& goal) {
  std::vector<std::vector<OpenSlice>> found(TimeSlices::count);
  in_parallel(TimeSlices::count, 1, goal.threads,
              [&](std::size_t begin, std::size_t end, std::size_t) {
                Sweep sweep(vehicles, slices, goal);
                for (std::size_t k = begin; k < end; ++k) sweep.run(k, found[k]);
              });
  std::vector<OpenSlice> all;
  for (const auto& list : found) all.insert(all.end(), list.begin(), list.end());
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

/// Least distances of pairs from the slices that all of them share.
class SwarmCheck {
 public:
  SwarmCheck(std::span<const Vehicle> vehicles, const SwarmGoal& goal)
      : vehicles_(vehicles),
        goal_(goal),
        slices_(vehicles, goal.separation.vertical_scale, goal.threads) {}

  std::vector<ClosePair> close() const {
    const std::vector<OpenSlice> open = open_slices(vehicles_, slices_, goal_);
    std::vector<std::size_t> begins;  // of each pair's slices
    for (std::size_t i = 0; i < open.size(); ++i) {
      const bool same =
          i > 0 && open[i].first == open[i - 1].first && open[i].second == open[i - 1].second;
      if (!same) begins.push_back(i);
    }
    begins.push_back(open.size());
    std::vector<Answer> answers(begins.size() - 1);
    constexpr std::size_t chunk = 64;
    in_parallel(
        answers.size(), chunk, goal_.threads, [&](std::size_t begin, std::size_t end, std::size_t) {
          SeparationSearch search;
          for (std::size_t p = begin; p < end; ++p) {
            answers[p] =
                keeps(std::span(open).subspan(begins[p], begins[p + 1] - begins[p]), search);
          }
        });
    std::vector<ClosePair> result;
    for (std::size_t p = 0; p < answers.size(); ++p) {
      if (answers[p] == Answer::yes) continue;
      const auto& [i, j, slice] = open[begins[p]];
      result.push_back({i, j, required_of(vehicles_[i], vehicles_[j], goal_), answers[p]});
    }
    return result;
  }

  SeparationMatrix matrix() const {
    SeparationMatrix result;
    const std::size_t n = vehicles_.size();
    result.size_ = n;
    result.entries_.resize(n * (n - 1) / 2);
    // Rows i and n - 1 - i together are equally long.
    in_parallel((n + 1) / 2, 1, goal_.threads,
                [&](std::size_t begin, std::size_t end, std::size_t) {
                  SeparationSearch search;
                  for (std::size_t i = begin; i < end; ++i) {
                    row(i, search, result);
                    if (n - 1 - i != i) row(n - 1 - i, search, result);
                  }
                });
    return result;
  }

 private:
  void row(std::size_t i, SeparationSearch& search, SeparationMatrix& result) const {
    for (std::size_t j = 0; j < i; ++j) {
      SeparationMatrix::Stored& stored = result.entries_[i * (i - 1) / 2 + j];
      const bool there = slices_.vehicle(i).always_there && slices_.vehicle(j).always_there;
      if (there && !is_formation(i, j)) {
        stored = {of_pair(j, i, search), true};
      } else if (const auto found =
                     least_separation(vehicles_[j].motion, vehicles_[i].motion, goal_.separation)) {
        stored = {{found->distance, found->time}, true};
      }
    }
  }

  /// Whether a pair keeps its distance, from the slices where that is open.
  Answer keeps(std::span<const OpenSlice> open, SeparationSearch& search) const {
    const std::size_t i = open[0].first, j = open[0].second;
    const double required = required_of(vehicles_[i], vehicles_[j], goal_);
    const SlicedVehicle &a = slices_.vehicle(i), &b = slices_.vehicle(j);
    if (!a.always_there || !b.always_there || is_formation(i, j)) {
      return separated_by(vehicles_[i].motion, vehicles_[j].motion, required, goal_.separation);
    }
    const MovingPair pair = slices_.pair(i, j);
    search.begin(width_of(i, j), required);
    std::size_t next = TimeSlices::count + 1;  // the time that `last` is at
    std::uint32_t last = 0;
    for (const OpenSlice& o : open) {
      const std::uint32_t first = next == o.slice ? last : search.add(met(pair, a, b, o.slice));
      next = o.slice + 1;
      last = search.add(met(pair, a, b, next));
      add_slice(pair, a, b, o.slice, first, last, search);
      if (search.upper() < required) return Answer::no;
    }
    const auto found = search.finish(pair, goal_.separation.most_evaluations);
    if (found.upper < required) return Answer::no;
    return found.lower >= required ? Answer::yes : Answer::undecided;
  }

  /// Perhaps; those are quicker alone.
  bool is_formation(std::size_t i, std::size_t j) const {
    return vehicles_[i].motion.places().shape() == vehicles_[j].motion.places().shape();
  }
  Meeting met(const MovingPair& pair, const SlicedVehicle& a, const SlicedVehicle& b,
              std::size_t k) const {
    return pair.met(slices_.time(k), a.points[k], b.points[k]);
  }
  double width_of(std::size_t i, std::size_t j) const {
    return goal_.separation.relative_width *
           std::min(vehicles_[i].motion.length(), vehicles_[j].motion.length());
  }

  /// Both are there all the time.
  SeparationMatrix::Entry of_pair(std::size_t i, std::size_t j, SeparationSearch& search) const {
    constexpr std::size_t count = TimeSlices::count;
    const SlicedVehicle &a = slices_.vehicle(i), &b = slices_.vehicle(j);
    std::array<double, count + 1> size;
    std::array<double, count> lower;
    for (std::size_t k = 0; k <= count; ++k) {
      const double x = a.x[k] - b.x[k], y = a.y[k] - b.y[k], z = a.z[k] - b.z[k];
      size[k] = x * x + y * y + z * z;
    }
    for (std::size_t k = 0; k <= count; ++k) size[k] = std::sqrt(size[k]);
    std::size_t nearest = 0;
    for (std::size_t k = 1; k <= count; ++k) nearest = size[k] < size[nearest] ? k : nearest;
    // |D| ≥ (|D_k| + |D_k+1| - |D_k+1 - D_k|)/2 on the chord of the difference.
    for (std::size_t k = 0; k < count; ++k) {
      lower[k] = 0.5 * (size[k] + size[k + 1]) * (1.0 - 16.0 * planning_detail::rounding_unit) -
                 (a.half_reach[k] + b.half_reach[k]);
    }
    const double width = width_of(i, j);
    const double upper =
        (size[nearest] + (a.error + b.error)) * (1.0 + 16.0 * planning_detail::rounding_unit);
    const MovingPair pair = slices_.pair(i, j);
    search.begin(width, SeparationSearch::none);
    std::array<std::uint32_t, count + 1> known;
    known.fill(none);
    const auto meeting_at = [&](std::size_t k) {
      if (known[k] == none) known[k] = search.add(met(pair, a, b, k));
      return known[k];
    };
    meeting_at(nearest);
    for (std::size_t k = 0; k < count; ++k) {
      if (lower[k] >= upper - width) {
        search.allow(lower[k]);
      } else {
        add_slice(pair, a, b, k, meeting_at(k), meeting_at(k + 1), search);
      }
    }
    const auto found = search.finish(pair, goal_.separation.most_evaluations);
    return {{found.lower, found.upper},
            slices_.window().begin + search.meeting(found.nearest).time};
  }

  /// Slice k, divided where one of the two starts or arrives.
  void add_slice(const MovingPair& pair, const SlicedVehicle& a, const SlicedVehicle& b,
                 std::size_t k, std::uint32_t first, std::uint32_t last,
                 SeparationSearch& search) const {
    std::array<double, 4> events{a.start, a.arrival, b.start, b.arrival};
    std::sort(events.begin(), events.end());
    std::uint32_t before = first;
    const auto add_part = [&](std::uint32_t to) {
      search.add(before, to, pair.least_between(search.meeting(before), search.meeting(to)));
      before = to;
    };
    for (const double time : events) {
      const bool inside = search.meeting(before).time < time && time < slices_.time(k + 1);
      if (inside) add_part(search.add(pair.at(time)));
    }
    add_part(last);
  }

  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::span<const Vehicle> vehicles_;
  const SwarmGoal& goal_;
  TimeSlices slices_;
};

Result<std::vector<ClosePair>> close_pairs(std::span<const Vehicle> vehicles,
                                           const SwarmGoal& goal) {
  if (auto fault = swarm_fault(vehicles, goal)) return *std::move(fault);
  return SwarmCheck(vehicles, goal).close();
}

Result<std::vector<Conflict>> conflicts(std::span<const Vehicle> vehicles, const SwarmGoal& goal) {
  auto close = close_pairs(vehicles, goal);
  if (!close) return close.fault();
  std::vector<Conflict> result(close->size());
  double begin_of_all = infinity, end_of_all = -infinity;
  for (const Vehicle& v : vehicles) {
    begin_of_all = std::min(begin_of_all, v.motion.start_time());
    end_of_all = std::max(end_of_all, v.motion.end_time());
  }
  const double resolution = (end_of_all - begin_of_all) / 1024.0;
  constexpr std::size_t chunk = 16;
  in_parallel(
      close->size(), chunk, goal.threads, [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t i = begin; i < end; ++i) {
          const ClosePair& pair = (*close)[i];
          const TimedMotion &a = vehicles[pair.first].motion, &b = vehicles[pair.second].motion;
          // A pair that is close has a common time, and the goal was checked.
          result[i] = {pair, *least_separation(a, b, goal.separation),
                       *close_passages(a, b, pair.required, resolution, goal.separation)};
        }
      });
  return result;
}

Result<SeparationMatrix> separation_matrix(std::span<const Vehicle> vehicles,
                                           const SwarmGoal& goal) {
  if (auto fault = swarm_fault(vehicles, goal)) return *std::move(fault);
  return SwarmCheck(vehicles, goal).matrix();
}

}  // namespace hodograph
