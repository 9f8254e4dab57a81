// SPDX-License-Identifier: MIT
// Frames of a rolled path in batches, a point in each lane; included by one source file for every
// instruction set, which defines HODOGRAPH_KERNEL_ISA (a namespace) and HODOGRAPH_KERNEL_LANES.
#pragma once

#include <array>
#include <cstddef>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/foundation/pack.hpp"
#include "hodograph/frame/detail/rolled_piece.hpp"

#if !defined(HODOGRAPH_KERNEL_ISA) || !defined(HODOGRAPH_KERNEL_LANES)
#error "define the instruction set and the number of lanes first"
#endif

namespace hodograph::frame_detail {

namespace {

struct ThisFile {};
constexpr std::size_t lanes = HODOGRAPH_KERNEL_LANES;
using P = Pack<lanes, ThisFile>;

/// Σ c_k x^k, count a multiple of 4: four sums over every fourth k side by side, so that the
/// processor need not wait for one.
template <std::size_t count>
[[gnu::always_inline]] inline P polynomial(const double* c, const P& x, const P& x2, const P& x4) {
  static_assert(count % 4 == 0);
  std::array<P, 4> part{P(c[count - 4]), P(c[count - 3]), P(c[count - 2]), P(c[count - 1])};
#pragma GCC unroll 8
  for (std::size_t k = count - 4; k > 0; k -= 4) {
#pragma GCC unroll 4
    for (std::size_t i = 0; i < 4; ++i) part[i] = part[i] * x4 + P(c[k - 4 + i]);
  }
  return (part[0] + x * part[1]) + x2 * (part[2] + x * part[3]);
}

/// sin δ and cos δ for |δ| ≤ π/4 and a little more: Taylor's series, whose first terms left out are
/// δ^17/17! and δ^16/16!, below 2^-49 of an ulp of 1 and 2^-52.
[[gnu::always_inline]] inline void sine_cosine(const P& delta, P& sine, P& cosine) {
  // By z = -δ², from the low powers up.
  constexpr std::array<double, 8> s{1.0,
                                    1.0 / 6.0,
                                    1.0 / 120.0,
                                    1.0 / 5040.0,
                                    1.0 / 362880.0,
                                    1.0 / 39916800.0,
                                    1.0 / 6227020800.0,
                                    1.0 / 1307674368000.0};
  constexpr std::array<double, 8> c{
      1.0 / 2.0,       1.0 / 24.0,        1.0 / 720.0,         1.0 / 40320.0,
      1.0 / 3628800.0, 1.0 / 479001600.0, 1.0 / 87178291200.0, 1.0 / 20922789888000.0};
  const P z = -(delta * delta), z2 = z * z, z4 = z2 * z2;
  sine = delta * polynomial<8>(s.data(), z, z2, z4);
  cosine = P(1.0) + z * polynomial<8>(c.data(), z, z2, z4);
}

typedef double Four __attribute__((vector_size(32)));
/// The numbers at four places of a and b, one after the other.
template <int... places>
[[gnu::always_inline]] inline Four picked(const Four& a, const Four& b) {
#if defined(__clang__)
  return __builtin_shufflevector(a, b, places...);
#else
  return __builtin_shuffle(a, b, decltype(Four{} < Four{}){places...});
#endif
}

/// Stores the lanes of 9 packs as rows of 9 numbers: blocks of four by four are turned round in
/// registers where there are enough lanes.
[[gnu::always_inline]] inline void store_rows(double* to, const std::array<P, 9>& from) {
  alignas(64) double columns[9][lanes];
  for (std::size_t k = 0; k < 9; ++k) from[k].store(columns[k]);
  if constexpr (lanes % 4 == 0) {
#pragma GCC unroll 2
    for (std::size_t i = 0; i < lanes; i += 4) {
#pragma GCC unroll 2
      for (std::size_t k = 0; k < 8; k += 4) {
        Four row[4];
        for (std::size_t j = 0; j < 4; ++j) {
          __builtin_memcpy(&row[j], &columns[k + j][i], sizeof(Four));
        }
        const Four low01 = picked<0, 4, 2, 6>(row[0], row[1]);
        const Four high01 = picked<1, 5, 3, 7>(row[0], row[1]);
        const Four low23 = picked<0, 4, 2, 6>(row[2], row[3]);
        const Four high23 = picked<1, 5, 3, 7>(row[2], row[3]);
        const Four turned[4] = {
            picked<0, 1, 4, 5>(low01, low23), picked<0, 1, 4, 5>(high01, high23),
            picked<2, 3, 6, 7>(low01, low23), picked<2, 3, 6, 7>(high01, high23)};
        for (std::size_t j = 0; j < 4; ++j) {
          __builtin_memcpy(to + 9 * (i + j) + k, &turned[j], sizeof(Four));
        }
      }
      for (std::size_t j = 0; j < 4; ++j) to[9 * (i + j) + 8] = columns[8][i + j];
    }
  } else {
    for (std::size_t i = 0; i < lanes; ++i) {
      for (std::size_t k = 0; k < 9; ++k) to[9 * i + k] = columns[k][i];
    }
  }
}

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
      a = {a.w * x + P(c[0]), a.x * x + P(c[1]), a.y * x + P(c[2]), a.z * x + P(c[3])};
    }
    const P x2 = x * x;
    P sine, cosine;
    sine_cosine(x * polynomial<rolled_degree>(piece.roll, x, x2, x2 * x2), sine, cosine);
    const P c = P(piece.cosine) * cosine - P(piece.sine) * sine;
    const P s = P(piece.sine) * cosine + P(piece.cosine) * sine;

    const P sigma = speed_form(a, a);
    least = min(least, sigma);
    const P reciprocal = P(1.0) / sigma;
    const auto f = scaled_frame(a);
    const P along = reciprocal * c, across = reciprocal * s;
    const std::array<P, 9> rows{reciprocal * f.e1.x,
                                reciprocal * f.e1.y,
                                reciprocal * f.e1.z,
                                along * f.e2.x + across * f.e3.x,
                                along * f.e2.y + across * f.e3.y,
                                along * f.e2.z + across * f.e3.z,
                                along * f.e3.x - across * f.e2.x,
                                along * f.e3.y - across * f.e2.y,
                                along * f.e3.z - across * f.e2.z};
    if (here == lanes) {
      store_rows(out + 9 * first, rows);
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
