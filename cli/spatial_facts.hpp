// SPDX-License-Identifier: MIT
// What a path in space is beyond what every path is: how it bends and twists, each enclosed.
#pragma once

#include <optional>

#include "cli/json.hpp"
#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/path/any_path.hpp"

namespace hodograph::cli {

struct SpatialFacts {
  // Nothing of either for preimages above degree 8.
  std::optional<Enclosure> bending_energy{};  ///< ∫κ² ds; none where the path may stand still
  /// The extremes of the torsion; none where it is unbounded.
  std::optional<Enclosure> smallest_torsion{}, largest_torsion{};
};

/// Nothing for a path in the plane.
std::optional<SpatialFacts> spatial_facts_of(const AnyPath& path);

Json json_of(const SpatialFacts& facts);

}  // namespace hodograph::cli
