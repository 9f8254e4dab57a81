// SPDX-License-Identifier: MIT
// The polynomials of a path's segments, in space and with degrees known at run time.
#pragma once

#include <vector>

#include "hodograph/algebra/quaternion.hpp"
#include "hodograph/bernstein/dynamic_polynomial.hpp"
#include "hodograph/path/any_path.hpp"

namespace hodograph::surface_detail {

/// A segment: r = start + displacement, dr/dξ = A i A*. A path of the plane lies in z = 0: with
/// w = a + bi it has A = a + b k, whose frame is (tangent, left normal, k).
struct SpatialPiece {
  double begin = 0.0, end = 1.0;
  Vector3<double> start{};
  DynamicPolynomial<Vector3<double>> displacement;  ///< degree 2n + 1, 0 at the begin
  DynamicPolynomial<Quaternion<double>> preimage;   ///< degree n
};

/// The displacement's coefficients are the path's own up to a few roundings.
std::vector<SpatialPiece> spatial_pieces(const PathNumbers& numbers);

}  // namespace hodograph::surface_detail
