// SPDX-License-Identifier: MIT
// The Frenet frame of a path, where its curvature is more than rounding.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include "hodograph/foundation/accuracy.hpp"
#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// Tangent, principal normal and binormal at one point, with the curvature κ > 0 and the torsion τ
/// by which they turn: e₁' = κ e₂, e₂' = -κ e₁ + τ e₃, e₃' = -τ e₂ per unit arc length.
template <class S>
struct FrenetState {
  Frame3<S> frame{};
  S curvature{}, torsion{};
  S roll{};  ///< of this frame against the ERF, radians in (-π, π]

  /// χ = (τ, 0, κ), radians per unit arc length.
  Vector3<S> body_rate_per_arc_length() const { return {torsion, S(0), curvature}; }
  /// The Darboux vector τ e₁ + κ e₃.
  Vector3<S> world_rate_per_arc_length() const { return torsion * frame.e1 + curvature * frame.e3; }
};

/// The Frenet frame at ξ, where it exists. With V = vec(A* A') the normal has the direction
/// (V₃, -V₂) in the ERF, so it exists where |(V₂, V₃)| exceeds what rounding alone makes of it:
/// |A| δ₁ + |A'| δ₀ with δ₀ = accuracy::evaluation_error(n) · M, δ₁ = δ₀ · 2n/h, the errors of A
/// and A' evaluated from coefficients of size M. On a straight segment, at an inflection, and where
/// the path stands still there is none. Domain: ξ inside the knots (throws outside_domain).
/// Accuracy: the angle of the normal within the ratio of that error to |(V₂, V₃)|.
template <class S, std::size_t n>
std::optional<FrenetState<S>> frenet(const SpatialPath<n, S>& path, const S& xi) {
  using std::atan2;
  using std::sqrt;
  const auto at = path.locate(xi);
  const auto& curve = path.segment(at.segment);
  const auto jet = curve.template preimage_jet<2>(at.u);
  const S sigma = speed_form(jet[0], jet[0]);
  if (!(S(0) < sigma)) return std::nullopt;

  S largest(0);
  for (const auto& c : curve.preimage().coefficients()) {
    if (const S size = norm(c); largest < size) largest = size;
  }
  const S error = S(accuracy::evaluation_error<S>(n)) * largest;
  const S derivative_error = error * S(2.0 * static_cast<double>(n)) / curve.parameter_step();
  const Vector3<S> v = body_rate_form(jet[0], jet[1]);
  const S bend = sqrt(S(v.y * v.y + v.z * v.z));
  if (!(sqrt(sigma) * derivative_error + norm(jet[1]) * error < bend)) return std::nullopt;

  const Frame3<S> erf = euler_rodrigues_frame(jet);
  const S c = v.z / bend, s = -v.y / bend;
  const auto tau = torsion(jet);
  if (!tau) return std::nullopt;
  return FrenetState<S>{{erf.e1, c * erf.e2 + s * erf.e3, c * erf.e3 - s * erf.e2},
                        curvature(jet),
                        *tau,
                        S(atan2(-v.y, v.z))};
}

}  // namespace hodograph
