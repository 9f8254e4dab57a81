// SPDX-License-Identifier: MIT
// Several doubles that go through the same arithmetic in one vector register: a scalar for the
// batch kernels, and for the two ends of a segment. Needs the vector extensions of GCC or Clang.
//
// The second argument names the instruction set a file is compiled for. Every template instantiated
// with a Pack is then a type of that file alone, so that the linker never takes one file's inline
// function, compiled for a newer processor, for another's. Let it be a type of an unnamed
// namespace.
#pragma once

#include <cstddef>
#include <cstdint>

#include "hodograph/foundation/scalar.hpp"

namespace hodograph {

/// The register types; spelled out because a dependent vector_size is ignored by some compilers.
template <std::size_t lanes>
struct Registers;
template <>
struct Registers<2> {
  typedef double Numbers __attribute__((vector_size(16)));
  typedef std::int64_t Truths __attribute__((vector_size(16)));
};
template <>
struct Registers<4> {
  typedef double Numbers __attribute__((vector_size(32)));
  typedef std::int64_t Truths __attribute__((vector_size(32)));
};
template <>
struct Registers<8> {
  typedef double Numbers __attribute__((vector_size(64)));
  typedef std::int64_t Truths __attribute__((vector_size(64)));
};

/// One truth value a lane; all bits set where true.
template <std::size_t lanes, class Isa>
struct PackMask {
  using Lanes = typename Registers<lanes>::Truths;
  Lanes value;

  [[gnu::always_inline]] friend PackMask operator&&(const PackMask& a, const PackMask& b) {
    return {a.value & b.value};
  }
  [[gnu::always_inline]] friend PackMask operator||(const PackMask& a, const PackMask& b) {
    return {a.value | b.value};
  }
  [[gnu::always_inline]] friend PackMask operator!(const PackMask& a) { return {~a.value}; }
  [[gnu::always_inline]] bool operator[](std::size_t lane) const { return value[lane] != 0; }
  [[gnu::always_inline]] bool all() const {
    std::int64_t result = -1;
    for (std::size_t i = 0; i < lanes; ++i) result &= value[i];
    return result != 0;
  }
};

template <std::size_t lanes, class Isa>
class Pack {
 public:
  static constexpr std::size_t size = lanes;
  using Mask = PackMask<lanes, Isa>;
  using Lanes = typename Registers<lanes>::Numbers;

  Pack() : lanes_{} {}
  /// The same number in every lane.
  [[gnu::always_inline]] Pack(double x) : lanes_(x - Lanes{}) {}  // x + 0 is not -0 for -0
  [[gnu::always_inline]] explicit Pack(Lanes x) : lanes_(x) {}
  [[gnu::always_inline]] static Pack load(const double* from) {
    Pack result;
    __builtin_memcpy(&result.lanes_, from, sizeof(Lanes));
    return result;
  }
  [[gnu::always_inline]] void store(double* to) const {
    __builtin_memcpy(to, &lanes_, sizeof(Lanes));
  }
  [[gnu::always_inline]] double operator[](std::size_t lane) const { return lanes_[lane]; }
  [[gnu::always_inline]] void set(std::size_t lane, double x) { lanes_[lane] = x; }

  [[gnu::always_inline]] friend Pack operator+(const Pack& a, const Pack& b) {
    return Pack(a.lanes_ + b.lanes_);
  }
  [[gnu::always_inline]] friend Pack operator-(const Pack& a, const Pack& b) {
    return Pack(a.lanes_ - b.lanes_);
  }
  [[gnu::always_inline]] friend Pack operator-(const Pack& a) { return Pack(-a.lanes_); }
  [[gnu::always_inline]] friend Pack operator*(const Pack& a, const Pack& b) {
    return Pack(a.lanes_ * b.lanes_);
  }
  [[gnu::always_inline]] friend Pack operator/(const Pack& a, const Pack& b) {
    return Pack(a.lanes_ / b.lanes_);
  }

  [[gnu::always_inline]] friend Mask operator<(const Pack& a, const Pack& b) {
    return {reinterpret_cast<typename Mask::Lanes>(a.lanes_ < b.lanes_)};
  }
  [[gnu::always_inline]] friend Mask operator<=(const Pack& a, const Pack& b) {
    return {reinterpret_cast<typename Mask::Lanes>(a.lanes_ <= b.lanes_)};
  }
  [[gnu::always_inline]] friend Mask operator>(const Pack& a, const Pack& b) { return b < a; }
  [[gnu::always_inline]] friend Mask operator>=(const Pack& a, const Pack& b) { return b <= a; }
  // constexpr so that vectors of packs may default their own comparison.
  [[gnu::always_inline]] friend constexpr Mask operator==(const Pack& a, const Pack& b) {
    return {reinterpret_cast<typename Mask::Lanes>(a.lanes_ == b.lanes_)};
  }

  /// a where the condition holds, b elsewhere.
  [[gnu::always_inline]] friend Pack select(const Mask& condition, const Pack& a, const Pack& b) {
    return Pack(condition.value ? a.lanes_ : b.lanes_);
  }
  [[gnu::always_inline]] friend Pack min(const Pack& a, const Pack& b) {
    return select(b < a, b, a);
  }
  [[gnu::always_inline]] friend Pack max(const Pack& a, const Pack& b) {
    return select(a < b, b, a);
  }
  [[gnu::always_inline]] friend Pack abs(const Pack& a) { return select(a < Pack(0.0), -a, a); }
  /// Compile with -fno-math-errno, so that this is one instruction.
  [[gnu::always_inline]] friend Pack sqrt(const Pack& a) {
    Pack result;
    for (std::size_t i = 0; i < lanes; ++i) result.lanes_[i] = __builtin_sqrt(a.lanes_[i]);
    return result;
  }

 private:
  Lanes lanes_;
};

template <std::size_t lanes, class Isa>
struct RealOf<Pack<lanes, Isa>> {
  using type = double;
};

}  // namespace hodograph
