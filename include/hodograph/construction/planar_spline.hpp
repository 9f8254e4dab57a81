// SPDX-License-Identifier: MIT
// The C² path of planar PH quintics through points, open or closed.
//
// Source: Albrecht and Farouki; Farouki, Kuspa, Manni and Sestini; here on any knots, and with the
// other solutions searched where the data are wild. Derivation: src/construction/
// planar_spline_system.hpp.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hodograph/algebra/complex.hpp"
#include "hodograph/algebra/vector.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// The parameter steps of the spans.
enum class SplineParameters {
  uniform,       ///< 1 each, as published
  chord_length,  ///< the chord's length: speed near 1, a better shape on uneven spacing
};

/// What to do with a point equal to the one before it.
enum class RepeatedPoints {
  refuse,  ///< a fault with its index
  merge,   ///< leave it out; the report counts them
};

struct PlanarSplineOptions {
  bool closed = false;  ///< periodic; the first point may be repeated at the end, or not
  SplineParameters parameters = SplineParameters::uniform;
  RepeatedPoints repeated = RepeatedPoints::refuse;
  /// How many sharp turns, at most, are also tried the other way round; 0: the first solution is
  /// taken. A trial costs a few microseconds, whatever the number of points.
  std::size_t most_alternatives = 4096;
  bool with_energy = false;  ///< report the bending energy: about 1 µs a point
};

/// How a spline was found.
struct PlanarSplineReport {
  std::size_t newton_steps = 0;  ///< on the whole system
  /// The largest |h ∫w² - Δq| / (h max(|a|², |z|², |b|²)) over the spans, a, z, b the
  /// coefficients of w there: how far a span misses its end, relative to its size.
  double residual = 0.0;
  std::size_t worst_span = 0;  ///< where
  /// ±1: the preimage returns to itself or to its negative (odd turning number); 1 if open.
  int closure_sign = 1;
  /// Whether Newton's iteration from the ordinary cubic spline failed somewhere, and a
  /// continuation took over.
  bool continued = false;
  /// Solutions are not unique: where the tangent turns by more than 150° between the middles of
  /// two spans, the turn the other way round is tried, and taken if the bending energy ∫κ²ds is
  /// less.
  std::size_t alternatives_tried = 0;
  std::size_t alternatives_taken = 0;
  std::size_t solutions_found = 1;  ///< the first one, and those of the trials that differ from it
  std::size_t merged_points = 0;
  /// ∫κ²ds, if asked for, as bending_energy of the path (planar_spline_preimage: to about 8
  /// digits); infinite where the curve comes to rest.
  std::optional<double> energy;
};

/// The spline's numbers alone: span i has the preimage coefficients node[i], middle[i],
/// (the end of the span) node[i + 1], in the global scaling, over a step knots[i + 1] - knots[i].
/// For a closed spline node[N] is closure_sign times node[0].
struct PlanarSplinePreimage {
  std::vector<double> knots;
  std::vector<Complex<double>> middle, node;
  std::vector<std::size_t> kept;  ///< which point each node is; empty: all of them
  PlanarSplineReport report;
};

struct PlanarSpline {
  PlanarPath<2> path;
  PlanarSplineReport report;
};

/// The path r with r(ξ_i) = q_i that is C² everywhere, its preimage C¹ and quadratic between the
/// knots. Open: cubic end spans (one span: a straight line; two points at least). Closed: periodic,
/// preimage up to the closure sign (two distinct points at least).
///
/// Scaling the points by a power of 4 scales the path exactly; sizes from 1e-150 to 1e150. Time
/// linear in the number of points; memory beside the result under 250 bytes a point.
/// Accuracy: the residual is at most 2048 ε, usually a few ε.
/// Faults: too_few; not_finite (index of the point); outside_domain (index of a point equal to the
/// one before it; or of a point so close to it that its chord-length knot does not advance);
/// no_convergence (index of the worst span; seen only on data contrived for it); those of
/// Path::create where coordinates near the ends of the range overflow.
Result<PlanarSpline> planar_spline(std::span<const Vector2<double>> points,
                                   const PlanarSplineOptions& options = {});

/// The same without the path: all the work of solving, none of building the path's tables.
Result<PlanarSplinePreimage> planar_spline_preimage(std::span<const Vector2<double>> points,
                                                    const PlanarSplineOptions& options = {});

}  // namespace hodograph
