// SPDX-License-Identifier: MIT
// Frames of a rolled path in batches, a point in each lane; included by one source file for every
// instruction set, which defines HODOGRAPH_KERNEL_ISA (a namespace) and HODOGRAPH_KERNEL_LANES.
#pragma once

#include <array>
#include <cstddef>

#include "frame_lanes.hpp"
#include "hodograph/frame/detail/rolled_piece.hpp"

namespace hodograph::frame_detail {

namespace {

[[gnu::always_inline]] inline P load_some(const double* from, std::size_t count) {
  if (count >= lanes) return P::load(from);
  P result(from[0]);
  for (std::size_t i = 1; i < count; ++i) result.set(i, from[i]);
  return result;
}

bool frames(const RolledPiece& piece, std::size_t degree, const double* preimage, const double* xi,
            std::size_t count, double* out) {
  P least(1.0);
  for (std::size_t first = 0; first < count; first += lanes) {
    const std::size_t here = count - first < lanes ? count - first : lanes;
    const P x = (load_some(xi + first, here) - P(piece.xi)) * P(piece.scale);
    Quaternion<P> a{P(preimage[4 * degree]), P(preimage[4 * degree + 1]),
                    P(preimage[4 * degree + 2]), P(preimage[4 * degree + 3])};
    for (std::size_t k = degree; k-- > 0;) {
      const double* c = preimage + 4 * k;
      a = {multiply_add(a.w, x, P(c[0])), multiply_add(a.x, x, P(c[1])),
           multiply_add(a.y, x, P(c[2])), multiply_add(a.z, x, P(c[3]))};
    }
    const P x2 = x * x;
    P c, s;
    along_rotor(x * polynomial<rolled_degree>([&](std::size_t k) { return P(piece.half_roll[k]); },
                                              x, x2, x2 * x2),
                c, s);
    const auto turned = rolled_preimage(a, c, s);
    const P sigma = speed(turned);
    least = min(least, sigma);
    const std::array<P, 9> rows = axes(turned, sigma);
    if (here == lanes) {
      store_rows([&](std::size_t i) { return out + 9 * (first + i); }, rows);
    } else {
      for (std::size_t i = 0; i < here; ++i) {
        for (std::size_t k = 0; k < 9; ++k) out[9 * (first + i) + k] = rows[k][i];
      }
    }
  }
  return (P(0.0) < least).all();
}

}  // namespace

namespace HODOGRAPH_KERNEL_ISA {

RolledKernel rolled_kernel();
RolledKernel rolled_kernel() { return &frames; }

}  // namespace HODOGRAPH_KERNEL_ISA

}  // namespace hodograph::frame_detail
