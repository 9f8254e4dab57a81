// SPDX-License-Identifier: MIT
// A periodic orbit as a curve: position and four derivatives anywhere, from the equations of
// motion.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "hodograph/foundation/result.hpp"
#include "hodograph/orbit/periodic_orbit.hpp"
#include "hodograph/orbit/reference_frame.hpp"

namespace hodograph {

/// The frame a curve is drawn in.
enum class OrbitFrame {
  rotating,                ///< barycentric, primaries at rest; the orbit is closed
  earth_centred_inertial,  ///< see reference_frame.hpp; in general not closed
};

/// What the curve's parameter ξ is.
enum class OrbitParameter {
  time,         ///< TU since the initial state
  revolutions,  ///< time / period
};

/// A periodic orbit, parametrised over any number of revolutions. It holds Taylor series of the
/// motion, computed once in long double over half a period; the other half is their mirror image.
/// Evaluating is summing one polynomial. Cheap to copy (copies share the series), immutable, safe
/// to use from several threads at once.
class OrbitCurve {
 public:
  /// A curve over `revolutions` ≥ 1 of the orbit.
  /// Faults: those of propagate for the initial state; outside_domain (period or number of
  /// revolutions); not_continuous (an initial state that is not a perpendicular crossing of y = 0,
  /// or that does not cross it perpendicularly half a period later).
  static Result<OrbitCurve> make(const PeriodicOrbit& orbit,
                                 OrbitFrame frame = OrbitFrame::rotating,
                                 OrbitParameter parameter = OrbitParameter::time,
                                 std::size_t revolutions = 1);

  /// Position (LU) and its first four derivatives with respect to ξ. Any finite ξ is allowed, for
  /// the orbit is periodic. Error: within a few ulps of the motion through the orbit's own initial
  /// state, for each derivative relative to its largest value near by; smooth to that accuracy
  /// where series meet.
  std::array<Vector3<double>, 5> operator()(double xi) const;

  /// ξ runs from 0 to this: revolutions, or revolutions · period.
  double end() const { return end_; }
  std::size_t revolutions() const { return revolutions_; }
  OrbitFrame frame() const { return frame_; }
  OrbitParameter parameter() const { return parameter_; }
  const PeriodicOrbit& orbit() const;
  /// How many series half a revolution took.
  std::size_t series_count() const;

 private:
  struct Series;
  OrbitCurve() = default;

  std::shared_ptr<const Series> series_;
  OrbitFrame frame_ = OrbitFrame::rotating;
  OrbitParameter parameter_ = OrbitParameter::time;
  std::size_t revolutions_ = 1;
  double end_ = 0.0;
};

}  // namespace hodograph
