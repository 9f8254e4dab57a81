// SPDX-License-Identifier: MIT
// What both ascents from the Moon to its near-rectilinear halo orbit share: where they start, the
// orbit as a path, and how they are solved.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/control/solver.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/orbit/periodic_orbit.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// The Moon's mean radius.
inline constexpr double moon_radius_km = 1737.4;

/// A place on the Moon's surface: the direction from its centre, of length 1.
struct AscentStart {
  std::string name;
  Vector3<double> direction;
};

/// +z (the north pole), -z, +x (the far side), -x, -y, +y.
std::array<AscentStart, 6> ascent_starts();
/// The place with this name. Faults: unsupported (the sentence lists the names).
Result<AscentStart> ascent_start(const std::string& name);

/// How near the orbit's path stays to the orbit by default: 0.4 m.
inline constexpr double default_reference_tolerance = 1e-9;

/// A periodic orbit with its path, ξ in revolutions from 0 to 1, in LU, closed. Cheap to copy.
class AscentReference {
 public:
  /// The path of `orbit` to `tolerance` (LU). Faults: those of OrbitCurve::make and fit.
  static Result<AscentReference> make(const PeriodicOrbit& orbit,
                                      double tolerance = default_reference_tolerance);
  /// The orbit of the PHODCOS paper, lunar_gateway_nrho().
  static Result<AscentReference> gateway();

  const PeriodicOrbit& orbit() const { return parts_->orbit; }
  const SpatialPath<8>& path() const { return parts_->path; }
  /// Seconds a revolution.
  double period_s() const;
  /// The Moon's centre (LU): (1-μ, 0, 0).
  Vector3<double> moon() const;

  /// p, p', p'', p''' with respect to revolutions, LU; any finite number of revolutions. Exact to
  /// rounding; p is C⁴.
  std::array<Vector3<double>, 4> derivatives(double revolutions) const;

 private:
  struct Parts {
    PeriodicOrbit orbit;
    SpatialPath<8> path;
  };
  explicit AscentReference(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}
  std::shared_ptr<const Parts> parts_;
};

/// How an ascent is solved.
struct AscentSolving {
  /// How many initial guesses are tried, at least 1; the answer with the least objective is kept.
  std::size_t guesses = 4;
  std::size_t max_iterations = 300;  ///< for each guess
  double time_limit_s = 0.0;         ///< for each guess; 0: none
  /// Called after every iteration with the number of the guess (from 0); false stops everything.
  std::function<bool(std::size_t guess, const SolverIteration&)> progress{};
  std::vector<SolverSetting> more{};
};

/// How the kept answer was found.
struct AscentSolved {
  double objective{};
  std::size_t guess = 0;       ///< the guess that led to it, from 0
  std::size_t tried = 0;       ///< guesses tried
  std::size_t converged = 0;   ///< of which so many led to a solution
  std::size_t iterations = 0;  ///< of the kept one
  double seconds{};            ///< of the kept one, wall clock
  double constraint_error{};   ///< largest defect or violation, in the problem's units
  std::string status;          ///< the solver's words
};

}  // namespace hodograph
