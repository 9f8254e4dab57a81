// SPDX-License-Identifier: MIT
// Best-first bisection of time for the least distance of two motions.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hodograph/foundation/fault.hpp"
#include "hodograph/planning/swarm/separation.hpp"
#include "moving_pair.hpp"

namespace hodograph::planning_detail {

/// The fault of heights that count too often.
inline std::optional<Fault> scale_fault(double vertical_scale) {
  if (vertical_scale <= largest_vertical_scale) return std::nullopt;
  return Fault{FaultCode::outside_domain,
               "the vertical_scale must be at most " + to_text(largest_vertical_scale) + "; got " +
                   to_text(vertical_scale),
               std::nullopt,
               "vertical_scale",
               vertical_scale,
               largest_vertical_scale};
}

/// The times that divide a pair's clock to begin with, in order: the ends, where a motion starts or
/// arrives (no interval may contain such a time inside: speed jumps there), where its acceleration
/// changes if that is seldom, and a few more.
void first_times(const MovingPair& pair, std::vector<double>& times);

/// The search's memory, kept from pair to pair.
class SeparationSearch {
 public:
  struct Found {
    double lower = std::numeric_limits<double>::infinity();  ///< rigorous bounds of the minimum
    double upper = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;  ///< the meeting with the least upper bound
    std::size_t evaluations = 0;
  };

  /// No cutoff.
  static constexpr double none = std::numeric_limits<double>::infinity();

  /// Closes in until upper - lower ≤ width, or, with a cutoff, until it is known whether the
  /// minimum is below that.
  Found run(const MovingPair& pair, double width, double cutoff, std::size_t most_evaluations);

  /// The same in steps: what is known already, then the search.
  void begin(double width, double cutoff);
  std::uint32_t add(const Meeting& meeting);
  /// Between two meetings the distance is at least `lower`.
  void add(std::uint32_t first, std::uint32_t last, double lower) { keep({lower, first, last}); }
  /// On intervals that are not searched the distance is at least `lower`.
  void allow(double lower) { floor_ = std::min(floor_, lower); }
  /// The least upper bound among the meetings added.
  double upper() const { return found_.upper; }
  Found finish(const MovingPair& pair, std::size_t most_evaluations);

  const Meeting& meeting(std::size_t i) const { return meetings_[i]; }
  /// On the pair's clock: a range that contains every time at which the minimum is attained.
  TimeWindow times_of_minimum(const Found& found) const;

 private:
  struct Interval {
    double lower;
    std::uint32_t first, last;
    friend bool operator<(const Interval& a, const Interval& b) {  // a heap with the least on top
      return a.lower != b.lower ? a.lower > b.lower : a.first > b.first;
    }
  };
  void keep(const Interval& interval);

  std::vector<double> times_;
  std::vector<Meeting> meetings_;
  std::vector<Interval> open_, settled_;
  double width_ = 0.0, cutoff_ = 0.0, floor_ = none;
  Found found_;
};

}  // namespace hodograph::planning_detail
