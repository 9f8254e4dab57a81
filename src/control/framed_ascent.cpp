// SPDX-License-Identifier: MIT
#include "hodograph/control/framed_ascent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "ascent_solving.hpp"
#include "hodograph/control/path_coordinates.hpp"
#include "powered_model.hpp"

namespace hodograph {
namespace {

using ascent_detail::PoweredModel;
using A = Quaternion<double>;
using OrbitPath = ReferencePath<A>;

/// x = (ξ, η₂, η₃, v), u the thrust, the parameter T.
struct FramedModel {
  static constexpr std::size_t states = 6, controls = 3, parameters = 1;
  static constexpr std::size_t path_constraints = 2, end_constraints = 3;
  template <class S>
  using State = std::array<S, states>;
  template <class S>
  using Control = std::array<S, controls>;
  template <class S>
  using Parameters = std::array<S, parameters>;

  PoweredModel motion;
  std::shared_ptr<const OrbitPath> path;

  /// Everything but the thrust, a function of the state alone.
  template <class S>
  State<S> drift(const State<S>& x) const {
    const ReferenceValue<A, S> at = path->on(x[0]);
    const std::array<S, 2> eta{x[1], x[2]};
    const Vector3<S> v{x[3], x[4], x[5]};
    const std::array<S, 3> rates = coordinate_rates(at, eta, v);
    const Vector3<S> place = place_of(at, eta);
    const State<S> slope =
        motion.motion(State<S>{place.x, place.y, place.z, v.x, v.y, v.z}, Control<S>{});
    return {rates[0], rates[1], rates[2], slope[3], slope[4], slope[5]};
  }
  template <class S>
  State<S> derivative(double, const State<S>& x, const Control<S>& u,
                      const Parameters<S>& p) const {
    State<S> slope = evaluated_apart([this](const auto& y) { return this->drift(y); }, x);
    for (std::size_t i = 0; i < controls; ++i) slope[3 + i] += u[i];
    for (S& component : slope) component = p[0] * component;
    return slope;
  }
  template <class S>
  S stage_cost(std::size_t k, const State<S>& x, const Control<S>& u,
               const Parameters<S>& p) const {
    return motion.stage_cost(k, x, u, std::array<S, 2>{p[0], S(0.0)});
  }
  template <class S>
  S end_cost(const State<S>& x, const Parameters<S>& p) const {
    return motion.end_cost(x, std::array<S, 2>{p[0], S(0.0)});
  }
  /// |r|² and |u|².
  template <class S>
  std::array<S, 2> path_values(std::size_t, const State<S>& x, const Control<S>& u,
                               const Parameters<S>&) const {
    const auto square = evaluated_apart(
        [this]<class T>(const std::array<T, 3>& y) {
          const Vector3<T> place = place_of(path->on(y[0]), std::array<T, 2>{y[1], y[2]});
          return std::array<T, 1>{dot(place, place)};
        },
        std::array<S, 3>{x[0], x[1], x[2]});
    return {square[0], u[0] * u[0] + u[1] * u[1] + u[2] * u[2]};
  }
  /// The velocity less the orbit's.
  template <class S>
  std::array<S, 3> end_values(const State<S>& x, const Parameters<S>&) const {
    const ReferenceValue<A, S> at = path->on(x[0]);
    return {x[3] - at.speed * at.frame.e1.x, x[4] - at.speed * at.frame.e1.y,
            x[5] - at.speed * at.frame.e1.z};
  }
};

/// The orbit's path from the Moon's centre, in 1000 km, its knots in 1000 s.
Result<OrbitPath> scaled_path(const AscentReference& reference, const PoweredModel& model) {
  PathNumbers numbers = AnyPath(reference.path()).numbers();
  const double period = reference.period_s() / 1000.0, length = model.units.length;
  const Vector3<double> moon = reference.moon();
  numbers.closed = false;  // its frame does not close
  for (double& knot : numbers.knots) knot *= period;
  for (std::size_t i = 0; i < numbers.starts.size(); ++i) {
    numbers.starts[i] = length * (numbers.starts[i] - moon[i % 3]);
  }
  for (double& a : numbers.preimages) a *= std::sqrt(length / period);
  auto path = AnyPath::create(numbers);
  if (!path) return path.fault();
  return OrbitPath::of(*path);
}

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
  auto scaled = scaled_path(reference, motion);
  if (!scaled) return scaled.fault();
  const auto path = std::make_shared<const OrbitPath>(*std::move(scaled));
  MultipleShooting<FramedModel> program({motion, path}, count);

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
