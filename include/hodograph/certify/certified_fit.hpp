// SPDX-License-Identifier: MIT
// Fitting a curve that is a template on its scalar: differentiated for the user, and the error
// certified.
#pragma once

#include "hodograph/certify/certified_error.hpp"
#include "hodograph/construction/fit.hpp"

namespace hodograph {

/// The path that stays within options.tolerance of γ on [xi_begin, xi_end], for
///   template <class S> Vector3<S> operator()(const S& xi) const.
/// The tolerance is met by the certified upper bound of every segment (see segment_error). Faults:
/// those of fit; where γ cannot be shown to be smooth the bound is infinite and the tolerance is
/// not reached.
template <AnalyticCurve F>
Result<Fit> certified_fit(const F& gamma, double xi_begin, double xi_end,
                          const FitOptions& options) {
  return fit(differentiated(gamma), xi_begin, xi_end, options,
             [&gamma](const SpatialPhCurve<8>& segment, double from, double to) {
               return segment_error(gamma, segment, from, to);
             });
}

}  // namespace hodograph
