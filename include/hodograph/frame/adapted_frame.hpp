// SPDX-License-Identifier: MIT
// Adapted frames: the Euler-Rodrigues frame (ERF) that the preimage carries, turned about the tangent
// by a roll angle θ(ξ). One notion; Frenet, periodic and other frames differ only in θ.
//
//   e₂ = cos θ e₂ᴱᴿᶠ + sin θ e₃ᴱᴿᶠ,  e₃ = cos θ e₃ᴱᴿᶠ - sin θ e₂ᴱᴿᶠ    (roll positive from e₂ to e₃)
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/curve/preimage_jet.hpp"
#include "hodograph/frame/angular_velocity.hpp"

namespace hodograph {

/// The ERF: in the plane (tangent, left normal). Domain: σ > 0. Orthonormal to a few ε.
template <class A, std::size_t size>
constexpr frame_t<A> euler_rodrigues_frame(const std::array<A, size>& jet) {
  using S = typename A::Scalar;
  return (S(1) / speed_form(jet[0], jet[0])) * scaled_frame(jet[0]);
}

/// R, R', ..., from a frame and its body rate χ, χ', ...: R' = R [χ]×,
/// R'' = R ([χ]×² + [χ']×), and so on by R^(r+1) = Σ_j C(r,j) R^(r-j) [χ^(j)]×.
template <class Frame, class Rate, std::size_t count>
constexpr std::array<Frame, count + 1> frame_derivatives(const Frame& frame,
                                                         const std::array<Rate, count>& chi) {
  using S = scalar_of_t<Rate>;
  std::array<Frame, count + 1> result;
  result[0] = frame;
  for (std::size_t r = 0; r < count; ++r) {
    result[r + 1] = frame_times_rate(result[r], chi[0]);
    for (std::size_t j = 1; j <= r; ++j) {
      result[r + 1] = result[r + 1] + S(static_cast<double>(binomial(r, j))) *
                                          frame_times_rate(result[r - j], chi[j]);
    }
  }
  return result;
}

/// The ERF and its derivatives with respect to ξ, as many as the jet of the preimage has.
template <class A, std::size_t size>
constexpr auto euler_rodrigues_frame_derivatives(const std::array<A, size>& jet) {
  return frame_derivatives(euler_rodrigues_frame(jet), body_rate_per_xi(jet));
}

/// A frame turned about its tangent by the roll θ.
template <class S>
Frame3<S> rolled(const Frame3<S>& frame, const S& theta) {
  using std::cos;
  using std::sin;
  const S c = cos(theta), s = sin(theta);
  return {frame.e1, c * frame.e2 + s * frame.e3, c * frame.e3 - s * frame.e2};
}

/// The body rate of a frame rolled by θ with rate θ': the tangential part gains θ', the others turn
/// by -θ.
template <class S>
Vector3<S> rolled_rate(const Vector3<S>& chi, const S& theta, const S& theta_rate) {
  using std::cos;
  using std::sin;
  const S c = cos(theta), s = sin(theta);
  return {chi.x + theta_rate, c * chi.y + s * chi.z, c * chi.z - s * chi.y};
}

/// The roll of the Frenet frame against the ERF, atan2(-χ₂, χ₃), where the curvature is not zero:
/// the normal is then (χ₃ e₂ - χ₂ e₃)/|...|.
template <class S, std::size_t size>
std::optional<S> frenet_roll(const std::array<Quaternion<S>, size>& jet)
  requires(size >= 2)
{
  using std::atan2;
  const Vector3<S> v = body_rate_form(jet[0], jet[1]);
  if (v.y == S(0) && v.z == S(0)) return std::nullopt;
  return atan2(-v.y, v.z);
}

/// The Frenet frame (tangent, principal normal, binormal), where the curvature is not zero.
template <class S, std::size_t size>
std::optional<Frame3<S>> frenet_frame(const std::array<Quaternion<S>, size>& jet)
  requires(size >= 2)
{
  using std::sqrt;
  const Vector3<S> v = body_rate_form(jet[0], jet[1]);
  const S bend = sqrt(v.y * v.y + v.z * v.z);
  if (!(S(0) < bend)) return std::nullopt;
  const Frame3<S> erf = euler_rodrigues_frame(jet);
  const S c = v.z / bend, s = -v.y / bend;
  return Frame3<S>{erf.e1, c * erf.e2 + s * erf.e3, c * erf.e3 - s * erf.e2};
}

/// A roll that is linear in ξ: θ(ξ) = θ_0 + rate (ξ - ξ_0). It distributes the leftover roll of a
/// closed path evenly.
template <class S>
struct LinearRoll {
  S xi_begin{}, theta_begin{}, rate{};
  constexpr S angle(const S& xi) const { return theta_begin + rate * (xi - xi_begin); }
};

/// The ERF of a path, turned by a linear roll (none by default).
template <class PathType>
class AdaptedFrame {
 public:
  using Scalar = typename PathType::Scalar;
  explicit AdaptedFrame(const PathType& path, const LinearRoll<Scalar>& roll = {})
      : path_(&path), roll_(roll) {}

  /// The frame at ξ.
  Frame3<Scalar> at(const Scalar& xi) const {
    return rolled(euler_rodrigues_frame(path_->template preimage_jet<0>(xi)), roll_.angle(xi));
  }
  /// Its body rate χ per unit ξ.
  Vector3<Scalar> body_rate_per_xi(const Scalar& xi) const {
    const auto chi = hodograph::body_rate_per_xi(path_->template preimage_jet<1>(xi));
    return rolled_rate(chi[0], roll_.angle(xi), roll_.rate);
  }
  const LinearRoll<Scalar>& roll() const { return roll_; }

 private:
  const PathType* path_;
  LinearRoll<Scalar> roll_;
};

}  // namespace hodograph
