// SPDX-License-Identifier: MIT
// Rational PH curves in floating point: points, rational Bézier curves, paths. Every number is the
// exact one rounded; only the square roots of a speed that is no square are computed.
#pragma once

#include <vector>

#include "hodograph/bernstein/rational_curve.hpp"
#include "hodograph/path/any_path.hpp"
#include "hodograph/rational/rational_ph_curve.hpp"

namespace hodograph {

/// r(t): the exact value at the double t, each coordinate rounded once.
/// Faults: not_finite (t), outside_domain (a pole at t; a value beyond the range of doubles, which
/// the functions below refuse as well).
Result<Vector3<double>> position(const RationalPhCurve& curve, double t);

/// The curve over [begin, end] as rational Bézier curves with positive weights, the largest of
/// each 1, which follow each other: one where the Bernstein coefficients of the denominator have
/// one sign, else the interval is halved. Control points and weights are exact, rounded once.
/// Faults: not_finite; not_increasing (begin ≥ end); outside_domain (a pole in [begin, end], with
/// its place); unsupported (a pole so close that more than 2^10 pieces would be needed).
Result<std::vector<SpatialRationalBezier>> rational_bezier(const RationalPhCurve& curve,
                                                           double begin, double end);

/// A polynomial curve over [begin, end] as a path of one segment with parameter ξ = t: its preimage
/// P, of degree deg A + deg λ / 2, satisfies P i P* = λ A i A*. With λ = c q² s, s monic and
/// square-free: P = √|c| q A G K with |G|² = s, G in ℂ[t], and K = 1 for c > 0, k for c < 0 (the
/// curve then runs against A i A*).
/// Accuracy: coefficients of q A are exact, rounded once; for s = 1 the preimage has a few
/// roundings; G has the accuracy of the roots of s in double.
/// Faults: not_finite; not_increasing; outside_domain (a point, whose speed is 0; a curve with
/// poles; λ with a zero of odd multiplicity, where the curve turns back: no polynomial is its
/// preimage, wherever that zero lies), unsupported (a preimage of degree above
/// maximum_dynamic_degree), no_convergence (the roots of s).
Result<PathNumbers> path_numbers(const RationalPhCurve& curve, double begin, double end);

}  // namespace hodograph
