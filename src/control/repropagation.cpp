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

/// Heights are looked at this often within an interval of constant thrust; between two looks the
/// cubic through |r|² and its rates at both ends is used.
constexpr std::size_t looks = 8;
/// The local error of a step, relative to the state: far below what is to be measured.
constexpr Real step_tolerance = 4096 * std::numeric_limits<Real>::epsilon();

/// The least value on [0, 1] of the cubic with values a, b and slopes da, db at the ends.
Real least_of_cubic(Real a, Real da, Real b, Real db) {
  Real least = std::min(a, b);
  // Slope: da + 2 c2 t + 3 c3 t².
  const Real c2 = 3 * (b - a) - 2 * da - db, c3 = 2 * (a - b) + da + db;
  const Real discriminant = c2 * c2 - 3 * c3 * da;
  if (discriminant < 0) return least;
  const Real root = c2 + std::copysign(std::sqrt(discriminant), c2);
  for (const Real t : {-root / (3 * c3), -da / root}) {
    if (t > 0 && t < 1) least = std::min(least, a + t * (da + t * (c2 + t * c3)));
  }
  return least;
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
  const Real h = static_cast<Real>(answer.duration_s) / 1000 / static_cast<Real>(count * looks);
  const auto square = [](const State& s) { return s[0] * s[0] + s[1] * s[1] + s[2] * s[2]; };
  const auto rate = [](const State& s) { return 2 * (s[0] * s[3] + s[1] * s[4] + s[2] * s[5]); };
  Real least = square(x), least_later = std::numeric_limits<Real>::infinity();
  for (std::size_t k = 0; k < count; ++k) {
    const std::array<Real, 3> u{static_cast<Real>(answer.thrust[k].x),
                                static_cast<Real>(answer.thrust[k].y),
                                static_cast<Real>(answer.thrust[k].z)};
    const auto slope = [&](const State& at, State& result_slope, Real) {
      result_slope = model.motion<Real>(at, u);
    };
    for (std::size_t look = 0; look < looks; ++look) {
      const Real before = square(x), rate_before = rate(x) * h;
      auto stepper = odeint::make_controlled(step_tolerance, step_tolerance,
                                             odeint::runge_kutta_fehlberg78<State, Real>());
      result.steps += odeint::integrate_adaptive(stepper, slope, x, Real(0), h, h);
      const Real lowest = least_of_cubic(before, rate_before, square(x), rate(x) * h);
      least = std::min(least, lowest);
      if (k > 0) least_later = std::min(least_later, lowest);
    }
  }
  const auto height = [&](Real squared) {
    return static_cast<double>(1000 * std::sqrt(squared) -
                               static_cast<Real>(answer.options.surface_km));
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
