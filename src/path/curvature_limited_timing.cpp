// SPDX-License-Identifier: MIT
#include "hodograph/path/curvature_limited_timing.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "hodograph/foundation/enclosure.hpp"

namespace hodograph {

Result<TimingLaw> curvature_limited_timing(const CurvatureParts& parts, const LateralLimit& limit,
                                           double start_time) {
  const double most = limit.lateral_acceleration;
  if (!(std::isfinite(most) && most > 0.0)) {
    return Fault{std::isfinite(most) ? FaultCode::outside_domain : FaultCode::not_finite,
                 "the lateral acceleration must be positive and finite; got " + to_text(most),
                 std::nullopt,
                 "lateral_acceleration",
                 most,
                 0.0};
  }
  // The limits, neighbours with the same one merged. An acceptable speed is a few roundings below
  // what the bound gives, so that the rounding of the law keeps it.
  constexpr double below = 1.0 - 0x1.0p-48;  // not a tolerance: sixteen roundings
  std::vector<double> arc_lengths{0.0}, speeds;
  for (std::size_t i = 0; i < parts.most_curvature.size(); ++i) {
    const double kappa = parts.most_curvature[i], end = parts.arc_lengths[i + 1];
    if (!(end > parts.arc_lengths[i])) continue;
    double speed = std::numeric_limits<double>::infinity();
    if (kappa > 0.0) speed = below * sqrt(Enclosure(most) / Enclosure(kappa)).lower();
    if (!(kappa < std::numeric_limits<double>::infinity())) {
      return Fault{FaultCode::no_interpolant,
                   "the curvature has no bound between arc lengths " +
                       to_text(parts.arc_lengths[i]) + " and " + to_text(end) +
                       ", where the parametric speed may vanish: no speed keeps the lateral "
                       "acceleration there",
                   i,
                   "curvature",
                   kappa,
                   std::nullopt};
    }
    speed = std::min(speed, limit.along.cruise_speed);
    if (!speeds.empty() && speed == speeds.back()) {
      arc_lengths.back() = end;
    } else {
      speeds.push_back(speed);
      arc_lengths.push_back(end);
    }
  }
  // The slower side of a border reaches beyond it.
  for (std::size_t i = 1; i + 1 < arc_lengths.size(); ++i) {
    const double reach = 2.0 * parts.arc_length_error;
    arc_lengths[i] += speeds[i] < speeds[i - 1] ? -reach : reach;
  }
  // A part shorter than the reach gives way to its slower neighbours.
  std::vector<double> borders{0.0}, kept;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const double end = i + 1 < speeds.size() ? arc_lengths[i + 1] : arc_lengths.back();
    if (end > borders.back()) {
      kept.push_back(speeds[i]);
      borders.push_back(end);
    } else if (!kept.empty()) {
      kept.back() = std::min(kept.back(), speeds[i]);
    }
  }
  return TimingLaw::under_limits(borders, kept, limit.along, start_time);
}

}  // namespace hodograph
