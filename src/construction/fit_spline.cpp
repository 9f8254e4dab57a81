// SPDX-License-Identifier: MIT
#include "hodograph/construction/fit_spline.hpp"

#include <algorithm>

#include "hodograph/construction/piecewise_error.hpp"

namespace hodograph {

template <std::size_t p>
ErrorBound spline_error(const InterpolatingSpline<p>& spline, const SpatialPhCurve<8>& segment,
                        double xi_begin, double xi_end) {
  const auto& knots = spline.breakpoints();
  const auto after = std::upper_bound(knots.begin() + 1, knots.end() - 1, xi_begin);
  auto j = static_cast<std::size_t>(after - knots.begin()) - 1;
  ErrorBound total{Enclosure(0.0), true, xi_begin};
  for (; j < spline.pieces().size() && knots[j] < xi_end; ++j) {
    total = larger_error(total, piece_error<p, Quaternion<double>, 8>(
                                    spline.pieces()[j], knots[j], knots[j + 1], segment, xi_begin,
                                    std::max(xi_begin, knots[j]), std::min(xi_end, knots[j + 1])));
  }
  return total;
}

template <std::size_t p>
Result<Fit> fit(const InterpolatingSpline<p>& spline, FitOptions options) {
  options.closed = spline.is_periodic();
  const DerivativeCurve gamma = [&spline](double xi) { return spline(xi); };
  return fit(gamma, spline.begin(), spline.end(), options,
             [&spline](const SpatialPhCurve<8>& segment, double from, double to) {
               return spline_error(spline, segment, from, to);
             });
}

template ErrorBound spline_error(const InterpolatingSpline<5>&, const SpatialPhCurve<8>&, double,
                                 double);
template ErrorBound spline_error(const InterpolatingSpline<7>&, const SpatialPhCurve<8>&, double,
                                 double);
template Result<Fit> fit(const InterpolatingSpline<5>&, FitOptions);
template Result<Fit> fit(const InterpolatingSpline<7>&, FitOptions);

}  // namespace hodograph
