// SPDX-License-Identifier: MIT
// C⁴ Hermite segments, one in each lane; included by one source file for every instruction set,
// which defines HODOGRAPH_KERNEL_ISA (a namespace) and HODOGRAPH_KERNEL_LANES. The arithmetic is
// construction/detail/hermite_kernel.hpp, run on packs of a type of this file alone.
#pragma once

#include <array>
#include <cstddef>

#include "hodograph/construction/detail/hermite_kernel.hpp"
#include "hodograph/foundation/pack.hpp"

#if !defined(HODOGRAPH_KERNEL_ISA) || !defined(HODOGRAPH_KERNEL_LANES)
#error "define the instruction set and the number of lanes first"
#endif

namespace hodograph {

namespace hermite_detail {
namespace {

struct ThisFile {};
constexpr std::size_t lanes = HODOGRAPH_KERNEL_LANES;
constexpr std::size_t longest = 64;
using P = Pack<lanes, ThisFile>;

/// The jets at all points of a run, component by component, padded by a register.
using Jets = std::array<std::array<double, longest + 1 + lanes>, 16>;

[[gnu::always_inline]] inline EndJet<P, 4> jets_from(const Jets& jets, std::size_t first) {
  EndJet<P, 4> result;
  for (std::size_t c = 0; c < 16; ++c) result[c / 4][c % 4] = P::load(&jets[c][first]);
  return result;
}

/// points: 15 numbers each; out: 40 numbers a segment.
void run(const double* points, const double* steps, double square, std::size_t count, double* out) {
  const std::size_t last_point = count;
  Jets jets;
  for (std::size_t first = 0; first <= last_point; first += lanes) {
    std::array<Vector3<P>, 4> derivatives;
    for (std::size_t i = 0; i < lanes; ++i) {
      const double* from = points + 15 * (first + i < last_point ? first + i : last_point) + 3;
      for (std::size_t c = 0; c < 12; ++c) derivatives[c / 3][c % 3].set(i, from[c]);
    }
    for (auto& d : derivatives) d = P(square) * d;
    const EndJet<P, 4> jet = end_jet<4, P>(derivatives.data(), RotationMinimising{});
    for (std::size_t c = 0; c < 16; ++c) jet[c / 4][c % 4].store(&jets[c][first]);
  }
  for (std::size_t first = 0; first < count; first += lanes) {
    const std::size_t here = count - first < lanes ? count - first : lanes;
    P h(steps[first]);
    Vector3<P> chord;
    for (std::size_t i = 0; i < lanes; ++i) {
      const std::size_t k = first + (i < here ? i : 0);
      h.set(i, steps[k]);
      for (std::size_t c = 0; c < 3; ++c) {
        chord[c].set(i, points[15 * (k + 1) + c] - points[15 * k + c]);
      }
    }
    const auto segment = twist_free_segment<P, 4>(
        jets_from(jets, first), jets_from(jets, first + 1), h, (P(square) / h) * chord);
    std::array<P, 40> numbers;
    for (std::size_t c = 0; c < 36; ++c) numbers[c] = segment.preimage[c / 4][c % 4];
    numbers[36] = segment.roll.cosine;
    numbers[37] = segment.roll.sine;
    numbers[38] = segment.excess;
    numbers[39] = segment.closeness;
    alignas(64) double columns[40][lanes];
    for (std::size_t c = 0; c < 40; ++c) numbers[c].store(columns[c]);
    for (std::size_t i = 0; i < here; ++i) {
      for (std::size_t c = 0; c < 40; ++c) out[40 * (first + i) + c] = columns[c][i];
    }
  }
}

}  // namespace

namespace HODOGRAPH_KERNEL_ISA {

void twist_free_run(const double* points, const double* steps, double square, std::size_t count,
                    double* out);
void twist_free_run(const double* points, const double* steps, double square, std::size_t count,
                    double* out) {
  run(points, steps, square, count, out);
}

}  // namespace HODOGRAPH_KERNEL_ISA
}  // namespace hermite_detail
}  // namespace hodograph
