// SPDX-License-Identifier: MIT
// G¹ Hermite interpolation with a prescribed arc length: the planar PH quintic between two points
// with given tangent directions, of equal end speeds, whose length is exactly S.
//
// Source: "Construction of G¹ planar Hermite interpolants with prescribed arc lengths" as used in
// "Path planning with Pythagorean-hodograph curves for unmanned or autonomous vehicles", (10)-(13).
// Here in a form without cancellation and without special cases: with X the chord's length, φs, φe
// in (-π, π] the tangent angles from the chord, (ls, ms) = (cos, sin)(φs/2) and (le, me) likewise,
//   p = 3 ls² + 3 le² - 2 ls le,   q = 3 ms² + 3 me² - 2 ms me,
//   g = sin((φs + φe)/2) (1 - 3 cos((φs - φe)/2)),
//   A = (S+X) q + (S-X) p,  B = (S+X) q - (S-X) p,  H = hypot(B, 2 √(S² - X²) g),
//   |w0|² = |w2|² = z = 24 (S² - X²)/(A + H), P = 60 (S+X)(H+B)/(A+H), Q = 60 (S-X)(H-B)/(A+H),
//   w1 = (-3 (ls+le) √z ± √P)/4 + i (-3 (ms+me) √z ± sign(g) √Q)/4  (one sign for both).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hodograph/construction/planar_hermite.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// A point and a direction: any vector but zero.
struct DirectedPoint {
  Vector2<double> position{}, direction{};
};

/// (cos θ, sin θ).
Vector2<double> direction_of_angle(double theta);

/// The chosen solution, and how good it is.
struct PrescribedLength {
  PlanarPhCurve<2> curve;
  double rotation_index = 0.0;  ///< ∫|κ| ds, the least of the solutions
  double margin = 0.0;          ///< by how much the next larger index exceeds it
  TieBreak tie = TieBreak::none;
  /// |φs| + |φe|: the turn from the first tangent to the chord and from there to the last, which a
  /// curve makes that does not turn away from its chord.
  double unavoidable_rotation = 0.0;
  /// Whether the rotation index exceeds the unavoidable one by less than π, the least turn of a
  /// closed loop. Where the best solution is not loop-free, none is: S is too long for these
  /// directions. (Turns that the directions ask for may still make the curve meet itself; see
  /// crosses_itself.)
  bool loop_free = true;
};

/// Which solutions there are to choose from.
enum class LengthSolutions {
  published,  ///< two: the tangent angles wrapped to (-π, π] decide the sign of w2
  all,        ///< four: also those with -w2, a full turn more or less between the ends
};

/// The curve over a parameter interval h > 0 with |dr/dξ| equal at both ends and arc length S, the
/// least rotation index first, ties broken as TieBreak says (mirror images: the one that turns to
/// the left). The points may coincide. Invariant under motions and scaling (1e-150 to 1e150).
///
/// S counts as the chord's length X where they agree to accuracy::join_error. The straight line is
/// then the answer if the directions lie along the chord, up to the angles that a curve longer than
/// X by that fraction can have (about 1e-7); S > X with such directions gives its own curve
/// wherever that has no loop.
///
/// Faults: not_finite (index 0: begin, 1: end, none: the length), outside_domain (h ≤ 0, S ≤ 0, a
/// zero direction), no_interpolant (S < X, with both numbers; S = X with directions off the chord;
/// numbers out of double's range). Accuracy: length, end point and directions hold to a few ε of S
/// (of the largest displacement coefficient, where the curve has loops).
Result<PrescribedLength> prescribed_length_curve(
    const DirectedPoint& begin, const DirectedPoint& end, double length, double h = 1.0,
    LengthSolutions among = LengthSolutions::published);

/// All solutions, by increasing rotation index; the last `LengthSolutions::all` adds are included
/// if asked for. A straight line is a single solution. Faults as above.
Result<std::vector<PlanarSolution>> prescribed_length_solutions(
    const DirectedPoint& begin, const DirectedPoint& end, double length, double h = 1.0,
    LengthSolutions among = LengthSolutions::published);

/// Whether a planar PH quintic meets itself: r(a) = r(b) for some a < b (b - a < 1 where it is
/// closed). Decided in double by the roots of a polynomial in (a + b)/2: a curve that touches
/// itself within rounding may be called either way. Microseconds; at once false for a curve that
/// turns by less than π.
bool crosses_itself(const PlanarPhCurve<2>& curve);

/// One problem of many, and its answer: the chosen curve is PlanarPhCurve<2>(begin.position,
/// preimage, step).
struct PrescribedLengthProblem {
  DirectedPoint begin{}, end{};
  double length = 0.0, step = 1.0;
};

/// Many problems at once (published solutions): the preimage, index and margin of
/// prescribed_length_curve, bit by bit, several times faster; loops are not looked for. A fault is
/// that of the first problem that has one, with its index; the answers are then unspecified.
/// Domain: as many answers as problems.
std::optional<Fault> prescribed_length_curves(std::span<const PrescribedLengthProblem> problems,
                                              std::span<PlanarHermiteAnswer> answers);

}  // namespace hodograph
