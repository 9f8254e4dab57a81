// SPDX-License-Identifier: MIT
// Periodic orbits symmetric about the plane y = 0 (halo orbits), by differential correction.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <limits>
#include <optional>

#include "hodograph/orbit/propagation.hpp"

namespace hodograph {

/// A start on the plane y = 0, perpendicular to it: position (x, 0, z), velocity (0, vy, 0).
struct SymmetricGuess {
  long double x{}, z{};                 ///< LU
  long double vy{};                     ///< LU/TU
  std::optional<long double> period{};  ///< TU; found from the next crossing where not given
};

/// Which of the four numbers of a guess the correction leaves alone.
enum class HeldQuantity {
  x,       ///< the distance along the line of primaries
  z,       ///< the height above their plane (choose this for a catalogue orbit)
  period,  ///< the period (choose this for a resonance)
};

/// A periodic orbit that crosses y = 0 perpendicularly at its start and half a period later, and so
/// obeys r(-t) = diag(1, -1, 1) r(t).
struct PeriodicOrbit {
  ThreeBodySystem system;
  OrbitState<long double> initial;  ///< y, vx and vz are exactly 0
  long double period{};             ///< TU
  long double crossing_residual{};  ///< largest of |y|, |vx|, |vz| at half the period
  long double closure{};            ///< largest component of state(period) - state(0)
  long double jacobi{};             ///< the Jacobi constant of the initial state
  long double closest_approach_larger{}, closest_approach_smaller{};  ///< LU, over the orbit
  std::size_t iterations = 0;    ///< of the correction that found it
  TransitionMatrix monodromy{};  ///< the transition matrix over one period
  /// ν = (λ + 1/λ)/2 for the two non-trivial pairs of eigenvalues λ, 1/λ of the monodromy
  /// matrix, the larger modulus first: the orbit is linearly stable when both are real in [-1, 1].
  std::array<std::complex<double>, 2> stability_indices{};
};

/// A crossing counts as perpendicular when |y|, |vx| and |vz| are at most this (LU, LU/TU): some
/// 10³ steps with local errors of 16 epsilon each, grown by up to 2⁶ over half a period.
inline constexpr long double crossing_tolerance =
    0x1p20L * std::numeric_limits<long double>::epsilon();

/// Newton steps of one correction; from a guess with three right digits about six are taken.
inline constexpr std::size_t default_max_corrections = 30;

/// How an orbit is corrected.
struct CorrectionOptions {
  std::size_t max_iterations = default_max_corrections;
  PropagationOptions propagation{};
};

/// The periodic orbit nearest to a guess, by Newton's method on y = vx = vz = 0 at half the period,
/// with `held` kept and the other three numbers of the guess corrected. The derivatives are the
/// transition matrix's; iterates until rounding stops the decrease of the residual.
/// Faults: those of propagate; not_finite; outside_domain (a period that is not positive);
/// zero_speed (a guess or an iterate at rest); no_convergence (the residual reached is in the
/// sentence), also where the equations become singular.
Result<PeriodicOrbit> correct_symmetric_orbit(const ThreeBodySystem& system,
                                              const SymmetricGuess& guess, HeldQuantity held,
                                              const CorrectionOptions& options = {});

/// The member with the given period (TU) of the family that `start` belongs to, by continuation:
/// a step along the family's tangent, a correction with the period held, a shorter step where the
/// correction fails or strays from the tangent by more than an eighth of the step. Cannot pass a
/// member whose period is stationary along the family (no_convergence; the sentence says how far it
/// got). Other faults as the correction's.
Result<PeriodicOrbit> continue_to_period(const PeriodicOrbit& start, long double period,
                                         const CorrectionOptions& options = {});

/// The southern L2 near-rectilinear halo orbit of the PHODCOS paper, section 6 (period 7.008 d):
/// the member with apolune height -0.18551533506611556 LU in the JPL three-body periodic orbit
/// catalogue, Earth-Moon system, corrected with that height held.
Result<PeriodicOrbit> lunar_gateway_nrho();

/// Nine revolutions in two synodic months: period 2/9 · 29.530588861 d = 6.562 d.
inline constexpr double mean_synodic_month_days = 29.530588861;

/// The southern L2 near-rectilinear halo orbit in 9:2 resonance with the synodic month, reached by
/// continuation from lunar_gateway_nrho().
Result<PeriodicOrbit> synodic_9_2_nrho();

}  // namespace hodograph
