// SPDX-License-Identifier: MIT
// Adapted frames: the Euler-Rodrigues frame (ERF) that the preimage carries, turned about the
// tangent by a roll angle θ(ξ). One notion; Frenet, periodic and other frames differ only in θ.
//
//   e₂ = cos θ e₂ᴱᴿᶠ + sin θ e₃ᴱᴿᶠ,  e₃ = cos θ e₃ᴱᴿᶠ - sin θ e₂ᴱᴿᶠ    (roll positive from e₂ to
//   e₃)
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/curve/preimage_jet.hpp"
#include "hodograph/foundation/fault.hpp"
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

/// The body rate χ and its derivatives of a frame that is rolled by θ(ξ), from those of the frame
/// before and from θ, θ', ..., θ^(count) at the point. With c = χ₂ + i χ₃ and g = e^(-iθ):
/// χ₁ gains θ', and c becomes g c, where g^(r+1) = -i Σ_j C(r,j) θ^(j+1) g^(r-j).
template <class S, std::size_t count>
std::array<Vector3<S>, count> rolled_rates(const std::array<Vector3<S>, count>& chi,
                                           const std::array<S, count + 1>& theta) {
  using std::cos;
  using std::sin;
  const auto weight = [](std::size_t r, std::size_t j) {
    return S(static_cast<double>(binomial(r, j)));
  };
  std::array<Complex<S>, count> g;
  g[0] = {cos(theta[0]), -sin(theta[0])};
  for (std::size_t r = 0; r + 1 < count; ++r) {
    Complex<S> sum{};
    for (std::size_t j = 0; j <= r; ++j) sum += (weight(r, j) * theta[j + 1]) * g[r - j];
    g[r + 1] = {sum.im, -sum.re};
  }
  std::array<Vector3<S>, count> result;
  for (std::size_t r = 0; r < count; ++r) {
    Complex<S> across{};
    for (std::size_t j = 0; j <= r; ++j) {
      across += weight(r, j) * (g[r - j] * Complex<S>{chi[j].y, chi[j].z});
    }
    result[r] = {chi[r].x + theta[r + 1], across.re, across.im};
  }
  return result;
}

/// A roll that is linear in ξ: θ(ξ) = θ_0 + rate (ξ - ξ_0). It distributes the leftover roll of a
/// closed path evenly.
template <class S>
struct LinearRoll {
  S xi_begin{}, theta_begin{}, rate{};
  constexpr S angle(const S& xi) const { return theta_begin + rate * (xi - xi_begin); }
  /// θ, θ', ..., θ^(K) at ξ.
  template <std::size_t K>
  constexpr std::array<S, K + 1> derivatives(const S& xi) const {
    std::array<S, K + 1> result{};
    result[0] = angle(xi);
    if constexpr (K > 0) result[1] = rate;
    return result;
  }
};

/// The ERF of a spatial path, turned by a roll θ(ξ) (none by default). A roll offers
/// derivatives<K>(ξ) -> θ, θ', ..., θ^(K) at ξ, as LinearRoll does.
///
/// The rates of rotation come in the four forms of angular_velocity.hpp, each with its derivatives
/// up to order K ≤ 2: with respect to ξ for the rates per ξ, to arc length for those per arc
/// length. Holds a reference: the path must outlive it. Domain: ξ inside the knots (throws
/// outside_domain) where the path moves (throws zero_speed).
template <class PathType, class RollFunction = LinearRoll<typename PathType::Scalar>>
class AdaptedFrame {
 public:
  using Scalar = typename PathType::Scalar;
  using Algebra = typename PathType::Algebra;
  using Vector = Vector3<Scalar>;
  template <std::size_t K>
  using Rates = std::array<Vector, K + 1>;

  explicit AdaptedFrame(const PathType& path, const RollFunction& roll = {})
      : path_(&path), roll_(roll) {}

  const RollFunction& roll() const { return roll_; }

  /// The frame R at ξ.
  Frame3<Scalar> at(const Scalar& xi) const {
    return rolled(euler_rodrigues_frame(jet<0>(xi)), roll_.template derivatives<0>(xi)[0]);
  }
  /// R, R', ..., R^(K) with respect to ξ.
  template <std::size_t K>
  std::array<Frame3<Scalar>, K + 1> derivatives(const Scalar& xi) const {
    if constexpr (K == 0) {
      return {at(xi)};
    } else {
      return frame_derivatives(at(xi), body_rate_per_xi_derivatives<K - 1>(xi));
    }
  }

  /// χ, radians per unit ξ.
  Vector body_rate_per_xi(const Scalar& xi) const { return body_rate_per_xi_derivatives<0>(xi)[0]; }
  template <std::size_t K>
  Rates<K> body_rate_per_xi_derivatives(const Scalar& xi) const {
    return rolled_rates(hodograph::body_rate_per_xi(jet<K + 1>(xi)),
                        roll_.template derivatives<K + 1>(xi));
  }
  /// ω = R χ, radians per unit ξ: that of the ERF plus θ' e₁, whatever θ.
  Vector world_rate_per_xi(const Scalar& xi) const {
    return world_rate_per_xi_derivatives<0>(xi)[0];
  }
  template <std::size_t K>
  Rates<K> world_rate_per_xi_derivatives(const Scalar& xi) const {
    const auto preimage = jet<K + 1>(xi);
    const auto theta = roll_.template derivatives<K + 1>(xi);
    const auto frame = euler_rodrigues_frame_derivatives(preimage);
    Rates<K> omega = hodograph::world_rate_per_xi(preimage);
    for (std::size_t r = 0; r <= K; ++r) {
      for (std::size_t j = 0; j <= r; ++j) {
        omega[r] += (Scalar(static_cast<double>(binomial(r, j))) * theta[j + 1]) * frame[r - j].e1;
      }
    }
    return omega;
  }

  /// χ/σ and ω/σ, radians per unit arc length.
  Vector body_rate_per_arc_length(const Scalar& xi) const {
    return body_rate_per_arc_length_derivatives<0>(xi)[0];
  }
  template <std::size_t K>
  Rates<K> body_rate_per_arc_length_derivatives(const Scalar& xi) const {
    return rate_detail::per_arc_length(jet<K + 1>(xi), body_rate_per_xi_derivatives<K>(xi));
  }
  Vector world_rate_per_arc_length(const Scalar& xi) const {
    return world_rate_per_arc_length_derivatives<0>(xi)[0];
  }
  template <std::size_t K>
  Rates<K> world_rate_per_arc_length_derivatives(const Scalar& xi) const {
    return rate_detail::per_arc_length(jet<K + 1>(xi), world_rate_per_xi_derivatives<K>(xi));
  }

 private:
  template <std::size_t K>
  PreimageJet<Algebra, K> jet(const Scalar& xi) const {
    const auto preimage = path_->template preimage_jet<K>(xi);
    if (!(Scalar(0) < speed_form(preimage[0], preimage[0]))) {
      throw Error(Fault{
          FaultCode::zero_speed,
          "the path stands still at xi = " + to_text(to_double(xi)) + ": no frame exists there",
          std::nullopt, "speed", 0.0, std::nullopt});
    }
    return preimage;
  }

  const PathType* path_;
  RollFunction roll_;
};

}  // namespace hodograph
