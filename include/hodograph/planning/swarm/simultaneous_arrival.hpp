// SPDX-License-Identifier: MIT
// Vehicles that leave from different places, at different times if wanted, and arrive at the same
// time: each on a planar PH quintic of exactly the length that takes.
//
// Source: "Path planning with Pythagorean-hodograph curves for unmanned or autonomous vehicles",
// section 5: with constant speeds v_i and departures t_i, arrival at T means lengths v_i (T - t_i),
// which construction/prescribed_length.hpp gives to rounding, two formal solutions each.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hodograph/construction/prescribed_length.hpp"
#include "hodograph/planning/swarm/pairs.hpp"

namespace hodograph {

/// What is given of a vehicle.
struct ArrivingVehicle {
  std::string id;
  DirectedPoint begin, end;
  double speed = 1.0;
  double departure = 0.0;
  double radius = 0.0;
  std::optional<double> most_curvature{};  ///< 1/(least turning radius), if it has one
  Presence presence{};
  double altitude = 0.0;  ///< z of the plane it flies in
};

/// A vehicle's path.
struct ArrivingPath {
  PlanarPath<2> path;  ///< over ξ in [0, length], of mean parametric speed 1
  double departure = 0.0;
  std::size_t solution = 0;  ///< of the formal solutions by increasing rotation index
  double rotation_index = 0.0;
  Enclosure largest_curvature;  ///< of |κ|, over the whole path; at most the vehicle's limit
};

/// All of them, and the same as vehicles of a swarm that leave at `departure`, fly at constant
/// speed and arrive at `arrival`.
struct SimultaneousArrival {
  double arrival = 0.0;
  std::vector<ArrivingPath> paths;
  std::vector<Vehicle> vehicles;
};

/// The path of one vehicle that arrives at a given time, the formal solution of that number.
/// Faults: those of prescribed_length_curve, whose sentence names the vehicle (a length below the
/// distance: with the earliest arrival), outside_domain (a speed, radius or curvature limit that is
/// not usable; a solution that does not exist), no_interpolant (a curvature that certainly or
/// within rounding exceeds the limit, with both).
Result<ArrivingPath> arriving_path(const ArrivingVehicle& vehicle, double arrival,
                                   std::size_t solution);

/// Arrival at the given time, each vehicle on the first of its solutions that keeps its curvature
/// limit. Faults: as above, with the vehicle's number; for a curvature limit also what would be
/// feasible, a later arrival or a larger curvature, looked for as least_arrival does.
Result<SimultaneousArrival> arrival_at(std::span<const ArrivingVehicle> vehicles, double arrival);

/// The most steps that a search for an arrival time takes.
inline constexpr std::size_t most_arrival_steps = 100000;

/// Where the least arrival is looked for: from the earliest (all directions left aside) up to
/// `most_excess` times the longest straight flight later, at `steps` + 1 times whose distances grow
/// in proportion; then between the last time that does not serve and the first that does, by
/// bisection down to `resolution` of that range. A later time than one that serves need not serve
/// (a longer path may turn more), so an earlier one might hide between two of the times looked at.
struct ArrivalSearch {
  double most_excess = 1.0;
  std::size_t steps = 64;         ///< 1 to most_arrival_steps
  double resolution = 0x1.0p-20;  // not a tolerance: how closely the least time is looked for
};

/// The least arrival time at which every vehicle keeps its curvature limit. Without limits that is
/// the earliest one, next to which curvatures have no bound. Faults: those of arrival_at;
/// no_interpolant (none in the range, naming a vehicle that rules it out and its least curvature).
Result<SimultaneousArrival> least_arrival(std::span<const ArrivingVehicle> vehicles,
                                          const ArrivalSearch& search = {});

/// The least at which all pairs keep their distances, too, certified for every instant, also from
/// `others`, whose motions are given and stay (pairs of two of them are not looked at). In
/// sentences and faults the others are counted on after the vehicles. Faults: as
/// least_arrival; not_separated (none in the range, with the pair that comes closest to keeping its
/// distance too little, the time and both numbers); those of close_pairs.
Result<SimultaneousArrival> least_separated_arrival(std::span<const ArrivingVehicle> vehicles,
                                                    const SwarmGoal& goal,
                                                    const ArrivalSearch& search = {},
                                                    std::span<const Vehicle> others = {});

/// The earliest arrival: max of departure + distance/speed. Domain: usable vehicles, at least one.
double earliest_arrival(std::span<const ArrivingVehicle> vehicles);

}  // namespace hodograph
