// SPDX-License-Identifier: MIT
// A sweep at one v, ready for many points of the profile.
#pragma once

#include <cmath>

#include "hodograph/surface/motion.hpp"

namespace hodograph::surface_detail {

/// S = c + N p, S_v = c' + M p, S_u = N p', with N = λ R and M = R (λ' + λ [χ]×).
class Ring {
 public:
  explicit Ring(const MotionState& state)
      : center_(state.position), velocity_(state.velocity), tangent_(state.frame.e1) {
    const Vector3<double>* e[3] = {&state.frame.e1, &state.frame.e2, &state.frame.e3};
    const Vector3<double>& chi = state.body_rate;
    const double s = state.scale, r = state.scale_rate;
    // The columns of λ' + λ [χ]×.
    const Vector3<double> m[3] = {
        {r, s * chi.z, -(s * chi.y)}, {-(s * chi.z), r, s * chi.x}, {s * chi.y, -(s * chi.x), r}};
    for (int j = 0; j < 3; ++j) {
      n_[j] = s * *e[j];
      m_[j] = m[j].x * *e[0] + m[j].y * *e[1] + m[j].z * *e[2];
    }
  }

  Vector3<double> position(const Vector3<double>& p) const { return center_ + times(n_, p); }
  Vector3<double> normal(const Vector3<double>& p, const Vector3<double>& derivative) const {
    const Vector3<double> along_u = times(n_, derivative);
    Vector3<double> across = cross(along_u, velocity_ + times(m_, p));
    double square = dot(across, across);
    if (!(square > 0.0) || !std::isfinite(square)) {
      across = cross(along_u, tangent_);
      square = dot(across, across);
      if (!(square > 0.0) || !std::isfinite(square)) return tangent_;
    }
    return (1.0 / std::sqrt(square)) * across;
  }
  const Vector3<double>& tangent() const { return tangent_; }

 private:
  static Vector3<double> times(const Vector3<double> (&columns)[3], const Vector3<double>& p) {
    return p.x * columns[0] + (p.y * columns[1] + p.z * columns[2]);
  }

  Vector3<double> center_, velocity_, tangent_;
  Vector3<double> n_[3], m_[3];
};

}  // namespace hodograph::surface_detail
