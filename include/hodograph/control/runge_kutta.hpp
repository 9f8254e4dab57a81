// SPDX-License-Identifier: MIT
// The classical Runge-Kutta step of order four, on any scalar.
#pragma once

#include <array>
#include <cstddef>

namespace hodograph {

/// The state a step h after x by the classical scheme for x' = f(τ, x):
///   k1 = f(τ, x), k2 = f(τ + h/2, x + h/2 k1), k3 = f(τ + h/2, x + h/2 k2), k4 = f(τ + h, x + h
///   k3), x + h/6 (k1 + 2 k2 + 2 k3 + k4).
/// f(double, const std::array<S, n>&) returns std::array<S, n>. Local error O(h⁵).
template <class S, std::size_t n, class F>
std::array<S, n> runge_kutta_step(const F& f, double tau, double h, const std::array<S, n>& x) {
  const auto moved = [&x](double step, const std::array<S, n>& slope) {
    std::array<S, n> result;
    for (std::size_t i = 0; i < n; ++i) result[i] = x[i] + S(step * slope[i]);
    return result;
  };
  const double half = h / 2.0;
  const std::array<S, n> k1 = f(tau, x);
  const std::array<S, n> k2 = f(tau + half, moved(half, k1));
  const std::array<S, n> k3 = f(tau + half, moved(half, k2));
  const std::array<S, n> k4 = f(tau + h, moved(h, k3));
  std::array<S, n> result;
  for (std::size_t i = 0; i < n; ++i) {
    const S middle = k2[i] + k3[i];
    result[i] = x[i] + S((h / 6.0) * S(k1[i] + k4[i] + middle + middle));
  }
  return result;
}

}  // namespace hodograph
