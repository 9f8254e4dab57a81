// SPDX-License-Identifier: MIT
// C¹ Hermite interpolation in the plane: the PH quintic with given end points and end derivatives,
// the best of its four solutions chosen by the exact absolute rotation index.
//
// Source: "Path planning with Pythagorean-hodograph curves for unmanned or autonomous vehicles",
// sections 2 and 3. With w0² and w2² the end derivatives and v the mean velocity, ∫w² = v says
//   2 w1² + 3 (w0 + w2) w1 + 3 w0² + 3 w2² + w0 w2 - 15 v = 0;
// the two signs of w2 and of the root give four solutions.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hodograph/foundation/result.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// A point and the derivative dr/dξ of the path there. The derivative may be zero: the path then
/// starts from rest, and the four solutions are two pairs.
struct PlanarHermitePoint {
  Vector2<double> position{}, derivative{};
};

/// What decided between solutions whose rotation indices agree within rounding
/// (accuracy_of_rotation_index); the first of these that differs.
enum class TieBreak {
  none,        ///< there was no tie
  regularity,  ///< the larger least speed: no cusp rather than one
  left_turn,   ///< the larger signed rotation index: the curve that turns to the left
  order,       ///< nothing but the order: + before - for w2 against the principal roots, then for
               ///< the root in w1
};

/// Two rotation indices closer than this (radians) are a tie: twice the error of one.
inline constexpr double accuracy_of_rotation_index = 64.0 * epsilon<double>();

/// The chosen solution.
struct PlanarHermite {
  PlanarPhCurve<2> curve;
  double rotation_index = 0.0;  ///< ∫|κ| ds, the least of the solutions
  double margin = 0.0;          ///< by how much the next larger index exceeds it
  TieBreak tie = TieBreak::none;
};

/// One of several solutions.
struct PlanarSolution {
  PlanarPhCurve<2> curve;
  double rotation_index = 0.0;
};

/// The curve over a parameter interval of length h > 0 whose rotation index is the least of the
/// four, ties broken as TieBreak says. Invariant under motions and scaling (1e-150 to 1e150); C¹
/// data of a PH quintic without loops gives that quintic.
///
/// Faults: not_finite (index 0: begin, 1: end), outside_domain (h ≤ 0), zero_speed (both
/// derivatives and the displacement are zero), no_interpolant (numbers out of double's range).
/// Accuracy: the end point and the end derivatives are met to a few ε of the largest displacement
/// coefficient and of the derivative.
Result<PlanarHermite> planar_hermite(const PlanarHermitePoint& begin, const PlanarHermitePoint& end,
                                     double h = 1.0);

/// All four, by increasing rotation index, ties in the order of TieBreak. Faults as above.
Result<std::array<PlanarSolution, 4>> planar_hermite_solutions(const PlanarHermitePoint& begin,
                                                               const PlanarHermitePoint& end,
                                                               double h = 1.0);

/// The Hermite data of the control points p0, p1 and p4, p5 of a quintic over an interval of length
/// h: derivatives 5 (p1 - p0)/h and 5 (p5 - p4)/h.
std::array<PlanarHermitePoint, 2> hermite_data_of_control_points(const Vector2<double>& p0,
                                                                 const Vector2<double>& p1,
                                                                 const Vector2<double>& p4,
                                                                 const Vector2<double>& p5,
                                                                 double h = 1.0);

/// The path through the points with their derivatives at the knots: C¹, the preimage continuous,
/// sign included. Faults: as above with the index of the segment or point; mismatched_size, too_few
/// (two points), not_increasing and not_finite (the knots), and those of Path::create.
Result<PlanarPath<2>> planar_hermite_path(std::vector<double> knots,
                                          std::span<const PlanarHermitePoint> points,
                                          bool closed = false);

/// One problem of many, and its answer: the chosen curve is PlanarPhCurve<2>(begin.position,
/// preimage, step).
struct PlanarHermiteProblem {
  PlanarHermitePoint begin{}, end{};
  double step = 1.0;
};
struct PlanarHermiteAnswer {
  std::array<Complex<double>, 3> preimage{};
  double rotation_index = 0.0, margin = 0.0;
};

/// Many problems at once; the numbers of planar_hermite, bit by bit, several times faster. A fault
/// is that of the first problem that has one, with its index; the answers are then unspecified.
/// Domain: as many answers as problems.
std::optional<Fault> planar_hermite(std::span<const PlanarHermiteProblem> problems,
                                    std::span<PlanarHermiteAnswer> answers);

}  // namespace hodograph
