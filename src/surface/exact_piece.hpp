// SPDX-License-Identifier: MIT
// One piece of a motion as the products that exact surfaces are made of.
#pragma once

#include <cstddef>

#include "hodograph/bernstein/dynamic_polynomial.hpp"
#include "hodograph/surface/motion.hpp"

namespace hodograph::surface_detail {

/// The piece's products that patches and tracks are made of.
struct ExactPiece {
  DynamicPolynomial<double> weight;               // |B|²
  DynamicPolynomial<Vector3<double>> center;      // |B|² c
  DynamicPolynomial<Vector3<double>> e1, e2, e3;  // λ B i B*, λ B j B*, λ B k B*
};

inline ExactPiece exact_piece(const MotionPiece& piece) {
  using Q = Quaternion<double>;
  const auto form = [](std::size_t j) {
    // The polar form of the quadratic map B -> B e_j B*.
    return [j](const Q& a, const Q& b) {
      const Q unit{0.0, j == 0 ? 1.0 : 0.0, j == 1 ? 1.0 : 0.0, j == 2 ? 1.0 : 0.0};
      return vector_part(a * unit * conjugate(b));
    };
  };
  const auto along = [&](std::size_t j) {
    return scaled_product(piece.scale, product(piece.preimage, piece.preimage, form(j)));
  };
  ExactPiece exact;
  exact.weight =
      product(piece.preimage, piece.preimage, [](const Q& a, const Q& b) { return dot(a, b); });
  exact.center = scaled_product(
      exact.weight,
      piece.displacement.mapped([&](const Vector3<double>& d) { return piece.start + d; }));
  exact.e1 = along(0);
  exact.e2 = along(1);
  exact.e3 = along(2);
  return exact;
}

inline MotionPiece restricted(const MotionPiece& piece, double a, double b) {
  MotionPiece part = piece;
  part.begin = piece.begin + a * (piece.end - piece.begin);
  part.end = piece.begin + b * (piece.end - piece.begin);
  part.displacement = piece.displacement.restricted(a, b);
  part.preimage = piece.preimage.restricted(a, b);
  part.scale = piece.scale.restricted(a, b);
  return part;
}

}  // namespace hodograph::surface_detail
