// SPDX-License-Identifier: MIT
// How close a path comes to itself, and the largest tube round it that does not touch itself.
//
// Two points of a path are distinct parts of it where they are at least a given arc length apart
// (round a closed path: both ways). Both answers are of the exact curve of the stored numbers (see
// path/bounds.hpp), rounding included, up to the rounding of the joins at knots.
//
// The largest tube radius is the reach of the path (Federer 1959): the largest R such that every
// point nearer than R to the path has one nearest point on it; normal discs of radius below R are
// then disjoint, and so are the half balls at the ends of an open path. It is
//   R = min(1/κ_max, D/2),  D = min |r(a) - r(b)| over parts at least π/κ_max apart.
// Derivation: an arc of curvature ≤ κ and length ≤ π/κ stays outside the balls of radius 1/κ that
// touch it at its start, and its chord is at least (2/κ) sin(κ length/2) (Schur); parts further
// apart have |r(a) - r(b)|² ≥ D · (distance of one from the tangent at the other). Where D <
// 2/κ_max it is attained with the chord in both normal planes (behind an end: beyond it), which is
// a contact.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/bounds.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// The least distance between parts of a path, and where it is attained.
struct SelfDistance {
  Enclosure distance;           ///< contains the least distance; 0 where the path meets itself
  double separation = 0.0;      ///< how far apart along the path its points are at least
  double xi[2] = {0.0, 0.0};    ///< two points at a distance of at most distance.upper(), in order
  std::size_t evaluations = 0;  ///< pairs of pieces looked at
};

/// The least distance of two points that are at least `separation` apart along the path (pairs
/// within rounding of that count or not). goal.relative_width is of the distance;
/// goal.subdivisions bounds the pairs of pieces that are subdivided, after which the enclosure is
/// rigorous all the same, only wider. Where the path meets itself the lower end is 0 and the upper
/// end is rounding.
/// Faults: not_finite, outside_domain (a separation that is not positive, or no two points so far
/// apart: the separation exceeds the length, or half of it for a closed path).
/// Method: best-first subdivision of pairs of pieces; the hulls of two pieces are separated in the
/// direction between their chords, so that the gap falls with the square of their length.
/// Cost: 0.1 to 1 µs a pair of pieces; some hundred pairs for isolated minima, some thousand for
/// parallel parts.
template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
Result<SelfDistance> self_distance(const Path<A, n>& path, double separation,
                                   const RangeGoal& goal);

/// What a tube round the path is limited by.
enum class TubeLimit {
  curvature,  ///< it folds where the path is most curved
  distance,   ///< it touches itself where parts come close
  corner,     ///< the tangent breaks at a knot: no radius
  standstill  ///< the speed may vanish, and the curvature is not bounded
};

/// "curvature", "distance", "corner", "standstill".
const char* name_of(TubeLimit limit);

/// The largest radius of a tube round a path, and what limits it.
struct TubeRadius {
  /// Contains the reach R above; [largest double, ∞) for a straight path.
  Enclosure radius;
  TubeLimit limit = TubeLimit::curvature;
  Enclosure curvature;   ///< the largest curvature
  std::size_t knot = 0;  ///< of a corner
  /// Distinct parts, π/κ apart; nothing where the path is too short to have them. Where the
  /// curvature limits, the upper end may be infinite: they are no closer than the lower end.
  std::optional<SelfDistance> distance{};
};

/// The largest radius of a tube of circular cross section (in the plane: the largest offset to both
/// sides) that is free of folds and of contact with itself: R above. goal.relative_width is of R.
/// A tangent that breaks by more than rounding at a knot gives radius 0.
/// Cost: that of curvature_extremes and of self_distance.
template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
TubeRadius largest_tube_radius(const Path<A, n>& path, const RangeGoal& goal);

}  // namespace hodograph

#include "hodograph/path/detail/self_distance_impl.hpp"
