// SPDX-License-Identifier: MIT
// Places near a path by its own coordinates: progress ξ and the offset η across it.
//
//   space:  p = r(ξ) + η₂ e₂ + η₃ e₃      h = σ - η₂ χ₃ + η₃ χ₂
//   plane:  p = r(ξ) + η e₂               h = σ - η χ
// With v = dp/dt and ξ̇ = (v · e₁)/h:
//   space:  η̇₂ = v · e₂ + ξ̇ χ₁ η₃,  η̇₃ = v · e₃ - ξ̇ χ₁ η₂;   plane:  η̇ = v · e₂.
// Regular where h > 0: inside the tube of offset_limits. Derivation: differentiate p with
// e₁' = χ₃ e₂ - χ₂ e₃ and its cyclic fellows (frame/angular_velocity.hpp).
#pragma once

#include <array>
#include <cstddef>

#include "hodograph/control/reference_path.hpp"

namespace hodograph {

/// h.
template <class S>
S progress_stretch(const ReferenceValue<Quaternion<double>, S>& at, const std::array<S, 2>& eta) {
  return at.speed - eta[0] * at.body_rate.z + eta[1] * at.body_rate.y;
}
template <class S>
S progress_stretch(const ReferenceValue<Complex<double>, S>& at, const std::array<S, 1>& eta) {
  return at.speed - eta[0] * at.body_rate;
}

/// p.
template <class S>
Vector3<S> place_of(const ReferenceValue<Quaternion<double>, S>& at, const std::array<S, 2>& eta) {
  return at.position + (eta[0] * at.frame.e2 + eta[1] * at.frame.e3);
}
template <class S>
Vector2<S> place_of(const ReferenceValue<Complex<double>, S>& at, const std::array<S, 1>& eta) {
  return at.position + eta[0] * at.frame.e2;
}

/// (ξ̇, η̇₂, η̇₃) of a point with velocity v.
template <class S>
std::array<S, 3> coordinate_rates(const ReferenceValue<Quaternion<double>, S>& at,
                                  const std::array<S, 2>& eta, const Vector3<S>& v) {
  const S progress = dot(v, at.frame.e1) / progress_stretch(at, eta);
  const S turn = progress * at.body_rate.x;
  return {progress, dot(v, at.frame.e2) + turn * eta[1], dot(v, at.frame.e3) - turn * eta[0]};
}
/// (ξ̇, η̇).
template <class S>
std::array<S, 2> coordinate_rates(const ReferenceValue<Complex<double>, S>& at,
                                  const std::array<S, 1>& eta, const Vector2<S>& v) {
  return {dot(v, at.frame.e1) / progress_stretch(at, eta), dot(v, at.frame.e2)};
}

}  // namespace hodograph
