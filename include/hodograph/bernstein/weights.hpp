// SPDX-License-Identifier: MIT
// The values of the Bernstein polynomials of a degree at a point, and the sums they weigh.
//
// Values and sums are formed from both ends at once: (B_i^n, B_{n-i}^n) is one product of pairs,
// and a sum adds its two halves last. Hence reversing a polynomial about u = 1/2 reverses its value
// bit for bit wherever 1 - u is exact, and one evaluation, a batch and every instruction set agree.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "hodograph/bernstein/binomial.hpp"
#include "hodograph/foundation/pair.hpp"

namespace hodograph {

/// (u^k, (1-u)^k) for k = 0..n, by halves: the chain of dependent products has length log₂ n.
template <std::size_t n, class P>
class UnitPowers {
 public:
  using S = typename P::Scalar;
  constexpr explicit UnitPowers(const S& u) {
    power_[0] = P::both(S(1));
    if constexpr (n > 0) power_[1] = P(u, S(1) - u);
#pragma GCC unroll 64
    for (std::size_t k = 2; k <= n; ++k) power_[k] = power_[k / 2] * power_[k - k / 2];
  }
  constexpr const P& operator[](std::size_t k) const { return power_[k]; }

  /// (B_i^m(u), B_{m-i}^m(u)), 2i ≤ m ≤ n: at most m + 1 roundings each, besides that of 1 - u.
  template <std::size_t m>
  constexpr P weights(std::size_t i) const {
    static_assert(m <= n);
    if (i == 0) return power_[m].swapped();
    const auto& row = constant_table<real_of_t<S>, BinomialRow<real_of_t<S>, m>>();
    return (P::both(S(row[i])) * power_[i]) * power_[m - i].swapped();
  }

 private:
  std::array<P, n + 1> power_;
};

/// The n + 1 values B_i^n(u); they are not negative on [0, 1] and sum to 1 up to rounding. Each
/// is computed by at most n + 1 multiplications, so its relative error is at most (2n + 2) ε/2
/// (1 - u is correctly rounded, which counts n times).
template <std::size_t n, class S>
constexpr std::array<S, n + 1> bernstein_values(const S& u) {
  const auto values = [](const auto& powers) {
    std::array<S, n + 1> result;
#pragma GCC unroll 64
    for (std::size_t i = 0; 2 * i <= n; ++i) {
      const auto pair = powers.template weights<n>(i);
      result[i] = pair.first();
      if (2 * i != n) result[n - i] = pair.second();
    }
    return result;
  };
  if (std::is_constant_evaluated()) return values(UnitPowers<n, PlainPair<S>>(u));
  return values(UnitPowers<n, pair_of_t<S>>(u));
}

/// The components of a value in a vector space, two by two.
template <class V, class P>
class PairedComponents {
 public:
  static constexpr std::size_t dimension = V::dimension, pairs = (dimension + 1) / 2;

  static constexpr PairedComponents load(const V& value) {
    return load(value, std::make_index_sequence<pairs>{});
  }
  constexpr V value() const {
    V result{};
    for (std::size_t i = 0; i < dimension; ++i) {
      result[i] = i % 2 == 0 ? part_[i / 2].first() : part_[i / 2].second();
    }
    return result;
  }

  friend constexpr PairedComponents operator+(const PairedComponents& a,
                                              const PairedComponents& b) {
    PairedComponents r;
    for (std::size_t k = 0; k < pairs; ++k) r.part_[k] = a.part_[k] + b.part_[k];
    return r;
  }
  friend constexpr PairedComponents operator-(const PairedComponents& a,
                                              const PairedComponents& b) {
    PairedComponents r;
    for (std::size_t k = 0; k < pairs; ++k) r.part_[k] = a.part_[k] - b.part_[k];
    return r;
  }
  /// Every component times the factor, which stands in both lanes.
  friend constexpr PairedComponents operator*(const P& factor, const PairedComponents& a) {
    PairedComponents r;
    for (std::size_t k = 0; k < pairs; ++k) r.part_[k] = factor * a.part_[k];
    return r;
  }

 private:
  template <std::size_t... k>
  static constexpr PairedComponents load(const V& value, std::index_sequence<k...>) {
    PairedComponents r;
    ((r.part_[k] = P::template load<2 * k>(value)), ...);
    return r;
  }
  std::array<P, pairs> part_;
};

/// Σ_{i=0..m} B_i^m(u) c_{first + i}: the halves i < m/2 and i > m/2 from the ends inwards, terms
/// two by two, then their sum, then the middle term of an even degree.
template <std::size_t m, class V, std::size_t n, class P, std::size_t size>
[[gnu::always_inline]] constexpr auto weighted_sum(const UnitPowers<n, P>& powers,
                                                   const std::array<V, size>& c,
                                                   std::size_t first) {
  using Components = PairedComponents<V, P>;
  if constexpr (m == 0) {
    return Components::load(c[first]);
  } else {
    P w = powers.template weights<m>(0);
    Components front = w.first_twice() * Components::load(c[first]);
    Components back = w.second_twice() * Components::load(c[first + m]);
    constexpr std::size_t half = (m + 1) / 2;  // terms of each half
    if constexpr (half % 2 == 0) {
      w = powers.template weights<m>(1);
      front = front + w.first_twice() * Components::load(c[first + 1]);
      back = back + w.second_twice() * Components::load(c[first + m - 1]);
    }
#pragma GCC unroll 64
    for (std::size_t i = 2 - half % 2; i < half; i += 2) {
      w = powers.template weights<m>(i);
      const P v = powers.template weights<m>(i + 1);
      front = front + (w.first_twice() * Components::load(c[first + i]) +
                       v.first_twice() * Components::load(c[first + i + 1]));
      back = back + (w.second_twice() * Components::load(c[first + m - i]) +
                     v.second_twice() * Components::load(c[first + m - i - 1]));
    }
    Components sum = front + back;
    if constexpr (m % 2 == 0) {
      w = powers.template weights<m>(m / 2);
      sum = sum + w.first_twice() * Components::load(c[first + m / 2]);
    }
    return sum;
  }
}

/// The same sum of numbers c(0), ..., c(m), both halves in one pair; m must be odd.
template <std::size_t m, std::size_t n, class P, class Coefficients>
[[gnu::always_inline]] constexpr typename P::Scalar mirrored_sum(const UnitPowers<n, P>& powers,
                                                                 const Coefficients& c) {
  static_assert(m % 2 == 1);
  constexpr std::size_t half = (m + 1) / 2;
  const auto term = [&](std::size_t i) {
    return powers.template weights<m>(i) * P(c(i), c(m - i));
  };
  P sum = term(0);
  if constexpr (half % 2 == 0) sum = sum + term(1);
#pragma GCC unroll 64
  for (std::size_t i = 2 - half % 2; i < half; i += 2) sum = sum + (term(i) + term(i + 1));
  return sum.first() + sum.second();
}

}  // namespace hodograph
