// SPDX-License-Identifier: MIT
// Frames in packs: what the frame kernels of one instruction set share. Included by them after
// HODOGRAPH_KERNEL_LANES is defined; everything here belongs to the including file alone.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/foundation/pack.hpp"

#if !defined(HODOGRAPH_KERNEL_ISA) || !defined(HODOGRAPH_KERNEL_LANES)
#error "define the instruction set and the number of lanes first"
#endif
#if HODOGRAPH_KERNEL_LANES == 8 && defined(__AVX512F__)
#include <immintrin.h>
#define HODOGRAPH_FUSED _mm512_fmadd_pd
#elif HODOGRAPH_KERNEL_LANES == 4 && defined(__FMA__)
#include <immintrin.h>
#define HODOGRAPH_FUSED _mm256_fmadd_pd
#endif

namespace hodograph::frame_detail {

namespace {

struct ThisFile {};
constexpr std::size_t lanes = HODOGRAPH_KERNEL_LANES;
using P = Pack<lanes, ThisFile>;

// Bodies of `repeat`, all in one function: registers keep what they share. The address sanitizer,
// which looks at every access for itself, would take GCC minutes that way.
#if defined(__SANITIZE_ADDRESS__)
#define INLINED
#else
#define INLINED __attribute__((always_inline))
#endif

/// body(0), ..., body(count - 1) with indices that the compiler knows: no loop is left.
template <std::size_t count, class Body>
INLINED inline void repeat(const Body& body) {
  [&]<std::size_t... i>(std::index_sequence<i...>) INLINED {
    (body(std::integral_constant<std::size_t, i>{}), ...);
  }(std::make_index_sequence<count>{});
}

/// a b + c, rounded once where the instruction set can (the frames are within their bounds either
/// way; nothing else depends on it).
[[gnu::always_inline]] inline P multiply_add(const P& a, const P& b, const P& c) {
#if defined(HODOGRAPH_FUSED)
  P::Lanes x, y, z;
  __builtin_memcpy(&x, &a, sizeof(x));
  __builtin_memcpy(&y, &b, sizeof(y));
  __builtin_memcpy(&z, &c, sizeof(z));
  return P(P::Lanes(HODOGRAPH_FUSED(x, y, z)));
#else
  return a * b + c;
#endif
}

/// Σ c(k) x^k, count a multiple of 4: four sums over every fourth k side by side, so that the
/// processor need not wait for one.
template <std::size_t count, class Coefficient>
[[gnu::always_inline]] inline P polynomial(const Coefficient& c, const P& x, const P& x2,
                                           const P& x4) {
  static_assert(count % 4 == 0);
  std::array<P, 4> part{c(count - 4), c(count - 3), c(count - 2), c(count - 1)};
#pragma GCC unroll 8
  for (std::size_t k = count - 4; k > 0; k -= 4) {
#pragma GCC unroll 4
    for (std::size_t i = 0; i < 4; ++i) part[i] = multiply_add(part[i], x4, c(k - 4 + i));
  }
  return multiply_add(x2, multiply_add(x, part[3], part[2]), multiply_add(x, part[1], part[0]));
}

/// c + i s = λ e^(iy) with some λ near 1, for |y| ≤ π/8 and a little more: numerator and
/// denominator of the continued fraction of the tangent, y/(1 - y²/(3 - y²/(5 - ... - y²/13))).
/// The next quotient changes y by at most y^15/(15 (13!!)²), below 2^-57 of y.
[[gnu::always_inline]] inline void along_rotor(const P& y, P& c, P& s) {
  constexpr double unit = 135135.0;  // 13!!
  const P z = y * y;
  c = multiply_add(z, P(-28.0 / unit), P(3150.0 / unit));
  c = multiply_add(z, multiply_add(z, c, P(-62370.0 / unit)), P(1.0));
  s = multiply_add(z, P(-1.0 / unit), P(378.0 / unit));
  s = y * multiply_add(z, multiply_add(z, s, P(-17325.0 / unit)), P(1.0));
}

/// A (c + i s).
[[gnu::always_inline]] inline Quaternion<P> rolled_preimage(const Quaternion<P>& a, const P& c,
                                                            const P& s) {
  const P minus = -s;
  return {multiply_add(a.w, c, a.x * minus), multiply_add(a.x, c, a.w * s),
          multiply_add(a.y, c, a.z * s), multiply_add(a.z, c, a.y * minus)};
}

/// |A|².
[[gnu::always_inline]] inline P speed(const Quaternion<P>& a) {
  return multiply_add(a.w, a.w, multiply_add(a.x, a.x, multiply_add(a.y, a.y, a.z * a.z)));
}

/// The axes that A carries, of length 1, whatever the length of A: nine numbers. σ = |A|² > 0.
/// With B = A √(2/σ): 1 - (y² + z²), x y + w z, ...
[[gnu::always_inline]] inline std::array<P, 9> axes(const Quaternion<P>& a, const P& sigma) {
  const P scale = P(2.0) / sigma, one(1.0);
  const P w = scale * a.w, x = scale * a.x, y = scale * a.y, z = scale * a.z;
  const P wx = w * a.x, wy = w * a.y, wz = w * a.z;
  const P minus_x = -x, minus_y = -y, minus_z = -z;
  return {multiply_add(minus_y, a.y, multiply_add(minus_z, a.z, one)),
          multiply_add(x, a.y, wz),
          multiply_add(x, a.z, -wy),
          multiply_add(x, a.y, -wz),
          multiply_add(minus_x, a.x, multiply_add(minus_z, a.z, one)),
          multiply_add(y, a.z, wx),
          multiply_add(x, a.z, wy),
          multiply_add(y, a.z, -wx),
          multiply_add(minus_x, a.x, multiply_add(minus_y, a.y, one))};
}

typedef double Four __attribute__((vector_size(32)));
typedef double Eight __attribute__((vector_size(64)));
/// The numbers at these places of a and b, one after the other.
template <int... places, class Numbers>
[[gnu::always_inline]] inline Numbers picked(const Numbers& a, const Numbers& b) {
#if defined(__clang__)
  return __builtin_shufflevector(a, b, places...);
#else
  return __builtin_shuffle(a, b, decltype(Numbers{} < Numbers{}){places...});
#endif
}

/// Stores the lanes of 9 packs as rows of 9 numbers at to(0), to(1), ...: blocks are turned round
/// in registers where there are enough lanes.
template <class Place>
[[gnu::always_inline]] inline void store_rows(const Place& to, const std::array<P, 9>& from) {
  if constexpr (lanes == 8) {
    Eight r[8];
    for (std::size_t k = 0; k < 8; ++k) __builtin_memcpy(&r[k], &from[k], sizeof(Eight));
    // Pairs of rows by even and odd lanes, then four rows, then eight.
    Eight even[4], odd[4];
#pragma GCC unroll 4
    for (std::size_t k = 0; k < 4; ++k) {
      even[k] = picked<0, 8, 2, 10, 4, 12, 6, 14>(r[2 * k], r[2 * k + 1]);
      odd[k] = picked<1, 9, 3, 11, 5, 13, 7, 15>(r[2 * k], r[2 * k + 1]);
    }
    Eight block[4][2];
#pragma GCC unroll 2
    for (std::size_t h = 0; h < 2; ++h) {
      block[0][h] = picked<0, 1, 8, 9, 4, 5, 12, 13>(even[2 * h], even[2 * h + 1]);
      block[1][h] = picked<0, 1, 8, 9, 4, 5, 12, 13>(odd[2 * h], odd[2 * h + 1]);
      block[2][h] = picked<2, 3, 10, 11, 6, 7, 14, 15>(even[2 * h], even[2 * h + 1]);
      block[3][h] = picked<2, 3, 10, 11, 6, 7, 14, 15>(odd[2 * h], odd[2 * h + 1]);
    }
#pragma GCC unroll 4
    for (std::size_t i = 0; i < 4; ++i) {
      const Eight low = picked<0, 1, 2, 3, 8, 9, 10, 11>(block[i][0], block[i][1]);
      const Eight high = picked<4, 5, 6, 7, 12, 13, 14, 15>(block[i][0], block[i][1]);
      __builtin_memcpy(to(i), &low, sizeof(Eight));
      __builtin_memcpy(to(i + 4), &high, sizeof(Eight));
    }
#pragma GCC unroll 8
    for (std::size_t i = 0; i < lanes; ++i) to(i)[8] = from[8][i];
  } else if constexpr (lanes == 4) {
    Four r[8];
    for (std::size_t k = 0; k < 8; ++k) __builtin_memcpy(&r[k], &from[k], sizeof(Four));
#pragma GCC unroll 2
    for (std::size_t k = 0; k < 8; k += 4) {
      const Four low01 = picked<0, 4, 2, 6>(r[k], r[k + 1]);
      const Four high01 = picked<1, 5, 3, 7>(r[k], r[k + 1]);
      const Four low23 = picked<0, 4, 2, 6>(r[k + 2], r[k + 3]);
      const Four high23 = picked<1, 5, 3, 7>(r[k + 2], r[k + 3]);
      const Four turned[4] = {picked<0, 1, 4, 5>(low01, low23), picked<0, 1, 4, 5>(high01, high23),
                              picked<2, 3, 6, 7>(low01, low23), picked<2, 3, 6, 7>(high01, high23)};
#pragma GCC unroll 4
      for (std::size_t i = 0; i < 4; ++i) __builtin_memcpy(to(i) + k, &turned[i], sizeof(Four));
    }
#pragma GCC unroll 4
    for (std::size_t i = 0; i < lanes; ++i) to(i)[8] = from[8][i];
  } else {
#pragma GCC unroll 2
    for (std::size_t i = 0; i < lanes; ++i) {
      for (std::size_t k = 0; k < 9; ++k) to(i)[k] = from[k][i];
    }
  }
}

}  // namespace

}  // namespace hodograph::frame_detail
