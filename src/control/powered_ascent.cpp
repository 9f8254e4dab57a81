// SPDX-License-Identifier: MIT
#include "hodograph/control/powered_ascent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "ascent_solving.hpp"
#include "powered_model.hpp"

namespace hodograph {
namespace {

using ascent_detail::check_number;
using ascent_detail::PoweredModel;

constexpr double pi = std::numbers::pi;

std::optional<Fault> check(const PoweredOptions& options) {
  if (auto fault = ascent_detail::check(options.solving, options.intervals)) return fault;
  constexpr double least_duration = 60.0, most_duration = 1e6;  // a minute; twelve days
  if (auto fault = check_number("duration_s", options.duration_s, least_duration, most_duration)) {
    return fault;
  }
  constexpr double least_thrust = 0.01, most_thrust = 1000.0;
  if (auto fault =
          check_number("thrust_limit_m_s2", options.thrust_limit_m_s2, least_thrust, most_thrust)) {
    return fault;
  }
  constexpr double least_surface = 1000.0, most_surface = 3000.0;  // the orbit is lowest at 4170 km
  if (auto fault = check_number("surface_km", options.surface_km, least_surface, most_surface)) {
    return fault;
  }
  constexpr double most_margin = 100.0;
  return check_number("margin_km", options.margin_km, 0.0, most_margin);
}

/// A unit vector across `a`, as near to `wish` as it can be.
Vector3<double> across(const Vector3<double>& a, const Vector3<double>& wish) {
  const Vector3<double> rest = wish - dot(a, wish) * a;
  return (1.0 / norm(rest)) * rest;
}

}  // namespace

Result<PoweredAscent> powered_ascent(const AscentReference& reference, const AscentStart& start,
                                     const PoweredOptions& options) {
  if (auto fault = check(options)) return *fault;
  const std::size_t count = options.intervals;
  const double intervals = static_cast<double>(count);
  const bool least_time = options.objective == PoweredObjective::least_time;
  const PoweredModel model{reference, ascent_detail::PoweredUnits(reference.orbit().system),
                           least_time, intervals};
  MultipleShooting<PoweredModel> program(model, count);

  const double radius = options.surface_km / 1000.0, lowest = radius + options.margin_km / 1000.0;
  const Vector3<double> from = radius * start.direction;
  program.fix_start({from.x, from.y, from.z, 0.0, 0.0, 0.0});
  const double limit = options.thrust_limit_m_s2;
  for (std::size_t k = 0; k < count; ++k) {
    if (k > 0) program.path_ranges(k)[0].lower = lowest * lowest;
    program.path_ranges(k)[1].upper = limit * limit;
    for (Range& range : program.control_ranges(k)) range = {-limit, limit};
  }
  for (Range& range : program.end_ranges()) range = Range::only(0.0);
  const double duration = options.duration_s / 1000.0;
  program.parameter_ranges()[0] =
      least_time ? Range{0.05 * duration, 20.0 * duration} : Range::only(duration);
  // Half a revolution either way of where the orbit is lowest.
  program.parameter_ranges()[1] = {0.0, 1.0};

  // Guesses: round the Moon in the plane of the start and a point of the orbit near its lowest, the
  // shorter way or the longer one, the height growing evenly, with the thrust that this takes.
  constexpr std::array<double, 4> phases{0.5, 0.503, 0.497, 0.508};
  const auto guess = [&](std::size_t number) {
    const bool longer = number % 2 == 1;
    const double phase = phases[number / 2 % phases.size()];
    const auto target = model.orbit_state<double>(phase);
    const Vector3<double> to{target[0], target[1], target[2]};
    const Vector3<double> motion{target[3], target[4], target[5]};
    const double far = norm(to);
    double angle = std::atan2(norm(cross(start.direction, to)), dot(start.direction, to));
    // Where start and goal (nearly) are on one line through the centre, the orbit's motion names
    // the plane.
    const bool plane_known = std::sin(angle) > std::numeric_limits<float>::epsilon();
    Vector3<double> side = across(start.direction, plane_known ? to : motion);
    if (longer) {
      side = -side;
      angle = 2.0 * pi - angle;
    }
    SolverPoint point;
    point.variables.assign(program.variable_ranges().size(), 0.0);
    for (std::size_t k = 0; k <= count; ++k) {
      const double share = static_cast<double>(k) / intervals;
      // From rest: turned by angle · (2 s² - s³)..., at the full rate in the end.
      const double turned = share * share * (3.0 - 2.0 * share),
                   turning = 6.0 * share * (1.0 - share);
      const double curving = 6.0 - 12.0 * share;
      const double height = radius + (far - radius) * turned;
      const double c = std::cos(angle * turned), s = std::sin(angle * turned);
      const Vector3<double> out = c * start.direction + s * side;
      const Vector3<double> along = c * side - s * start.direction;
      const double rise = (far - radius) * turning / duration, spin = angle * turning / duration;
      const Vector3<double> place = height * out;
      const Vector3<double> velocity = rise * out + (height * spin) * along;
      double* x = point.variables.data() + program.state_at(k);
      for (std::size_t i = 0; i < 3; ++i) {
        x[i] = place[i];
        x[3 + i] = velocity[i];
      }
      if (k == count) break;
      const double square = duration * duration;
      const Vector3<double> acceleration =
          ((far - radius) * curving / square - height * spin * spin) * out +
          (2.0 * rise * spin + height * angle * curving / square) * along;
      const auto without = model.motion<double>({x[0], x[1], x[2], x[3], x[4], x[5]}, {});
      const Vector3<double> thrust =
          acceleration - Vector3<double>{without[3], without[4], without[5]};
      const double size = norm(thrust), most = 0.9 * limit;
      const Vector3<double> allowed = (size > most ? most / size : 1.0) * thrust;
      double* u = point.variables.data() + program.control_at(k);
      for (std::size_t i = 0; i < 3; ++i) u[i] = allowed[i];
    }
    point.variables[program.parameters_at()] = duration;
    point.variables[program.parameters_at() + 1] = phase;
    return point;
  };
  auto best = ascent_detail::best_of(program, options.solving, guess);
  if (!best) return best.fault();

  PoweredAscent result;
  result.start = start;
  result.options = options;
  result.solved = best->facts;
  const std::vector<double>& z = best->solution.point.variables;
  const double time = z[program.parameters_at()];
  result.duration_s = 1000.0 * time;
  result.phase = reference.path().wrapped(z[program.parameters_at() + 1]);
  for (std::size_t k = 0; k <= count; ++k) {
    const double* x = z.data() + program.state_at(k);
    const Vector3<double> r{x[0], x[1], x[2]}, v{x[3], x[4], x[5]};
    const double left = 1.0 - static_cast<double>(k) / intervals;
    result.time_s.push_back(result.duration_s * (1.0 - left));
    result.position.push_back(1000.0 * r);
    result.velocity.push_back(v);
    const double phase = result.phase - left * result.duration_s / reference.period_s();
    const auto orbit = model.orbit_state<double>(phase);
    result.position_error_km.push_back(1000.0 *
                                       norm(r - Vector3<double>{orbit[0], orbit[1], orbit[2]}));
    const Vector3<double> tangent{orbit[3], orbit[4], orbit[5]};
    Vector3<double> heading = v;
    if (k < count) {
      const double* u = z.data() + program.control_at(k);
      result.thrust.push_back({u[0], u[1], u[2]});
      result.velocity_change_m_s += norm(result.thrust.back()) * result.duration_s / intervals;
      if (k == 0) heading = result.thrust.back();
    }
    result.orientation_error.push_back(
        std::atan2(norm(cross(heading, tangent)), dot(heading, tangent)));
  }
  result.again = ascent_detail::followed_again(model, result);
  return result;
}

}  // namespace hodograph
