// SPDX-License-Identifier: MIT
// Fitting samples: the path through the C⁴ data of their interpolating spline, its error against
// that spline certified.
#pragma once

#include <cstddef>

#include "hodograph/construction/fit.hpp"
#include "hodograph/construction/interpolating_spline.hpp"
#include "hodograph/foundation/result.hpp"

namespace hodograph {

/// The certified error of one segment against a spline over [xi_begin, xi_end] inside the spline's
/// interval, piece by piece (see piece_error).
template <std::size_t p>
ErrorBound spline_error(const InterpolatingSpline<p>& spline, const SpatialPhCurve<8>& segment,
                        double xi_begin, double xi_end);

/// The path that stays within options.tolerance of a spline over its whole interval; closed when
/// the spline is periodic. The error is certified against the spline, which meets the samples to
/// rounding. Faults: those of fit.
template <std::size_t p>
Result<Fit> fit(const InterpolatingSpline<p>& spline, FitOptions options);

}  // namespace hodograph
