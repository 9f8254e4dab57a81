// SPDX-License-Identifier: MIT
// Swarms: vehicles that arrive together, or fly given paths; made, kept apart and checked. What the
// subcommand `swarm` and the request "swarm" have in common.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/json.hpp"
#include "cli/motions.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/planning/swarm/deconfliction.hpp"

namespace hodograph::cli {

class Members;

/// A vehicle that flies a given path.
struct FlyingVehicle {
  std::string id;
  PathDocument document;
  Flight flight{};
  double radius = 0.0;
  bool fixed = false;  ///< deconfliction leaves it as it is
};

/// When vehicles arrive together: exactly one of the first three, or the least that is sought.
struct ArrivalChoice {
  std::optional<double> arrival{};  ///< this time
  std::optional<double> length{};   ///< when all have flown this length; equal speeds, departures
  std::optional<double> excess{};   ///< later than straight flight, by this fraction of the longest
  bool separated = false;           ///< of the least: the least at which all keep their distance
};

/// A swarm as it is asked for: vehicles that arrive together, vehicles that fly given paths, or
/// both; then paths are made, and departures chosen, around those that are given.
struct SwarmRequest {
  std::vector<ArrivingVehicle> arriving{};
  std::vector<FlyingVehicle> flying{};
  /// For each vehicle in the order of the request: its number among the arriving, or where `flies`
  /// among the flying ones.
  struct Place {
    bool flies = false;
    std::size_t number = 0;
  };
  std::vector<Place> order{};
  ArrivalChoice arrival{};
  SwarmGoal goal{};
  std::optional<ArrivalMoves> deconflict{};
  bool longest_delay_given = false;  ///< else it follows from the longest flight
};

/// The members of a swarm's file or request; see docs/requests.md. Throws Error.
SwarmRequest swarm_request(Members& members);

/// A swarm with all that is known of it.
struct SwarmFacts {
  std::vector<Vehicle> vehicles{};
  std::vector<PathDocument> documents{};            ///< of their paths
  std::vector<std::optional<ArrivingPath>> made{};  ///< nothing where the path is given
  std::optional<double> arrival{};                  ///< of those whose paths were made
  std::vector<Flight> flights{};                    ///< how the documents' paths are flown
  SeparationMatrix matrix{};
  std::vector<Conflict> conflicts{};
  std::optional<DeconflictionEffort> effort{};
  SwarmGoal goal{};
};

/// Makes the paths, keeps them apart if asked to, and checks all pairs. Throws Error: the faults of
/// simultaneous_arrival.hpp, deconfliction.hpp and pairs.hpp.
SwarmFacts swarm_facts(const SwarmRequest& request);

/// Two vehicles and how close they come.
struct PairFact {
  std::size_t first, second;
  SeparationMatrix::Entry entry;
};
/// All pairs that are there at one time, the closest first.
std::vector<PairFact> closest_pairs(const SwarmFacts& facts);

/// Vehicles, the `closest` closest pairs, conflicts, and what deconfliction took; the paths that
/// were made as `document` of their vehicles where asked for.
Json json_of(const SwarmFacts& facts, std::size_t closest, bool with_documents, bool with_matrix);

/// The tables that people read.
std::string text_of(const SwarmFacts& facts, std::size_t closest);

/// The matrix of lower bounds of the least separations: a column and a row for every vehicle, 0 on
/// the diagonal, nothing where two have no common time.
std::string matrix_csv(const SwarmFacts& facts);

/// The swarm as a file for `hodograph swarm`, its paths in files `<id>.json` beside it.
std::string swarm_json(const SwarmFacts& facts);

/// The fault of a swarm that does not keep its distances; nothing where it does.
std::optional<Fault> conflict_fault(const SwarmFacts& facts);

}  // namespace hodograph::cli
