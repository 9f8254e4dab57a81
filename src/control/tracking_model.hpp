// SPDX-License-Identifier: MIT
// Private to control/: the optimal control problem (25) as a shooting model.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/control/multiple_shooting.hpp"

namespace hodograph::ascent_detail {

constexpr double control_weight = 1e-10;  // not a tolerance: R of (25)

/// The lander (24): p, v, θ, φ; a and the rates of the angles; per unit of ξ = ξ0 + horizon τ.
struct Lander {
  static constexpr std::size_t states = 6, controls = 3, parameters = 0;
  static constexpr std::size_t path_constraints = 0, end_constraints = 0;
  template <class S>
  using State = std::array<S, states>;
  template <class S>
  using Control = std::array<S, controls>;
  template <class S>
  using None = std::array<S, 0>;

  double horizon = 0.0;
  std::vector<Vector3<double>> reference;

  template <class S>
  State<S> derivative(double, const State<S>& x, const Control<S>& u, const None<S>&) const {
    const auto slope = evaluated_apart(
        []<class T>(const std::array<T, 3>& z) {
          using std::cos;
          using std::sin;
          const T level = z[0] * cos(z[2]);
          return std::array<T, 3>{level * cos(z[1]), z[0] * sin(z[2]), level * sin(z[1])};
        },
        std::array<S, 3>{x[3], x[4], x[5]});
    return {horizon * slope[0], horizon * slope[1], horizon * slope[2],
            horizon * u[0],     horizon * u[1],     horizon * u[2]};
  }
  template <class S>
  S stage_cost(std::size_t k, const State<S>& x, const Control<S>& u, const None<S>&) const {
    const Vector3<double>& r = reference[k];
    const S ex = x[0] - r.x, ey = x[1] - r.y, ez = x[2] - r.z;
    return ex * ex + ey * ey + ez * ez + control_weight * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  }
  template <class S>
  S end_cost(const State<S>&, const None<S>&) const {
    return S(0.0);
  }
  template <class S>
  None<S> path_values(std::size_t, const State<S>&, const Control<S>&, const None<S>&) const {
    return {};
  }
  template <class S>
  None<S> end_values(const State<S>&, const None<S>&) const {
    return {};
  }
};

}  // namespace hodograph::ascent_detail
