// SPDX-License-Identifier: MIT
// Paths from paths: reversed, cut, joined, moved, scaled, mirrored, lifted, with other knots or
// degree.
//
// Each returns a new path whose preimage follows from the old one by a formula, so nothing is
// fitted and the PH property holds by construction. Accuracy: every coefficient within a few ε of
// the largest. Faults of all: those of Path::create (not_finite where the result overflows).
#pragma once

#include <algorithm>
#include <cstddef>

#include "hodograph/foundation/result.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

// ---- along the path ----------------------------------------------------------------------------

/// The path run backwards, ξ -> -ξ: r̃(ξ) = r(-ξ) on the knots -ξ_N < ... < -ξ_0. The negated knots
/// keep every parameter step to the last bit, and with it the continuity at the knots; use
/// reparametrised for another interval.
/// Preimage: A(1-u) j in space (the frame becomes -e₁, e₂, -e₃), i w(1-u) in the plane.
template <PreimageAlgebra A, std::size_t n>
Result<Path<A, n>> reversed(const Path<A, n>& path);

/// The part on [ξ_a, ξ_b], open, with its ξ unchanged: r̃(ξ) = r(ξ), knots ξ_a, those between, ξ_b.
/// Faults: outside_domain (ξ_a or ξ_b not a number inside the knots), not_increasing (ξ_a ≥ ξ_b).
template <PreimageAlgebra A, std::size_t n>
Result<Path<A, n>> subpath(const Path<A, n>& path, const typename A::Scalar& xi_a,
                           const typename A::Scalar& xi_b);

/// First `a`, then `b`, open, in the larger of their degrees. b's knots move by a.xi_end() -
/// b.xi_begin() (where that is zero they stay to the last bit); its place and shape do not.
/// In space b's preimage is multiplied on the right by the constant Q = conj(A_0ᵇ) A_nᵃ / |...|,
/// whose j and k parts vanish where the tangents agree: the frame, sign included, continues. In the
/// plane Q is ±1. The speed may jump at the join.
/// Faults (index: the knot of the join): not_continuous (a gap beyond accuracy::join_error, or
/// tangents that differ by more than accuracy::join_error times the largest preimage coefficients
/// over those at the join), zero_speed (no tangent at the join), not_increasing (knots so far from
/// zero that b's steps vanish in them).
template <PreimageAlgebra A, std::size_t m, std::size_t n>
Result<Path<A, std::max(m, n)>> joined(const Path<A, m>& a, const Path<A, n>& b);

/// The same path declared closed (or open).
/// Faults: not_continuous (index 0) where the end does not meet the start.
template <PreimageAlgebra A, std::size_t n>
Result<Path<A, n>> with_closure(const Path<A, n>& path, bool closed);

/// The same curve on [begin, end]: ξ̃ = begin + (ξ - ξ_0)(end - begin)/(ξ_N - ξ_0).
/// The preimage of segment k is multiplied by √(h_k/h̃_k), with the rounded steps: place, shape and
/// arc length stay; the jump of the preimage at a knot grows by the rounding ε|ξ̃|/h̃ of the knots.
/// Faults: not_finite, not_increasing (begin ≥ end, or knots that fall together).
template <PreimageAlgebra A, std::size_t n>
Result<Path<A, n>> reparametrised(const Path<A, n>& path, const typename A::Scalar& begin,
                                  const typename A::Scalar& end);

/// The same path with a preimage written in degree m ≥ n.
template <std::size_t m, PreimageAlgebra A, std::size_t n>
  requires(m >= n)
Result<Path<A, m>> with_preimage_degree(const Path<A, n>& path);

// ---- in space and in the plane -----------------------------------------------------------------

/// Turned by a unit quaternion q, then shifted by t: r -> q r q* + t, A -> q A.
/// Faults: not_finite, outside_domain (|q| differs from 1 by more than accuracy::unit_error; what
/// is left of the difference is divided out).
template <class S, std::size_t n>
Result<SpatialPath<n, S>> moved(const SpatialPath<n, S>& path, const Quaternion<S>& rotation,
                                const Vector3<S>& translation);

/// Turned about the origin by an angle α (radians, counter-clockwise), then shifted by t:
/// w -> (cos α/2 + i sin α/2) w. Faults: not_finite.
template <class S, std::size_t n>
Result<PlanarPath<n, S>> moved(const PlanarPath<n, S>& path, const S& angle,
                               const Vector2<S>& translation);

/// Scaled about the origin: r -> c r, A -> √c A.
/// Faults: outside_domain (c not a finite positive number).
template <PreimageAlgebra A, std::size_t n>
Result<Path<A, n>> scaled(const Path<A, n>& path, const typename A::Scalar& c);

/// Mirrored in the plane (in the plane: the line) through `point` with the given normal of any
/// length: r -> r - 2 ((r - point)·ν) ν, ν = normal/|normal|.
/// In space A -> ν A k: the frame becomes (mirrored e₁, mirrored e₂, minus mirrored e₃),
/// right-handed again. In the plane w -> i ν w*. Faults: not_finite, outside_domain (a normal of
/// length zero).
template <PreimageAlgebra A, std::size_t n>
Result<Path<A, n>> reflected(const Path<A, n>& path, const point_t<A>& normal,
                             const point_t<A>& point);

/// A planar path as a spatial one in the plane z = 0: (x, y) -> (x, y, 0). Its preimage is u + v k
/// for w = u + i v, since (u + v k) i (u - v k) = (u² - v²) i + 2uv j; the frame is (tangent, left
/// normal, z axis). `moved` takes it to any other plane.
template <class S, std::size_t n>
Result<SpatialPath<n, S>> lifted(const PlanarPath<n, S>& path);

}  // namespace hodograph

#include "hodograph/path/detail/operations_impl.hpp"
