// SPDX-License-Identifier: MIT
#include "hodograph/control/framed_ascent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "ascent_solving.hpp"
#include "framed_model.hpp"
#include "hodograph/control/path_coordinates.hpp"

namespace hodograph {
namespace {

using ascent_detail::FramedModel;
using ascent_detail::PoweredModel;
using OrbitPath = ReferencePath<Quaternion<double>>;

/// ξ and η of a point: the nearest place of the path between two, then Newton's method.
std::array<double, 3> coordinates_of(const OrbitPath& path, const Vector3<double>& point,
                                     double from, double to) {
  constexpr int places = 1000, most_steps = 50;
  double xi = from, least = norm(point - path.value(from).position);
  for (int i = 1; i <= places; ++i) {
    const double at = from + (to - from) * i / places;
    const double distance = norm(point - path.value(at).position);
    if (distance < least) {
      least = distance;
      xi = at;
    }
  }
  for (int step = 0; step < most_steps; ++step) {
    const auto at = path.value(xi);
    const Vector3<double> off = point - at.position;
    const std::array<double, 2> eta{dot(off, at.frame.e2), dot(off, at.frame.e3)};
    const double move = dot(off, at.frame.e1) / progress_stretch(at, eta);
    if (!(std::abs(move) > std::numeric_limits<double>::epsilon() * xi)) break;
    xi += move;
  }
  const auto at = path.value(xi);
  const Vector3<double> off = point - at.position;
  return {xi, dot(off, at.frame.e2), dot(off, at.frame.e3)};
}

}  // namespace

Result<PoweredAscent> powered_ascent_along_path(const AscentReference& reference,
                                                const AscentStart& start,
                                                const PoweredOptions& options) {
  if (auto fault = ascent_detail::check(options)) return *fault;
  const std::size_t count = options.intervals;
  const double intervals = static_cast<double>(count);
  const bool least_time = options.objective == PoweredObjective::least_time;
  const PoweredModel motion{reference, ascent_detail::PoweredUnits(reference.orbit().system),
                            least_time, intervals};
  const auto scaled = ascent_detail::path_from_the_moon(reference, motion);
  if (!scaled) return scaled.fault();
  auto made = OrbitPath::of(*scaled);
  if (!made) return made.fault();
  const auto path = std::make_shared<const OrbitPath>(*std::move(made));
  MultipleShooting<FramedModel<>> program({motion, path}, count);

  const double radius = options.surface_km / 1000.0;
  const double lowest = radius + options.margin_km / 1000.0, limit = options.thrust_limit_m_s2;
  constexpr double early = 0.4, late = 0.6;  // shares of the period: where the orbit is low
  const std::array<double, 3> from =
      coordinates_of(*path, radius * start.direction, early * path->end(), late * path->end());
  program.fix_start({from[0], from[1], from[2], 0.0, 0.0, 0.0});
  for (std::size_t k = 0; k <= count; ++k) {
    if (k > 0) program.state_ranges(k)[0] = {path->begin(), path->end()};
    if (k == count) break;
    if (k > 0) program.path_ranges(k)[0].lower = lowest * lowest;
    program.path_ranges(k)[1].upper = limit * limit;
    for (Range& range : program.control_ranges(k)) range = {-limit, limit};
  }
  program.state_ranges(count)[1] = program.state_ranges(count)[2] = Range::only(0.0);
  for (Range& range : program.end_ranges()) range = Range::only(0.0);
  const double duration = options.duration_s / 1000.0;
  program.parameter_ranges()[0] =
      least_time ? Range{0.05 * duration, 20.0 * duration} : Range::only(duration);

  // The same guesses as in rectangular coordinates.
  const auto guess = [&](std::size_t number) {
    const ascent_detail::PoweredGuess way =
        ascent_detail::way_round_the_moon(motion, start, options, number);
    SolverPoint point;
    point.variables.assign(program.variable_ranges().size(), 0.0);
    for (std::size_t k = 0; k <= count; ++k) {
      const auto& y = way.states[k];
      const auto place =
          coordinates_of(*path, {y[0], y[1], y[2]}, early * path->end(), late * path->end());
      double* const x = point.variables.data() + program.state_at(k);
      std::copy(place.begin(), place.end(), x);
      std::copy(y.begin() + 3, y.end(), x + 3);
      if (k == count) break;
      double* const u = point.variables.data() + program.control_at(k);
      for (std::size_t i = 0; i < 3; ++i) u[i] = way.thrust[k][i];
    }
    point.variables[program.parameters_at()] = duration;
    return point;
  };
  auto best = ascent_detail::best_of(program, options.solving, guess);
  if (!best) return best.fault();

  const std::vector<double>& z = best->solution.point.variables;
  std::vector<std::array<double, 6>> states;
  std::vector<Vector3<double>> thrust;
  for (std::size_t k = 0; k <= count; ++k) {
    const double* const x = z.data() + program.state_at(k);
    const Vector3<double> place = place_of(path->value(x[0]), std::array<double, 2>{x[1], x[2]});
    states.push_back({place.x, place.y, place.z, x[3], x[4], x[5]});
    if (k == count) break;
    const double* const u = z.data() + program.control_at(k);
    thrust.push_back({u[0], u[1], u[2]});
  }
  return ascent_detail::powered_answer(motion, start, options, best->facts, states, thrust,
                                       z[program.parameters_at()],
                                       z[program.state_at(count)] / path->end());
}

}  // namespace hodograph
