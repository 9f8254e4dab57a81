// SPDX-License-Identifier: MIT
// From the rotating frame of the three-body problem to the Earth-centred inertial one, and back.
//
// The rotating frame turns about +z at 1 rad/TU (one turn in 2π TU, the sidereal period of the
// primaries, whatever orbit is flown in it), and the larger primary rests in it at (-μ, 0, 0). The
// two frames' axes agree at t = 0:
//   X(t) = R_z(t) (x(t) + μ e_x).
// The origin itself circles the barycentre, so a motion seen from it obeys
//   X'' = -(1-μ) X/|X|³ - μ (X - M)/|X - M|³ - μ M,   M = (cos t, sin t, 0) the smaller primary.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/orbit/three_body.hpp"

namespace hodograph {

/// A position and its first N-1 derivatives with respect to time (TU).
template <class S, std::size_t N>
using MotionJet = std::array<Vector3<S>, N>;

namespace frame_detail {

/// The derivatives of R_z(±t) w(t) by Leibniz' rule. In the plane, as complex numbers,
///   (e^{±it} w)^(k) = e^{±it} Σ_j C(k, j) (±i)^{k-j} w^(j).
template <class S, std::size_t N>
MotionJet<S, N> rotate_jet(const MotionJet<S, N>& jet, const S& cosine, const S& sine, bool back) {
  MotionJet<S, N> result;
  for (std::size_t k = 0; k < N; ++k) {
    S re(0), im(0), binomial(1);
    for (std::size_t j = k + 1; j-- > 0;) {
      // Multiply w^(j) by (±i)^{k-j}: 0 nothing, 1 a quarter turn, 2 a half turn, 3 three quarters.
      const std::size_t turns = back ? (4 - (k - j) % 4) % 4 : (k - j) % 4;
      const S x = binomial * jet[j].x, y = binomial * jet[j].y;
      re = turns == 0 ? re + x : turns == 1 ? re - y : turns == 2 ? re - x : re + y;
      im = turns == 0 ? im + y : turns == 1 ? im + x : turns == 2 ? im - y : im - x;
      binomial = binomial * S(static_cast<double>(j)) / S(static_cast<double>(k - j + 1));
    }
    result[k] = back ? Vector3<S>{cosine * re + sine * im, cosine * im - sine * re, jet[k].z}
                     : Vector3<S>{cosine * re - sine * im, sine * re + cosine * im, jet[k].z};
  }
  return result;
}

}  // namespace frame_detail

/// The jet at time t (TU) of a motion given in the rotating frame, seen from the larger primary in
/// axes that do not turn. `cosine` and `sine` are those of t, given by whoever knows t to more
/// digits than S holds. Exact up to rounding.
template <class S, std::size_t N>
MotionJet<S, N> to_earth_centred_inertial(const ThreeBodySystem& system,
                                          const MotionJet<S, N>& rotating, const S& cosine,
                                          const S& sine) {
  static_assert(N >= 1);
  MotionJet<S, N> shifted = rotating;
  shifted[0] = offset_from_larger(system, rotating[0]);
  return frame_detail::rotate_jet(shifted, cosine, sine, false);
}
template <class S, std::size_t N>
MotionJet<S, N> to_earth_centred_inertial(const ThreeBodySystem& system,
                                          const MotionJet<S, N>& rotating, const S& time) {
  using std::cos;
  using std::sin;
  return to_earth_centred_inertial(system, rotating, S(cos(time)), S(sin(time)));
}

/// The inverse of to_earth_centred_inertial.
template <class S, std::size_t N>
MotionJet<S, N> from_earth_centred_inertial(const ThreeBodySystem& system,
                                            const MotionJet<S, N>& inertial, const S& time) {
  static_assert(N >= 1);
  using std::cos;
  using std::sin;
  MotionJet<S, N> result = frame_detail::rotate_jet(inertial, S(cos(time)), S(sin(time)), true);
  result[0].x = result[0].x - S(system.mass_ratio);
  return result;
}

/// Where the smaller primary is in the Earth-centred inertial frame: (cos t, sin t, 0) (LU).
template <class S>
Vector3<S> smaller_primary_inertial(const S& time) {
  using std::cos;
  using std::sin;
  return {S(cos(time)), S(sin(time)), S(0)};
}

}  // namespace hodograph
