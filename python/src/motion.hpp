// SPDX-License-Identifier: MIT
// Motions and vehicles as Python holds them: with the path they fly.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hodograph/planning/swarm/timed_motion.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

/// A TimedMotion and what it was made of.
struct Motion {
  std::shared_ptr<const AnyPath> path;
  double altitude;
  TimedMotion motion;
};

/// A Vehicle likewise.
struct Flyer {
  std::string id;
  Motion motion;
  double radius;
};

inline std::vector<Vehicle> vehicles_of(const std::vector<Flyer>& flyers) {
  std::vector<Vehicle> vehicles;
  vehicles.reserve(flyers.size());
  for (const Flyer& one : flyers) vehicles.push_back({one.id, one.motion.motion, one.radius});
  return vehicles;
}

}  // namespace hodograph::python
