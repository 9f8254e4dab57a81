// SPDX-License-Identifier: MIT
#include "hodograph/orbit/periodic_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "motion_checks.hpp"

namespace hodograph {
namespace {

using motion_checks::text;

/// The initial conditions of a symmetric orbit, in the order (x, z, vy, half the period).
using Unknowns = std::array<long double, 4>;
constexpr std::array<const char*, 4> unknown_names{"x", "z", "vy", "period"};

/// Newton's correction moves no unknown by more than this (LU, LU/TU, TU) at once: a tenth of the
/// primaries' distance, within which a guess can be meant for one orbit and not for another.
constexpr long double largest_correction = 0.1L;

/// A start slower than this (LU/TU) is at rest: its crossing is an equilibrium, not an orbit.
const long double least_speed = std::sqrt(std::numeric_limits<long double>::epsilon());

/// Where no crossing comes within this many turns of the primaries, none is waited for.
constexpr long double longest_half_period = 100.0L;

/// A continuation step moves the four unknowns by at most this (Euclidean), and the correction
/// after it by at most this part of the step: a halved step halves that part, while another family
/// through or near this one stays at its distance.
constexpr long double longest_continuation = 0.1L;
constexpr long double straying = 0.125L;

/// The shortest continuation step, as a part of the whole way.
constexpr long double shortest_continuation = 0x1p-10L;

std::size_t held_index(HeldQuantity held) {
  return held == HeldQuantity::x ? 0 : held == HeldQuantity::z ? 1 : 3;
}

OrbitState<long double> start_of(const Unknowns& u) {
  return {{u[0], 0.0L, u[1]}, {0.0L, u[2], 0.0L}};
}

/// What half a period from a start tells: the residual y, vx, vz and its derivatives with respect
/// to the four unknowns.
struct Crossing {
  std::array<long double, 3> residual{};
  std::array<std::array<long double, 4>, 3> slopes{};
  long double size() const {
    return std::max(std::max(std::abs(residual[0]), std::abs(residual[1])), std::abs(residual[2]));
  }
};

Result<Crossing> cross(const ThreeBodySystem& system, const Unknowns& u,
                       const PropagationOptions& options) {
  const auto half = propagate_variations(system, start_of(u), u[3], options);
  if (!half) return half.fault();
  const OrbitState<long double>& state = half->motion.state;
  const Vector3<long double> acceleration = three_body_acceleration(system, state);
  const TransitionMatrix& phi = half->transition;
  constexpr std::array<std::size_t, 3> rows{1, 3, 5}, columns{0, 2, 4};
  Crossing result;
  result.residual = {state.position.y, state.velocity.x, state.velocity.z};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result.slopes[i][j] = phi[rows[i]][columns[j]];
  }
  result.slopes[0][3] = state.velocity.y;
  result.slopes[1][3] = acceleration.x;
  result.slopes[2][3] = acceleration.z;
  return result;
}

/// Solves the three equations Σ_{j ≠ held} slopes[i][j] d[j] = right[i]; d[held] is 0. Gaussian
/// elimination with row exchange; nothing where a pivot vanishes.
std::optional<Unknowns> solve(const Crossing& crossing, const std::array<long double, 3>& right,
                              std::size_t held) {
  std::array<std::size_t, 3> columns{};
  for (std::size_t j = 0, n = 0; j < 4; ++j) {
    if (j != held) columns[n++] = j;
  }
  std::array<std::array<long double, 4>, 3> m{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = crossing.slopes[i][columns[j]];
    m[i][3] = right[i];
  }
  for (std::size_t p = 0; p < 3; ++p) {
    std::size_t largest = p;
    for (std::size_t i = p + 1; i < 3; ++i) {
      if (std::abs(m[i][p]) > std::abs(m[largest][p])) largest = i;
    }
    std::swap(m[p], m[largest]);
    if (m[p][p] == 0.0L) return std::nullopt;
    for (std::size_t i = p + 1; i < 3; ++i) {
      const long double factor = m[i][p] / m[p][p];
      for (std::size_t j = p; j < 4; ++j) m[i][j] -= factor * m[p][j];
    }
  }
  Unknowns d{};
  for (std::size_t p = 3; p-- > 0;) {
    long double sum = m[p][3];
    for (std::size_t j = p + 1; j < 3; ++j) sum -= m[p][j] * d[columns[j]];
    d[columns[p]] = sum / m[p][p];
    if (!is_finite(d[columns[p]])) return std::nullopt;
  }
  return d;
}

std::optional<Fault> check_iterate(const Unknowns& u) {
  if (!(u[3] > 0.0L)) {
    return Fault{FaultCode::outside_domain,
                 "the period is " + text(2.0L * u[3]) + "; it must be positive",
                 {},
                 "period",
                 static_cast<double>(2.0L * u[3]),
                 0.0};
  }
  if (std::abs(u[2]) < least_speed) {
    return Fault{FaultCode::zero_speed,
                 "the velocity at the crossing of y = 0 is " + text(u[2]) +
                     "; a periodic orbit must leave the plane, with a speed of at least " +
                     text(least_speed),
                 {},
                 "vy",
                 static_cast<double>(u[2]),
                 static_cast<double>(least_speed)};
  }
  return std::nullopt;
}

Fault no_orbit(const std::string& why, std::size_t iterations, long double residual) {
  return {FaultCode::no_convergence,
          "no periodic orbit found from this guess: " + why + " after " +
              std::to_string(iterations) + " corrections, with a residual of " + text(residual) +
              " at the half period; a closer guess is needed",
          {},
          "residual",
          static_cast<double>(residual),
          static_cast<double>(crossing_tolerance)};
}

/// The indices ν from the traces: with s = λ + 1/λ of the two pairs beside the pair 1, 1,
/// s₁ + s₂ = tr M - 2 and s₁² + s₂² = tr M² + 2.
std::array<std::complex<double>, 2> stability_indices(const TransitionMatrix& m) {
  long double trace = 0.0L, trace_of_square = 0.0L;
  for (std::size_t i = 0; i < 6; ++i) {
    trace += m[i][i];
    for (std::size_t j = 0; j < 6; ++j) trace_of_square += m[i][j] * m[j][i];
  }
  const long double sum = trace - 2.0L;
  const long double discriminant = 2.0L * (trace_of_square + 2.0L) - sum * sum;  // (s₁ - s₂)²
  const long double root = std::sqrt(std::abs(discriminant));
  const auto half_of = [](long double re, long double im) {
    return std::complex<double>(static_cast<double>(re / 4.0L), static_cast<double>(im / 4.0L));
  };
  std::array<std::complex<double>, 2> nu{half_of(sum + root, 0.0L), half_of(sum - root, 0.0L)};
  if (discriminant < 0.0L) nu = {half_of(sum, root), half_of(sum, -root)};
  if (std::abs(nu[0]) < std::abs(nu[1])) std::swap(nu[0], nu[1]);
  return nu;
}

/// The orbit of a corrected start, with what one more revolution tells about it.
Result<PeriodicOrbit> complete(const ThreeBodySystem& system, const Unknowns& u,
                               long double residual, std::size_t iterations,
                               const PropagationOptions& options) {
  PeriodicOrbit orbit;
  orbit.system = system;
  orbit.initial = start_of(u);
  orbit.period = 2.0L * u[3];
  orbit.crossing_residual = residual;
  orbit.iterations = iterations;
  orbit.jacobi = jacobi_constant(system, orbit.initial);
  const auto turn = propagate_variations(system, orbit.initial, orbit.period, options);
  if (!turn) return turn.fault();
  const OrbitState<long double>& last = turn->motion.state;
  orbit.closure = std::max(largest_component(last.position - orbit.initial.position),
                           largest_component(last.velocity - orbit.initial.velocity));
  orbit.closest_approach_larger = turn->motion.closest_approach_larger;
  orbit.closest_approach_smaller = turn->motion.closest_approach_smaller;
  orbit.monodromy = turn->transition;
  orbit.stability_indices = stability_indices(orbit.monodromy);
  return orbit;
}

Result<PeriodicOrbit> correct(const ThreeBodySystem& system, Unknowns u, HeldQuantity held,
                              const CorrectionOptions& options) {
  Unknowns best = u;
  long double best_size = std::numeric_limits<long double>::infinity();
  for (std::size_t iteration = 0;; ++iteration) {
    if (auto fault = check_iterate(u)) return std::move(*fault);
    const auto crossing = cross(system, u, options.propagation);
    if (!crossing) return crossing.fault();
    const long double size = crossing->size();
    const bool is_settled = best_size <= crossing_tolerance && !(size < 0.5L * best_size);
    if (size < best_size) {
      best = u;
      best_size = size;
    }
    if (is_settled || best_size == 0.0L) {
      return complete(system, best, best_size, iteration, options.propagation);
    }
    if (iteration == options.max_iterations) {
      return no_orbit("the correction did not settle", iteration, best_size);
    }
    auto step = solve(*crossing, crossing->residual, held_index(held));
    if (!step) return no_orbit("the equations became singular", iteration, best_size);
    long double largest = 0.0L;
    for (const long double d : *step) largest = std::max(largest, std::abs(d));
    const long double scale = largest > largest_correction ? largest_correction / largest : 1.0L;
    for (std::size_t j = 0; j < 4; ++j) u[j] -= scale * (*step)[j];
  }
}

long double distance(const Unknowns& a, const Unknowns& b) {
  long double sum = 0.0L;
  for (std::size_t j = 0; j < 4; ++j) sum += (a[j] - b[j]) * (a[j] - b[j]);
  return std::sqrt(sum);
}

Unknowns unknowns_of(const PeriodicOrbit& orbit) {
  return {orbit.initial.position.x, orbit.initial.position.z, orbit.initial.velocity.y,
          0.5L * orbit.period};
}

}  // namespace

Result<PeriodicOrbit> correct_symmetric_orbit(const ThreeBodySystem& system,
                                              const SymmetricGuess& guess, HeldQuantity held,
                                              const CorrectionOptions& options) {
  Unknowns u{guess.x, guess.z, guess.vy, guess.period ? 0.5L * *guess.period : 0.0L};
  for (std::size_t j = 0; j < 4; ++j) {
    if (is_finite(u[j])) continue;
    return Fault{FaultCode::not_finite,
                 std::string("the guess's ") + unknown_names[j] + " is " + text(u[j]) +
                     "; it must be finite",
                 j,
                 unknown_names[j],
                 static_cast<double>(u[j]),
                 {}};
  }
  if (!guess.period) {
    if (held == HeldQuantity::period) {
      return Fault{FaultCode::too_few,
                   "the period is to be held, but the guess has none; state it",
                   {},
                   "period",
                   {},
                   {}};
    }
    const auto crossing =
        next_plane_crossing(system, start_of(u), longest_half_period, options.propagation);
    if (!crossing) return crossing.fault();
    u[3] = *crossing;
  }
  return correct(system, u, held, options);
}

Result<PeriodicOrbit> continue_to_period(const PeriodicOrbit& start, long double period,
                                         const CorrectionOptions& options) {
  if (!(period > 0.0L) || !is_finite(period)) {
    return Fault{FaultCode::outside_domain,
                 "the period asked for is " + text(period) + "; it must be positive and finite",
                 {},
                 "period",
                 static_cast<double>(period),
                 0.0};
  }
  PeriodicOrbit orbit = start;
  const long double way = 0.5L * (period - start.period);
  long double part = 1.0L, done = 0.0L;
  while (done < 1.0L) {
    const Unknowns here = unknowns_of(orbit);
    const auto crossing = cross(start.system, here, options.propagation);
    if (!crossing) return crossing.fault();
    // Along the family slopes · d = 0: solve for d with the half period's share given.
    std::array<long double, 3> right{};
    for (std::size_t i = 0; i < 3; ++i) right[i] = -crossing->slopes[i][3];
    const auto tangent = solve(*crossing, right, held_index(HeldQuantity::period));
    if (!tangent) return no_orbit("the family turns back", orbit.iterations, crossing->size());
    const long double next = std::min(1.0L, done + part);
    Unknowns predicted = here;
    predicted[3] = 0.5L * start.period + next * way;
    for (std::size_t j = 0; j < 3; ++j) predicted[j] += (predicted[3] - here[3]) * (*tangent)[j];
    const long double length = distance(predicted, here);
    if (length <= longest_continuation) {
      const auto corrected = correct(start.system, predicted, HeldQuantity::period, options);
      // Where the period asked for is the one at hand there is no step to stray from.
      if (corrected && (distance(unknowns_of(*corrected), predicted) <= straying * length ||
                        predicted[3] == here[3])) {
        orbit = *corrected;
        done = next;
        part *= 2.0L;
        continue;
      }
    }
    part *= 0.5L;
    if (part < shortest_continuation) {
      return Fault{FaultCode::no_convergence,
                   "the family could be followed from period " + text(start.period) + " to " +
                       text(orbit.period) + " only, not to " + text(period) +
                       "; it turns back or branches there",
                   {},
                   "period",
                   static_cast<double>(orbit.period),
                   static_cast<double>(period)};
    }
  }
  return orbit;
}

Result<PeriodicOrbit> lunar_gateway_nrho() {
  const SymmetricGuess catalogue{1.02731322944525L, -0.18551533506611556L, -0.114498861101236L,
                                 1.58092382295613L};
  return correct_symmetric_orbit(earth_moon_system, catalogue, HeldQuantity::z);
}

Result<PeriodicOrbit> synodic_9_2_nrho() {
  const auto start = lunar_gateway_nrho();
  if (!start) return start.fault();
  constexpr long double seconds_per_day = 86400.0L;
  const long double period = static_cast<long double>(mean_synodic_month_days) * 2.0L / 9.0L *
                             seconds_per_day /
                             static_cast<long double>(earth_moon_system.time_unit_s);
  return continue_to_period(*start, period);
}

}  // namespace hodograph
