// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>

#include "hodograph/orbit/orbit_curve.hpp"
#include "powered_model.hpp"

namespace hodograph::ascent_detail {
namespace {

using Real = long double;
using State = std::array<Real, 6>;

/// An interval of constant thrust is followed in this many parts, and in halves of them where the
/// height might be least.
constexpr std::size_t parts = 8;
constexpr int most_halvings = 8;
/// Heights are bounded to this, 10 cm, in 1000 km.
constexpr Real height_resolution = 1e-7L;
/// The local error of a step, relative to the state: far below what is to be measured.
constexpr Real step_tolerance = 4096 * std::numeric_limits<Real>::epsilon();

Real length_of(const State& s, std::size_t first) {
  return std::sqrt(s[first] * s[first] + s[first + 1] * s[first + 1] + s[first + 2] * s[first + 2]);
}

/// A distance from the Moon that the motion from a to b, in the time h under the thrust u, keeps.
///
/// With the acceleration a(t), |r|'' = (|v|² - |r|'²)/|r| + r̂·a is at least m = min over both ends
/// of r̂·a, less L h/2, where L bounds |d/dt (r̂·a)| ≤ |a| |v|/|r| + |da/dt|; so |r| keeps above the
/// parabola with its distance and rate at either end, up to the middle. L follows from bounds of
/// |r|, |v| and |a|: from assuming that |a| is at most 3/2 of what it is at the ends, which is then
/// seen to hold. Gravity is μ/|r|² of the Moon, and what the Earth and the turning of the frame
/// add: zero at the Moon's centre (but for the Coriolis part 2 n |v|), with a gradient below 4 n²
/// within a tenth of the primaries' distance. Zero (nothing is known) where the assumption fails.
Real distance_kept(const PoweredModel& model, const State& a, const State& b, Real h,
                   const std::array<Real, 3>& u) {
  const auto radial = [&](const State& s) {
    const State slope = model.motion<Real>(s, u);
    return (s[0] * slope[3] + s[1] * slope[4] + s[2] * slope[5]) / length_of(s, 0);
  };
  const Real length = static_cast<Real>(model.units.length);
  const Real turning = 1 / static_cast<Real>(model.units.time);  // n
  const Real mass = static_cast<Real>(model.reference.orbit().system.mass_ratio) * length * length *
                    length * turning * turning;
  const Real thrust = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  const Real others = 4 * turning * turning;  // the gradient of Earth and turning
  const auto most_acceleration = [&](Real low, Real high, Real speed) {
    return thrust + mass / (low * low) + others * high + 2 * turning * speed;
  };
  const Real ra = length_of(a, 0), rb = length_of(b, 0);
  const Real fastest = std::max(length_of(a, 3), length_of(b, 3));
  const Real most = 1.5L * most_acceleration(std::min(ra, rb), std::max(ra, rb), fastest);
  const Real speed = fastest + most * h / 2;
  const Real low = std::min(ra, rb) - speed * h / 2, high = std::max(ra, rb) + speed * h / 2;
  if (!(low > 0) || high > length / 10) return 0;
  if (!(most_acceleration(low, high, speed) <= most)) return 0;
  const Real gradient = 2 * mass / (low * low * low) + others;
  const Real change = most * speed / low + gradient * speed + 2 * turning * most;
  const Real m = std::min(radial(a), radial(b)) - change * h / 2;
  // The least of r + rate t + m t²/2 on [0, h/2].
  const auto least = [&](Real r, Real rate) {
    const Real end = r + h / 2 * (rate + m * h / 4);
    Real lowest = std::min(r, end);
    if (m > 0 && rate < 0 && -rate < m * h / 2) lowest = r - rate * rate / (2 * m);
    return lowest;
  };
  const auto rate = [](const State& s, Real r) {
    return (s[0] * s[3] + s[1] * s[4] + s[2] * s[5]) / r;
  };
  return std::min(least(ra, rate(a, ra)), least(rb, -rate(b, rb)));
}

double difference(const State& a, const std::array<double, 6>& b, std::size_t first) {
  Real sum = 0;
  for (std::size_t i = first; i < first + 3; ++i) {
    sum += (a[i] - static_cast<Real>(b[i])) * (a[i] - static_cast<Real>(b[i]));
  }
  return static_cast<double>(std::sqrt(sum));
}

}  // namespace

Repropagation followed_again(const PoweredModel& model, const PoweredAscent& answer) {
  namespace odeint = boost::numeric::odeint;
  const std::size_t count = answer.thrust.size();
  State x{};
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = static_cast<Real>(answer.position.front()[i]) / 1000;
    x[3 + i] = static_cast<Real>(answer.velocity.front()[i]);
  }
  Repropagation result;
  const Real h = static_cast<Real>(answer.duration_s) / 1000 / static_cast<Real>(count * parts);
  Real least = length_of(x, 0), least_later = std::numeric_limits<Real>::infinity();
  for (std::size_t k = 0; k < count; ++k) {
    const std::array<Real, 3> u{static_cast<Real>(answer.thrust[k].x),
                                static_cast<Real>(answer.thrust[k].y),
                                static_cast<Real>(answer.thrust[k].z)};
    const auto slope = [&](const State& at, State& result_slope, Real) {
      result_slope = model.motion<Real>(at, u);
    };
    // The lowest place seen so far, here or (from the second interval on) later than the start.
    Real seen = std::min(length_of(x, 0), k > 0 ? least_later : least);
    Real kept = std::numeric_limits<Real>::infinity();
    const auto follow = [&](const auto& self, Real time, int halvings) -> void {
      const State before = x;
      static const odeint::runge_kutta_fehlberg78<State, Real> blank;  // static: copied with zeros
      auto stepper = odeint::make_controlled(step_tolerance, step_tolerance, blank);
      result.steps += odeint::integrate_adaptive(stepper, slope, x, Real(0), time, time);
      const Real here = distance_kept(model, before, x, time, u);
      seen = std::min(seen, length_of(x, 0));
      if (here < seen - height_resolution && halvings > 0) {
        x = before;
        self(self, time / 2, halvings - 1);
        self(self, time / 2, halvings - 1);
        return;
      }
      kept = std::min(kept, here);
    };
    for (std::size_t part = 0; part < parts; ++part) follow(follow, h, most_halvings);
    least = std::min(least, kept);
    if (k > 0) least_later = std::min(least_later, kept);
  }
  const auto height = [&](Real distance) {
    return static_cast<double>(1000 * distance - static_cast<Real>(answer.options.surface_km));
  };
  result.lowest_height_km = height(least);
  result.lowest_later_height_km = height(least_later);

  const Vector3<double> r = 0.001 * answer.position.back(), v = answer.velocity.back();
  const std::array<double, 6> node{r.x, r.y, r.z, v.x, v.y, v.z};
  result.position_error_km = 1000.0 * difference(x, node, 0);
  result.velocity_error_m_s = 1000.0 * difference(x, node, 3);

  // The orbit itself, not its path.
  const auto orbit =
      OrbitCurve::make(model.reference.orbit(), OrbitFrame::rotating, OrbitParameter::time, 1);
  if (orbit) {
    const auto jet = (*orbit)(answer.phase * static_cast<double>(model.reference.orbit().period));
    const Vector3<double> place = jet[0] - model.reference.moon();
    std::array<double, 6> meeting;
    for (std::size_t i = 0; i < 3; ++i) {
      meeting[i] = model.units.length * place[i];
      meeting[3 + i] = model.units.speed * jet[1][i];
    }
    result.orbit_error_km = 1000.0 * difference(x, meeting, 0);
    result.orbit_velocity_error_m_s = 1000.0 * difference(x, meeting, 3);
  }
  return result;
}

}  // namespace hodograph::ascent_detail
