// SPDX-License-Identifier: MIT
#include "hodograph/planning/swarm/simultaneous_arrival.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "arrival_search.hpp"
#include "hodograph/foundation/interruption.hpp"
#include "hodograph/path/bounds.hpp"

namespace hodograph {
namespace planning_detail {

std::string name_of_vehicle(std::size_t index, const std::string& id) {
  return "vehicle " + std::to_string(index) + (id.empty() ? "" : " (" + id + ")");
}

namespace {

/// How closely a path's largest curvature is enclosed.
constexpr RangeGoal curvature_goal{0x1.0p-30};  // not a tolerance: the width asked for

std::optional<Fault> unusable(const char* quantity, double value, bool may_be_zero) {
  if (std::isfinite(value) && (value > 0.0 || (may_be_zero && value == 0.0))) return std::nullopt;
  return Fault{std::isfinite(value) ? FaultCode::outside_domain : FaultCode::not_finite,
               "the " + std::string(quantity) + " must be " +
                   (may_be_zero ? "zero or positive" : "positive") + " and finite; got " +
                   to_text(value),
               std::nullopt,
               quantity,
               value,
               0.0};
}

std::optional<Fault> vehicle_fault(const ArrivingVehicle& v) {
  if (auto fault = unusable("speed", v.speed, false)) return fault;
  if (auto fault = unusable("radius", v.radius, true)) return fault;
  if (!std::isfinite(v.departure)) {
    return Fault{
        FaultCode::not_finite, "the departure must be a finite time; got " + to_text(v.departure),
        std::nullopt,          "departure",
        v.departure,           std::nullopt};
  }
  if (!std::isfinite(v.altitude)) {
    return Fault{FaultCode::not_finite,
                 "the altitude must be a finite number; got " + to_text(v.altitude),
                 std::nullopt,
                 "altitude",
                 v.altitude,
                 std::nullopt};
  }
  return v.most_curvature ? unusable("curvature limit", *v.most_curvature, false) : std::nullopt;
}

/// The same fault of a vehicle with this number.
Fault of_vehicle(Fault fault, std::size_t index, const std::string& id) {
  fault.sentence = name_of_vehicle(index, id) + ": " + fault.sentence;
  fault.index = index;
  return fault;
}

double straight_flight(const ArrivingVehicle& v) {
  const Vector2<double> chord = v.end.position - v.begin.position;
  return std::hypot(chord.x, chord.y) / v.speed;
}

Enclosure largest_curvature(const PlanarPath<2>& path) {
  const Extremes found = curvature_extremes(path, curvature_goal);
  const Enclosure low = abs(found.minimum), high = abs(found.maximum);
  return {std::max(low.lower(), high.lower()), std::max(low.upper(), high.upper())};
}

/// The first solution that keeps the limit, else the fault of the first.
Result<ArrivingPath> first_path(const ArrivingVehicle& v, double arrival) {
  auto first = arriving_path(v, arrival, 0);
  if (first || first.fault().quantity != "curvature") return first;
  auto second = arriving_path(v, arrival, 1);
  return second ? std::move(second) : std::move(first);
}

/// What a vehicle could do on its own, for a sentence: the first of the times at which it keeps its
/// limit, or the least curvature at any.
std::string what_would_do(const ArrivingVehicle& v, std::span<const double> times) {
  double least = std::numeric_limits<double>::infinity(), at = 0.0;
  ArrivingVehicle free = v;
  free.most_curvature.reset();
  for (const double time : times) {
    check_interruption();
    if (first_path(v, time)) {
      return "arrival at " + to_text(time) + ", a length of " +
             to_text(v.speed * (time - v.departure)) + ", would do";
    }
    for (const std::size_t solution : {0U, 1U}) {
      const auto path = arriving_path(free, time, solution);
      if (path && path->largest_curvature.upper() < least) {
        least = path->largest_curvature.upper();
        at = v.speed * (time - v.departure);
      }
    }
  }
  if (!std::isfinite(least)) {
    return "no later arrival was looked at; an earlier one or a larger limit may do";
  }
  return "no later arrival looked at would do; the least largest curvature is " + to_text(least) +
         ", at length " + to_text(at);
}

Result<SimultaneousArrival> assembled(std::span<const ArrivingVehicle> vehicles, double arrival) {
  SimultaneousArrival result;
  result.arrival = arrival;
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    auto path = first_path(vehicles[i], arrival);
    if (!path) return of_vehicle(path.fault(), i, vehicles[i].id);
    auto vehicle = flown(vehicles[i], *path, arrival);
    if (!vehicle) return of_vehicle(vehicle.fault(), i, vehicles[i].id);
    result.paths.push_back(*std::move(path));
    result.vehicles.push_back(*std::move(vehicle));
  }
  return result;
}

using Attempt = std::function<std::optional<SimultaneousArrival>(double)>;

/// The first of the times that serves, moved towards the one before it; empty if none does.
std::optional<SimultaneousArrival> first_that_serves(std::span<const double> times,
                                                     const ArrivalSearch& search,
                                                     const Attempt& attempt) {
  for (std::size_t k = 0; k < times.size(); ++k) {
    check_interruption();
    auto best = attempt(times[k]);
    if (!best) continue;
    if (k == 0) return best;
    double low = times[k - 1], high = times[k];
    const double enough = search.resolution * (times.back() - times.front());
    while (high - low > enough) {
      const double middle = 0.5 * (low + high);
      if (!(low < middle && middle < high)) break;
      if (auto earlier = attempt(middle)) {
        best = std::move(earlier);
        high = middle;
      } else {
        low = middle;
      }
    }
    return best;
  }
  return std::nullopt;
}

/// Why no time serves: the vehicle that at most of them has no path.
Fault no_arrival(std::span<const ArrivingVehicle> vehicles, std::span<const double> times) {
  std::size_t worst = 0, most = 0;
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    std::size_t failures = 0;
    for (const double time : times) failures += first_path(vehicles[i], time) ? 0U : 1U;
    if (failures > most) {
      most = failures;
      worst = i;
    }
  }
  const ArrivingVehicle& v = vehicles[worst];
  const double limit = v.most_curvature.value_or(0.0);
  return {FaultCode::no_interpolant,
          "no arrival between " + to_text(times.front()) + " and " + to_text(times.back()) +
              " suits all vehicles; " + name_of_vehicle(worst, v.id) +
              " with its curvature limit of " + to_text(limit) + " rules out " +
              std::to_string(most) + " of the " + std::to_string(times.size()) +
              " times looked at: " + what_would_do(v, times),
          worst,
          "curvature",
          limit,
          std::nullopt};
}

}  // namespace

std::optional<Fault> arriving_fault(std::span<const ArrivingVehicle> vehicles) {
  if (vehicles.empty()) {
    return Fault{FaultCode::too_few,
                 "an arrival needs at least one vehicle; got none",
                 std::nullopt,
                 "vehicles",
                 0.0,
                 1.0};
  }
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    if (auto fault = vehicle_fault(vehicles[i])) {
      return of_vehicle(*std::move(fault), i, vehicles[i].id);
    }
    if (!std::isfinite(straight_flight(vehicles[i]))) {
      return of_vehicle({FaultCode::not_finite, "its positions must be finite", i, "position",
                         std::nullopt, std::nullopt},
                        i, vehicles[i].id);
    }
  }
  return std::nullopt;
}

std::optional<Fault> search_fault(const ArrivalSearch& search) {
  if (auto fault = unusable("most_excess", search.most_excess, false)) return fault;
  if (auto fault = unusable("resolution", search.resolution, false)) return fault;
  if (search.steps > most_arrival_steps) {
    return Fault{FaultCode::outside_domain,
                 "there may be at most " + std::to_string(most_arrival_steps) + " steps; got " +
                     std::to_string(search.steps),
                 std::nullopt,
                 "steps",
                 static_cast<double>(search.steps),
                 static_cast<double>(most_arrival_steps)};
  }
  return unusable("steps", static_cast<double>(search.steps), false);
}

std::vector<double> arrival_times(std::span<const ArrivingVehicle> vehicles,
                                  const ArrivalSearch& search) {
  const double earliest = earliest_arrival(vehicles);
  double longest = 0.0;
  for (const ArrivingVehicle& v : vehicles) longest = std::max(longest, straight_flight(v));
  if (longest == 0.0) {  // all end where they begin: the unit is the only length there is
    for (const ArrivingVehicle& v : vehicles) longest = std::max(longest, 1.0 / v.speed);
  }
  std::vector<double> times;
  for (std::size_t k = 0; k <= search.steps; ++k) {
    const double x = static_cast<double>(k) / static_cast<double>(search.steps);
    times.push_back(earliest + search.most_excess * longest * (x * x));
  }
  return times;
}

Result<Vehicle> flown(const ArrivingVehicle& vehicle, const ArrivingPath& path, double arrival) {
  auto law = TimingLaw::between(path.path.arc_length(), path.departure, arrival);
  if (!law) return law.fault();
  auto motion = TimedMotion::create(path.path, *std::move(law), vehicle.presence, vehicle.altitude);
  if (!motion) return motion.fault();
  return Vehicle{vehicle.id, *std::move(motion), vehicle.radius};
}

std::vector<Vehicle> with_others(std::span<const Vehicle> vehicles,
                                 std::span<const Vehicle> others) {
  std::vector<Vehicle> all(vehicles.begin(), vehicles.end());
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

Fault separation_fault(std::span<const Conflict> conflicts, std::span<const Vehicle> vehicles,
                       const std::string& before) {
  std::size_t worst = 0;
  for (std::size_t i = 1; i < conflicts.size(); ++i) {
    if (conflicts[i].shortfall().upper() > conflicts[worst].shortfall().upper()) worst = i;
  }
  const Conflict& c = conflicts[worst];
  const double distance = c.separation.distance.upper();
  return {FaultCode::not_separated,
          before + name_of_vehicle(c.pair.first, vehicles[c.pair.first].id) + " and " +
              name_of_vehicle(c.pair.second, vehicles[c.pair.second].id) + " come within " +
              to_text(distance) + " of each other at time " + to_text(c.separation.time) + "; " +
              to_text(c.pair.required) + " is required",
          c.pair.first,
          "separation",
          distance,
          c.pair.required};
}

}  // namespace planning_detail

using namespace planning_detail;

double earliest_arrival(std::span<const ArrivingVehicle> vehicles) {
  double earliest = -std::numeric_limits<double>::infinity();
  for (const ArrivingVehicle& v : vehicles) {
    earliest = std::max(earliest, v.departure + straight_flight(v));
  }
  return earliest;
}

Result<ArrivingPath> arriving_path(const ArrivingVehicle& v, double arrival, std::size_t solution) {
  if (auto fault = vehicle_fault(v)) return *std::move(fault);
  if (!std::isfinite(arrival) || !(arrival > v.departure)) {
    return Fault{std::isfinite(arrival) ? FaultCode::outside_domain : FaultCode::not_finite,
                 "arrival must be after the departure at " + to_text(v.departure) + "; got " +
                     to_text(arrival),
                 std::nullopt,
                 "arrival",
                 arrival,
                 v.departure};
  }
  const double length = v.speed * (arrival - v.departure);
  auto solutions = prescribed_length_solutions(v.begin, v.end, length, length);
  if (!solutions) {
    Fault fault = solutions.fault();
    const double earliest = v.departure + straight_flight(v);
    if (fault.code == FaultCode::no_interpolant && fault.quantity == "length") {
      fault.sentence += "; it can arrive at " + to_text(earliest) + " at the earliest, not at " +
                        to_text(arrival);
    }
    return fault;
  }
  if (solution >= solutions->size()) {
    return Fault{FaultCode::outside_domain,
                 "there are " + std::to_string(solutions->size()) +
                     " solutions, counted from 0; got " + std::to_string(solution),
                 std::nullopt,
                 "solution",
                 static_cast<double>(solution),
                 static_cast<double>(solutions->size() - 1)};
  }
  const PlanarSolution& chosen = (*solutions)[solution];
  auto path = PlanarPath<2>::create({0.0, length}, {chosen.curve}, false);
  if (!path) return path.fault();
  const Enclosure curvature = largest_curvature(*path);
  if (v.most_curvature && !(curvature.upper() <= *v.most_curvature)) {
    return Fault{FaultCode::no_interpolant,
                 "its path of length " + to_text(length) + " has curvatures up to " +
                     to_text(curvature.upper()) + "; its limit is " + to_text(*v.most_curvature),
                 std::nullopt,
                 "curvature",
                 curvature.upper(),
                 *v.most_curvature};
  }
  return ArrivingPath{*std::move(path), v.departure, solution, chosen.rotation_index, curvature};
}

Result<SimultaneousArrival> arrival_at(std::span<const ArrivingVehicle> vehicles, double arrival) {
  if (auto fault = arriving_fault(vehicles)) return *std::move(fault);
  auto result = assembled(vehicles, arrival);
  if (result || result.fault().quantity != "curvature") return result;
  Fault fault = result.fault();
  const ArrivingVehicle& v = vehicles[*fault.index];
  std::vector<double> later = arrival_times(std::span(&v, 1), {});
  std::erase_if(later, [&](double time) { return time < arrival; });
  fault.sentence += "; " + what_would_do(v, later);
  return fault;
}

Result<SimultaneousArrival> least_arrival(std::span<const ArrivingVehicle> vehicles,
                                          const ArrivalSearch& search) {
  if (auto fault = arriving_fault(vehicles)) return *std::move(fault);
  if (auto fault = search_fault(search)) return *std::move(fault);
  const std::vector<double> times = arrival_times(vehicles, search);
  auto found = first_that_serves(times, search, [&](double time) {
    auto result = assembled(vehicles, time);
    return result ? std::optional(*std::move(result)) : std::nullopt;
  });
  if (found) return *std::move(found);
  return no_arrival(vehicles, times);
}

Result<SimultaneousArrival> least_separated_arrival(std::span<const ArrivingVehicle> vehicles,
                                                    const SwarmGoal& goal,
                                                    const ArrivalSearch& search,
                                                    std::span<const Vehicle> others) {
  if (auto fault = arriving_fault(vehicles)) return *std::move(fault);
  if (auto fault = search_fault(search)) return *std::move(fault);
  const std::vector<double> times = arrival_times(vehicles, search);
  const std::size_t count = vehicles.size();
  std::optional<Fault> refused;             // the goal's own fault
  std::optional<SimultaneousArrival> best;  // the attempt with the fewest close pairs
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  auto found =
      first_that_serves(times, search, [&](double time) -> std::optional<SimultaneousArrival> {
        auto result = assembled(vehicles, time);
        if (refused || !result) return std::nullopt;
        auto close = close_pairs(with_others(result->vehicles, others), goal);
        if (!close) {
          refused = close.fault();
          return std::nullopt;
        }
        std::erase_if(*close, [&](const ClosePair& pair) { return pair.first >= count; });
        if (close->empty()) return *std::move(result);
        if (close->size() < fewest) {
          fewest = close->size();
          best = *std::move(result);
        }
        return std::nullopt;
      });
  if (refused) return *std::move(refused);
  if (found) return *std::move(found);
  if (!best) return no_arrival(vehicles, times);
  const std::vector<Vehicle> all = with_others(best->vehicles, others);
  auto close = conflicts(all, goal).value();
  std::erase_if(close, [&](const Conflict& conflict) { return conflict.pair.first >= count; });
  return separation_fault(close, all,
                          "no arrival between " + to_text(times.front()) + " and " +
                              to_text(times.back()) + " of " + std::to_string(times.size()) +
                              " looked at keeps all vehicles apart; arriving at " +
                              to_text(best->arrival) + ", ");
}

}  // namespace hodograph
