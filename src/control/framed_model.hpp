// SPDX-License-Identifier: MIT
// Private to control/: the powered ascent in the coordinates of the orbit's path, as a shooting
// model.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

#include "hodograph/control/path_coordinates.hpp"
#include "powered_model.hpp"

namespace hodograph::ascent_detail {

/// How much ξ grows in 1000 s on the orbit: about as much as the other numbers. Of nine scales from
/// 0.1 to 10 it took the fewest iterations in the ascents of the tests.
inline constexpr double framed_pace = 0.7;

/// x = (ξ, η₂, η₃, v), u the thrust, the parameter T.
template <class Path = ReferencePath<Quaternion<double>>>
struct FramedModel {
  using A = Quaternion<double>;
  static constexpr std::size_t states = 6, controls = 3, parameters = 1;
  static constexpr std::size_t path_constraints = 2, end_constraints = 3;
  template <class S>
  using State = std::array<S, states>;
  template <class S>
  using Control = std::array<S, controls>;
  template <class S>
  using Parameters = std::array<S, parameters>;

  PoweredModel motion;
  std::shared_ptr<const Path> path;

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
    const S speed = framed_pace * at.speed;
    return {x[3] - speed * at.frame.e1.x, x[4] - speed * at.frame.e1.y,
            x[5] - speed * at.frame.e1.z};
  }
};

/// The orbit's path from the Moon's centre, in 1000 km, its knots by framed_pace.
inline Result<AnyPath> path_from_the_moon(const AscentReference& reference,
                                          const PoweredModel& model) {
  PathNumbers numbers = AnyPath(reference.path()).numbers();
  const double period = framed_pace * reference.period_s() / 1000.0, length = model.units.length;
  const Vector3<double> moon = reference.moon();
  numbers.closed = false;  // its frame does not close
  for (double& knot : numbers.knots) knot *= period;
  for (std::size_t i = 0; i < numbers.starts.size(); ++i) {
    numbers.starts[i] = length * (numbers.starts[i] - moon[i % 3]);
  }
  for (double& a : numbers.preimages) a *= std::sqrt(length / period);
  return AnyPath::create(numbers);
}

}  // namespace hodograph::ascent_detail
