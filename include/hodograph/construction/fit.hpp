// SPDX-License-Identifier: MIT
// fit(curve, tolerance): a C⁴ spatial PH path, with its frame, that stays within a tolerance of any
// curve (PHODCOS, Algorithm 2, with knots placed where they are needed).
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "hodograph/construction/derivative_curve.hpp"
#include "hodograph/construction/error_bound.hpp"
#include "hodograph/construction/hermite_data.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// Where a fit puts its knots.
enum class FitKnots {
  adaptive,  ///< bisection of the intervals whose error is too large
  uniform,   ///< equal intervals, the fewest that do (by bisection on their number)
};

struct FitOptions {
  /// The largest distance allowed, in the curve's own length; not used when `segments` is given.
  double tolerance = 0.0;
  HermiteChoice choice = HermiteChoice::order_ten;
  FitKnots knots = FitKnots::adaptive;
  /// A fixed number of uniform segments instead of a tolerance; 0: none.
  std::size_t segments = 0;
  /// More segments than this are a Fault.
  std::size_t most_segments = 200000;
  /// The curve returns to its start with its derivatives; the path is then closed exactly.
  bool closed = false;
  /// Called now and then with the number of segments accepted and the fraction of ξ they cover;
  /// returning false stops the fit (Fault cancelled).
  std::function<bool(std::size_t segments, double fraction)> progress{};
};

/// The error of one segment against the curve on [ξ_k, ξ_{k+1}], as a certificate or an estimate.
using ErrorMeasure =
    std::function<ErrorBound(const SpatialPhCurve<8>& segment, double xi_begin, double xi_end)>;

/// A fitted path and what is known of its error.
struct Fit {
  SpatialPath<8> path;
  ErrorBound error;                        ///< over the whole path
  std::vector<ErrorBound> segment_errors;  ///< one a segment
};

/// The path through γ's own C⁴ data at knots between xi_begin and xi_end, whose error by `measure`
/// is at most options.tolerance (its upper end where certified).
///
/// Properties: position C⁴, preimage and frame C³, angular velocity C² across every knot.
/// Faults: outside_domain (interval, tolerance or segments not positive), not_finite (γ at the ξ
/// named), zero_speed (γ' = 0 at the ξ named), not_continuous (closed, but γ is not, to the
/// tolerance), tolerance_not_reached (with the error reached and the place: most_segments, or the
/// rounding of double precision at this size), no_interpolant (fixed segments too long), cancelled.
Result<Fit> fit(const DerivativeCurve& gamma, double xi_begin, double xi_end,
                const FitOptions& options, const ErrorMeasure& measure);

/// The same for a curve about which nothing else is known: the error is an estimate.
Result<Fit> fit(const DerivativeCurve& gamma, double xi_begin, double xi_end,
                const FitOptions& options);

/// The largest |γ - p| seen over a segment at 32 interior parameters, improved by one parabola
/// through the largest three: an estimate, not a bound.
ErrorBound estimated_error(const DerivativeCurve& gamma, const SpatialPhCurve<8>& segment,
                           double xi_begin, double xi_end);

}  // namespace hodograph
