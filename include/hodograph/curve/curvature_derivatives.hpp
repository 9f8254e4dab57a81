// SPDX-License-Identifier: MIT
// The curvature of a PH curve and how it changes along it, from the preimage and its derivatives.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "hodograph/curve/preimage_jet.hpp"

namespace hodograph {

namespace curve_detail {

/// vec(A* A')^(r), r ≤ 2, where the form is zero on the diagonal: vec(A* A''), and
/// vec(A* A''') + vec(A'* A'').
template <class A, std::size_t size>
constexpr auto turning_derivative(const std::array<A, size>& jet, std::size_t r) {
  const auto first = body_rate_form(jet[0], jet[r + 1]);
  return r < 2 ? first : first + body_rate_form(jet[1], jet[2]);
}

/// κ, κ', κ'' from f, f', f'' with κ σ² = 2 f, by the quotient rule.
template <class S, std::size_t count>
constexpr std::array<S, count> over_squared_speed(const std::array<S, count>& f,
                                                  const std::array<S, count>& sigma) {
  std::array<S, count> kappa{};
  const S square = sigma[0] * sigma[0];
  kappa[0] = S(2) * f[0] / square;
  if constexpr (count > 1) {
    const S rate = S(2) * (sigma[0] * sigma[1]);
    kappa[1] = (S(2) * f[1] - rate * kappa[0]) / square;
    if constexpr (count > 2) {
      const S second = S(2) * (sigma[0] * sigma[2] + sigma[1] * sigma[1]);
      kappa[2] = (S(2) * f[2] - (S(2) * rate) * kappa[1] - second * kappa[0]) / square;
    }
  }
  return kappa;
}

template <std::size_t count, class S, std::size_t size>
constexpr std::array<S, count> first_of(const std::array<S, size>& all) {
  std::array<S, count> some{};
  for (std::size_t r = 0; r < count; ++r) some[r] = all[r];
  return some;
}

}  // namespace curve_detail

/// The signed curvature of a planar curve and its derivatives with respect to ξ, as many as the jet
/// has beyond the first (at most κ''): κ σ² = 2 Im(w* w'), by the quotient rule. The first is
/// curvature(jet), bit for bit. Domain: σ > 0. Accuracy: a few ε times the largest term of the
/// rule. Source: derivation above.
template <class S, std::size_t size>
constexpr std::array<S, size - 1> curvature_derivatives(const std::array<Complex<S>, size>& jet)
  requires(size >= 2 && size <= 4)
{
  std::array<S, size - 1> turning{};
  for (std::size_t r = 0; r + 1 < size; ++r) {
    turning[r] = curve_detail::turning_derivative(jet, r);
  }
  return curve_detail::over_squared_speed(turning,
                                          curve_detail::first_of<size - 1>(speed_derivatives(jet)));
}

/// The same for a space curve: κ σ² = 2 q, q = |(V₂, V₃)|, V = vec(A* A'); q' = (V₂ V₂' + V₃ V₃')/q
/// and q q'' = V₂'² + V₃'² + V₂ V₂'' + V₃ V₃'' - q'². Nothing where derivatives are asked for and
/// the curvature is zero: it has a corner there, as |x| has.
template <class S, std::size_t size>
std::optional<std::array<S, size - 1>> curvature_derivatives(
    const std::array<Quaternion<S>, size>& jet)
  requires(size >= 2 && size <= 4)
{
  using std::sqrt;
  const Vector3<S> v = body_rate_form(jet[0], jet[1]);
  std::array<S, size - 1> q{};
  q[0] = sqrt(v.y * v.y + v.z * v.z);
  if constexpr (size > 2) {
    if (!(S(0) < q[0])) return std::nullopt;
    const Vector3<S> dv = curve_detail::turning_derivative(jet, 1);
    q[1] = (v.y * dv.y + v.z * dv.z) / q[0];
    if constexpr (size > 3) {
      const Vector3<S> ddv = curve_detail::turning_derivative(jet, 2);
      q[2] = ((dv.y * dv.y + dv.z * dv.z) + (v.y * ddv.y + v.z * ddv.z) - q[1] * q[1]) / q[0];
    }
  }
  return curve_detail::over_squared_speed(q,
                                          curve_detail::first_of<size - 1>(speed_derivatives(jet)));
}

}  // namespace hodograph
