// SPDX-License-Identifier: MIT
// Whether a sweep is free of contact with itself, from the profile's own extent in each direction:
// further than the tube that holds it (surface/sweep.hpp) may reach.
//
// Derivation. The cross-sections at ξ₁ < ξ₂ lie in normal planes of the path. For a point x in
// both, f(ξ) = (x - r(ξ))·e₁(ξ) vanishes at ξ₁ and ξ₂, so f' = -|r'| + (x - r)·e₁' vanishes between
// (Rolle; at knots f has one-sided derivatives). So they do not meet where
//   |r'(η)|⁴ > (c(ξ) + λ R p - r(η)) · (r'(η) × (r''(η) × r'(η)))   for ξ₁ ≤ ξ, η ≤ ξ₂, p in the
//   profile,
// which for η = ξ is the condition 1 > κ (component of λ p along the principal normal). Sections
// further apart do not meet where a plane separates the convex hulls of the control points of what
// they sweep. The convex hull of the profile is taken in both: linear, so its corners decide.
//
// A roll beside the pieces' frames turns the sections in their planes: over each part of the path
// the corners are replaced by points whose hull holds their arcs. In a tubular family whose profile
// lies in a plane of the carried frame, with normal N (times any positive function), the same
// theorem for (x - c)·N leaves c'·N > (x - c)·N', or both the other way round.
#pragma once

#include <cstddef>

#include "hodograph/surface/sweep.hpp"

namespace hodograph {

/// What is known of the contact of a sweep with itself.
struct SweepContact {
  bool free = false;          ///< certainly no two cross-sections meet
  double xi[2] = {0.0, 0.0};  ///< where this was not decided
  std::size_t pairs = 0;      ///< parts compared
};

/// Whether the sweep with its profile `factor` times as large is certainly free of contact with
/// itself. Not free means: it meets itself, or its profile's convex hull does, or the search ended
/// undecided. For sweeps of planar profiles along paths in any frame, and tubular families whose
/// profile lies in a coordinate plane of the carried frame; for other profiles never free. A circle
/// is replaced by a polygon round it (0.5 % larger). Rounding is kept off by a margin of 2^-40 of
/// the size of the numbers; the rounding of the joins at knots is not counted. Domain: factor > 0
/// and finite. Cost: some microseconds a pair; 10² to 10⁴ pairs, at most 10⁵.
SweepContact contact_of(const Sweep& sweep, double factor = 1.0);

/// The largest factor of the profile, up to 2^-10 of it, for which contact_of certifies the sweep,
/// between those of the two tubes: the one inside which the sweep is certain, at least, and the
/// `most` asked for. 0 where no factor is certified (a corner).
double largest_free_factor(const Sweep& sweep, const TubeRadius& tube, double most = 64.0);

}  // namespace hodograph
