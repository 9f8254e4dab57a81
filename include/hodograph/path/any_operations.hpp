// SPDX-License-Identifier: MIT
// Paths made from paths whose dimension and degree are known only when the program runs: what
// path/operations.hpp offers, for AnyPath. Formulas, faults and accuracy are those of the functions
// of the same names there; what is said here is added. Compiled once, in the library.
#pragma once

#include <cstddef>
#include <span>

#include "hodograph/algebra/quaternion.hpp"
#include "hodograph/algebra/vector.hpp"
#include "hodograph/path/any_path.hpp"

namespace hodograph {

Result<AnyPath> reversed(const AnyPath& path);
Result<AnyPath> subpath(const AnyPath& path, double xi_a, double xi_b);

/// First `a`, then `b`, in the larger of their degrees.
/// Faults: unsupported (one planar, one spatial), and those of joined for paths of known type.
Result<AnyPath> joined(const AnyPath& a, const AnyPath& b);

Result<AnyPath> with_closure(const AnyPath& path, bool closed);
Result<AnyPath> reparametrised(const AnyPath& path, double begin, double end);

/// The same path with its preimage written in degree m.
/// Faults: outside_domain (m below the path's, or above maximum_dynamic_degree).
Result<AnyPath> with_preimage_degree(const AnyPath& path, std::size_t m);

/// Turned by a unit quaternion and shifted. Faults: unsupported (a planar path).
Result<AnyPath> moved(const AnyPath& path, const Quaternion<double>& rotation,
                      const Vector3<double>& translation);
/// Turned by an angle (radians) about the origin and shifted. Faults: unsupported (a spatial path).
Result<AnyPath> moved(const AnyPath& path, double angle, const Vector2<double>& translation);

Result<AnyPath> scaled(const AnyPath& path, double c);

/// Mirrored in the plane, or line, through a point with a normal of any length.
/// Faults: mismatched_size (vectors of another dimension than the path's).
Result<AnyPath> reflected(const AnyPath& path, std::span<const double> normal,
                          std::span<const double> point);

/// A planar path in the plane z = 0 of space. Faults: unsupported (a spatial path).
Result<AnyPath> lifted(const AnyPath& path);

}  // namespace hodograph
