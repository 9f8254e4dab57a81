// SPDX-License-Identifier: MIT
// What is certain of one loop: speed, curvature, torsion, bending energy, box, and the tube that
// fits round it.
#pragma once

#include <array>
#include <optional>

#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/path/path.hpp"
#include "hodograph/path/self_distance.hpp"

namespace hodograph {

/// Enclosures of the extremes over a loop, each by the function of path/ with its name.
struct LoopFacts {
  Extremes speed;                   ///< per unit ξ
  Extremes curvature;               ///< unbounded for limit members
  Extremes torsion;                 ///< unbounded where the curvature may vanish
  std::optional<Enclosure> energy;  ///< ∫ κ² ds; nothing for limit members
  std::array<Extremes, 3> box;      ///< of each coordinate
  TubeRadius tube;                  ///< the largest tube that does not touch itself
};

/// All of them, refined to a relative width of 2^-20. Domain: any path of degree 7 in space.
/// Cost: some 2 ms for a loop.
LoopFacts loop_facts(const SpatialPath<3>& path);

}  // namespace hodograph
