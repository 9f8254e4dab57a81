// SPDX-License-Identifier: MIT
#include "hodograph/control/tracking_ascent.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "ascent_solving.hpp"
#include "tracking_model.hpp"

namespace hodograph {
namespace {

constexpr double pi = std::numbers::pi;
// The numbers of the publication.
constexpr double start_radius_km = 1.05 * 1740.0, start_speed = 0.01;
constexpr Range speed_range{0.001, 50.0}, rate_range{-500.0, 500.0};

struct Setting {
  double begin, horizon, revolutions;  ///< ξ0, Ξ, revolutions a unit of ξ
};
Setting numbers_of(TrackingSetting setting) {
  return setting == TrackingSetting::one_revolution ? Setting{0.5, 0.08, 1.0}
                                                    : Setting{0.125, 0.02, 4.0};
}

struct Angles {
  double theta, phi;
};
Angles angles_of(const Vector3<double>& v) {
  return {std::atan2(v.z, v.x), std::atan2(v.y, std::hypot(v.x, v.z))};
}
Vector3<double> direction_of(double theta, double phi) {
  return {std::cos(phi) * std::cos(theta), std::sin(phi), std::cos(phi) * std::sin(theta)};
}
/// The angle a whole number of turns away that lies within half a turn of `near`.
double turned_near(double angle, double near) {
  return angle - 2.0 * pi * std::round((angle - near) / (2.0 * pi));
}

}  // namespace

Result<TrackingAscent> tracking_ascent(const AscentReference& reference, const AscentStart& start,
                                       const TrackingOptions& options) {
  if (auto fault = ascent_detail::check(options.solving, options.intervals)) return *fault;
  constexpr double most_theta = 1000.0;
  if (auto fault = ascent_detail::check_number("singular_theta", options.singular_theta,
                                               -most_theta, most_theta)) {
    return *fault;
  }
  const Setting setting = numbers_of(options.setting);
  const std::size_t count = options.intervals;
  const double length_unit = reference.orbit().system.length_unit_km;
  TrackingAscent result;
  result.start = start;
  result.options = options;
  result.time_unit_s = reference.period_s() * setting.revolutions;
  result.speed_unit_m_s = 1000.0 * length_unit / result.time_unit_s;

  std::vector<Vector3<double>> tangents;
  for (std::size_t k = 0; k <= count; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(count);
    result.xi.push_back(setting.begin + setting.horizon * share);
    const auto jet = reference.derivatives(setting.revolutions * result.xi.back());
    result.reference.push_back(jet[0]);
    tangents.push_back(setting.revolutions * jet[1]);
  }
  const Vector3<double> from = reference.moon() + (start_radius_km / length_unit) * start.direction;
  Angles first = angles_of(start.direction);
  if (start.direction.x == 0.0 && start.direction.z == 0.0) {
    first.theta = options.singular_theta;
  }

  MultipleShooting<ascent_detail::Lander> program({setting.horizon, result.reference}, count);
  program.fix_start({from.x, from.y, from.z, start_speed, first.theta, first.phi});
  for (std::size_t k = 1; k <= count; ++k) program.state_ranges(k)[3] = speed_range;
  for (std::size_t k = 0; k < count; ++k) {
    program.control_ranges(k)[1] = program.control_ranges(k)[2] = rate_range;
  }

  // Guesses: the place moves to the reference evenly; the angles turn to those of its end, as
  // (θ + π, π - φ), which is the same direction, or directly, the longer or the shorter way round
  // in θ, over the first third of the horizon or all of it. In this order the first ones do best.
  const auto guess = [&](std::size_t number) {
    const bool over = number % 2 == 0, longer = number / 2 % 2 == 0, slow = number / 4 % 2 == 1;
    Angles end = angles_of(tangents.back());
    if (over) end = {end.theta + pi, pi - end.phi};
    end = {turned_near(end.theta, first.theta), turned_near(end.phi, first.phi)};
    if (longer) end.theta += end.theta > first.theta ? -2.0 * pi : 2.0 * pi;
    SolverPoint point;
    point.variables.assign(program.variable_ranges().size(), 0.0);
    for (std::size_t k = 0; k <= count; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(count);
      const double turn = slow ? share : std::min(1.0, 3.0 * share);
      const Vector3<double> offset = result.reference[k] - from;
      const Vector3<double> place = from + share * offset;
      const double speed = norm(share * tangents[k] + (1.0 / setting.horizon) * offset);
      double* x = point.variables.data() + program.state_at(k);
      x[0] = place.x;
      x[1] = place.y;
      x[2] = place.z;
      x[3] = std::clamp(speed, 2.0 * speed_range.lower, 0.98 * speed_range.upper);
      x[4] = first.theta + turn * (end.theta - first.theta);
      x[5] = first.phi + turn * (end.phi - first.phi);
    }
    return point;
  };
  auto best = ascent_detail::best_of(program, options.solving, guess);
  if (!best) return best.fault();
  result.solved = best->facts;

  const std::vector<double>& z = best->solution.point.variables;
  double nearest = norm(from - reference.moon());
  for (std::size_t k = 0; k <= count; ++k) {
    const double* x = z.data() + program.state_at(k);
    const Vector3<double> place{x[0], x[1], x[2]};
    result.position.push_back(place);
    result.speed.push_back(x[3]);
    result.theta.push_back(x[4]);
    result.phi.push_back(x[5]);
    result.position_error_km.push_back(length_unit * norm(place - result.reference[k]));
    const Vector3<double> heading = direction_of(x[4], x[5]), tangent = tangents[k];
    result.orientation_error.push_back(
        std::atan2(norm(cross(heading, tangent)), dot(heading, tangent)));
    nearest = std::min(nearest, norm(place - reference.moon()));
    if (k == count) break;
    const double* u = z.data() + program.control_at(k);
    result.acceleration.push_back(u[0]);
    result.theta_rate.push_back(u[1]);
    result.phi_rate.push_back(u[2]);
    for (const double* at : {x, z.data() + program.state_at(k + 1)}) {
      // (v d)' = a d + v d', and |d'|² = (ω_θ cos φ)² + ω_φ².
      const double thrust = std::hypot(u[0], at[3] * u[1] * std::cos(at[5]), at[3] * u[2]);
      result.largest_thrust_m_s2 =
          std::max(result.largest_thrust_m_s2, thrust * result.speed_unit_m_s / result.time_unit_s);
    }
  }
  result.end_error_km = result.position_error_km.back();
  result.lowest_height_km = length_unit * nearest - moon_radius_km;
  result.arrives = result.end_error_km < arrival_distance_km;
  return result;
}

}  // namespace hodograph
