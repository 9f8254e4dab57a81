// SPDX-License-Identifier: MIT
// Two numbers that go through the same arithmetic: one register of two doubles where the compiler
// has them. Every operation is the scalar's own in each lane, so results do not depend on which is
// used.
#pragma once

#include <cstddef>
#include <limits>

#include "hodograph/foundation/scalar.hpp"

namespace hodograph {

/// (first, second) of any scalar; usable in constant expressions.
template <class S>
struct PlainPair {
  using Scalar = S;
  S lane[2]{};

  constexpr PlainPair() = default;
  constexpr PlainPair(const S& first, const S& second) : lane{first, second} {}
  /// (x, x).
  static constexpr PlainPair both(const S& x) { return {x, x}; }
  /// Components i and i + 1 of a value that has them as value[i]; a last odd one goes with a zero.
  template <std::size_t i, class V>
  static constexpr PlainPair load(const V& value) {
    if constexpr (i + 1 < V::dimension) {
      return {value[i], value[i + 1]};
    } else {
      return {value[i], S(0)};
    }
  }
  constexpr S first() const { return lane[0]; }
  constexpr S second() const { return lane[1]; }
  /// (first, first), (second, second), (second, first).
  constexpr PlainPair first_twice() const { return {lane[0], lane[0]}; }
  constexpr PlainPair second_twice() const { return {lane[1], lane[1]}; }
  constexpr PlainPair swapped() const { return {lane[1], lane[0]}; }
  /// (a.first, b.first), (a.second, b.second).
  static constexpr PlainPair firsts(const PlainPair& a, const PlainPair& b) {
    return {a.lane[0], b.lane[0]};
  }
  static constexpr PlainPair seconds(const PlainPair& a, const PlainPair& b) {
    return {a.lane[1], b.lane[1]};
  }
  /// (a.first - b.first, a.second + b.second), (a.first + b.first, a.second - b.second).
  static constexpr PlainPair minus_plus(const PlainPair& a, const PlainPair& b) {
    return {a.lane[0] - b.lane[0], a.lane[1] + b.lane[1]};
  }
  static constexpr PlainPair plus_minus(const PlainPair& a, const PlainPair& b) {
    return {a.lane[0] + b.lane[0], a.lane[1] - b.lane[1]};
  }

  friend constexpr PlainPair operator+(const PlainPair& a, const PlainPair& b) {
    return {a.lane[0] + b.lane[0], a.lane[1] + b.lane[1]};
  }
  friend constexpr PlainPair operator-(const PlainPair& a, const PlainPair& b) {
    return {a.lane[0] - b.lane[0], a.lane[1] - b.lane[1]};
  }
  friend constexpr PlainPair operator*(const PlainPair& a, const PlainPair& b) {
    return {a.lane[0] * b.lane[0], a.lane[1] * b.lane[1]};
  }
};

/// The fastest pair of a scalar at run time.
template <class S>
struct PairOf {
  using type = PlainPair<S>;
};

#if defined(__GNUC__)  // GCC and Clang: vector extensions

/// Two doubles in one register.
class DoublePair {
 public:
  using Scalar = double;

  DoublePair() = default;
  DoublePair(double first, double second) : lanes_{first, second} {}
  static DoublePair both(double x) { return {x, x}; }
  template <std::size_t i, class V>
  static DoublePair load(const V& value) {
    static_assert(sizeof(V) == V::dimension * sizeof(double));
    if constexpr (i + 1 < V::dimension) {
      DoublePair result;
      __builtin_memcpy(&result.lanes_, reinterpret_cast<const char*>(&value) + i * sizeof(double),
                       sizeof(Lanes));
      return result;
    } else {
      return {value[i], 0.0};
    }
  }
  double first() const { return lanes_[0]; }
  double second() const { return lanes_[1]; }
  DoublePair first_twice() const { return DoublePair(shuffled<0, 0>(lanes_, lanes_)); }
  DoublePair second_twice() const { return DoublePair(shuffled<1, 1>(lanes_, lanes_)); }
  DoublePair swapped() const { return DoublePair(shuffled<1, 0>(lanes_, lanes_)); }
  static DoublePair firsts(DoublePair a, DoublePair b) {
    return DoublePair(shuffled<0, 2>(a.lanes_, b.lanes_));
  }
  static DoublePair seconds(DoublePair a, DoublePair b) {
    return DoublePair(shuffled<1, 3>(a.lanes_, b.lanes_));
  }
  static DoublePair minus_plus(DoublePair a, DoublePair b) {
    return DoublePair(a.lanes_ + signs_turned<true, false>(b.lanes_));
  }
  static DoublePair plus_minus(DoublePair a, DoublePair b) {
    return DoublePair(a.lanes_ + signs_turned<false, true>(b.lanes_));
  }

  friend DoublePair operator+(DoublePair a, DoublePair b) {
    return DoublePair(a.lanes_ + b.lanes_);
  }
  friend DoublePair operator-(DoublePair a, DoublePair b) {
    return DoublePair(a.lanes_ - b.lanes_);
  }
  friend DoublePair operator*(DoublePair a, DoublePair b) {
    return DoublePair(a.lanes_ * b.lanes_);
  }

 private:
  typedef double Lanes __attribute__((vector_size(16)));
  explicit DoublePair(Lanes lanes) : lanes_(lanes) {}
  template <int i, int j>
  static Lanes shuffled(Lanes a, Lanes b) {
#if defined(__clang__)
    return __builtin_shufflevector(a, b, i, j);
#else
    typedef long long Places __attribute__((vector_size(16)));
    return __builtin_shuffle(a, b, Places{i, j});
#endif
  }
  template <bool first, bool second>
  static Lanes signs_turned(Lanes a) {
    typedef long long Bits __attribute__((vector_size(16)));
    constexpr long long sign = std::numeric_limits<long long>::min();
    return reinterpret_cast<Lanes>(reinterpret_cast<Bits>(a) ^
                                   Bits{first ? sign : 0, second ? sign : 0});
  }
  Lanes lanes_;
};

template <>
struct PairOf<double> {
  using type = DoublePair;
};

#endif

template <class S>
using pair_of_t = typename PairOf<S>::type;

}  // namespace hodograph
