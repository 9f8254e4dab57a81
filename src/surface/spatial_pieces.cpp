// SPDX-License-Identifier: MIT
#include "spatial_pieces.hpp"

#include "hodograph/algebra/preimage_algebra.hpp"

namespace hodograph::surface_detail {

std::vector<SpatialPiece> spatial_pieces(const PathNumbers& numbers) {
  const std::size_t count = numbers.knots.size() - 1, n = numbers.preimage_degree;
  const bool planar = numbers.dimension == 2;
  const std::size_t parts = numbers.components_per_coefficient();
  std::vector<SpatialPiece> pieces(count);
  for (std::size_t k = 0; k < count; ++k) {
    SpatialPiece& piece = pieces[k];
    piece.begin = numbers.knots[k];
    piece.end = numbers.knots[k + 1];
    const double* start = numbers.starts.data() + k * numbers.dimension;
    piece.start = {start[0], start[1], planar ? 0.0 : start[2]};
    const double* preimage = numbers.preimages.data() + k * (n + 1) * parts;
    std::vector<Quaternion<double>> coefficients(n + 1);
    for (std::size_t i = 0; i <= n; ++i) {
      const double* c = preimage + i * parts;
      coefficients[i] = planar ? Quaternion<double>{c[0], 0.0, 0.0, c[1]}
                               : Quaternion<double>{c[0], c[1], c[2], c[3]};
    }
    piece.preimage = DynamicPolynomial<Quaternion<double>>(std::move(coefficients));
    const auto hodograph = product(piece.preimage, piece.preimage,
                                   [](const Quaternion<double>& a, const Quaternion<double>& b) {
                                     return hodograph_form(a, b);
                                   });
    piece.displacement = (piece.end - piece.begin) * hodograph.antiderivative();
  }
  return pieces;
}

}  // namespace hodograph::surface_detail
