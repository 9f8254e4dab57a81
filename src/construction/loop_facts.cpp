// SPDX-License-Identifier: MIT
#include "hodograph/construction/loop_facts.hpp"

#include "hodograph/path/bending_energy.hpp"
#include "hodograph/path/torsion.hpp"

namespace hodograph {

LoopFacts loop_facts(const SpatialPath<3>& path) {
  constexpr RangeGoal goal{0x1.0p-20};  // a millionth: what the header says
  LoopFacts facts{speed_extremes(path, goal),   curvature_extremes(path, goal),
                  torsion_extremes(path, goal), std::nullopt,
                  bounding_box(path, goal),     largest_tube_radius(path, goal)};
  if (const auto energy = bending_energy_enclosure(path)) facts.energy = *energy;
  return facts;
}

}  // namespace hodograph
