// SPDX-License-Identifier: MIT
// Keeping a swarm apart by later departures, the other formal solution, or a later common arrival.
//
// For a given arrival time every vehicle has a list of candidates, the preferred first: its formal
// solution with the least rotation index at each of its delays, then the other one, as far as they
// keep its curvature limit. Whether two candidates keep their distance is decided once, certified
// for every instant (separated_by). A backtracking search with forward checking, the vehicle with
// the fewest candidates left first, finds a choice in which all pairs do, or proves that there is
// none among the candidates. All of it is deterministic.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodograph/planning/swarm/simultaneous_arrival.hpp"

namespace hodograph {

/// The most delays, and the most later arrivals, that are offered: all candidates are made.
inline constexpr std::size_t most_moves = 10000;

/// Departures later by 0, longest_delay/delays, ..., longest_delay.
struct DelayMoves {
  double longest_delay = 0.0;
  std::size_t delays = 0;  ///< at most most_moves
  /// The search gives up after this many choices, over all arrival times.
  std::size_t most_choices = 100000;
};

/// What may be changed besides departures.
struct ArrivalMoves {
  DelayMoves departure{};
  bool other_solution = true;  ///< the formal solution with the larger rotation index, too
  /// Arrival later by up to this fraction of the longest flight, at `later_arrivals` times more.
  double latest_excess = 0.0;
  std::size_t later_arrivals = 0;  ///< at most most_moves
};

/// What a search did.
struct DeconflictionEffort {
  std::size_t choices = 0;        ///< candidates chosen, on the way to the answer
  std::size_t pairs_checked = 0;  ///< certified separations
};

/// Vehicles with delays, all pairs certainly apart.
struct DelayedSwarm {
  std::vector<Vehicle> vehicles;
  std::vector<double> delays;
  DeconflictionEffort effort{};
};

/// Delays some of the vehicles, whatever their paths, so that all pairs keep the goal's distance,
/// also from `others`, which stay as they are (pairs of two of them are not looked at). In
/// sentences the others are counted on after the vehicles. Faults: those of close_pairs;
/// outside_domain (a delay that is negative or not finite, too many of them); not_separated: no
/// choice within the search does; the sentence says whether that is proven (all combinations ruled
/// out) or the search gave up, and names a pair with its distance and the required one, of all
/// candidates of a pair that are never apart if there is such a pair.
Result<DelayedSwarm> deconflict_by_delays(std::span<const Vehicle> vehicles, const SwarmGoal& goal,
                                          const DelayMoves& moves,
                                          std::span<const Vehicle> others = {});

/// An arrival whose vehicles are certainly apart.
struct SeparatedArrival {
  SimultaneousArrival plan;
  std::vector<double> delays;  ///< of the departures given
  DeconflictionEffort effort{};
};

/// Keeps vehicles apart that arrive together: at `arrival` if that can be done by delays and
/// solutions (a vehicle that leaves later gets a shorter path), else at the first later arrival at
/// which it can. `others`, whose motions are given, stay as they are; the vehicles keep their
/// distances from them, too (pairs of two of them are not looked at). In sentences the others are
/// counted on after the vehicles. Faults: as above and those of arrival_at for the first arrival
/// time (a vehicle without any path there, if it has none at the later ones, either).
Result<SeparatedArrival> deconflict_arrival(std::span<const ArrivingVehicle> vehicles,
                                            double arrival, const SwarmGoal& goal,
                                            const ArrivalMoves& moves,
                                            std::span<const Vehicle> others = {});

}  // namespace hodograph
