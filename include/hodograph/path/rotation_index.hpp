// SPDX-License-Identifier: MIT
// The absolute rotation index of planar curves, ∫|κ| ds, and the signed one, ∫κ ds: exact, and
// enclosed.
//
// The tangent angle is twice the argument of the preimage w, so both are sums of differences of
// arg w over the pieces between inflections, the roots of Im(w* w'). No root of w is needed: where
// the control polygon of w stays within a half-plane, arg w between two points is one arc tangent.
#pragma once

#include <concepts>
#include <cstddef>

#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// ∫|κ| ds, radians, between 0 and 2 π n: how much the tangent turns, to the left and to the right
/// together. Invariant under motions, scaling, reversal and any change of parameter.
///
/// Where w vanishes on the curve (a cusp, or a stop), the tangent may jump; the jump is not
/// counted. Accuracy: 32 ε for a quintic, some ε for each of the pieces (about the number of roots
/// of w and Im(w* w') near [0, 1]) in general, as far as the stored coefficients determine it:
/// where |w| falls to δ of its size, their rounding alone may turn w by ε/δ. Domain: finite
/// coefficients, any scale. Quintics (n = 2) take one arc tangent and no loop.
template <std::size_t n>
double absolute_rotation_index(const PlanarPhCurve<n>& curve);

/// ∫κ ds, radians, positive to the left: the angle by which the tangent turns from the start to the
/// end, full turns included. Otherwise as above.
template <std::size_t n>
double rotation_index(const PlanarPhCurve<n>& curve);

/// The sums over the segments of a path; a corner at a knot is not counted.
template <std::size_t n>
double absolute_rotation_index(const PlanarPath<n>& path);
template <std::size_t n>
double rotation_index(const PlanarPath<n>& path);

/// The same of the exact curves of the stored numbers, enclosed: rounding is included, and so is
/// what is not known about a zero of w, by which the index may change by 2π.
template <std::size_t n>
Enclosure absolute_rotation_index_enclosure(const PlanarPhCurve<n>& curve);
template <std::size_t n>
Enclosure rotation_index_enclosure(const PlanarPhCurve<n>& curve);
template <std::size_t n>
Enclosure absolute_rotation_index_enclosure(const PlanarPath<n>& path);
template <std::size_t n>
Enclosure rotation_index_enclosure(const PlanarPath<n>& path);

/// Both of a path, for the work of one.
struct RotationIndices {
  Enclosure absolute, with_sign;
};
template <std::size_t n>
RotationIndices rotation_index_enclosures(const PlanarPath<n>& path);

}  // namespace hodograph

#include "hodograph/path/detail/rotation_index_impl.hpp"
