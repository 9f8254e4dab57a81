// SPDX-License-Identifier: MIT
// Random test data: std::mt19937_64, our own distributions (the standard ones differ between
// libraries), seeds that are named and printed, and numbers that are nasty on purpose.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <string_view>

#include "hodograph/algebra/complex.hpp"
#include "hodograph/algebra/quaternion.hpp"
#include "hodograph/algebra/vector.hpp"

namespace hodograph::test {

/// How many random cases a test draws where it asks for `count`: all of them, or an eighth where
/// sanitizers watch every access, which makes a case ten times as long and shows what it shows
/// within the first hundreds.
template <class Count>
constexpr Count cases(Count count) {
#if defined(__SANITIZE_ADDRESS__)
  return (count + 7) / 8;
#else
  return count;
#endif
}

/// A named sequence of random numbers. Every failure in the scope of a Random prints its name and
/// seed; the environment variable HODOGRAPH_TEST_SEED (a whole number) draws another set of
/// sequences in all tests. Make it a local variable of the test.
class Random {
 public:
  explicit Random(std::string_view name)
      : seed_(seed_of(name)),
        engine_(seed_),
        trace_(__FILE__, __LINE__,
               "random sequence \"" + std::string(name) + "\", seed " + std::to_string(seed_)) {}

  std::uint64_t seed() const { return seed_; }
  std::uint64_t bits() { return engine_(); }

  /// Uniform on the 2^53 multiples of 2^-53 in [0, 1).
  double unit() { return std::ldexp(static_cast<double>(engine_() >> 11), -53); }
  /// Uniform in [a, b] (rounded).
  double uniform(double a, double b) {
    const double u = unit();
    const double x = (1 - u) * a + u * b;
    return x < a ? a : b < x ? b : x;
  }
  /// A whole number in [low, high], every one with the same probability.
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    const std::uint64_t count =
        static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
    std::uint64_t draw = engine_();
    if (count != 0) {
      const std::uint64_t excess = (std::numeric_limits<std::uint64_t>::max() % count + 1) % count;
      while (draw > std::numeric_limits<std::uint64_t>::max() - excess) draw = engine_();
      draw %= count;
    }
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + draw);
  }
  std::size_t index(std::size_t size) {
    return static_cast<std::size_t>(integer(0, static_cast<std::int64_t>(size) - 1));
  }
  /// True with the given probability.
  bool chance(double probability) { return unit() < probability; }
  /// ±1.
  double sign() { return chance(0.5) ? -1.0 : 1.0; }
  /// A number whose size is spread evenly over the powers of two in [2^low, 2^high), either sign.
  double spread(int low, int high) {
    return std::ldexp(sign() * uniform(1.0, 2.0), static_cast<int>(integer(low, high - 1)));
  }

  // ---- vectors and rotations
  // ---------------------------------------------------------------------

  /// Components uniform in [-scale, scale].
  Vector2<double> vector2(double scale) { return components<Vector2<double>>(scale); }
  Vector3<double> vector3(double scale) { return components<Vector3<double>>(scale); }
  Complex<double> complex(double scale) { return components<Complex<double>>(scale); }
  Quaternion<double> quaternion(double scale) { return components<Quaternion<double>>(scale); }
  /// Of the algebra Complex<double> or Quaternion<double>, components uniform in [-scale, scale].
  template <class V>
  V components(double scale) {
    V v{};
    for (std::size_t i = 0; i < V::dimension; ++i) v[i] = uniform(-scale, scale);
    return v;
  }

  /// Uniform on the sphere (the circle, the 3-sphere), of length 1 within a few roundings.
  Vector2<double> unit_vector2() { return direction<Vector2<double>>(); }
  Vector3<double> unit_vector3() { return direction<Vector3<double>>(); }
  Quaternion<double> rotation() { return direction<Quaternion<double>>(); }

  // ---- near misses and hostile numbers
  // -------------------------------------------------------------

  /// x moved by a few ulps, up to `most`, in either direction (or not at all).
  double near(double x, int most = 3) {
    for (auto steps = integer(-most, most); steps != 0; steps += steps < 0 ? 1 : -1) {
      x = std::nextafter(x, steps < 0 ? -largest : largest);
    }
    return x;
  }
  /// x with relative noise of a size spread evenly over 2^-52 ... 2^-4.
  double nearly(double x) { return x * (1.0 + spread(-52, -4)); }
  Vector3<double> nearly(const Vector3<double>& v) {
    return {nearly(v.x), nearly(v.y), nearly(v.z)};
  }

  /// A finite double chosen to hurt: zero of either sign, subnormal, next to the ends of the range,
  /// of size 1e±150 (whose square is at the ends of the range), a small whole number, a few ulps
  /// from one, a power of two, the last hostile number again or next to it, or any bit pattern.
  double hostile() {
    last_hostile_ = next_hostile();
    return last_hostile_;
  }

 private:
  static constexpr double largest = std::numeric_limits<double>::max();
  static constexpr double smallest_subnormal = std::numeric_limits<double>::denorm_min();

  static std::uint64_t seed_of(std::string_view name) {
    std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    const char* chosen = std::getenv("HODOGRAPH_TEST_SEED");
    return chosen == nullptr ? hash : hash + std::strtoull(chosen, nullptr, 10);
  }

  template <class V>
  V direction() {
    for (;;) {
      const V v = components<V>(1.0);
      const double square = dot(v, v);
      if (0.0625 < square && square <= 1.0) return (1.0 / std::sqrt(square)) * v;
    }
  }

  double next_hostile() {
    switch (integer(0, 11)) {
      case 0:
        return 0.0 * sign();
      case 1:
        return sign() * smallest_subnormal * static_cast<double>(integer(1, 9));
      case 2:
        return sign() * uniform(0.0, std::numeric_limits<double>::min());
      case 3:
        return sign() * near(std::numeric_limits<double>::min());
      case 4:
        return sign() * std::numeric_limits<double>::max() * (chance(0.5) ? 1.0 : unit());
      case 5:
        return spread(-499, -497);
      case 6:
        return spread(498, 500);
      case 7:
        return static_cast<double>(integer(-9, 9));
      case 8:
        return near(static_cast<double>(integer(-9, 9)));
      case 9:
        return std::ldexp(sign(), static_cast<int>(integer(-1074, 1023)));
      case 10:
        return near(chance(0.5) ? last_hostile_ : -last_hostile_, 1);
      default:
        for (;;) {
          const double any =
              std::ldexp(sign() * uniform(1.0, 2.0), static_cast<int>(integer(-1080, 1022)));
          if (std::isfinite(any)) return any;
        }
    }
  }

  std::uint64_t seed_;
  std::mt19937_64 engine_;
  ::testing::ScopedTrace trace_;
  double last_hostile_ = 1.0;
};

}  // namespace hodograph::test
