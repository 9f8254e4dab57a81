// SPDX-License-Identifier: MIT
// Rotation-minimising frames of several pieces of a path at once; included by one source file for
// every instruction set, which defines HODOGRAPH_KERNEL_ISA (a namespace) and
// HODOGRAPH_KERNEL_LANES.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "../minimising_group.hpp"
#include "frame_lanes.hpp"

namespace hodograph::frame_detail {

namespace {

/// Tables of the series with as many nodes.
template <std::size_t nodes>
struct SeriesTables {
  static constexpr std::size_t half_nodes = nodes / 2;
  double node[half_nodes];                                           ///< the positive ones
  double even[half_nodes][half_nodes], odd[half_nodes][half_nodes];  ///< [node][coefficient]
  double powers[nodes + 1][nodes + 1];  ///< T_k = Σ_i powers[k][i] x^i
  double row_size[nodes + 1];           ///< Σ_i |powers[k][i]|

  SeriesTables() {
    for (std::size_t j = 0; j < half_nodes; ++j) {
      const double angle =
          std::numbers::pi * (static_cast<double>(j) + 0.5) / static_cast<double>(nodes);
      node[j] = std::cos(angle);
      const double weight = 2.0 / static_cast<double>(nodes);
      for (std::size_t k = 0; k < half_nodes; ++k) {
        even[j][k] = (k == 0 ? 0.5 : 1.0) * weight * std::cos(static_cast<double>(2 * k) * angle);
        odd[j][k] = weight * std::cos(static_cast<double>(2 * k + 1) * angle);
      }
    }
    for (auto& row : powers) {
      for (double& x : row) x = 0.0;
    }
    powers[0][0] = powers[1][1] = 1.0;
    for (std::size_t k = 2; k <= nodes; ++k) {
      for (std::size_t i = 0; i <= nodes; ++i) {
        powers[k][i] = (i > 0 ? 2.0 * powers[k - 1][i - 1] : 0.0) - powers[k - 2][i];
      }
    }
    for (std::size_t k = 0; k <= nodes; ++k) {
      row_size[k] = 0.0;
      for (const double x : powers[k]) row_size[k] += x < 0.0 ? -x : x;
    }
  }
};

/// x^m = Σ_k value[m][k] T_k.
template <std::size_t degree>
struct PowersInChebyshev {
  double value[degree + 1][degree + 1]{};
  constexpr PowersInChebyshev() {
    value[0][0] = 1.0;
    for (std::size_t m = 1; m <= degree; ++m) {
      for (std::size_t k = 0; k < m; ++k) {
        // x T_0 = T_1, x T_k = (T_(k+1) + T_(k-1))/2.
        value[m][k + 1] += (k == 0 ? 1.0 : 0.5) * value[m - 1][k];
        if (k > 0) value[m][k - 1] += 0.5 * value[m - 1][k];
      }
    }
  }
};

constexpr double choose(std::size_t n, std::size_t k) {
  double value = 1.0;
  for (std::size_t r = 1; r <= k; ++r) {
    value = value * static_cast<double>(n - r + 1) / static_cast<double>(r);
  }
  return value;
}

template <std::size_t count>
INLINED inline P sum_of_sizes(const std::array<P, count>& c) {
  P total;
  repeat<count>([&](auto k) INLINED { total = total + abs(c[k]); });
  return total;
}

/// c_first + c_(first+2) z + c_(first+4) z² + ...
template <std::size_t first, std::size_t count>
INLINED inline P every_other(const std::array<P, count>& c, const P& z) {
  P value;
  if constexpr (first < count) {
    constexpr std::size_t last = (count - 1 - first) / 2;
    value = c[first + 2 * last];
    repeat<last>([&](auto i)
                     INLINED { value = multiply_add(value, z, c[first + 2 * (last - 1 - i)]); });
  }
  return value;
}

/// See rate_series.hpp for the series and the bound of what it leaves out. Rounding, with ε twice
/// the unit roundoff, M = max |A_i|, g = 1 + 2 half: the coefficient of x^k is a k-th difference of
/// points of de Casteljau's algorithm, (2n + 2) ε C(n,k) (2 half)^k M off, so that P (of absolute
/// terms below B = 4 n half g^(2n-1) M²) is off by at most (5n + 6) ε B, and Q, with g^2n M² in
/// place of B, by (5n + 8) ε times that; the rest is counted by `terms`.
template <std::size_t n, std::size_t nodes>
void expand(const PieceLanes& in, PieceGroup& out) {
  static_assert(2 * n - 1 <= nodes && 2 * n + 1 <= 2 * nodes && nodes % 4 == 0);
  static const SeriesTables<nodes> table;
  constexpr PowersInChebyshev<2 * n> in_chebyshev;
  constexpr std::size_t half_nodes = nodes / 2, q_size = 2 * n + 1, p_size = 2 * n - 1;

  alignas(64) double loaded[4 * (n + 1)][lanes];
  for (std::size_t l = 0; l < lanes; ++l) {
    const double* from = in.preimage[l];
    for (std::size_t i = 0; i < 4 * (n + 1); ++i) loaded[i][l] = from[i];
  }
  const P u = P::load(in.middle), v = P(1.0) - u, r = P::load(in.half);
  std::array<P, n + 1> power;
  power[0] = P(1.0);
  repeat<n>([&](auto k) INLINED { power[k + 1] = power[k] * r; });

  // A = Σ a_k x^k: C(n,k) half^k times the k-th difference of the points that n - k steps leave.
  std::array<std::array<P, 4>, n + 1> a;
  repeat<4>([&](auto c) INLINED {
    std::array<P, n + 1> point;
    repeat<n + 1>([&](auto i) INLINED { point[i] = P::load(loaded[4 * i + c]); });
    repeat<n + 1>([&](auto step) INLINED {
      constexpr std::size_t k = n - step;
      std::array<P, n + 1> difference = point;
      repeat<k>([&](auto s) INLINED {
        repeat<k - s>([&](auto i) INLINED { difference[i] = difference[i + 1] - difference[i]; });
      });
      a[k][c] = P(choose(n, k)) * power[k] * difference[0];
      a[k][c].store(out.preimage[4 * k + c]);
      repeat<k>([&](auto i) INLINED { point[i] = multiply_add(v, point[i], u * point[i + 1]); });
    });
  });

  // The rate of the roll by x is P/Q, P = -2 <A', A i>, Q = |A|².
  std::array<P, p_size> p;
  std::array<P, q_size> q;
  repeat<n + 1>([&](auto k) INLINED {
    const Quaternion<P> first{a[k][0], a[k][1], a[k][2], a[k][3]};
    repeat<n + 1 - k>([&](auto more) INLINED {
      constexpr std::size_t j = k + more;
      const Quaternion<P> second{a[j][0], a[j][1], a[j][2], a[j][3]};
      const P product = speed_form(first, second);
      q[k + j] = q[k + j] + (more == 0 ? product : product + product);
      if constexpr (more > 0) {
        p[k + j - 1] =
            p[k + j - 1] - P(2.0 * static_cast<double>(j - k)) * twist_form(first, second);
      }
    });
  });

  std::array<P, nodes> c;
  repeat<half_nodes>([&](auto j) INLINED {
    const P x(table.node[j]), z = x * x;
    const P p_even = every_other<0>(p, z), p_odd = every_other<1>(p, z);
    const P q_even = every_other<0>(q, z), q_odd = every_other<1>(q, z);
    const P p_side = x * p_odd, p_right = p_even + p_side, p_left = p_even - p_side;
    const P q_side = x * q_odd, q_right = q_even + q_side, q_left = q_even - q_side;
    const P reciprocal = P(1.0) / (q_right * q_left);
    const P right = p_right * q_left, left = p_left * q_right;
    const P sum = reciprocal * (right + left), difference = reciprocal * (right - left);
    repeat<half_nodes>([&](auto k) INLINED {
      c[2 * k] = multiply_add(P(table.even[j][k]), sum, c[2 * k]);
      c[2 * k + 1] = multiply_add(P(table.odd[j][k]), difference, c[2 * k + 1]);
    });
  });

  // Half the roll: ∫ T_k = T_(k+1)/(2(k+1)) - T_(k-1)/(2(k-1)), ∫ T_0 = T_1, ∫ T_1 = T_2/4.
  std::array<P, nodes + 1> roll;
  P spread;
  repeat<nodes>([&](auto before) INLINED {
    constexpr std::size_t k = before + 1;
    P t = P((k == 1 ? 0.5 : 0.25 / static_cast<double>(k))) * c[k - 1];
    if constexpr (k + 1 < nodes) t = t - P(0.25 / static_cast<double>(k)) * c[k + 1];
    repeat<(k + 1) / 2>([&](auto down) INLINED {
      constexpr std::size_t i = k - 2 * down;
      roll[i] = multiply_add(P(table.powers[k][i]), t, roll[i]);
    });
    spread = multiply_add(P(2.0 * table.row_size[k]), abs(t), spread);
  });
  std::array<P, 2> part;
  repeat<nodes>([&](auto before) INLINED {
    constexpr std::size_t i = before + 1;
    part[i % 2] = part[i % 2] + roll[i];
    roll[i].store(out.half_roll[before]);
  });
  (P(2.0) * (part[0] - part[1])).store(out.begin);
  (P(2.0) * (part[0] + part[1])).store(out.end);
  (P(2.0) * sum_of_sizes(roll)).store(out.turn);

  // Bounds.
  std::array<P, q_size> chebyshev;
  repeat<q_size>([&](auto m) INLINED {
    repeat<m / 2 + 1>([&](auto down) INLINED {
      constexpr std::size_t k = m - 2 * down;
      chebyshev[k] = multiply_add(P(in_chebyshev.value[m][k]), q[m], chebyshev[k]);
    });
  });
  P remainder, remainder_slope, q_slope;
  repeat<q_size>([&](auto k) INLINED {
    q_slope = q_slope + P(static_cast<double>(k * k)) * abs(chebyshev[k]);
  });
  repeat<q_size - 1>([&](auto after) INLINED {
    constexpr std::size_t k = nodes + after;
    P twice;
    repeat<q_size>([&](auto l) INLINED {
      if constexpr (l + nodes > k && l <= k) twice = multiply_add(c[k - l], chebyshev[l], twice);
      if constexpr (l >= k) twice = multiply_add(c[l - k], chebyshev[l], twice);
    });
    const P size = abs(twice);
    remainder = remainder + P(after == 0 ? 0.5 : 1.0) * size;
    remainder_slope = remainder_slope + P(static_cast<double>(after * after)) * size;
  });
  constexpr double eps = std::numeric_limits<double>::epsilon();
  constexpr auto degree = static_cast<double>(n), count = static_cast<double>(nodes);
  constexpr double terms = 3.0 * count + 6.0 * degree + 16.0;
  const P g = P(1.0) + P(2.0) * r, g2 = g * g;
  P growth = g;
  repeat<n - 1>([&](auto) INLINED { growth = growth * g2; });
  const P size = P::load(in.size);
  const P p_bound = P(4.0 * degree) * r * growth * size, q_bound = growth * g * size;
  const P p_sum = sum_of_sizes(p), q_sum = sum_of_sizes(q), c_sum = sum_of_sizes(c);
  const P least = (chebyshev[0] + abs(chebyshev[0])) - sum_of_sizes(chebyshev) -
                  P(eps) * (P(5.0 * degree + 8.0) * q_bound + P(2.0 * degree + 10.0) * q_sum);
  const P infinite(std::numeric_limits<double>::infinity());
  const auto positive = P(0.0) < least;
  const P over = P(1.0 + 64.0 * eps) / least, twice_over = over + over;
  // With s the factor of T_N, h = s/Q and T_N = W': ∫ T_N h = W h - ∫ W h'.
  constexpr double w_most = 0.5 / (count + 1.0) + 0.5 / (count - 1.0);
  constexpr double w_end = 1.0 / (count * count - 1.0);
  const P h = over * remainder, slope = over * (remainder_slope + h * q_slope);
  const P truncation = min(h + h, P(w_most + w_end) * h + P(2.0 * w_most) * slope);
  select(positive, truncation, infinite).store(out.truncation);
  const P rounding =
      twice_over * (P(terms) * (c_sum * q_sum + p_sum) + P(5.0 * degree + 6.0) * p_bound +
                    P(5.0 * degree + 8.0) * c_sum * q_bound);
  select(positive, P(eps) * (rounding + P(count) * spread), infinite).store(out.carried);
  select(positive, P(4.0 * count * eps) * spread, infinite).store(out.local);
}

/// The rotor of half an angle, up to a factor near 1 and its sign.
[[gnu::always_inline]] inline void rotor_of_half(const P& angle, P& c, P& s) {
  constexpr double pi_high = 0x1.921fb54400000p+1, pi_low = 0x1.0b4611a626331p-33;
  constexpr double to_integer = 0x1.8p+52;
  const P half = P(0.5) * angle;
  const P turns = (half * P(std::numbers::inv_pi) + P(to_integer)) - P(to_integer);
  const P y = P(0.25) * ((half - turns * P(pi_high)) - turns * P(pi_low));
  along_rotor(y, c, s);
#pragma GCC unroll 2
  for (int i = 0; i < 2; ++i) {
    const P square = c * c - s * s;
    s = P(2.0) * c * s;
    c = square;
  }
}

/// The axes at x of the piece with these coefficients.
template <std::size_t n, std::size_t nodes, class Preimage, class HalfRoll>
[[gnu::always_inline]] inline std::array<P, 9> axes_at(const P& x, const Preimage& preimage,
                                                       const HalfRoll& half_roll) {
  const P x2 = x * x;
  P c, s;
  along_rotor(x * polynomial<nodes>(half_roll, x, x2, x2 * x2), c, s);
  Quaternion<P> a{preimage(4 * n), preimage(4 * n + 1), preimage(4 * n + 2), preimage(4 * n + 3)};
#pragma GCC unroll 8
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = 4 * (n - 1 - i);
    a = {multiply_add(a.w, x, preimage(k)), multiply_add(a.x, x, preimage(k + 1)),
         multiply_add(a.y, x, preimage(k + 2)), multiply_add(a.z, x, preimage(k + 3))};
  }
  const auto rolled = rolled_preimage(a, c, s);
  return axes(rolled, speed(rolled));
}

template <std::size_t n, std::size_t nodes>
void frames(const PieceGroup& group, const FrameLanes& at) {
  constexpr std::size_t size = 4 * (n + 1);
  alignas(64) double preimage[size][lanes];
  {
    P c, s;
    rotor_of_half(P::load(at.angle), c, s);
    for (std::size_t k = 0; k < size; k += 4) {
      const auto a = rolled_preimage(
          Quaternion<P>{P::load(group.preimage[k]), P::load(group.preimage[k + 1]),
                        P::load(group.preimage[k + 2]), P::load(group.preimage[k + 3])},
          c, s);
      a.w.store(preimage[k]);
      a.x.store(preimage[k + 1]);
      a.y.store(preimage[k + 2]);
      a.z.store(preimage[k + 3]);
    }
  }
  std::size_t across = 0, along = 0;  // packs to compute either way
  for (std::size_t l = 0; l < at.used; ++l) {
    across = across < at.count[l] ? at.count[l] : across;
    along += (at.count[l] + lanes - 1) / lanes;
  }
  // Points side by side on ξ are quicker to read and to write.
  if (4 * across < 3 * along) {
    // A point of every piece at a time.
    const P center = P::load(at.center), scale = P::load(at.scale);
    double unwanted[9];
    for (std::size_t j = 0; j < across; ++j) {
      alignas(64) double xi[lanes];
      double* to[lanes];
      for (std::size_t l = 0; l < lanes; ++l) {
        const bool wanted = l < at.used && j < at.count[l];
        xi[l] = wanted ? at.xi[at.first[l] + j] : at.center[l];
        to[l] = wanted ? at.frames + 9 * (at.first[l] + j) : unwanted;
      }
      const P x = (P::load(xi) - center) * scale;
      store_rows([&](std::size_t l) { return to[l]; },
                 axes_at<n, nodes>(
                     x, [&](std::size_t k) { return P::load(preimage[k]); },
                     [&](std::size_t k) { return P::load(group.half_roll[k]); }));
    }
    return;
  }
  // Some points of one piece at a time.
  for (std::size_t l = 0; l < at.used; ++l) {
    double own[size], half_roll[nodes];
    for (std::size_t k = 0; k < size; ++k) own[k] = preimage[k][l];
    for (std::size_t k = 0; k < nodes; ++k) half_roll[k] = group.half_roll[k][l];
    const P center(at.center[l]), scale(at.scale[l]);
    const double* xi = at.xi + at.first[l];
    double* to = at.frames + 9 * at.first[l];
    const std::size_t behind = at.points - at.first[l];  // from here to the end of the path
    for (std::size_t j = 0; j < at.count[l]; j += lanes) {
      // A pack may go on beyond the piece: the next pieces write anew what it leaves there.
      const bool fits = j + lanes <= behind;
      double last_xi[lanes], last_rows[9 * lanes];
      if (!fits) {
        for (std::size_t i = 0; i < lanes; ++i) last_xi[i] = xi[j + i < behind ? j + i : j];
      }
      double* rows = fits ? to + 9 * j : last_rows;
      store_rows([&](std::size_t i) { return rows + 9 * i; },
                 axes_at<n, nodes>((P::load(fits ? xi + j : last_xi) - center) * scale,
                                   [&](std::size_t k) { return P(own[k]); },
                                   [&](std::size_t k) { return P(half_roll[k]); }));
      for (std::size_t i = 0; !fits && i < 9 * (behind - j); ++i) to[9 * j + i] = last_rows[i];
    }
  }
}

bool ascend(const double* numbers, std::size_t count) {
  auto all = P(0.0) <= P(0.0);
  std::size_t i = 0;
  for (; i + lanes < count; i += lanes)
    all = all && P::load(numbers + i) <= P::load(numbers + i + 1);
  bool rest = all.all();
  for (; i + 1 < count; ++i) rest = rest && numbers[i] <= numbers[i + 1];
  return rest;
}

template <std::size_t n, std::size_t nodes>
constexpr MinimisingKernels kernels_of{lanes, nodes, &expand<n, nodes>, &frames<n, nodes>, &ascend};

}  // namespace

namespace HODOGRAPH_KERNEL_ISA {

const MinimisingKernels* minimising_kernels(std::size_t degree, std::size_t nodes);
const MinimisingKernels* minimising_kernels(std::size_t degree, std::size_t nodes) {
  const bool few = nodes <= 8;
  switch (degree) {
    case 1:
      return &kernels_of<1, 8>;
    case 2:
      return few ? &kernels_of<2, 8> : &kernels_of<2, 16>;
    case 3:
      return few ? &kernels_of<3, 8> : &kernels_of<3, 16>;
    case 4:
      return few ? nullptr : &kernels_of<4, 16>;
    case 8:
      return few ? nullptr : &kernels_of<8, 16>;
    default:
      return nullptr;
  }
}

}  // namespace HODOGRAPH_KERNEL_ISA

}  // namespace hodograph::frame_detail
