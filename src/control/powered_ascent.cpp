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
using ascent_detail::PoweredModel;

Result<PoweredAscent> powered_ascent(const AscentReference& reference, const AscentStart& start,
                                     const PoweredOptions& options) {
  if (auto fault = ascent_detail::check(options)) return *fault;
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

  const auto guess = [&](std::size_t number) {
    const ascent_detail::PoweredGuess way =
        ascent_detail::way_round_the_moon(model, start, options, number);
    SolverPoint point;
    point.variables.assign(program.variable_ranges().size(), 0.0);
    for (std::size_t k = 0; k <= count; ++k) {
      std::copy(way.states[k].begin(), way.states[k].end(),
                point.variables.data() + program.state_at(k));
      if (k == count) break;
      double* u = point.variables.data() + program.control_at(k);
      for (std::size_t i = 0; i < 3; ++i) u[i] = way.thrust[k][i];
    }
    point.variables[program.parameters_at()] = duration;
    point.variables[program.parameters_at() + 1] = way.phase;
    return point;
  };
  auto best = ascent_detail::best_of(program, options.solving, guess);
  if (!best) return best.fault();

  const std::vector<double>& z = best->solution.point.variables;
  std::vector<std::array<double, 6>> states(count + 1);
  std::vector<Vector3<double>> thrust;
  for (std::size_t k = 0; k <= count; ++k) {
    const double* x = z.data() + program.state_at(k);
    std::copy(x, x + 6, states[k].begin());
    if (k == count) break;
    const double* u = z.data() + program.control_at(k);
    thrust.push_back({u[0], u[1], u[2]});
  }
  return ascent_detail::powered_answer(model, start, options, best->facts, states, thrust,
                                       z[program.parameters_at()], z[program.parameters_at() + 1]);
}

}  // namespace hodograph
