// SPDX-License-Identifier: MIT
// Initial guesses of the powered ascent.
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "powered_model.hpp"

namespace hodograph::ascent_detail {
namespace {

constexpr double pi = std::numbers::pi;

/// A unit vector across `a`, as near to `wish` as it can be.
Vector3<double> across(const Vector3<double>& a, const Vector3<double>& wish) {
  const Vector3<double> rest = wish - dot(a, wish) * a;
  return (1.0 / norm(rest)) * rest;
}

}  // namespace

PoweredGuess way_round_the_moon(const PoweredModel& model, const AscentStart& start,
                                const PoweredOptions& options, std::size_t number) {
  const std::size_t count = options.intervals;
  const double intervals = static_cast<double>(count), duration = options.duration_s / 1000.0;
  const double radius = options.surface_km / 1000.0, limit = options.thrust_limit_m_s2;
  constexpr std::array<double, 4> phases{0.5, 0.503, 0.497, 0.508};
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
  PoweredGuess guess;
  guess.phase = phase;
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
    guess.states.push_back({place.x, place.y, place.z, velocity.x, velocity.y, velocity.z});
    if (k == count) break;
    const double square = duration * duration;
    const Vector3<double> acceleration =
        ((far - radius) * curving / square - height * spin * spin) * out +
        (2.0 * rise * spin + height * angle * curving / square) * along;
    const auto without = model.motion<double>(guess.states.back(), {});
    const Vector3<double> thrust =
        acceleration - Vector3<double>{without[3], without[4], without[5]};
    const double size = norm(thrust), most = 0.9 * limit;
    guess.thrust.push_back((size > most ? most / size : 1.0) * thrust);
  }
  return guess;
}

}  // namespace hodograph::ascent_detail
