// SPDX-License-Identifier: MIT
// The functions of a path at several places at once, a place in each lane; included by one source
// file for every instruction set, which defines HODOGRAPH_KERNEL_ISA (a namespace) and
// HODOGRAPH_KERNEL_LANES.
//
// Everything here is in an unnamed namespace or a template over a type of one, and so is compiled
// for this file alone. Operations and their order are those of ReferencePath::at: the same bits.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "../reference_jet.hpp"
#include "hodograph/foundation/pack.hpp"

#if !defined(HODOGRAPH_KERNEL_ISA) || !defined(HODOGRAPH_KERNEL_LANES)
#error "define the instruction set and the number of lanes first"
#endif

namespace hodograph::control_detail {

namespace {

struct ThisFile {};
constexpr std::size_t lanes = HODOGRAPH_KERNEL_LANES;
using P = Pack<lanes, ThisFile>;
using Lanes = P::Lanes;
using Truths = P::Mask::Lanes;
using Row = std::array<P, row>;

template <class Register>
[[gnu::always_inline]] inline Register load(const double* from) {
  Register result;
  __builtin_memcpy(&result, from, sizeof result);
  return result;
}
template <class Register>
[[gnu::always_inline]] inline void store(const Register& value, double* to) {
  __builtin_memcpy(to, &value, sizeof value);
}

/// Four numbers of each lane, from `at` places on: columns of the lanes' rows.
[[gnu::always_inline]] inline Row load_rows(const std::array<const double*, lanes>& from,
                                            std::size_t at) {
#if HODOGRAPH_KERNEL_LANES == 8
  using Half = Registers<4>::Numbers;
  const auto two = [&](std::size_t a, std::size_t b) {
    return __builtin_shufflevector(load<Half>(from[a] + at), load<Half>(from[b] + at), 0, 1, 2, 3,
                                   4, 5, 6, 7);
  };
  const Lanes a = two(0, 2), b = two(1, 3), c = two(4, 6), d = two(5, 7);
  const Lanes even_ab = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lanes odd_ab = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  const Lanes even_cd = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lanes odd_cd = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
  return {P(Lanes(__builtin_shufflevector(even_ab, even_cd, 0, 1, 4, 5, 8, 9, 12, 13))),
          P(Lanes(__builtin_shufflevector(odd_ab, odd_cd, 0, 1, 4, 5, 8, 9, 12, 13))),
          P(Lanes(__builtin_shufflevector(even_ab, even_cd, 2, 3, 6, 7, 10, 11, 14, 15))),
          P(Lanes(__builtin_shufflevector(odd_ab, odd_cd, 2, 3, 6, 7, 10, 11, 14, 15)))};
#elif HODOGRAPH_KERNEL_LANES == 4
  const Lanes a = load<Lanes>(from[0] + at), b = load<Lanes>(from[1] + at);
  const Lanes c = load<Lanes>(from[2] + at), d = load<Lanes>(from[3] + at);
  const Lanes even_ab = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Lanes odd_ab = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes even_cd = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Lanes odd_cd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return {P(Lanes(__builtin_shufflevector(even_ab, even_cd, 0, 1, 4, 5))),
          P(Lanes(__builtin_shufflevector(odd_ab, odd_cd, 0, 1, 4, 5))),
          P(Lanes(__builtin_shufflevector(even_ab, even_cd, 2, 3, 6, 7))),
          P(Lanes(__builtin_shufflevector(odd_ab, odd_cd, 2, 3, 6, 7)))};
#else
  Row result;
  for (std::size_t k = 0; k < row; k += 2) {
    const Lanes a = load<Lanes>(from[0] + at + k), b = load<Lanes>(from[1] + at + k);
    result[k] = P(Lanes(__builtin_shufflevector(a, b, 0, 2)));
    result[k + 1] = P(Lanes(__builtin_shufflevector(a, b, 1, 3)));
  }
  return result;
#endif
}

/// The inverse, for twice as many: eight numbers of each lane to `to` + lane · stride.
[[gnu::always_inline]] inline void store_rows(const Lanes* v, double* to, std::size_t stride) {
#if HODOGRAPH_KERNEL_LANES == 8
  // Pairs of numbers, then fours of two lanes each, then the lanes' rows.
  Lanes even[4], odd[4];
  for (std::size_t k = 0; k < 4; ++k) {
    even[k] = __builtin_shufflevector(v[2 * k], v[2 * k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    odd[k] = __builtin_shufflevector(v[2 * k], v[2 * k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  const auto put = [&](const Lanes* pairs, std::size_t lane) {
    const Lanes low = __builtin_shufflevector(pairs[0], pairs[1], 0, 1, 8, 9, 2, 3, 10, 11);
    const Lanes low2 = __builtin_shufflevector(pairs[2], pairs[3], 0, 1, 8, 9, 2, 3, 10, 11);
    const Lanes high = __builtin_shufflevector(pairs[0], pairs[1], 4, 5, 12, 13, 6, 7, 14, 15);
    const Lanes high2 = __builtin_shufflevector(pairs[2], pairs[3], 4, 5, 12, 13, 6, 7, 14, 15);
    const auto halves = [&](const Lanes& a, const Lanes& b, std::size_t first) {
      store(__builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11), to + first * stride);
      store(__builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15), to + (first + 2) * stride);
    };
    halves(low, low2, lane);
    halves(high, high2, lane + 4);
  };
  put(even, 0);
  put(odd, 1);
#elif HODOGRAPH_KERNEL_LANES == 4
  for (std::size_t k = 0; k < 8; k += 4) {
    const Lanes even_xy = __builtin_shufflevector(v[k], v[k + 1], 0, 4, 2, 6);
    const Lanes odd_xy = __builtin_shufflevector(v[k], v[k + 1], 1, 5, 3, 7);
    const Lanes even_zw = __builtin_shufflevector(v[k + 2], v[k + 3], 0, 4, 2, 6);
    const Lanes odd_zw = __builtin_shufflevector(v[k + 2], v[k + 3], 1, 5, 3, 7);
    store(__builtin_shufflevector(even_xy, even_zw, 0, 1, 4, 5), to + k);
    store(__builtin_shufflevector(odd_xy, odd_zw, 0, 1, 4, 5), to + stride + k);
    store(__builtin_shufflevector(even_xy, even_zw, 2, 3, 6, 7), to + 2 * stride + k);
    store(__builtin_shufflevector(odd_xy, odd_zw, 2, 3, 6, 7), to + 3 * stride + k);
  }
#else
  for (std::size_t k = 0; k < 8; k += 2) {
    store(__builtin_shufflevector(v[k], v[k + 1], 0, 2), to + k);
    store(__builtin_shufflevector(v[k], v[k + 1], 1, 3), to + stride + k);
  }
#endif
}

/// A jet as the list of its numbers.
template <std::size_t dimension>
struct Numbers {
  Lanes all[jet_numbers<dimension>];
  std::size_t count = 0;

  [[gnu::always_inline]] void add(const P& x) { all[count++] = std::bit_cast<Lanes>(x); }
  template <class V>
  [[gnu::always_inline]] void add_vector(const V& v) {
    for (std::size_t i = 0; i < V::dimension; ++i) add(v[i]);
  }
  template <class Jet>
  [[gnu::always_inline]] explicit Numbers(const Jet& jet) {
    for (const auto& p : jet.position) add_vector(p);
    for (const auto& f : jet.frame) {
      add_vector(f.e1);
      add_vector(f.e2);
      if constexpr (dimension == 3) add_vector(f.e3);
    }
    for (const auto& chi : jet.body_rate) {
      if constexpr (dimension == 3) {
        add_vector(chi);
      } else {
        add(chi);
      }
    }
    for (const P& sigma : jet.speed) add(sigma);
  }
};

/// Coefficients of lanes that lie in at most two segments.
struct TwoRows {
  const double *first, *last;
  P::Mask in_last;
  [[gnu::always_inline]] Row operator()(std::size_t at) const {
    Row result;
    for (std::size_t i = 0; i < row; ++i) {
      result[i] = select(in_last, P(last[at + i]), P(first[at + i]));
    }
    return result;
  }
};
/// Of lanes in any segments.
struct ManyRows {
  std::array<const double*, lanes> from;
  [[gnu::always_inline]] Row operator()(std::size_t at) const { return load_rows(from, at); }
};

/// The preimage with three derivatives by ξ, and the position, by Horner's rule: two steps for the
/// position with each of the preimage, so that neither waits for itself.
template <class A, class Rows>
[[gnu::always_inline]] inline void polynomials(std::size_t n, const Rows& preimage,
                                               const Rows& integral, const P& x, const P& inverse,
                                               PreimageJet<A, 3>& jet, point_t<A>& position) {
  constexpr std::size_t dimension = point_t<A>::dimension;
  const std::size_t m = 2 * n + 1;
  const auto step = [&](std::size_t k) {
    const Row c = integral(k * row);
    for (std::size_t i = 0; i < dimension; ++i) position[i] = x * position[i] + c[i];
  };
  {
    const Row a = preimage(n * row), p = integral(m * row);
    for (std::size_t i = 0; i < A::dimension; ++i) jet[0][i] = a[i];
    for (std::size_t i = 0; i < dimension; ++i) position[i] = p[i];
  }
  for (std::size_t k = n; k-- > 0;) {
    const Row c = preimage(k * row);
    for (std::size_t i = 0; i < A::dimension; ++i) {
      for (std::size_t r = 3; r > 0; --r) jet[r][i] = x * jet[r][i] + jet[r - 1][i];
      jet[0][i] = x * jet[0][i] + c[i];
    }
    step(2 * k + 2);
    step(2 * k + 1);
  }
  step(0);
  P scale = inverse;
  for (std::size_t r = 1; r <= 3; ++r) {
    if (r > 1) scale = scale * (P(static_cast<double>(r)) * inverse);
    jet[r] = scale * jet[r];
  }
}

template <std::size_t dimension>
[[gnu::flatten]] void jets(const ReferencePolynomials& path, const ReferencePlaces& places,
                           double* to) {
  using A = std::conditional_t<dimension == 2, Complex<P>, Quaternion<P>>;
  constexpr std::size_t numbers = jet_numbers<dimension>;
  const std::size_t n = path.degree, size = (n + 1) * row, twice = 2 * size;
  alignas(64) double rest[lanes * numbers];
  std::int64_t padded_segment[lanes];
  double padded_x[lanes], padded_inverse[lanes];
  for (std::size_t first = 0; first < places.count; first += lanes) {
    const std::size_t here = places.count - first < lanes ? places.count - first : lanes;
    const std::int64_t* segment = places.segment + first;
    const double* x_from = places.x + first;
    const double* inverse_from = places.inverse + first;
    if (here < lanes) {  // the last place again and again
      for (std::size_t i = 0; i < lanes; ++i) {
        const std::size_t k = i < here ? i : here - 1;
        padded_segment[i] = segment[k];
        padded_x[i] = x_from[k];
        padded_inverse[i] = inverse_from[k];
      }
      segment = padded_segment;
      x_from = padded_x;
      inverse_from = padded_inverse;
    }
    const P x = P::load(x_from), inverse = P::load(inverse_from);
    const auto begin = static_cast<std::size_t>(segment[0]);
    const auto end = static_cast<std::size_t>(segment[lanes - 1]);
    Truths all;
    __builtin_memcpy(&all, segment, sizeof all);
    const P::Mask in_last{all == segment[lanes - 1]}, in_first{all == segment[0]};
    PreimageJet<A, 3> jet{};
    point_t<A> position;
    if ((in_first || in_last).all()) {
      polynomials<A>(n,
                     TwoRows{path.preimages + begin * size, path.preimages + end * size, in_last},
                     TwoRows{path.integrals + begin * twice, path.integrals + end * twice, in_last},
                     x, inverse, jet, position);
    } else {
      ManyRows preimage, integral;
      for (std::size_t i = 0; i < lanes; ++i) {
        preimage.from[i] = path.preimages + static_cast<std::size_t>(segment[i]) * size;
        integral.from[i] = path.integrals + static_cast<std::size_t>(segment[i]) * twice;
      }
      polynomials<A>(n, preimage, integral, x, inverse, jet, position);
    }
    const Numbers<dimension> result(reference_jet(jet, position, path.progress_by));
    double* const target = here == lanes ? to + first * numbers : rest;
#pragma GCC unroll 6
    for (std::size_t g = 0; g < numbers; g += 8) store_rows(result.all + g, target + g, numbers);
    if (here < lanes) __builtin_memcpy(to + first * numbers, rest, here * numbers * sizeof(double));
  }
}

}  // namespace

namespace HODOGRAPH_KERNEL_ISA {

/// The kernels of this file.
const ReferenceKernels& reference_kernels();
const ReferenceKernels& reference_kernels() {
  static constexpr ReferenceKernels kernels{&jets<2>, &jets<3>};
  return kernels;
}

}  // namespace HODOGRAPH_KERNEL_ISA

}  // namespace hodograph::control_detail
