// SPDX-License-Identifier: MIT
#include "hodograph/planning/swarm/timed_motion.hpp"

#include <algorithm>
#include <cmath>

namespace hodograph {

std::optional<Fault> TimedMotion::length_fault(const TimingLaw& law, double path_length) {
  const double allowed = accuracy::join_error<double>() * path_length;
  if (std::abs(law.length() - path_length) <= allowed) return std::nullopt;
  return Fault{FaultCode::outside_domain,
               "the timing law covers a length of " + to_text(law.length()) + "; the path is " +
                   to_text(path_length) + " long",
               std::nullopt,
               "length",
               law.length(),
               path_length};
}

std::optional<Fault> TimedMotion::altitude_fault(double altitude, bool planar) {
  if (std::isfinite(altitude) && (planar || altitude == 0.0)) return std::nullopt;
  const bool finite = std::isfinite(altitude);
  return Fault{finite ? FaultCode::unsupported : FaultCode::outside_domain,
               finite ? "an altitude of " + to_text(altitude) +
                            " is for a path in the plane; this one is in space and has its own"
                      : "an altitude is a finite number; got " + to_text(altitude),
               std::nullopt,
               "altitude",
               altitude,
               std::nullopt};
}

Vector3<double> TimedMotion::position(double t) const {
  const double local = std::clamp(t - law_.start_time(), 0.0, law_.duration());
  const double s = law_.arc_length_within(law_.piece_at(local), local);
  return places_->at(std::min(s, places_->length())).point;
}

double TimedMotion::position_error() const {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  const double times = std::max(std::abs(law_.start_time()), std::abs(law_.end_time()));
  return 2.0 * places_->rounding() + places_->largest_gap() + law_.arc_length_error() +
         accuracy::join_error<double>() * length() + 2.0 * eps * times * law_.most_speed();
}

TimedMotion TimedMotion::delayed(double delay) const {
  return TimedMotion(places_, law_.delayed(delay), presence_);
}

}  // namespace hodograph
