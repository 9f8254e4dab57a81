// SPDX-License-Identifier: MIT
// Private to control/: vehicles in the coordinates of a path, as shooting models.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "hodograph/control/multiple_shooting.hpp"
#include "hodograph/control/path_coordinates.hpp"

namespace hodograph::control_detail {

/// A car in the plane: x = (ξ, η, ψ, v), heading ψ against the tangent; u = (a, k), acceleration
/// along and curvature of the way.
///   ξ̇ = v cos ψ/h,  η̇ = v sin ψ,  ψ̇ = v k - ξ̇ χ,  v̇ = a
struct Car {
  using A = Complex<double>;
  static constexpr std::size_t states = 4, controls = 2, limited = 1, limited_at_end = 0;
  std::array<double, controls> scale{1.0, 1.0};  ///< of the effort

  template <class S>
  std::array<S, states> rates(const ReferenceValue<A, S>& at, const std::array<S, states>& x,
                              const std::array<S, controls>& u) const {
    using std::cos;
    using std::sin;
    const S progress = (x[3] * cos(x[2])) / progress_stretch(at, std::array<S, 1>{x[1]});
    return {progress, x[3] * sin(x[2]), x[3] * u[1] - progress * at.body_rate, u[0]};
  }
  template <class S>
  S forward(const ReferenceValue<A, S>&, const std::array<S, states>& x) const {
    using std::cos;
    return x[3] * cos(x[2]);
  }
  /// The lateral acceleration v² k.
  template <class S>
  std::array<S, limited> limits(const std::array<S, states>& x,
                                const std::array<S, controls>& u) const {
    return {x[3] * x[3] * u[1]};
  }
  template <class S>
  std::array<S, limited_at_end> end_limits(const std::array<S, states>&) const {
    return {};
  }
};

/// The car with a third control s ≥ 0, by how much it may leave its tube and, in proportion, exceed
/// its lateral acceleration: for real time, where a plan must exist wherever the car was pushed to.
struct SoftCar {
  using A = Complex<double>;
  static constexpr std::size_t states = 4, controls = 3, limited = 4, limited_at_end = 0;
  std::array<double, controls> scale{1.0, 1.0, 1.0};
  double lateral_per_offset = 0.0;  ///< of the lateral acceleration's excess to s
  double excess_weight = 0.0;       ///< cost of s, per unit of it

  template <class S>
  std::array<S, states> rates(const ReferenceValue<A, S>& at, const std::array<S, states>& x,
                              const std::array<S, controls>& u) const {
    return Car{}.rates(at, x, std::array<S, 2>{u[0], u[1]});
  }
  template <class S>
  S forward(const ReferenceValue<A, S>& at, const std::array<S, states>& x) const {
    return Car{}.forward(at, x);
  }
  /// ±v² k and ±η, less their excess.
  template <class S>
  std::array<S, limited> limits(const std::array<S, states>& x,
                                const std::array<S, controls>& u) const {
    const S lateral = x[3] * x[3] * u[1], more = lateral_per_offset * u[2];
    return {lateral - more, -lateral - more, x[1] - u[2], -x[1] - u[2]};
  }
  template <class S>
  S excess(const std::array<S, controls>& u) const {
    return excess_weight * u[2];
  }
  template <class S>
  std::array<S, limited_at_end> end_limits(const std::array<S, states>&) const {
    return {};
  }
};

/// A point in space: x = (ξ, η₂, η₃, v), u its acceleration, v and u in the axes of space.
struct Glider {
  using A = Quaternion<double>;
  static constexpr std::size_t states = 6, controls = 3, limited = 3, limited_at_end = 2;
  std::array<double, controls> scale{1.0, 1.0, 1.0};

  template <class S>
  static std::array<S, 2> eta(const std::array<S, states>& x) {
    return {x[1], x[2]};
  }
  template <class S>
  static Vector3<S> velocity(const std::array<S, states>& x) {
    return {x[3], x[4], x[5]};
  }
  template <class S>
  std::array<S, states> rates(const ReferenceValue<A, S>& at, const std::array<S, states>& x,
                              const std::array<S, controls>& u) const {
    const std::array<S, 3> c = coordinate_rates(at, eta(x), velocity(x));
    return {c[0], c[1], c[2], u[0], u[1], u[2]};
  }
  template <class S>
  S forward(const ReferenceValue<A, S>& at, const std::array<S, states>& x) const {
    return dot(velocity(x), at.frame.e1);
  }
  /// |u|², |v|², |η|².
  template <class S>
  std::array<S, limited> limits(const std::array<S, states>& x,
                                const std::array<S, controls>& u) const {
    const std::array<S, 2> end = end_limits(x);
    return {u[0] * u[0] + u[1] * u[1] + u[2] * u[2], end[0], end[1]};
  }
  template <class S>
  std::array<S, limited_at_end> end_limits(const std::array<S, states>& x) const {
    return {x[3] * x[3] + x[4] * x[4] + x[5] * x[5], x[1] * x[1] + x[2] * x[2]};
  }
};

/// Numbers without derivatives, as any scalar.
template <class S>
ReferenceValue<Complex<double>, S> constants(const ReferenceValue<Complex<double>, double>& at) {
  const auto vector = [](const Vector2<double>& v) { return Vector2<S>{S(v.x), S(v.y)}; };
  return {vector(at.position),
          {vector(at.frame.e1), vector(at.frame.e2)},
          S(at.body_rate),
          S(at.speed)};
}
template <class S>
ReferenceValue<Quaternion<double>, S> constants(
    const ReferenceValue<Quaternion<double>, double>& at) {
  const auto vector = [](const Vector3<double>& v) { return Vector3<S>{S(v.x), S(v.y), S(v.z)}; };
  return {vector(at.position),
          {vector(at.frame.e1), vector(at.frame.e2), vector(at.frame.e3)},
          vector(at.body_rate),
          S(at.speed)};
}

/// A vehicle over a stretch of a path. With time independent the state is the vehicle's and the
/// parameter the duration T; with ξ independent the time t takes the place of ξ:
/// dt/dξ = 1/ξ̇, dx/dξ = ẋ/ξ̇.
template <class Vehicle, bool by_progress, class Path = ReferencePath<typename Vehicle::A>>
struct FollowModel {
  static constexpr std::size_t states = Vehicle::states, controls = Vehicle::controls;
  static constexpr std::size_t parameters = by_progress ? 0 : 1;
  static constexpr std::size_t path_constraints = Vehicle::limited + (by_progress ? 1 : 0);
  static constexpr std::size_t end_constraints = Vehicle::limited_at_end;
  template <class S>
  using State = std::array<S, states>;
  template <class S>
  using Control = std::array<S, controls>;
  template <class S>
  using Parameters = std::array<S, parameters>;

  std::shared_ptr<const Path> path;
  Vehicle vehicle;
  double intervals = 1.0, begin = 0.0, end = 1.0;  // of the progress
  /// With ξ independent: the path at the nodes and halfway between them, where the Runge-Kutta
  /// steps look, all evaluated once.
  std::vector<ReferenceValue<typename Vehicle::A, double>> stages{};
  double time_weight = 1.0, progress_weight = 0.0, effort_weight = 0.0, centre_weight = 0.0;

  /// The path's place at a share of the horizon.
  ReferenceValue<typename Vehicle::A, double> at_stage(double tau) const {
    const double place = 2.0 * intervals * tau, nearest = std::round(place);
    constexpr double roundings = 8.0 * std::numeric_limits<double>::epsilon();
    if (std::abs(place - nearest) <= roundings * nearest) {
      return stages[static_cast<std::size_t>(nearest)];
    }
    return path->value(begin + tau * (end - begin));
  }
  void find_stages() {
    const auto count = static_cast<std::size_t>(2.0 * intervals) + 1;
    std::vector<double> places;
    for (std::size_t i = 0; i < count; ++i) {
      places.push_back(begin + static_cast<double>(i) / (2.0 * intervals) * (end - begin));
    }
    std::vector<ReferenceJet<typename Vehicle::A>> jets(count);
    path->at(places, jets);
    stages.clear();
    for (const auto& jet : jets) {
      stages.push_back({jet.position[0], jet.frame[0], jet.body_rate[0], jet.speed[0]});
    }
  }

  template <class S>
  State<S> derivative(double tau, const State<S>& x, const Control<S>& u,
                      const Parameters<S>& p) const {
    if constexpr (by_progress) {
      State<S> rates = vehicle.rates(constants<S>(at_stage(tau)), x, u);
      const S slowness = (end - begin) / rates[0];
      rates[0] = slowness;
      for (std::size_t i = 1; i < states; ++i) rates[i] = slowness * rates[i];
      return rates;
    } else {
      State<S> rates = vehicle.rates(path->on(x[0]), x, u);
      for (S& rate : rates) rate = p[0] * rate;
      return rates;
    }
  }
  /// The effort, and how far it is from the path, over the interval: of the whole, a share each.
  template <class S>
  S stage_cost(std::size_t, const State<S>& x, const Control<S>& u, const Parameters<S>&) const {
    S sum(0.0);
    for (std::size_t i = 0; i < controls; ++i) {
      const S part = (1.0 / vehicle.scale[i]) * u[i];
      sum += part * part;
    }
    sum = effort_weight * sum;
    if constexpr (requires { vehicle.excess(u); }) sum += vehicle.excess(u);
    if (centre_weight > 0.0) sum += centre_weight * (x[1] * x[1]);
    return (1.0 / intervals) * sum;
  }
  template <class S>
  S end_cost(const State<S>& x, const Parameters<S>& p) const {
    if constexpr (by_progress) {
      return time_weight * x[0];
    } else {
      return time_weight * p[0] - progress_weight * x[0];
    }
  }
  template <class S>
  std::array<S, path_constraints> path_values(std::size_t k, const State<S>& x, const Control<S>& u,
                                              const Parameters<S>&) const {
    const auto own = vehicle.limits(x, u);
    std::array<S, path_constraints> all;
    for (std::size_t i = 0; i < own.size(); ++i) all[i] = own[i];
    if constexpr (by_progress) {
      all[own.size()] = vehicle.forward(constants<S>(stages[2 * k]), x);
    }
    return all;
  }
  template <class S>
  std::array<S, end_constraints> end_values(const State<S>& x, const Parameters<S>&) const {
    return vehicle.end_limits(x);
  }
};

}  // namespace hodograph::control_detail
