// SPDX-License-Identifier: MIT
// What a path of any dimension and degree is: its continuity, lengths, bounds and holonomy,
// computed from its numbers alone. `inspect` shows them, `check` compares promises with them, and
// documents promise them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/frame/holonomy.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/path/any_path.hpp"

namespace hodograph::cli {

/// The worst jump of one derivative over all knots, as in path/continuity.hpp.
struct JumpFact {
  double jump = 0.0, allowed = 0.0;
  std::size_t knot = 0;
};

struct PathFacts {
  ContinuityOrders continuity{};
  std::vector<JumpFact> position, preimage, frame, angular_velocity;  ///< [derivative]
  bool antiperiodic = false;  ///< a closed path whose preimage returns to its negative
  std::optional<Holonomy<double>> holonomy{};  ///< of a closed path in space
  Enclosure arc_length, smallest_speed, largest_speed;
  Vector3<double> end{};         ///< z is 0 in the plane
  double end_rounding = 0.0;     ///< how far another computation of it may be off
  double curvature_bound = 0.0;  ///< infinite where the path may stand still
  /// The largest coefficient of |r'|² - σ², divided by what rounding allows it: at most 1 on a
  /// Pythagorean-hodograph curve.
  double hodograph_identity = 0.0;
};

/// Continuity alone: linear in the number of segments and cheap.
void set_continuity(PathFacts& facts, const AnyPath& path);
/// All of it.
PathFacts facts_of(const AnyPath& path);

/// What a document may promise of a path.
Promises promises_of(const PathFacts& facts);

}  // namespace hodograph::cli
