// SPDX-License-Identifier: MIT
// The circular restricted three-body problem in its rotating frame: constants, potential, motion.
//
// Two primaries circle their barycentre at rate 1; the frame turns with them about +z. In units of
// their distance and of (period / 2π) the larger one (Earth) rests at (-μ, 0, 0), the smaller one
// (Moon) at (1-μ, 0, 0), where μ is the smaller one's share of the mass. Everything here is
// templated on the scalar: double, long double, multiprecision, Taylor.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/foundation/fault.hpp"
#include "hodograph/foundation/scalar.hpp"

namespace hodograph {

/// The constants of one pair of primaries.
struct ThreeBodySystem {
  double mass_ratio{};      ///< μ = m_smaller / (m_larger + m_smaller), in (0, 1/2]
  double length_unit_km{};  ///< kilometres in one length unit (LU), the primaries' distance
  double time_unit_s{};     ///< seconds in one time unit (TU): the primaries turn by 1 rad

  friend constexpr bool operator==(const ThreeBodySystem&, const ThreeBodySystem&) = default;
};

/// Earth and Moon as in the JPL three-body periodic orbit catalogue (units rounded to 1 km, 1 s).
inline constexpr ThreeBodySystem earth_moon_system{0.01215058560962404, 389703.0, 382981.0};

/// Why a system cannot be used (μ outside (0, 1/2], a unit that is not positive), if so.
std::optional<Fault> check_system(const ThreeBodySystem& system);

/// Position (LU) and velocity (LU/TU) in the rotating frame.
template <class S>
struct OrbitState {
  Vector3<S> position;
  Vector3<S> velocity;

  friend constexpr bool operator==(const OrbitState&, const OrbitState&) = default;
};

/// The vector from the larger primary to a point: (x + μ, y, z).
template <class S>
constexpr Vector3<S> offset_from_larger(const ThreeBodySystem& system, const Vector3<S>& position) {
  return {position.x + S(system.mass_ratio), position.y, position.z};
}

/// The vector from the smaller primary to a point: ((x - 1) + μ, y, z); the first difference is
/// exact for 1/2 ≤ x ≤ 2, so nothing is lost near the primary.
template <class S>
constexpr Vector3<S> offset_from_smaller(const ThreeBodySystem& system,
                                         const Vector3<S>& position) {
  return {(position.x - S(1)) + S(system.mass_ratio), position.y, position.z};
}

/// The pseudo-potential Ω = (x² + y²)/2 + (1-μ)/r₁ + μ/r₂ (LU²/TU²), r₁ and r₂ the distances from
/// the larger and the smaller primary. Infinite at the primaries. Exact to rounding.
template <class S>
S pseudo_potential(const ThreeBodySystem& system, const Vector3<S>& position) {
  const S mu(system.mass_ratio);
  const S r1 = norm(offset_from_larger(system, position));
  const S r2 = norm(offset_from_smaller(system, position));
  return (position.x * position.x + position.y * position.y) / S(2) + (S(1) - mu) / r1 + mu / r2;
}

/// The gradient of Ω (LU/TU²): the centrifugal and both gravitational accelerations.
/// Undefined at the primaries. Exact to rounding.
template <class S>
Vector3<S> pseudo_potential_gradient(const ThreeBodySystem& system, const Vector3<S>& position) {
  const S mu(system.mass_ratio);
  const Vector3<S> d1 = offset_from_larger(system, position);
  const Vector3<S> d2 = offset_from_smaller(system, position);
  const S q1 = dot(d1, d1), q2 = dot(d2, d2);
  const S pull1 = (S(1) - mu) / (q1 * norm(d1)), pull2 = mu / (q2 * norm(d2));
  return {position.x - pull1 * d1.x - pull2 * d2.x, position.y - (pull1 + pull2) * position.y,
          -((pull1 + pull2) * position.z)};
}

/// The Hessian of Ω (1/TU²), row by row and symmetric; it drives the variational equations
/// δr'' = H δr + 2 δr' × e_z. With m the mass and d the offset of a primary, its share is
/// m (3 d dᵀ/|d|⁵ - 1/|d|³); the rotation adds diag(1, 1, 0). Exact to rounding.
template <class S>
std::array<Vector3<S>, 3> pseudo_potential_hessian(const ThreeBodySystem& system,
                                                   const Vector3<S>& position) {
  const S mu(system.mass_ratio);
  const auto share = [](const S& mass, const Vector3<S>& d, std::array<Vector3<S>, 3>& rows) {
    const S q = dot(d, d);
    const S pull = mass / (q * norm(d));
    const S stretch = S(3) * pull / q;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) rows[i][j] = rows[i][j] + stretch * (d[i] * d[j]);
      rows[i][i] = rows[i][i] - pull;
    }
  };
  std::array<Vector3<S>, 3> rows{};
  rows[0].x = S(1);
  rows[1].y = S(1);
  share(S(1) - mu, offset_from_larger(system, position), rows);
  share(mu, offset_from_smaller(system, position), rows);
  return rows;
}

/// The equations of motion: r'' = ∇Ω(r) + 2 (y', -x', 0) (LU/TU²). Undefined at the primaries.
template <class S>
Vector3<S> three_body_acceleration(const ThreeBodySystem& system, const OrbitState<S>& state) {
  const Vector3<S> gradient = pseudo_potential_gradient(system, state.position);
  const Vector3<S>& v = state.velocity;
  return {gradient.x + (v.y + v.y), gradient.y - (v.x + v.x), gradient.z};
}

/// The Jacobi constant C = 2Ω - |r'|² (LU²/TU²), conserved along every motion.
template <class S>
S jacobi_constant(const ThreeBodySystem& system, const OrbitState<S>& state) {
  return S(2) * pseudo_potential(system, state.position) - dot(state.velocity, state.velocity);
}

}  // namespace hodograph
