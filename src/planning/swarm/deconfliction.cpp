// SPDX-License-Identifier: MIT
#include "hodograph/planning/swarm/deconfliction.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "arrival_search.hpp"
#include "hodograph/foundation/interruption.hpp"

namespace hodograph {
namespace {

using planning_detail::name_of_vehicle;

/// One vehicle's candidates, in the order of preference.
using Candidates = std::vector<Vehicle>;

/// A choice of one candidate a vehicle so that all pairs keep their distance.
class ChoiceSearch {
 public:
  enum class Outcome { found, impossible, given_up };

  /// The last `given` vehicles have one candidate each, and two of them are taken to go together.
  ChoiceSearch(std::vector<Candidates> candidates, std::size_t given, const SwarmGoal& goal)
      : candidates_(std::move(candidates)), goal_(goal) {
    const std::size_t n = candidates_.size();
    known_.resize(n * n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        known_[i * n + j].assign(candidates_[i].size() * candidates_[j].size(),
                                 j + given >= n ? apart : unknown);
      }
    }
  }

  Outcome run(std::size_t most_choices, DeconflictionEffort& effort) {
    effort_ = &effort;
    const std::size_t n = candidates_.size();
    choice_.assign(n, none);
    blocked_.resize(n);
    for (std::size_t i = 0; i < n; ++i) blocked_[i].assign(candidates_[i].size(), 0);
    std::vector<Level> levels;
    levels.reserve(n);
    for (;;) {
      if (levels.size() == n) return Outcome::found;
      levels.push_back({next_vehicle(), 0, {}});
      while (!advance(levels.back())) {
        levels.pop_back();
        if (levels.empty()) return Outcome::impossible;
        undo(levels.back());
      }
      if (effort.choices > most_choices) return Outcome::given_up;
    }
  }

  const Vehicle& chosen(std::size_t i) const { return candidates_[i][choice_[i]]; }
  std::size_t choice(std::size_t i) const { return choice_[i]; }

  /// A pair none of whose candidates go together, else the pair at which the search went furthest.
  struct Obstacle {
    std::size_t first = 0, second = 1;
    bool hopeless = false;
  };
  Obstacle obstacle() const {
    const std::size_t n = candidates_.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const auto& pairs = known_[i * n + j];
        const bool hopeless =
            std::all_of(pairs.begin(), pairs.end(), [](std::uint8_t a) { return a == close; });
        if (hopeless) return {j, i, true};
      }
    }
    return {std::min(dead_[0], dead_[1]), std::max(dead_[0], dead_[1]), false};
  }
  /// Of all candidates of a pair, the two that come least near, and how near.
  std::pair<Separation, double> best_of(std::size_t i, std::size_t j) const {
    std::optional<Separation> best;
    for (const Vehicle& a : candidates_[i]) {
      for (const Vehicle& b : candidates_[j]) {
        const auto found = least_separation(a.motion, b.motion, goal_.separation);
        if (found && (!best || found->distance.upper() > best->distance.upper())) best = *found;
      }
    }
    return {best.value_or(Separation{}), required(i, j)};
  }
  std::size_t combinations(std::size_t i, std::size_t j) const {
    return candidates_[i].size() * candidates_[j].size();
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  static constexpr std::uint8_t unknown = 0, apart = 1, close = 2;

  /// A vehicle that is decided, the candidate to try next, and what its choice ruled out.
  struct Level {
    std::size_t vehicle, next;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ruled_out;
  };

  double required(std::size_t i, std::size_t j) const {
    return candidates_[i][0].radius + candidates_[j][0].radius + goal_.clearance;
  }

  bool go_together(std::size_t i, std::size_t a, std::size_t j, std::size_t b) {
    if (i < j) {
      std::swap(i, j);
      std::swap(a, b);
    }
    std::uint8_t& answer = known_[i * candidates_.size() + j][a * candidates_[j].size() + b];
    if (answer == unknown) {
      ++effort_->pairs_checked;
      const Answer keeps = separated_by(candidates_[i][a].motion, candidates_[j][b].motion,
                                        required(i, j), goal_.separation);
      answer = keeps == Answer::yes ? apart : close;
    }
    return answer == apart;
  }

  std::size_t left(std::size_t i) const {
    return static_cast<std::size_t>(std::count(blocked_[i].begin(), blocked_[i].end(), 0));
  }
  std::size_t next_vehicle() const {
    std::size_t best = none, fewest = none;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (choice_[i] != none) continue;
      if (const std::size_t count = left(i); best == none || count < fewest) {
        best = i;
        fewest = count;
      }
    }
    return best;
  }

  void undo(Level& level) {
    for (const auto& [j, b] : level.ruled_out) blocked_[j][b] = 0;
    level.ruled_out.clear();
    choice_[level.vehicle] = none;
  }

  /// Takes the next candidate that leaves every undecided vehicle one.
  bool advance(Level& level) {
    const std::size_t i = level.vehicle;
    while (level.next < candidates_[i].size()) {
      const std::size_t a = level.next++;
      if (blocked_[i][a] != 0) continue;
      choice_[i] = a;
      check_interruption();
      ++effort_->choices;
      if (rule_out(level, a)) return true;
      undo(level);
    }
    choice_[i] = none;
    return false;
  }

  bool rule_out(Level& level, std::size_t a) {
    const std::size_t i = level.vehicle;
    std::size_t decided = 0;
    for (const std::size_t c : choice_) decided += c == none ? 0U : 1U;
    for (std::size_t j = 0; j < candidates_.size(); ++j) {
      if (choice_[j] != none) continue;
      bool any = false;
      for (std::size_t b = 0; b < candidates_[j].size(); ++b) {
        if (blocked_[j][b] != 0) continue;
        if (go_together(i, a, j, b)) {
          any = true;
        } else {
          blocked_[j][b] = 1;
          level.ruled_out.push_back({static_cast<std::uint32_t>(j), static_cast<std::uint32_t>(b)});
        }
      }
      if (!any) {
        if (decided > furthest_) {
          furthest_ = decided;
          dead_[0] = i;
          dead_[1] = j;
        }
        return false;
      }
    }
    return true;
  }

  std::vector<Candidates> candidates_;
  const SwarmGoal& goal_;
  std::vector<std::vector<std::uint8_t>> known_;  // of vehicles i > j, all their candidates
  std::vector<std::vector<std::uint8_t>> blocked_;
  std::vector<std::size_t> choice_;
  std::size_t furthest_ = 0, dead_[2] = {0, 1};
  DeconflictionEffort* effort_ = nullptr;
};

Fault stuck(const ChoiceSearch& search, ChoiceSearch::Outcome outcome,
            std::span<const std::string> names, const DeconflictionEffort& effort,
            const std::string& where) {
  const ChoiceSearch::Obstacle o = search.obstacle();
  const auto [separation, required] = search.best_of(o.first, o.second);
  const double distance = separation.distance.upper();
  std::string sentence = where;
  if (outcome == ChoiceSearch::Outcome::impossible) {
    sentence += "no choice keeps all vehicles apart (all are ruled out): ";
  } else {
    sentence += "the search gave up after " + std::to_string(effort.choices) +
                " choices, with none that keeps all vehicles apart: ";
  }
  sentence += names[o.first] + " and " + names[o.second];
  const std::string count = std::to_string(search.combinations(o.first, o.second));
  if (o.hopeless) {
    sentence += " come within " + to_text(distance) + " of each other in the best of all " + count +
                " combinations of their candidates; " + to_text(required) + " is required";
  } else {
    sentence += " are the pair at which it went furthest; on their own they keep " +
                to_text(distance) + " in the best of " + count + " combinations, where " +
                to_text(required) + " is required";
  }
  return {FaultCode::not_separated, std::move(sentence), o.first, "separation", distance, required};
}

std::optional<Fault> moves_fault(const char* quantity, double value) {
  if (std::isfinite(value) && value >= 0.0) return std::nullopt;
  return Fault{std::isfinite(value) ? FaultCode::outside_domain : FaultCode::not_finite,
               "the " + std::string(quantity) + " must be zero or positive and finite; got " +
                   to_text(value),
               std::nullopt,
               quantity,
               value,
               0.0};
}

/// The fault of more moves than are offered.
std::optional<Fault> count_fault(const char* quantity, std::size_t count) {
  if (count <= most_moves) return std::nullopt;
  return Fault{FaultCode::outside_domain,
               "there may be at most " + std::to_string(most_moves) + " " + quantity + "; got " +
                   std::to_string(count),
               std::nullopt,
               quantity,
               static_cast<double>(count),
               static_cast<double>(most_moves)};
}

/// The vehicles that stay as they are, each its only candidate; their names where they are not
/// there yet.
void add_others(std::span<const Vehicle> others, std::vector<Candidates>& candidates,
                std::vector<std::string>& names) {
  for (const Vehicle& other : others) {
    const std::size_t number = candidates.size();
    if (names.size() == number) names.push_back(name_of_vehicle(number, other.id));
    candidates.push_back({other});
  }
}

double delay_of(const DelayMoves& moves, std::size_t k) {
  if (k == 0) return 0.0;
  return moves.longest_delay * (static_cast<double>(k) / static_cast<double>(moves.delays));
}

}  // namespace

Result<DelayedSwarm> deconflict_by_delays(std::span<const Vehicle> vehicles, const SwarmGoal& goal,
                                          const DelayMoves& moves,
                                          std::span<const Vehicle> others) {
  if (auto fault = moves_fault("longest_delay", moves.longest_delay)) return *std::move(fault);
  if (auto fault = count_fault("delays", moves.delays)) return *std::move(fault);
  auto close = close_pairs(planning_detail::with_others(vehicles, others), goal);
  if (!close) return close.fault();
  std::erase_if(*close, [&](const ClosePair& pair) { return pair.first >= vehicles.size(); });
  DelayedSwarm result;
  result.delays.assign(vehicles.size(), 0.0);
  if (close->empty()) {
    result.vehicles.assign(vehicles.begin(), vehicles.end());
    return result;
  }
  std::vector<Candidates> candidates(vehicles.size());
  std::vector<std::string> names;
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    names.push_back(name_of_vehicle(i, vehicles[i].id));
    for (std::size_t k = 0; k <= moves.delays; ++k) {
      const double delay = delay_of(moves, k);
      if (k > 0 && delay == 0.0) break;
      candidates[i].push_back(
          {vehicles[i].id, vehicles[i].motion.delayed(delay), vehicles[i].radius});
    }
  }
  add_others(others, candidates, names);
  ChoiceSearch search(std::move(candidates), others.size(), goal);
  const auto outcome = search.run(moves.most_choices, result.effort);
  if (outcome != ChoiceSearch::Outcome::found) {
    return stuck(search, outcome, names, result.effort, "");
  }
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    result.vehicles.push_back(search.chosen(i));
    result.delays[i] = delay_of(moves, search.choice(i));
  }
  return result;
}

Result<SeparatedArrival> deconflict_arrival(std::span<const ArrivingVehicle> vehicles,
                                            double arrival, const SwarmGoal& goal,
                                            const ArrivalMoves& moves,
                                            std::span<const Vehicle> others) {
  if (auto fault = planning_detail::arriving_fault(vehicles)) return *std::move(fault);
  if (auto fault = moves_fault("longest_delay", moves.departure.longest_delay)) {
    return *std::move(fault);
  }
  if (auto fault = count_fault("delays", moves.departure.delays)) return *std::move(fault);
  if (auto fault = moves_fault("latest_excess", moves.latest_excess)) return *std::move(fault);
  if (auto fault = count_fault("later_arrivals", moves.later_arrivals)) return *std::move(fault);
  if (!std::isfinite(arrival)) return moves_fault("arrival", arrival).value();
  double longest = 0.0;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    longest = std::max(longest, arrival - vehicles[i].departure);
    names.push_back(name_of_vehicle(i, vehicles[i].id));
  }
  DeconflictionEffort effort;
  std::optional<Fault> first_fault, last_fault;
  for (std::size_t step = 0; step <= moves.later_arrivals; ++step) {
    const double share =
        step == 0 ? 0.0 : static_cast<double>(step) / static_cast<double>(moves.later_arrivals);
    const double time = arrival + moves.latest_excess * longest * share;
    std::vector<Candidates> candidates(vehicles.size());
    std::vector<std::vector<ArrivingPath>> paths(vehicles.size());
    std::vector<std::vector<double>> delays(vehicles.size());
    bool complete = true;
    for (std::size_t i = 0; i < vehicles.size() && complete; ++i) {
      std::optional<Fault> own;
      for (std::size_t solution = 0; solution < (moves.other_solution ? 2U : 1U); ++solution) {
        for (std::size_t k = 0; k <= moves.departure.delays; ++k) {
          ArrivingVehicle later = vehicles[i];
          later.departure += delay_of(moves.departure, k);
          if (k > 0 && later.departure == vehicles[i].departure) break;
          auto path = arriving_path(later, time, solution);
          auto vehicle =
              path ? planning_detail::flown(later, *path, time) : Result<Vehicle>(path.fault());
          if (vehicle) {
            candidates[i].push_back(*std::move(vehicle));
            paths[i].push_back(*std::move(path));
            delays[i].push_back(later.departure - vehicles[i].departure);
          } else if (!own) {
            own = vehicle.fault();
            own->sentence = names[i] + ": " + own->sentence;
            own->index = i;
          }
        }
      }
      if (candidates[i].empty()) {
        if (!first_fault) first_fault = own;
        complete = false;
      }
    }
    if (!complete) continue;
    std::vector<Vehicle> preferred;
    add_others(others, candidates, names);
    for (const Candidates& list : candidates) preferred.push_back(list[0]);
    if (const auto checked = close_pairs(preferred, goal); !checked) return checked.fault();
    ChoiceSearch search(std::move(candidates), others.size(), goal);
    const auto outcome = search.run(moves.departure.most_choices, effort);
    if (outcome != ChoiceSearch::Outcome::found) {
      last_fault = stuck(search, outcome, names, effort,
                         "arriving at " + to_text(time) +
                             (moves.later_arrivals > 0
                                  ? ", the last of " + std::to_string(moves.later_arrivals + 1) +
                                        " times looked at, "
                                  : ", "));
      if (outcome == ChoiceSearch::Outcome::given_up) break;
      continue;
    }
    SeparatedArrival result;
    result.plan.arrival = time;
    result.effort = effort;
    for (std::size_t i = 0; i < vehicles.size(); ++i) {
      result.plan.paths.push_back(paths[i][search.choice(i)]);
      result.plan.vehicles.push_back(search.chosen(i));
      result.delays.push_back(delays[i][search.choice(i)]);
    }
    return result;
  }
  return last_fault ? *std::move(last_fault) : *std::move(first_fault);
}

}  // namespace hodograph
