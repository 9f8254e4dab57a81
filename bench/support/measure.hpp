// SPDX-License-Identifier: MIT
// The harness of the benchmarks: rivals take turns, so that a busy machine slows all of them alike;
// the table gives the median and the fastest repetition of each, and its ratio to the first.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "hodograph/path/path.hpp"

namespace hodograph::bench {

/// Keeps a result from being optimised away.
template <class T>
void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

struct Rival {
  std::string name;
  std::function<void()> run;  ///< does `items` things
  double items;
  std::vector<double> seconds{};
};

/// Runs the rivals in turns and prints nanoseconds an item; ratios are of medians, to the first
/// rival.
inline void compare(const std::string& question, std::vector<Rival> rivals, int repetitions = 31) {
  using Clock = std::chrono::steady_clock;
  for (int r = 0; r < repetitions; ++r) {
    for (Rival& rival : rivals) {
      rival.run();
      const auto begin = Clock::now();
      rival.run();
      const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
      rival.seconds.push_back(seconds / rival.items);
    }
  }
  std::printf("%s\n  %-52s %10s %10s %8s\n", question.c_str(), "ns an item", "median", "fastest",
              "speedup");
  double first = 0.0;
  for (Rival& rival : rivals) {
    std::sort(rival.seconds.begin(), rival.seconds.end());
    const double median = rival.seconds[rival.seconds.size() / 2];
    if (&rival == rivals.data()) first = median;
    std::printf("  %-52s %10.1f %10.1f %7.2fx\n", rival.name.c_str(), 1e9 * median,
                1e9 * rival.seconds.front(), first / median);
  }
  std::fflush(stdout);  // a table that was made stays, though a later one takes too long
}

/// Reproducible numbers in [0, 1).
class Numbers {
 public:
  double next() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11) * 0x1.0p-53;  // not a tolerance: 2^-53
  }
  double within(double low, double high) { return low + (high - low) * next(); }
  /// Random numbers in [low, high], in increasing order if wanted.
  std::vector<double> many(std::size_t count, double low, double high, bool sorted) {
    std::vector<double> result(count);
    for (double& x : result) x = std::min(high, within(low, high));
    if (sorted) std::sort(result.begin(), result.end());
    return result;
  }

 private:
  std::uint64_t state_ = 2024;
};

/// A spatial path on slightly uneven knots whose preimages vary by `wildness` within a segment.
template <std::size_t n>
SpatialPath<n> random_path(std::size_t segments, double wildness) {
  using A = Quaternion<double>;
  Numbers numbers;
  std::vector<double> knots{0.0};
  std::vector<SpatialPhCurve<n>> curves;
  Vector3<double> start{};
  knots.reserve(segments + 1);
  curves.reserve(segments);
  for (std::size_t k = 0; k < segments; ++k) {
    BernsteinPolynomial<A, n> preimage;
    for (std::size_t i = 0; i <= n; ++i) {
      preimage[i] = {1.0 + wildness * numbers.within(-1, 1), wildness * numbers.within(-1, 1),
                     wildness * numbers.within(-1, 1), wildness * numbers.within(-1, 1)};
    }
    knots.push_back(knots.back() + numbers.within(0.8, 1.2));
    curves.emplace_back(start, preimage, knots[k + 1] - knots[k]);
    start = curves.back().end();
  }
  return SpatialPath<n>::create(std::move(knots), std::move(curves), false).value();
}

/// Planar quintics whose preimages vary by `wildness` about 1.
inline std::vector<PlanarPhCurve<2>> random_quintics(std::size_t count, double wildness) {
  Numbers numbers;
  std::vector<PlanarPhCurve<2>> curves;
  for (std::size_t k = 0; k < count; ++k) {
    PlanarPhCurve<2>::Preimage w;
    for (std::size_t i = 0; i <= 2; ++i) {
      w[i] = {1.0 + wildness * numbers.within(-1, 1), wildness * numbers.within(-1, 1)};
    }
    curves.emplace_back(Vector2<double>{}, w, 1.0);
  }
  return curves;
}

}  // namespace hodograph::bench
