// SPDX-License-Identifier: MIT
// All pairs of a swarm: which come too close, when and by how much, and how close each pair comes.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hodograph/planning/swarm/separation.hpp"

namespace hodograph {

/// What all pairs are asked to keep, and how it is computed. The answers do not depend on the
/// number of threads.
struct SwarmGoal {
  SeparationGoal separation{};
  /// Vehicles keep the sum of their radii and this.
  double clearance = 0.0;
  unsigned threads = 0;  ///< 0: as many as the machine runs at once
};

/// Two vehicles, by their numbers (first < second), that do not keep the distance required.
struct ClosePair {
  std::size_t first = 0, second = 0;
  double required = 0.0;  ///< the sum of the radii and the clearance
  /// no: they certainly come closer; undecided: their least distance is the required one within the
  /// goal's width.
  Answer keeps = Answer::no;
};

/// All pairs that do not certainly keep their distance, in order; every other pair certainly does,
/// at every instant. Method: in each of a number of slices of time the vehicles' chords, widened by
/// their deviations, are sorted by a coordinate and swept; what overlaps is decided as separated_by
/// does. Faults: too_few (no vehicle), outside_domain or not_finite (a radius or clearance that is
/// negative, with the vehicle's number; a goal that is not positive).
Result<std::vector<ClosePair>> close_pairs(std::span<const Vehicle> vehicles,
                                           const SwarmGoal& goal);

/// A close pair with its least distance.
struct Conflict {
  ClosePair pair;
  Separation separation;
  std::vector<ClosePassage> passages;  ///< when they are too close, to 1/1024 of the swarm's time
  /// By how much the required distance is missed: bounds of required - distance.
  Enclosure shortfall() const { return Enclosure(pair.required) - separation.distance; }
};

/// What close_pairs finds, with every pair's least distance and when it is below the required one.
Result<std::vector<Conflict>> conflicts(std::span<const Vehicle> vehicles, const SwarmGoal& goal);

/// The least distances of all pairs, centre to centre.
class SeparationMatrix {
 public:
  struct Entry {
    Enclosure distance;  ///< as Separation::distance
    double time = 0.0;
  };
  std::size_t size() const { return size_; }
  /// Of vehicles i ≠ j; empty where they have no common time.
  std::optional<Entry> operator()(std::size_t i, std::size_t j) const {
    const std::size_t low = i < j ? i : j, high = i < j ? j : i;
    const Stored& stored = entries_[high * (high - 1) / 2 + low];
    if (!stored.exists) return std::nullopt;
    return stored.entry;
  }

 private:
  friend class SwarmCheck;
  struct Stored {
    Entry entry;
    bool exists = false;
  };
  std::size_t size_ = 0;
  std::vector<Stored> entries_;  // row i: columns below i
};

/// Every pair's least distance to the goal's width. Faults as close_pairs. Cost: some microseconds
/// a pair and thread.
Result<SeparationMatrix> separation_matrix(std::span<const Vehicle> vehicles,
                                           const SwarmGoal& goal);

}  // namespace hodograph
