// SPDX-License-Identifier: MIT
#include "hodograph/orbit/propagation.hpp"

#include <algorithm>
#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/algebra/default_operations.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <utility>

#include "motion_checks.hpp"
#include "series_step.hpp"

namespace hodograph {
namespace {

using motion_checks::Primary;

constexpr std::size_t state_size = 6;
constexpr std::size_t variational_size = state_size + state_size * state_size;

template <std::size_t N>
using Coordinates = std::array<long double, N>;

template <std::size_t N>
OrbitState<long double> state_of(const Coordinates<N>& c) {
  return {{c[0], c[1], c[2]}, {c[3], c[4], c[5]}};
}

/// The vector field; for N = 42 with the transition matrix, row by row, behind the state.
template <std::size_t N>
void field(const ThreeBodySystem& system, const Coordinates<N>& c, Coordinates<N>& rate) {
  const OrbitState<long double> state = state_of(c);
  const Vector3<long double> a = three_body_acceleration(system, state);
  rate[0] = c[3], rate[1] = c[4], rate[2] = c[5];
  rate[3] = a.x, rate[4] = a.y, rate[5] = a.z;
  if constexpr (N == variational_size) {
    const auto hessian = pseudo_potential_hessian(system, state.position);
    for (std::size_t column = 0; column < state_size; ++column) {
      const auto entry = [&](std::size_t row) -> const long double& {
        return c[state_size * (row + 1) + column];
      };
      const auto slope = [&](std::size_t row) -> long double& {
        return rate[state_size * (row + 1) + column];
      };
      for (std::size_t i = 0; i < 3; ++i) {
        slope(i) = entry(i + 3);
        slope(i + 3) = hessian[i].x * entry(0) + hessian[i].y * entry(1) + hessian[i].z * entry(2);
      }
      slope(3) += 2.0L * entry(4);
      slope(4) -= 2.0L * entry(3);
    }
  }
}

/// The smallest distance from a primary during a step, from the offsets and velocities at its ends.
long double closest_in_step(const Vector3<long double>& d0, const Vector3<long double>& v0,
                            const Vector3<long double>& d1, const Vector3<long double>& v1,
                            long double step) {
  const long double at_ends = std::min(norm(d0), norm(d1));
  if (!(dot(d0, v0) * step < 0.0L && dot(d1, v1) * step > 0.0L)) return at_ends;
  // d(u) = d0 + u m0 + u² a + u³ b, the cubic with these ends; bisect the sign of d · d'.
  const Vector3<long double> m0 = step * v0, m1 = step * v1, chord = d1 - d0;
  const Vector3<long double> a = 3.0L * chord - 2.0L * m0 - m1, b = m0 + m1 - 2.0L * chord;
  const auto offset = [&](long double u) { return d0 + u * (m0 + u * (a + u * b)); };
  long double lower = 0.0L, upper = 1.0L;
  for (int i = 0; i < std::numeric_limits<double>::digits; ++i) {
    const long double u = 0.5L * (lower + upper);
    (dot(offset(u), m0 + u * (2.0L * a + (3.0L * u) * b)) < 0.0L ? lower : upper) = u;
  }
  return std::min(at_ends, norm(offset(lower)));
}

/// Follows the motion in `c` for `duration`; both kinds of propagation.
template <std::size_t N>
Result<Propagation> follow(const ThreeBodySystem& system, Coordinates<N>& c, long double duration,
                           const PropagationOptions& options) {
  namespace odeint = boost::numeric::odeint;
  using Stepper =
      odeint::runge_kutta_fehlberg78<Coordinates<N>, long double, Coordinates<N>, long double,
                                     odeint::array_algebra, odeint::default_operations>;
  if (auto fault = motion_checks::check_start(system, state_of(c), options)) {
    return std::move(*fault);
  }
  if (!is_finite(duration)) {
    return Fault{FaultCode::not_finite,
                 "the duration is " + motion_checks::text(duration) + "; it must be finite",
                 {},
                 "duration",
                 static_cast<double>(duration),
                 {}};
  }
  auto stepper = odeint::make_controlled<Stepper>(options.step_tolerance, options.step_tolerance);
  const auto rate = [&system](const Coordinates<N>& x, Coordinates<N>& dxdt, long double) {
    field(system, x, dxdt);
  };

  Propagation result;
  OrbitState<long double> before = state_of(c);
  result.closest_approach_larger = norm(offset_from_larger(system, before.position));
  result.closest_approach_smaller = norm(offset_from_smaller(system, before.position));
  // Start with a fraction of the time the nearer primary's distance gives; the control does the
  // rest.
  const long double nearest =
      std::min(result.closest_approach_larger, result.closest_approach_smaller);
  const long double first =
      series_fraction * nearest / (1.0L + norm(before.velocity) + 1.0L / std::sqrt(nearest));
  long double time = 0.0L, step = std::copysign(first, duration);

  while (time != duration) {
    if (result.steps == options.max_steps) {
      return motion_checks::too_many_steps(time, duration, options);
    }
    ++result.steps;
    // The last step ends exactly at the duration.
    const long double left = duration - time;
    const bool is_last = std::abs(step) >= std::abs(left);
    if (is_last) step = left;
    const long double start_time = time, tried = step;
    if (start_time + tried == start_time) return motion_checks::stalled(time, duration);
    if (stepper.try_step(rate, c, time, step) != odeint::success) continue;
    if (is_last) time = duration;
    for (const long double x : c) {
      if (!is_finite(x)) return motion_checks::stalled(start_time, duration);
    }
    const OrbitState<long double> after = state_of(c);
    const long double larger =
        closest_in_step(offset_from_larger(system, before.position), before.velocity,
                        offset_from_larger(system, after.position), after.velocity, tried);
    const long double smaller =
        closest_in_step(offset_from_smaller(system, before.position), before.velocity,
                        offset_from_smaller(system, after.position), after.velocity, tried);
    if (auto fault = motion_checks::check_distance(Primary::larger, larger, time, options)) {
      return std::move(*fault);
    }
    if (auto fault = motion_checks::check_distance(Primary::smaller, smaller, time, options)) {
      return std::move(*fault);
    }
    result.closest_approach_larger = std::min(result.closest_approach_larger, larger);
    result.closest_approach_smaller = std::min(result.closest_approach_smaller, smaller);
    before = after;
  }
  result.state = before;
  return result;
}

template <std::size_t N>
Coordinates<N> coordinates_of(const OrbitState<long double>& s) {
  Coordinates<N> c{};
  for (std::size_t i = 0; i < 3; ++i) {
    c[i] = s.position[i];
    c[i + 3] = s.velocity[i];
  }
  return c;
}

}  // namespace

Result<Propagation> propagate(const ThreeBodySystem& system, const OrbitState<long double>& start,
                              long double duration, const PropagationOptions& options) {
  Coordinates<state_size> c = coordinates_of<state_size>(start);
  return follow(system, c, duration, options);
}

Result<VariationalPropagation> propagate_variations(const ThreeBodySystem& system,
                                                    const OrbitState<long double>& start,
                                                    long double duration,
                                                    const PropagationOptions& options) {
  Coordinates<variational_size> c = coordinates_of<variational_size>(start);
  for (std::size_t i = 0; i < state_size; ++i) c[state_size * (i + 1) + i] = 1.0L;
  Result<Propagation> motion = follow(system, c, duration, options);
  if (!motion) return motion.fault();
  VariationalPropagation result{*motion, {}};
  for (std::size_t i = 0; i < state_size; ++i) {
    for (std::size_t j = 0; j < state_size; ++j) {
      result.transition[i][j] = c[state_size * (i + 1) + j];
    }
  }
  return result;
}

Result<long double> next_plane_crossing(const ThreeBodySystem& system,
                                        const OrbitState<long double>& start, long double limit,
                                        const PropagationOptions& options) {
  if (auto fault = motion_checks::check_start(system, start, options)) return std::move(*fault);
  if (!(limit > 0.0L) || !is_finite(limit)) {
    return Fault{
        FaultCode::outside_domain,
        "the time limit is " + motion_checks::text(limit) + "; it must be positive and finite",
        {},
        "limit",
        static_cast<double>(limit),
        0.0};
  }
  OrbitState<long double> state = start;
  // The side of the plane the motion is on; at a start on the plane, the one it goes to.
  const auto side_of = [](long double y) { return y > 0.0L ? 1 : y < 0.0L ? -1 : 0; };
  int side = start.position.y != 0.0L ? side_of(start.position.y) : side_of(start.velocity.y);
  long double time = 0.0L;
  for (std::size_t steps = 0; steps < options.max_steps; ++steps) {
    const long double larger = norm(offset_from_larger(system, state.position));
    const long double smaller = norm(offset_from_smaller(system, state.position));
    for (const Primary primary : {Primary::larger, Primary::smaller}) {
      const long double distance = primary == Primary::larger ? larger : smaller;
      if (auto fault = motion_checks::check_distance(primary, distance, time, options)) {
        return std::move(*fault);
      }
    }
    const MotionSeries series = motion_series<series_order>(system, state);
    const long double step = std::min(series_step(series, std::min(larger, smaller)), limit - time);
    if (time + step == time) return motion_checks::stalled(time, limit);
    const OrbitState<long double> after = sum_series(series, step);
    if (!is_finite(after.position) || !is_finite(after.velocity)) {
      return motion_checks::stalled(time, limit);
    }
    if (side != 0 && side_of(after.position.y) != side) {
      long double lower = 0.0L, upper = step;
      for (int i = 0; i < std::numeric_limits<long double>::digits; ++i) {
        const long double middle = 0.5L * (lower + upper);
        const bool is_before = side_of(sum_series(series.y, middle)) == side;
        (is_before ? lower : upper) = middle;
      }
      return time + upper;
    }
    if (side == 0) side = side_of(after.position.y);
    time += step;
    state = after;
    if (time >= limit) {
      return Fault{FaultCode::no_convergence,
                   "the motion does not cross the plane y = 0 within " +
                       motion_checks::text(limit) + " time units; a symmetric orbit must",
                   {},
                   "time",
                   static_cast<double>(time),
                   static_cast<double>(limit)};
    }
  }
  return motion_checks::too_many_steps(time, limit, options);
}

}  // namespace hodograph
