// SPDX-License-Identifier: MIT
// The batch kernels, a point in each lane; included by one source file for every instruction set,
// which defines HODOGRAPH_KERNEL_ISA (a namespace) and HODOGRAPH_KERNEL_LANES.
//
// Everything here is in an unnamed namespace or a template over a type of one, and so is compiled
// for this file alone. Operations and their order are those of PhCurve::evaluate, of frame/
// path_state.hpp and of path/detail/arc_length_map_impl.hpp: the results have the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/foundation/pack.hpp"
#include "hodograph/path/detail/batch_kernels.hpp"

#if !defined(HODOGRAPH_KERNEL_ISA) || !defined(HODOGRAPH_KERNEL_LANES)
#error "define the instruction set and the number of lanes first"
#endif

namespace hodograph::batch_detail {

namespace {

struct ThisFile {};
constexpr std::size_t lanes = HODOGRAPH_KERNEL_LANES;
using P = Pack<lanes, ThisFile>;
using Mask = P::Mask;

template <std::size_t dimension>
using AlgebraOf = std::conditional_t<dimension == 2, Complex<P>, Quaternion<P>>;

template <std::size_t n>
consteval std::array<double, n + 1> binomial_row() {
  std::array<double, n + 1> row{};
  row[0] = 1.0;
  for (std::size_t m = 1; m <= n; ++m) {
    for (std::size_t i = m; i > 0; --i) row[i] += row[i - 1];
  }
  return row;
}

/// u^k and (1-u)^k, as UnitPowers.
template <std::size_t n>
struct Powers {
  std::array<P, n + 1> rising, falling;
  [[gnu::always_inline]] explicit Powers(const P& u) {
    rising[1] = u;
    falling[1] = P(1.0) - u;
#pragma GCC unroll 64
    for (std::size_t k = 2; k <= n; ++k) {
      rising[k] = rising[k / 2] * rising[k - k / 2];
      falling[k] = falling[k / 2] * falling[k - k / 2];
    }
  }
  /// B_i^m from the front, B_{m-i}^m from the back, i ≤ m/2.
  template <std::size_t m>
  [[gnu::always_inline]] P front(std::size_t i) const {
    if (i == 0) return falling[m];
    constexpr auto row = binomial_row<m>();
    return (P(row[i]) * rising[i]) * falling[m - i];
  }
  template <std::size_t m>
  [[gnu::always_inline]] P back(std::size_t i) const {
    if (i == 0) return rising[m];
    constexpr auto row = binomial_row<m>();
    return (P(row[i]) * falling[i]) * rising[m - i];
  }
};

/// `parts` numbers of Σ B_i^m c_i, with c_i at c + stride i: as weighted_sum.
template <std::size_t m, std::size_t parts, std::size_t stride, std::size_t n>
[[gnu::always_inline]] inline std::array<P, parts> sum(const Powers<n>& powers, const double* c) {
  std::array<P, parts> result;
  if constexpr (m == 0) {
    for (std::size_t k = 0; k < parts; ++k) result[k] = P(c[k]);
  } else {
    constexpr std::size_t half = (m + 1) / 2;
    std::array<P, parts> front, back;
    {
      const P f = powers.template front<m>(0), b = powers.template back<m>(0);
      for (std::size_t k = 0; k < parts; ++k) {
        front[k] = f * P(c[k]);
        back[k] = b * P(c[stride * m + k]);
      }
    }
    if constexpr (half % 2 == 0) {
      const P f = powers.template front<m>(1), b = powers.template back<m>(1);
      for (std::size_t k = 0; k < parts; ++k) {
        front[k] = front[k] + f * P(c[stride + k]);
        back[k] = back[k] + b * P(c[stride * (m - 1) + k]);
      }
    }
#pragma GCC unroll 64
    for (std::size_t i = 2 - half % 2; i < half; i += 2) {
      const P f = powers.template front<m>(i), b = powers.template back<m>(i);
      const P f2 = powers.template front<m>(i + 1), b2 = powers.template back<m>(i + 1);
      for (std::size_t k = 0; k < parts; ++k) {
        front[k] = front[k] + (f * P(c[stride * i + k]) + f2 * P(c[stride * (i + 1) + k]));
        back[k] = back[k] + (b * P(c[stride * (m - i) + k]) + b2 * P(c[stride * (m - i - 1) + k]));
      }
    }
    for (std::size_t k = 0; k < parts; ++k) result[k] = front[k] + back[k];
    if constexpr (m % 2 == 0) {
      const P f = powers.template front<m>(m / 2);
      for (std::size_t k = 0; k < parts; ++k)
        result[k] = result[k] + f * P(c[stride * (m / 2) + k]);
    }
  }
  return result;
}

/// A, dA/du and the integral at a pack of u; with_displacement as in PhCurve.
template <std::size_t dimension, std::size_t n>
struct Evaluation {
  static constexpr std::size_t points = dimension == 2 ? 2 : 3;
  AlgebraOf<dimension> preimage{}, rate{};
  std::array<P, points> displacement{};
  P length;

  [[gnu::always_inline]] Evaluation(const SegmentData& data, const P& u, bool with_displacement) {
    const Powers<2 * n + 1> powers(u);
    const auto left = sum<n - 1, dimension, dimension>(powers, data.preimage);
    const auto right = sum<n - 1, dimension, dimension>(powers, data.preimage + dimension);
    for (std::size_t k = 0; k < dimension; ++k) {
      preimage[k] = powers.falling[1] * left[k] + powers.rising[1] * right[k];
      rate[k] = P(static_cast<double>(n)) * (right[k] - left[k]);
    }
    if (with_displacement) {
      const auto all = sum<2 * n + 1, points + 1, points + 1>(powers, data.integral);
      for (std::size_t k = 0; k < points; ++k) displacement[k] = all[k];
      length = all[points];
    } else {
      length = sum<2 * n + 1, 1, points + 1>(powers, data.integral + points)[0];
    }
  }
};

/// Stores the first `count` lanes of `parts` packs as rows of `parts` numbers.
template <std::size_t parts>
[[gnu::always_inline]] inline void store_rows(double* to, const std::array<P, parts>& from,
                                              std::size_t count) {
  alignas(64) double columns[parts][lanes];
  for (std::size_t k = 0; k < parts; ++k) from[k].store(columns[k]);
  if (count == lanes) {
#pragma GCC unroll 8
    for (std::size_t i = 0; i < lanes; ++i) {
#pragma GCC unroll 16
      for (std::size_t k = 0; k < parts; ++k) to[i * parts + k] = columns[k][i];
    }
  } else {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < parts; ++k) to[i * parts + k] = columns[k][i];
    }
  }
}

/// The next `lanes` numbers, the last one repeated where fewer are left.
[[gnu::always_inline]] inline P load_some(const double* from, std::size_t count) {
  if (count >= lanes) return P::load(from);
  P result(from[0]);
  for (std::size_t i = 1; i < count; ++i) result.set(i, from[i]);
  return result;
}

template <std::size_t dimension, std::size_t n>
bool states(const SegmentData& data, const double* u, std::size_t count, const StateTargets& out) {
  constexpr std::size_t points = dimension == 2 ? 2 : 3;
  const bool oriented = out.frames != nullptr || out.rates != nullptr;
  const P inverse_step = P(1.0) / P(data.step);
  for (std::size_t first = 0; first < count; first += lanes) {
    const std::size_t here = count - first < lanes ? count - first : lanes;
    const P at = load_some(u + first, here);
    const Evaluation<dimension, n> e(data, at, true);
    const P sigma = speed_form(e.preimage, e.preimage);
    if (out.positions != nullptr) {
      std::array<P, points> position;
      for (std::size_t k = 0; k < points; ++k) position[k] = P(data.start[k]) + e.displacement[k];
      store_rows(out.positions + points * first, position, here);
    }
    if (out.speeds != nullptr) store_rows<1>(out.speeds + first, {sigma}, here);
    if (out.lengths != nullptr) {
      const P length = select(at == P(1.0), P(data.length_after), P(data.length_before) + e.length);
      store_rows<1>(out.lengths + first, {length}, here);
    }
    if (!oriented) continue;
    if (!(P(0.0) < sigma).all()) return false;
    const P reciprocal = P(1.0) / sigma;
    if (out.frames != nullptr) {
      const auto f = reciprocal * scaled_frame(e.preimage);
      if constexpr (dimension == 2) {
        store_rows<4>(out.frames + 4 * first, {f.e1.x, f.e1.y, f.e2.x, f.e2.y}, here);
      } else {
        store_rows<9>(out.frames + 9 * first,
                      {f.e1.x, f.e1.y, f.e1.z, f.e2.x, f.e2.y, f.e2.z, f.e3.x, f.e3.y, f.e3.z},
                      here);
      }
    }
    if (out.rates != nullptr) {
      const P scale = (P(2.0) * reciprocal) * inverse_step;
      const auto form = body_rate_form(e.preimage, e.rate);
      if constexpr (dimension == 2) {
        store_rows<1>(out.rates + first, {scale * form}, here);
      } else {
        store_rows<3>(out.rates + 3 * first, {scale * form.x, scale * form.y, scale * form.z},
                      here);
      }
    }
  }
  return true;
}

/// Steps of arc_length_map_impl.hpp.
struct LaneSteps {
  P rest, slope, newton, bend;
  template <class E>
  [[gnu::always_inline]] LaneSteps(const SegmentData& data, const E& e, const P& t) {
    rest = t - e.length;
    slope = P(data.step) * speed_form(e.preimage, e.preimage);
    const P reciprocal = P(1.0) / slope;
    const P turn = P(data.step) * speed_form(e.preimage, e.rate);
    newton = rest * reciprocal;
    bend = newton * (turn * reciprocal);
  }
  [[gnu::always_inline]] P halley() const { return newton / (P(1.0) + bend); }
  [[gnu::always_inline]] P small_step() const { return newton - newton * bend; }
};

struct LaneBracket {
  P low{0.0}, high{1.0};
  [[gnu::always_inline]] P next(const Mask& above, const P& u, const P& trial) {
    low = select(above, u, low);
    high = select(above, high, u);
    return select(low <= trial && trial <= high, trial, (low + high) * P(0.5));
  }
};

constexpr int lane_steps = 3;  // lanes that need more are settled one by one

[[gnu::always_inline]] inline void note(unsigned char* settled, const Mask& done,
                                        std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) settled[i] = done[i] ? 1 : 0;
}

template <std::size_t dimension, std::size_t n>
void points(const SegmentData& data, const double* t, const double* guess, std::size_t count,
            double* out, unsigned char* settled) {
  constexpr std::size_t size = dimension == 2 ? 2 : 3;
  const P reach(1.0 / static_cast<double>(1 << (std::numeric_limits<double>::digits / 3 + 1)));
  for (std::size_t first = 0; first < count; first += lanes) {
    const std::size_t here = count - first < lanes ? count - first : lanes;
    const P target = load_some(t + first, here);
    P u = load_some(guess + first, here);
    LaneBracket bracket;
    std::array<P, size> point{};
    Mask done = P(1.0) < P(0.0);
    for (int step = 0; step < lane_steps; ++step) {
      const Evaluation<dimension, n> e(data, u, true);
      const LaneSteps to(data, e, target);
      const P du = to.small_step();
      const Mask accept = !done && abs(to.newton) <= reach;
      const auto first_form = hodograph_form(e.preimage, e.preimage);
      const auto second_form = hodograph_form(e.preimage, e.rate);
      const P factor = P(data.step) * du;
      for (std::size_t k = 0; k < size; ++k) {
        const P value =
            P(data.start[k]) + (e.displacement[k] + factor * (first_form[k] + du * second_form[k]));
        point[k] = select(accept, value, point[k]);
      }
      done = done || accept;
      if (done.all()) break;
      u = select(done, u, bracket.next(P(0.0) < to.rest, u, u + to.halley()));
    }
    store_rows(out + size * first, point, here);
    note(settled + first, done, here);
  }
}

template <std::size_t dimension, std::size_t n>
void parameters(const SegmentData& data, double slack, const double* t, const double* guess,
                std::size_t count, double* out, unsigned char* settled) {
  constexpr double cells =
      static_cast<double>(std::int64_t{1} << (std::numeric_limits<double>::digits / 2 + 4));
  // Adding and taking away 2^52 rounds to a whole number.
  constexpr double whole = static_cast<double>(std::int64_t{1} << 52);
  const P width(1.0 / cells), margin(slack);
  for (std::size_t first = 0; first < count; first += lanes) {
    const std::size_t here = count - first < lanes ? count - first : lanes;
    const P target = load_some(t + first, here);
    P u = load_some(guess + first, here), result;
    LaneBracket bracket;
    Mask done = P(1.0) < P(0.0);
    for (int step = 0; step < lane_steps; ++step) {
      const P scaled = u * P(cells);
      const P nearest = (scaled + P(whole)) - P(whole);
      P node = select(scaled < nearest, nearest - P(1.0), nearest) * width;
      node = select(node < P(1.0), node, P(1.0) - width);
      const Evaluation<dimension, n> e(data, node, false);
      const LaneSteps to(data, e, target);
      const P beyond = to.slope * width - to.rest;
      const Mask right_of_node = margin < to.rest || (node == P(0.0) && !(to.rest < P(0.0)));
      const Mask left_of_next = margin < beyond || (node + width == P(1.0) && !(beyond < P(0.0)));
      const Mask accept = !done && right_of_node && left_of_next;
      result = select(accept, node + min(width, to.newton), result);
      done = done || accept;
      if (done.all()) break;
      u = select(done, u, bracket.next(P(0.0) < to.rest, node, node + to.halley()));
    }
    store_rows<1>(out + first, {result}, here);
    note(settled + first, done, here);
  }
}

template <std::size_t dimension, std::size_t n>
const Kernels* table() {
  static constexpr Kernels kernels{&states<dimension, n>, &points<dimension, n>,
                                   &parameters<dimension, n>};
  return &kernels;
}

}  // namespace

namespace HODOGRAPH_KERNEL_ISA {

/// The kernels of this file. The degrees are those of the constructions: C¹, C², C⁴ data and arcs.
const Kernels* find(std::size_t dimension, std::size_t n);
const Kernels* find(std::size_t dimension, std::size_t n) {
  if (n > 8) return nullptr;
  switch (16 * (dimension / 4) + n) {
    case 1:
      return table<2, 1>();
    case 2:
      return table<2, 2>();
    case 3:
      return table<2, 3>();
    case 4:
      return table<2, 4>();
    case 16 + 1:
      return table<4, 1>();
    case 16 + 2:
      return table<4, 2>();
    case 16 + 3:
      return table<4, 3>();
    case 16 + 4:
      return table<4, 4>();
    case 16 + 8:
      return table<4, 8>();
    default:
      return nullptr;
  }
}

}  // namespace HODOGRAPH_KERNEL_ISA

}  // namespace hodograph::batch_detail
