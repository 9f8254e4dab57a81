// SPDX-License-Identifier: MIT
// Planar constructions, one problem in each lane; included by one source file for every instruction
// set, which defines HODOGRAPH_KERNEL_ISA (a namespace) and HODOGRAPH_KERNEL_LANES. The arithmetic
// is construction/detail/planar_hermite_kernel.hpp and prescribed_length_kernel.hpp, run on packs
// of types of this file alone.
#pragma once

#include <cstddef>

#include "hodograph/construction/detail/prescribed_length_kernel.hpp"
#include "hodograph/foundation/pack.hpp"

#if !defined(HODOGRAPH_KERNEL_ISA) || !defined(HODOGRAPH_KERNEL_LANES)
#error "define the instruction set and the number of lanes first"
#endif

namespace hodograph::planar_detail {
namespace {

struct ThisFile {};
constexpr std::size_t lanes = HODOGRAPH_KERNEL_LANES;
using P = Pack<lanes, ThisFile>;

/// Runs `solve` on rows of numbers in columns of lanes, to rows of 8; the first row fills up.
template <std::size_t width, class Solve>
[[gnu::always_inline]] inline void run(const double* in, std::size_t count, double* out,
                                       const Solve& solve) {
  for (std::size_t first = 0; first < count; first += lanes) {
    const std::size_t here = count - first < lanes ? count - first : lanes;
    alignas(64) double given[width][lanes];
    for (std::size_t i = 0; i < lanes; ++i) {
      const double* row = in + width * (first + (i < here ? i : 0));
      for (std::size_t c = 0; c < width; ++c) given[c][i] = row[c];
    }
    P numbers[width];
    for (std::size_t c = 0; c < width; ++c) numbers[c] = P::load(given[c]);
    P results[8];
    solve(numbers, results);
    alignas(64) double columns[8][lanes];
    for (std::size_t c = 0; c < 8; ++c) results[c].store(columns[c]);
    for (std::size_t i = 0; i < here; ++i) {
      for (std::size_t c = 0; c < 8; ++c) out[8 * (first + i) + c] = columns[c][i];
    }
  }
}

[[gnu::always_inline]] inline void hermite(const P* in, P* out) {
  const auto found = solve_hermite<P>({in[0], in[1]}, {in[2], in[3]}, {in[4], in[5]});
  const LeastTurn<P> best = least_turn(found);
  out[0] = found.w0.re;
  out[1] = found.w0.im;
  out[2] = best.w1.re;
  out[3] = best.w1.im;
  out[4] = best.w2.re;
  out[5] = best.w2.im;
  out[6] = best.turn;
  out[7] = best.next;
}

[[gnu::always_inline]] inline void prescribed_length(const P* in, P* out) {
  const auto ends = canonical_ends<P>({in[0], in[1]}, {in[2], in[3]}, {in[4], in[5]});
  const auto found = solve_length<P>(ends.s, ends.e, in[6] + ends.chord,
                                     excess_of<P>(in[6], {in[4], in[5]}, ends.chord));
  const auto second = found.turn[1] < found.turn[0];
  const Complex<P> w1{select(second, found.w1[1].re, found.w1[0].re),
                      select(second, found.w1[1].im, found.w1[0].im)};
  const Complex<P> placed[3] = {ends.turn * found.w0, ends.turn * w1, ends.turn * found.w2};
  for (std::size_t i = 0; i < 3; ++i) {
    out[2 * i] = placed[i].re;
    out[2 * i + 1] = placed[i].im;
  }
  out[6] = select(second, found.turn[1], found.turn[0]);
  out[7] = select(second, found.turn[0], found.turn[1]);
}

constexpr std::size_t few = lanes < 4 ? lanes : 4;
using Few = Pack<few, ThisFile>;
using Two = Pack<2, ThisFile>;

[[gnu::always_inline]] inline Two two(double first, double second) {
  Two result(first);
  result.set(1, second);
  return result;
}

/// The turns of both solutions and, as often as lanes are left, the turn from -|φs|/2 over 0 to
/// |φe|/2.
struct TurnsBeside {
  const Complex<Two>&s, &e;
  double* turns;

  [[gnu::always_inline]] void operator()(const LengthRoots<Two>& found) const {
    const auto row = [](const Two& solution, const Two& other, const Two& bound, std::size_t i) {
      Few lanes_of(i == 0 ? solution[0] : bound[0]);
      if (i == 0) lanes_of.set(1, other[0]);
      if constexpr (few == 4) {
        lanes_of.set(2, bound[0]);
        lanes_of.set(3, bound[0]);
      }
      return lanes_of;
    };
    const Two one(1.0), zero(0.0);
    for (std::size_t i = 0; i < 4; i += few) {
      path_detail::absolute_turn<Few>(
          {row(found.w0.re, found.w0.re, s.re, i), row(found.w0.im, found.w0.im, -abs(s.im), i)},
          {row(found.w1[0].re, found.w1[1].re, one, i),
           row(found.w1[0].im, found.w1[1].im, zero, i)},
          {row(found.w2.re, found.w2.re, e.re, i), row(found.w2.im, found.w2.im, abs(e.im), i)})
          .store(turns + i);
    }
  }
};

}  // namespace

namespace HODOGRAPH_KERNEL_ISA {

void hermite_run(const double* in, std::size_t count, double* out);
void hermite_run(const double* in, std::size_t count, double* out) {
  run<6>(in, count, out, [](const P* i, P* o) { hermite(i, o); });
}
void prescribed_length_run(const double* in, std::size_t count, double* out);
void prescribed_length_run(const double* in, std::size_t count, double* out) {
  run<7>(in, count, out, [](const P* i, P* o) { prescribed_length(i, o); });
}

// Both ends' half angles in two lanes, and without a branch: half the time of plain numbers.
void one_prescribed_length_run(const double* in, double* out);
void one_prescribed_length_run(const double* in, double* out) {
  const Complex<Two> directions{two(in[0], in[2]), two(in[1], in[3])}, chord{in[4], in[5]};
  const auto ends = canonical_ends<Two>(directions, directions, chord);
  const Complex<Two> s{ends.s.re[0], ends.s.im[0]}, e{ends.s.re[1], ends.s.im[1]};
  const auto found =
      solve_length<Two>(s, e, in[6] + ends.chord, excess_of<Two>(in[6], chord, ends.chord),
                        TurnsBeside{s, e, out + 10});
  const Complex<Two>* numbers[] = {&found.w0, &found.w1[0], &found.w1[1], &found.w2, &ends.turn};
  for (std::size_t i = 0; i < 5; ++i) {
    out[2 * i] = numbers[i]->re[0];
    out[2 * i + 1] = numbers[i]->im[0];
  }
}

void four_turns_run(const double* in, double* turns);
void four_turns_run(const double* in, double* turns) {
  for (std::size_t i = 0; i < 4; i += few) {
    const auto row = [&](std::size_t c) { return Few::load(in + 4 * c + i); };
    path_detail::absolute_turn<Few>({row(0), row(1)}, {row(2), row(3)}, {row(4), row(5)})
        .store(turns + i);
  }
}

}  // namespace HODOGRAPH_KERNEL_ISA
}  // namespace hodograph::planar_detail
