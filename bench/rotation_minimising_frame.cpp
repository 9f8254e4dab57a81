// SPDX-License-Identifier: MIT
// Rotation-minimising frames along a path against the double reflection method (Wang, Jüttler,
// Zheng, Liu 2008), all preparation included, in two senses:
//   (a) few frames are wanted (one a segment: at the knots), right within a goal; double reflection
//       takes as many steps between them as the goal asks for;
//   (b) many are wanted (10 to 10 000 a segment); double reflection steps from frame to frame, in
//       several steps only where the goal asks for them.
// Its error is of order 4: the number of steps is found from the error of one step a frame. Times
// are processor time of this thread, medians.
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/frame/batch.hpp"
#include "hodograph/frame/minimising_frames.hpp"
#include "hodograph/frame/roll.hpp"
#include "hodograph/frame/rolled_frames.hpp"
#include "support/measure.hpp"

namespace {

using namespace hodograph;

constexpr double goals[] = {1e-6, 1e-9, 1e-12};  // not a tolerance: the accuracies compared
constexpr double coarse = 0.01;                  // an error too large to show an order

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

double now() {
  timespec at{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &at);
  return static_cast<double>(at.tv_sec) * 1e9 + static_cast<double>(at.tv_nsec);
}

/// Nanoseconds, the median of a few runs, each of several calls where one is short.
template <class Run>
double time_of(const Run& run) {
  constexpr double shortest = 20'000.0, longest = 1e8;
  const double start = now();
  run();
  const double once = now() - start;
  const int calls = once < shortest ? static_cast<int>(shortest / std::max(once, 100.0)) + 1 : 1;
  std::vector<double> times;
  do {
    const double begin = now();
    for (int i = 0; i < calls; ++i) run();
    times.push_back((now() - begin) / calls);
  } while (times.size() < 7 || (times.size() < 201 && now() - start < longest));
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

/// The largest distance of an e₂ from what it should be, at every `stride`-th frame.
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
  std::printf("%s: %zu segments, kernels %s\n", name, path.segment_count(),
              batch_detail::kernel_instruction_set());
  std::printf("  %9s %21s | %s\n", "frames", "reflected: ns, error",
              "for each goal: ns a frame, times faster; times the finest bound in equal time");
  Buffers mine, theirs;
  for (const std::size_t per_segment : {1UL, 10UL, 100UL, 1000UL, 10000UL}) {
    const std::size_t count = per_segment * path.segment_count() + 1;
    if (count > 2'000'000) continue;
    mine.resize(path.xi_begin(), path.xi_end(), count);
    if (per_segment == 1) mine.xi = path.knots();
    exact(path, mine);
    const std::vector<Frame3<double>> expected = mine.frames;
    const auto reflected = [&](std::size_t stride) {
      theirs.resize(path.xi_begin(), path.xi_end(), (count - 1) * stride + 1);
      for (std::size_t i = 0; i + 1 < count; ++i) {
        for (std::size_t j = 0; j < stride; ++j) {
          theirs.xi[i * stride + j] = mine.xi[i] + (mine.xi[i + 1] - mine.xi[i]) *
                                                       static_cast<double>(j) /
                                                       static_cast<double>(stride);
        }
      }
      const double time = time_of([&] { double_reflection(path, theirs); });
      double_reflection(path, theirs);
      return std::array{time, error_of(theirs.frames, expected, stride)};
    };
    // One step a frame; where that is too coarse to tell the order, more.
    std::size_t first = 1;
    auto same = reflected(first);
    const double one_step = same[0];
    while (same[1] > coarse) same = reflected(first *= 4);
    std::printf("  %9zu %9.1f ns %8.1e |", count, one_step / static_cast<double>(count),
                first == 1 ? same[1] : reflected(1)[1]);
    double finest_time = 0.0, finest_bound = 0.0;
    for (const double goal : goals) {
      const auto bound = rotation_minimising_frames(path, goal, mine.xi, mine.frames);
      if (!bound) {
        std::printf(" %.0e: rounding is more", goal);
        continue;
      }
      const double time = time_of(
          [&] { bench::keep(rotation_minimising_frames(path, goal, mine.xi, mine.frames)); });
      finest_time = time;
      finest_bound = *bound;
      // Fourth order: as many steps a frame as the error asks for.
      const auto steps = static_cast<std::size_t>(
          std::max(1.0, std::ceil(static_cast<double>(first) * std::pow(same[1] / goal, 0.25))));
      std::printf(" %.0e: %6.1f ns", goal, time / static_cast<double>(count));
      if ((count - 1) * steps > 20'000'000) {
        std::printf("     -   ");
      } else {
        const auto there = reflected(steps);
        std::printf(" %6.1fx%s", there[0] / time, there[1] > goal ? "*" : " ");
      }
    }
    // As many steps as fit in the time of our finest.
    const auto fitting = std::max<std::size_t>(1, static_cast<std::size_t>(finest_time / one_step));
    std::printf("| %8.0ex\n", reflected(fitting)[1] / finest_bound);
  }
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
