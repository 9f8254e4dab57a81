// SPDX-License-Identifier: MIT
// Everything differential about a PH curve at one point, from the preimage and its derivatives
// there.
//
// All derivatives are with respect to the global path parameter ξ unless the name says
// per_arc_length.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "hodograph/algebra/preimage_algebra.hpp"

namespace hodograph {

/// The preimage A and its derivatives A', ..., A^(K) with respect to ξ at one point.
template <PreimageAlgebra A, std::size_t K>
using PreimageJet = std::array<A, K + 1>;

/// The derivative of order r of a symmetric form of the preimage with itself, by Leibniz:
/// Σ_j C(r,j) form(A^(j), A^(r-j)).
template <class A, std::size_t size, class Form>
constexpr auto form_derivative(const std::array<A, size>& jet, std::size_t r, const Form& form) {
  using S = typename A::Scalar;
  auto sum = form(jet[0], jet[r]);
  if (r > 0) sum = S(2) * sum;
  S binomial_weight(1);
  for (std::size_t j = 1; 2 * j <= r; ++j) {
    binomial_weight =
        binomial_weight * S(static_cast<double>(r - j + 1)) / S(static_cast<double>(j));
    const S weight = 2 * j == r ? binomial_weight : S(2) * binomial_weight;
    sum = sum + weight * form(jet[j], jet[r - j]);
  }
  return sum;
}

/// The parametric speed σ = |A|² and its derivatives σ', ..., σ^(K).
template <class A, std::size_t size>
constexpr auto speed_derivatives(const std::array<A, size>& jet) {
  std::array<typename A::Scalar, size> sigma;
  for (std::size_t r = 0; r < size; ++r) {
    sigma[r] = form_derivative(jet, r, [](const A& a, const A& b) { return speed_form(a, b); });
  }
  return sigma;
}

/// The hodograph r' and its derivatives: r', r'', ..., r^(K+1), one more than the preimage has.
template <class A, std::size_t size>
constexpr auto hodograph_derivatives(const std::array<A, size>& jet) {
  std::array<point_t<A>, size> result;
  for (std::size_t r = 0; r < size; ++r) {
    result[r] =
        form_derivative(jet, r, [](const A& a, const A& b) { return hodograph_form(a, b); });
  }
  return result;
}

/// The unit tangent r'/σ. Domain: σ > 0.
template <class A, std::size_t size>
constexpr point_t<A> tangent(const std::array<A, size>& jet) {
  using S = typename A::Scalar;
  return (S(1) / speed_form(jet[0], jet[0])) * hodograph_form(jet[0], jet[0]);
}

/// The signed curvature of a planar curve, positive to the left: 2 Im(w* w')/σ². Domain: σ > 0.
template <class S, std::size_t size>
constexpr S curvature(const std::array<Complex<S>, size>& jet)
  requires(size >= 2)
{
  const S sigma = speed_form(jet[0], jet[0]);
  return S(2) * body_rate_form(jet[0], jet[1]) / (sigma * sigma);
}

/// The curvature κ = |r' × r''|/σ³ ≥ 0 of a space curve: with V = vec(A* A'), κ = 2 |(V₂, V₃)|/σ².
/// Domain: σ > 0. No differences of large terms occur; the error is a few ε |A'|/(|A| σ).
template <class S, std::size_t size>
S curvature(const std::array<Quaternion<S>, size>& jet)
  requires(size >= 2)
{
  using std::sqrt;
  const S sigma = speed_form(jet[0], jet[0]);
  const Vector3<S> v = body_rate_form(jet[0], jet[1]);
  return S(2) * sqrt(v.y * v.y + v.z * v.z) / (sigma * sigma);
}

/// The torsion (r' × r'')·r'''/|r' × r''|², where the curvature is not zero; nothing where it is.
/// With V = vec(A* A'): τ σ = 2 V₁/σ + (V₂ V₃' - V₃ V₂')/(V₂² + V₃²). Domain: σ > 0.
/// Source: the Frenet frame is the ERF rolled by atan2(-V₂, V₃); differentiate (errata (13c)).
template <class S, std::size_t size>
std::optional<S> torsion(const std::array<Quaternion<S>, size>& jet)
  requires(size >= 3)
{
  const S sigma = speed_form(jet[0], jet[0]);
  const Vector3<S> v = body_rate_form(jet[0], jet[1]);
  const Vector3<S> dv = body_rate_form(jet[0], jet[2]);  // A'* A' is real
  const S bend = v.y * v.y + v.z * v.z;
  if (!(S(0) < bend)) return std::nullopt;
  return (S(2) * v.x / sigma + (v.y * dv.z - v.z * dv.y) / bend) / sigma;
}

}  // namespace hodograph
