// SPDX-License-Identifier: MIT
// Rotation-minimising frames along a path: the exact roll against the double reflection method
// (Wang, Jüttler, Zheng, Liu 2008), at equal time and at equal accuracy, all preparation included.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/frame/batch.hpp"
#include "hodograph/frame/roll.hpp"
#include "hodograph/frame/rolled_frames.hpp"
#include "support/measure.hpp"

namespace {

using namespace hodograph;

constexpr double goals[] = {1e-6, 1e-9, 1e-12};  // not a tolerance: the accuracies compared

using A = Quaternion<double>;

/// Buffers of both rivals, so that neither pays for memory.
struct Buffers {
  std::vector<double> xi;
  std::vector<Vector3<double>> positions;
  std::vector<Frame3<double>> frames;
  void resize(double begin, double end, std::size_t count) {
    xi.resize(count);
    positions.resize(count);
    frames.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      xi[i] = i + 1 == count
                  ? end
                  : begin + (end - begin) * static_cast<double>(i) / static_cast<double>(count - 1);
    }
  }
};

/// Each frame is reflected in the plane that bisects the chord to the next point, then in the one
/// that takes the reflected tangent to the next tangent: an error of order 4 over the path.
template <std::size_t n>
void double_reflection(const SpatialPath<n>& path, Buffers& b) {
  evaluate(path, std::span<const double>(b.xi),
           PathStateSpans<A>{.positions = b.positions, .frames = b.frames});
  Vector3<double> r = b.frames[0].e2;
  for (std::size_t i = 0; i + 1 < b.xi.size(); ++i) {
    const Vector3<double> v1 = b.positions[i + 1] - b.positions[i];
    const double c1 = 2.0 / dot(v1, v1);
    const Vector3<double> r_left = r - (c1 * dot(v1, r)) * v1;
    const Vector3<double> t_left = b.frames[i].e1 - (c1 * dot(v1, b.frames[i].e1)) * v1;
    const Vector3<double> v2 = b.frames[i + 1].e1 - t_left;
    const double c2 = dot(v2, v2);
    r = c2 > 0.0 ? r_left - (2.0 / c2 * dot(v2, r_left)) * v2 : r_left;
    b.frames[i + 1].e2 = r;
    b.frames[i + 1].e3 = cross(b.frames[i + 1].e1, r);
  }
}

template <std::size_t n>
void exact(const SpatialPath<n>& path, Buffers& b) {
  const auto roll = rotation_minimising_roll(path);
  RolledFrames(path, *roll).at(b.xi, b.frames);
}

/// The same with a roll that is as accurate as asked for, or as rounding allows.
template <std::size_t n>
void exact_within(const SpatialPath<n>& path, Buffers& b, double accuracy) {
  const auto roll = rotation_minimising_roll_within(PreimageTable(path), accuracy);
  if (!roll) return exact(path, b);
  RolledFrames(path, *roll).at(b.xi, b.frames);
}

/// A path of curves whose preimages vary by `wildness` within a segment and go on over the knots.
template <std::size_t n>
SpatialPath<n> smooth_path(std::size_t segments, double wildness) {
  bench::Numbers numbers;
  const auto next = [&] {
    return A{1.0 + wildness * numbers.within(-1, 1), wildness * numbers.within(-1, 1),
             wildness * numbers.within(-1, 1), wildness * numbers.within(-1, 1)};
  };
  std::vector<double> knots{0.0};
  std::vector<SpatialPhCurve<n>> curves;
  Vector3<double> start{};
  A last = next();
  for (std::size_t k = 0; k < segments; ++k) {
    BernsteinPolynomial<A, n> preimage;
    preimage[0] = last;
    for (std::size_t i = 1; i <= n; ++i) preimage[i] = next();
    last = preimage[n];
    knots.push_back(knots.back() + numbers.within(0.8, 1.2));
    curves.emplace_back(start, preimage, knots[k + 1] - knots[k]);
    start = curves.back().end();
  }
  return SpatialPath<n>::create(std::move(knots), std::move(curves), false).value();
}

/// Nanoseconds, the median of a few runs.
template <class Run>
double time_of(const Run& run) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> times;
  const auto start = Clock::now();
  do {
    const auto begin = Clock::now();
    run();
    times.push_back(std::chrono::duration<double, std::nano>(Clock::now() - begin).count());
  } while (times.size() < 7 ||
           (times.size() < 201 && Clock::now() - start < std::chrono::milliseconds(100)));
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

/// The largest angle between e₂ and what it should be, at every `stride`-th frame.
double error_of(const std::vector<Frame3<double>>& frames,
                const std::vector<Frame3<double>>& expected, std::size_t stride) {
  double worst = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    worst = std::max(worst, norm(frames[i * stride].e2 - expected[i].e2));
  }
  return worst;
}

template <std::size_t n>
void run(const char* name, const SpatialPath<n>& path) {
  const FrameRoll roll = rotation_minimising_roll(path).value();
  const double spread = path.xi_end() - path.xi_begin();
  std::size_t pieces = 0;
  for (std::size_t k = 0; k < path.segment_count(); ++k) pieces += roll.pieces(k).size();
  std::printf("%s: %zu segments, %zu pieces, roll within %.1e rad, kernels %s\n", name,
              path.segment_count(), pieces, roll.error_bound(),
              batch_detail::kernel_instruction_set());
  Buffers mine, theirs;
  mine.resize(0.0, 1.0, 2);
  const double preparation = time_of([&] {
    const auto made = rotation_minimising_roll(path);
    const RolledFrames frames(path, *made);
    bench::keep(frames);
  });
  const auto per_segment_in_us = [&](double time) {
    return time / 1000.0 / static_cast<double>(path.segment_count());
  };
  std::printf("  preparation %.2f us a segment", per_segment_in_us(preparation));
  for (const double goal : goals) {
    const double time =
        time_of([&] { bench::keep(rotation_minimising_roll_within(PreimageTable(path), goal)); });
    std::printf(", within %.0e %.2f", goal, per_segment_in_us(time));
  }
  std::printf("\n");
  std::printf("  %9s %12s | %22s | %30s | %s\n", "frames", "exact", "same frames, reflected",
              "same time: error, x less exact", "to an error: times our time");
  for (const std::size_t per_segment : {10UL, 100UL, 1000UL, 10000UL}) {
    const std::size_t count = per_segment * path.segment_count() + 1;
    if (count > 2'000'000) continue;
    mine.resize(path.xi_begin(), path.xi_end(), count);
    const double our_time = time_of([&] { exact(path, mine); });
    exact(path, mine);
    const std::vector<Frame3<double>> expected = mine.frames;
    const auto reflected = [&](std::size_t stride) {
      theirs.resize(path.xi_begin(), path.xi_end(), (count - 1) * stride + 1);
      const double time = time_of([&] { double_reflection(path, theirs); });
      double_reflection(path, theirs);
      return std::array{time, error_of(theirs.frames, expected, stride)};
    };
    const auto same = reflected(1);
    // As many steps as fit in our time (at least one a frame).
    const auto fits = std::max<std::size_t>(1, static_cast<std::size_t>(our_time / same[0]));
    const auto equal_time = reflected(fits);
    std::printf("  %9zu %9.1f ns | %9.1f ns %9.1e | %12.1e %12.0fx | ", count,
                our_time / static_cast<double>(count), same[0] / static_cast<double>(count),
                same[1], equal_time[1], equal_time[1] / roll.error_bound());
    for (const double goal : goals) {
      // Fourth order: as many steps a frame as the error asks for.
      const auto stride =
          static_cast<std::size_t>(std::max(1.0, std::ceil(std::pow(same[1] / goal, 0.25))));
      if ((count - 1) * stride > 20'000'000) {
        std::printf("%7.0e: -      ", goal);
        continue;
      }
      const auto there = reflected(stride);
      const double time = time_of([&] { exact_within(path, mine, goal); });
      std::printf("%7.0e: %6.1fx%s ", goal, there[0] / time, there[1] > goal ? "*" : " ");
    }
    std::printf("\n");
  }
  bench::keep(spread);
}

}  // namespace

int main() {
  run("closed loop, degree 7", closed_loop({1.0, 0.6 * std::numbers::pi}).value());
  run("one tame quintic", smooth_path<2>(1, 0.3));
  run("100 quintics", smooth_path<2>(100, 0.3));
  run("100 wild quintics", smooth_path<2>(100, 0.9));
  run("100 curves of degree 17", smooth_path<8>(100, 0.3));
  std::printf("* rounding keeps it from getting there\n");
}
