// SPDX-License-Identifier: MIT
// What the powered ascent in rectangular coordinates and in those of the path have in common.
#include <cmath>

#include "ascent_solving.hpp"
#include "powered_model.hpp"

namespace hodograph::ascent_detail {

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

PoweredAscent powered_answer(const PoweredModel& model, const AscentStart& start,
                             const PoweredOptions& options, const AscentSolved& solved,
                             const std::vector<std::array<double, 6>>& states,
                             const std::vector<Vector3<double>>& thrust, double time,
                             double phase) {
  const AscentReference& reference = model.reference;
  const std::size_t count = thrust.size();
  const double intervals = static_cast<double>(count);
  PoweredAscent result;
  result.start = start;
  result.options = options;
  result.solved = solved;
  result.duration_s = 1000.0 * time;
  result.phase = reference.path().wrapped(phase);
  for (std::size_t k = 0; k <= count; ++k) {
    const auto& x = states[k];
    const Vector3<double> r{x[0], x[1], x[2]}, v{x[3], x[4], x[5]};
    const double left = 1.0 - static_cast<double>(k) / intervals;
    result.time_s.push_back(result.duration_s * (1.0 - left));
    result.position.push_back(1000.0 * r);
    result.velocity.push_back(v);
    const auto orbit =
        model.orbit_state<double>(result.phase - left * result.duration_s / reference.period_s());
    result.position_error_km.push_back(1000.0 *
                                       norm(r - Vector3<double>{orbit[0], orbit[1], orbit[2]}));
    const Vector3<double> tangent{orbit[3], orbit[4], orbit[5]};
    Vector3<double> heading = v;
    if (k < count) {
      result.thrust.push_back(thrust[k]);
      result.velocity_change_m_s += norm(thrust[k]) * result.duration_s / intervals;
      if (k == 0) heading = thrust[k];
    }
    result.orientation_error.push_back(
        std::atan2(norm(cross(heading, tangent)), dot(heading, tangent)));
  }
  result.again = followed_again(model, result);
  return result;
}

}  // namespace hodograph::ascent_detail
