// SPDX-License-Identifier: MIT
// Which closed loop of the family serves a purpose: ξ, ψ and, if wanted, the roll about the start's
// direction, found by a search of the whole range.
//
// What is certain and what is not: the loop returned meets its box, if one is given, and its value
// is enclosed rigorously. That no other loop is better is not proved: it is the best after a
// deterministic search of a grid of the whole range, whose steps the answer states, and local
// refinement from its best cells. A better loop would have to hide between the grid's points.
// Without a wish besides, the answers of least_energy and least_torsion_range are known: the planar
// oval ξ = 0, ψ = π (bending energy 39.64 over length, torsion 0).
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/foundation/enclosure.hpp"

namespace hodograph {

/// What is least in the chosen loop.
enum class LoopPurpose {
  least_energy,         ///< the bending energy ∫ κ² ds
  least_torsion_range,  ///< max τ - min τ (per unit length)
  near_point,           ///< the distance from a point to the loop
  extents,              ///< the largest difference of the box's sides from wanted ones
};

/// A box with sides along the axes of the world.
struct LoopBox {
  Vector3<double> low, high;
};

/// The purpose and its conditions.
struct LoopWish {
  LoopPurpose purpose = LoopPurpose::least_energy;
  Vector3<double> point{};            ///< for near_point
  Vector3<double> extents{};          ///< for extents: wanted sides of the loop's box, ≥ 0
  std::optional<LoopBox> within{};    ///< the loop must lie in it
  std::optional<double> xi{}, psi{};  ///< held at these values
  bool free_roll = false;   ///< the frame may turn about the direction: a third number to choose
  double largest_xi = 8.0;  ///< the range of the search is |ξ| ≤ this
};

/// The loop chosen.
struct ChosenLoop {
  LoopShape shape;
  double roll = 0.0;  ///< of the frame about the direction, beyond the one given, radians
  SpatialPath<3> path;
  /// Contains what the purpose makes least: energy, torsion range, distance or difference.
  Enclosure value;
  /// Steps of the grid that was searched: in arctan ξ, ψ and the roll; 0 for a number held.
  std::array<double, 3> grid_steps{};
  std::size_t evaluations = 0;
};

/// The best loop with the given placement. With near_point and free_roll many loops pass through a
/// point; of those the search prefers low energy, in a compromise that it does not prove best.
/// Faults: those of closed_loop; not_finite and outside_domain for the numbers of the wish (a
/// negative extent, a box with low > high or without the start, largest_xi ≤ 0, a held ξ that is
/// infinite); no_interpolant where no loop within the box was found, with the least distance by
/// which one stuck out.
/// Accuracy: the value is that of the loop returned, in an enclosure (relative width about 1e-6 for
/// torsion and extents, rounding for the others); ξ and ψ are a local minimum to about half of the
/// digits. Cost: 20 to 100 ms; with a free roll up to a second.
Result<ChosenLoop> choose_loop(const LoopPlacement& placement, const LoopWish& wish);

}  // namespace hodograph
