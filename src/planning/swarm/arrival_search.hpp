// SPDX-License-Identifier: MIT
// What arrival and deconfliction share: checked vehicles, vehicles made of paths, the times tried.
#pragma once

#include "hodograph/planning/swarm/simultaneous_arrival.hpp"

namespace hodograph::planning_detail {

/// "vehicle 3 (tanker)".
std::string name_of_vehicle(std::size_t index, const std::string& id);

/// The fault of vehicles that are too few or not usable.
std::optional<Fault> arriving_fault(std::span<const ArrivingVehicle> vehicles);
std::optional<Fault> search_fault(const ArrivalSearch& search);

/// The times at which an arrival is looked for, in order, the earliest first.
std::vector<double> arrival_times(std::span<const ArrivingVehicle> vehicles,
                                  const ArrivalSearch& search);

/// The vehicle on its path, at constant speed.
Result<Vehicle> flown(const ArrivingVehicle& vehicle, const ArrivingPath& path, double arrival);

/// All of them in one list, the others last.
std::vector<Vehicle> with_others(std::span<const Vehicle> vehicles,
                                 std::span<const Vehicle> others);

/// The pair of all that misses its required distance by most, in words: "vehicle 0 (a) and vehicle
/// 2 (c) come within 0.1 at time 0.5; 0.2 is required"; and the numbers.
Fault separation_fault(std::span<const Conflict> conflicts, std::span<const Vehicle> vehicles,
                       const std::string& before);

}  // namespace hodograph::planning_detail
