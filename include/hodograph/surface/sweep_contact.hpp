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
// the corners are replaced by points whose hull holds their arcs.
//
// The curves of a tubular family lie in no normal planes. There the surface itself is certified,
// whatever the profile: on a convex block of its parameters it is injective where, for two
// directions a and b, the matrix (a·S_v, a·S_u; b·S_v, b·S_u) is regular for every choice of its
// entries within their ranges (were S(q) = S(p), the mean of that matrix along the segment from p
// to q would take q - p to 0); blocks that do not touch are kept apart by planes between the hulls
// of their control points.
#pragma once

#include <cstddef>

#include "hodograph/surface/sweep.hpp"

namespace hodograph {

/// What is known of the contact of a sweep with itself.
struct SweepContact {
  bool free = false;          ///< certainly no two cross-sections meet, nor one itself
  double xi[2] = {0.0, 0.0};  ///< where this was not decided
  std::size_t pairs = 0;      ///< parts compared
};

/// Whether the sweep with its profile `factor` times as large is certainly free of contact with
/// itself. Not free means: it meets itself, or its profile's convex hull does, or the search ended
/// undecided. For sweeps of planar profiles (free of contact themselves) along paths in any frame;
/// and for tubular families and profiles in space, whose curves may cross themselves and then are
/// never free, in any frame whose roll is rational. There the hull is not taken, and only points
/// that a closed profile identifies may coincide: a family that returns to where it began meets
/// itself. A circle is replaced by a polygon round it (0.5 % larger). Rounding is kept off by a
/// margin of 2^-40 of the size of the numbers; the rounding of the joins at knots is not counted.
/// Domain: factor > 0 and finite. Cost: some microseconds a pair; 10² to 10⁴ pairs, at most 10⁵
/// (families: 2·10⁵).
SweepContact contact_of(const Sweep& sweep, double factor = 1.0);

/// The largest factor of the profile, up to 2^-10 of it, for which contact_of certifies the sweep,
/// between those of the two tubes: the one inside which the sweep is certain, at least, and the
/// `most` asked for. 0 where no factor is certified (a corner).
double largest_free_factor(const Sweep& sweep, const TubeRadius& tube, double most = 64.0);

}  // namespace hodograph
