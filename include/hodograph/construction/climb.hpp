// SPDX-License-Identifier: MIT
// Constant climb: the helical PH quintic between two points with given headings that climbs at a
// given angle, or covers a given length over ground.
//
// Source: "Helical polynomial curves interpolating G1 data with prescribed axes and pitch angles".
// A path climbing by Δz at the angle θ has the length S = Δz cot θ over ground (18); it is the
// lifting (construction/lift.hpp) of the planar quintic of exactly that length
// (construction/prescribed_length.hpp). θ < 0 descends; Δz and θ have the same sign.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hodograph/construction/prescribed_length.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// A point, and the heading there: the direction of flight seen from above, any vector but zero
/// (direction_of_angle gives that of an angle from the x axis).
struct HeadedPoint {
  Vector3<double> position{};
  Vector2<double> heading{};
};

/// A climb, and how good it is.
struct ClimbCurve {
  SpatialPhCurve<2> curve;     ///< |dr/dξ| is the same at both ends
  double climb_angle = 0.0;    ///< θ, radians; negative: descent
  double ground_length = 0.0;  ///< S; the path's own length is S sec θ
  /// Of the plan, as in PrescribedLength: ∫|κ| ds over ground, by how much the next solution's
  /// exceeds it, what decided a tie, and whether the plan has no loop that it could do without.
  double rotation_index = 0.0;
  double margin = 0.0;
  TieBreak tie = TieBreak::none;
  bool loop_free = true;
};

/// One of several climbs between the same ends.
struct ClimbSolution {
  SpatialPhCurve<2> curve;
  double rotation_index = 0.0;
};

/// The climb at the angle θ, 0 < |θ| < π/2, over a parameter interval h > 0: of the solutions the
/// one whose plan has the least rotation index. Start, headings and rate are met to rounding, the
/// end to a few ε of the largest displacement coefficient, and a·r' = σ sin θ to a few ε of the
/// largest |A_i|², everywhere.
///
/// Faults: not_finite, outside_domain (an angle that is no climb: 0 or beyond ±π/2; h ≤ 0; a zero
/// heading), no_interpolant: the altitude does not change, or against the angle; or it changes too
/// little: Δz must exceed |Δq| tan θ, |Δq| the distance over ground (the fault's bound; a straight
/// line may have just that), or S leaves the range of numbers.
Result<ClimbCurve> climb_curve(const HeadedPoint& begin, const HeadedPoint& end, double climb_angle,
                               double h = 1.0, LengthSolutions among = LengthSolutions::published);

/// The climb with the given length over ground, S > 0: the angle is θ = atan(Δz/S). Level flight
/// where the points are at the same altitude. Faults: not_finite, outside_domain, no_interpolant
/// (S below the distance over ground), as above.
Result<ClimbCurve> climb_curve_of_ground_length(const HeadedPoint& begin, const HeadedPoint& end,
                                                double ground_length, double h = 1.0,
                                                LengthSolutions among = LengthSolutions::published);

/// All solutions (two; four with LengthSolutions::all; one if straight), by increasing rotation
/// index. Faults as above.
Result<std::vector<ClimbSolution>> climb_solutions(
    const HeadedPoint& begin, const HeadedPoint& end, double climb_angle, double h = 1.0,
    LengthSolutions among = LengthSolutions::published);

/// A point and the direction of motion there, any vector but zero.
struct DirectedPoint3 {
  Vector3<double> position{}, direction{};
};

/// The same about any axis: the helix between two points whose directions are equally inclined to
/// the axis (any vector but zero, -k included), by turning the axis upright, see turn_upright. The
/// climb angle is that of the directions over the plane across the axis.
/// Faults: as above; outside_domain (a direction along the axis); no_interpolant (directions whose
/// sines of inclination differ by more than accuracy::join_error, with both angles).
Result<ClimbCurve> helical_curve(const Vector3<double>& axis, const DirectedPoint3& begin,
                                 const DirectedPoint3& end, double h = 1.0,
                                 LengthSolutions among = LengthSolutions::published);
Result<std::vector<ClimbSolution>> helical_solutions(
    const Vector3<double>& axis, const DirectedPoint3& begin, const DirectedPoint3& end,
    double h = 1.0, LengthSolutions among = LengthSolutions::published);

/// One climb of many, and its answer: the curve is SpatialPhCurve<2>(begin.position, preimage,
/// step).
struct ClimbProblem {
  HeadedPoint begin{}, end{};
  double climb_angle = 0.0, step = 1.0;
};
struct ClimbAnswer {
  std::array<Quaternion<double>, 3> preimage{};
  double ground_length = 0.0, rotation_index = 0.0, margin = 0.0;
};

/// Many climbs at once (published solutions): the preimages of climb_curve, bit by bit, several
/// times faster. A fault is that of the first problem that has one, with its index; the answers
/// are then unspecified. Domain: as many answers as problems.
std::optional<Fault> climb_curves(std::span<const ClimbProblem> problems,
                                  std::span<ClimbAnswer> answers);

}  // namespace hodograph
