// SPDX-License-Identifier: MIT
// Planar paths of an exact length between two directed points that keep a least turn radius: one
// quintic where one does, else arcs and straight lines, with whole turns where the length asks for
// them.
//
// Derivation. Paths of arcs of one radius ρ and straight lines (Dubins' words) have lengths that
// are elementary functions of ρ: for two left (right) turns about centres that are v(ρ) apart
//   L(ρ) = ρ (Δφ + 2πm) + |v(ρ)|,  v = Δq ± ρ Δn,  m whole turns,
// which does not fall with ρ since |Δn| = 2 |sin(Δφ/2)|; so every length from L at the least radius
// up has its radius. Other words (left-straight-right, three arcs) are solved on a grid; straight
// lines are lengthened by a swerve of arcs α, 2α, α, by 4ρ(α - sin α). An arc of at most a twelfth
// of a turn is one quintic of exactly its length (construction/prescribed_length.hpp), whose
// curvature exceeds 1/ρ by less than 2^-16 of it: arcs are made with ρ ≥ (1 + 2^-16) times the
// least radius; where that is too much, by pieces half as long, with 2^-20.
#pragma once

#include <cstddef>

#include "hodograph/construction/prescribed_length.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// What a turn-limited path is made of.
enum class TurnLimitedShape {
  one_span,  ///< one quintic
  arcs,      ///< arcs and straight lines
  swerve,    ///< the same with a detour in a straight line
  loiter,    ///< the same with whole turns
};

struct TurnLimitedPath {
  /// G1, and C1 in ξ: |dr/dξ| = 1 at all joints and both ends; its preimage is continuous.
  PlanarPath<2> path;
  TurnLimitedShape shape = TurnLimitedShape::one_span;
  std::size_t whole_turns = 0;
  double arc_radius = 0.0;      ///< of the arcs; 0 for one span
  double most_curvature = 0.0;  ///< certified: |κ| ≤ this everywhere, and this ≤ 1/turn_radius
};

/// The path of length S with |κ| ≤ 1/turn_radius. Where S is more than twice the shortest that arcs
/// reach and long enough for one, whole turns: as many as the radius allows, at most 64 (then of a
/// larger radius). Else, in this order: the one quintic of all four solutions with the least
/// rotation index that keeps the radius; arcs without whole turns, of the least total turning; arcs
/// with whole turns. turn_radius = 0 asks for no radius: one quintic.
///
/// Faults: those of prescribed_length_curve; outside_domain (a radius that is negative or not
/// finite); no_interpolant: S is below the shortest path of that curvature (`bound`, 2^-20 above
/// the least radius' own), or between lengths that arcs reach (`bound`: from there on every length
/// is met).
/// Accuracy: length and end to some ε of S and of the arcs' radius for each span; the radius is
/// kept with certainty.
Result<TurnLimitedPath> turn_limited_path(const DirectedPoint& begin, const DirectedPoint& end,
                                          double length, double turn_radius);

/// How the length is chosen where it is free.
struct TurnLimitedChoice {
  double least_length = 0.0;
  /// One quintic is taken where it is longer than the shortest arcs by at most this fraction.
  double most_detour = 0.25;
};

/// A short path of at least the given length with |κ| ≤ 1/turn_radius: of exactly that length where
/// turn_limited_path makes one; else one quintic of the least length (on a grid, then by bisection)
/// or the shortest arcs. Without a radius, of the lengths up to twice the larger of the distance
/// and the least length, the one of the least peak curvature. Always exists for points that are
/// apart or a least length or radius that is positive. Faults: as above but for the length.
Result<TurnLimitedPath> shortest_turn_limited_path(const DirectedPoint& begin,
                                                   const DirectedPoint& end, double turn_radius,
                                                   const TurnLimitedChoice& choice = {});

}  // namespace hodograph
