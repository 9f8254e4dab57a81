// SPDX-License-Identifier: MIT
// The Taylor series of a three-body motion about a state, by recursion on the equations of motion.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "hodograph/foundation/taylor.hpp"
#include "hodograph/orbit/three_body.hpp"

namespace hodograph {

/// The position along the motion through `state`, as a series in time to order K:
///   r(t) = Σ_{k=0..K} c_k t^k + O(t^{K+1}),   c_0 and c_1 the state's position and velocity.
/// Derivation: with s = |d|² and u = s^{-3/2} for the offset d from a primary, s u' = -(3/2) s' u
/// gives u_k = Σ_{j<k} (-(3/2)(k-j) - j) s_{k-j} u_j / (k s_0), and comparing coefficients of the
/// equations of motion gives (k+1)(k+2) c_{k+2} from c_0 ... c_{k+1}; O(K²) operations in all.
/// Domain: a state away from both primaries (contract). Each coefficient is exact up to rounding.
template <std::size_t K, class S>
Vector3<Taylor<S, K>> motion_series(const ThreeBodySystem& system, const OrbitState<S>& state) {
  static_assert(K >= 2, "position and velocity alone need no series");
  using std::sqrt;
  const auto count = [](std::size_t n) { return S(static_cast<double>(n)); };
  const S mu(system.mass_ratio), rest = S(1) - mu, three_halves = S(3) / S(2);

  Vector3<Taylor<S, K>> r;
  for (std::size_t i = 0; i < 3; ++i) {
    r[i][0] = state.position[i];
    r[i][1] = state.velocity[i];
  }
  // The offsets from the primaries differ from r in the constant term of x alone.
  const S x1 = offset_from_larger(system, state.position).x;
  const S x2 = offset_from_smaller(system, state.position).x;
  const auto offset = [&](const S& x0, std::size_t k) -> const S& { return k == 0 ? x0 : r.x[k]; };

  std::array<S, K - 1> s1{}, s2{}, u1{}, u2{};
  const auto next_power = [&](const std::array<S, K - 1>& s, const std::array<S, K - 1>& u,
                              std::size_t k) -> S {
    if (k == 0) return S(1) / (s[0] * sqrt(s[0]));
    S sum(0);
    for (std::size_t j = 0; j < k; ++j) {
      sum = sum - (three_halves * count(k - j) + count(j)) * s[k - j] * u[j];
    }
    return sum / (count(k) * s[0]);
  };

  for (std::size_t k = 0; k + 2 <= K; ++k) {
    S off_axis(0), square1(0), square2(0);
    for (std::size_t j = 0; j <= k; ++j) {
      off_axis = off_axis + r.y[j] * r.y[k - j] + r.z[j] * r.z[k - j];
      square1 = square1 + offset(x1, j) * offset(x1, k - j);
      square2 = square2 + offset(x2, j) * offset(x2, k - j);
    }
    s1[k] = square1 + off_axis;
    s2[k] = square2 + off_axis;
    u1[k] = next_power(s1, u1, k);
    u2[k] = next_power(s2, u2, k);

    Vector3<S> pull{S(0), S(0), S(0)};
    for (std::size_t j = 0; j <= k; ++j) {
      const S p1 = rest * u1[k - j], p2 = mu * u2[k - j];
      pull.x = pull.x + p1 * offset(x1, j) + p2 * offset(x2, j);
      pull.y = pull.y + (p1 + p2) * r.y[j];
      pull.z = pull.z + (p1 + p2) * r.z[j];
    }
    const S twice = S(2) * count(k + 1), divisor = count((k + 1) * (k + 2));
    r.x[k + 2] = (twice * r.y[k + 1] + r.x[k] - pull.x) / divisor;
    r.y[k + 2] = (r.y[k] - twice * r.x[k + 1] - pull.y) / divisor;
    r.z[k + 2] = -pull.z / divisor;
  }
  return r;
}

/// Position, velocity, acceleration, jerk and snap of the motion through `state`, with respect to
/// time in TU, from the equations of motion. Domain and accuracy as motion_series.
template <class S>
std::array<Vector3<S>, 5> motion_derivatives(const ThreeBodySystem& system,
                                             const OrbitState<S>& state) {
  const Vector3<Taylor<S, 4>> r = motion_series<4>(system, state);
  std::array<Vector3<S>, 5> jet;
  for (std::size_t k = 0; k < 5; ++k) {
    jet[k] = {r.x.derivative(k), r.y.derivative(k), r.z.derivative(k)};
  }
  return jet;
}

}  // namespace hodograph
