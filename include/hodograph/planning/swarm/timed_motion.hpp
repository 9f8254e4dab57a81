// SPDX-License-Identifier: MIT
// A path flown by a timing law: where a vehicle is at every time.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "hodograph/foundation/result.hpp"
#include "hodograph/path/timing_law.hpp"
#include "hodograph/planning/swarm/detail/path_places.hpp"

namespace hodograph {

class AnyPath;

/// Whether a vehicle stands at its first point before it starts, and at its last after it has
/// arrived; where not, it is absent then.
struct Presence {
  bool before_start = true, after_arrival = true;
};

/// r(s(t)) for a path of the plane (at one altitude z, 0 by default) or of space, of any degree,
/// and a law s(t). A value; copies share the path. What is certified of it holds for the exact path
/// of the stored numbers by its exact arc length (see path/bounds.hpp), and the law as its pieces
/// define it.
class TimedMotion {
 public:
  /// A path of the plane is flown at z = `altitude`, exactly.
  /// Faults: outside_domain (a law of another length than the path's, beyond accuracy::join_error;
  /// both numbers; an altitude that is not finite); unsupported (an altitude with a path of space).
  template <class A, std::size_t n>
  static Result<TimedMotion> create(Path<A, n> path, TimingLaw law, Presence presence = {},
                                    double altitude = 0.0) {
    if (auto fault = length_fault(law, path.arc_length())) return *std::move(fault);
    if (auto fault = altitude_fault(altitude, A::dimension == 2)) return *std::move(fault);
    return TimedMotion(
        std::make_shared<const planning_detail::PlacesOf<A, n>>(std::move(path), altitude),
        std::move(law), presence);
  }
  /// The same for a path whose type is known only when the program runs.
  static Result<TimedMotion> create(const AnyPath& path, TimingLaw law, Presence presence = {},
                                    double altitude = 0.0);

  const TimingLaw& law() const { return law_; }
  const Presence& presence() const { return presence_; }
  bool is_planar() const { return places_->is_planar(); }
  double start_time() const { return law_.start_time(); }
  double end_time() const { return law_.end_time(); }
  double length() const { return places_->length(); }

  /// The point at time t; before the start the first, after the arrival the last.
  Vector3<double> position(double t) const;
  /// Bounds |position(t) - r(s(t))|, rounding of time included.
  double position_error() const;

  /// The same motion, later by `delay`.
  TimedMotion delayed(double delay) const;

  const planning_detail::PathPlaces& places() const { return *places_; }

 private:
  TimedMotion(std::shared_ptr<const planning_detail::PathPlaces> places, TimingLaw law,
              Presence presence)
      : places_(std::move(places)), law_(std::move(law)), presence_(presence) {}
  static std::optional<Fault> length_fault(const TimingLaw& law, double path_length);
  static std::optional<Fault> altitude_fault(double altitude, bool planar);

  std::shared_ptr<const planning_detail::PathPlaces> places_;
  TimingLaw law_;
  Presence presence_;
};

/// One of several that move at once: no other comes closer to it than the sum of both radii and the
/// clearance asked for.
struct Vehicle {
  std::string id;
  TimedMotion motion;
  double radius = 0.0;
};

}  // namespace hodograph
