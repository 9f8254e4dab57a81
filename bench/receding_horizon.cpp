// SPDX-License-Identifier: MIT
// How long does the next plan of a receding horizon take, warm, against the same plan from cold?
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "support/measure.hpp"
#if defined(HODOGRAPH_HAS_CONTROL)
#include "hodograph/construction/planar_spline.hpp"
#include "hodograph/control/receding_horizon.hpp"

namespace {

using namespace hodograph;

/// A course with bends of different radii, some 300 m round.
AnyPath course() {
  std::vector<Vector2<double>> points;
  constexpr std::size_t count = 16;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / count;
    const double radius = 45.0 + 10.0 * std::cos(3.0 * angle);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return planar_spline(points, {.closed = true}).value().path;
}

struct Latencies {
  std::vector<double> seconds;
  std::size_t iterations = 0;
  void print(const char* name) {
    std::sort(seconds.begin(), seconds.end());
    const auto at = [this](double share) {
      return 1e3 *
             seconds[static_cast<std::size_t>(share * static_cast<double>(seconds.size() - 1))];
    };
    std::printf("  %-8s %8.2f %8.2f %8.2f %8.2f %8.2f   %6.1f\n", name, at(0.0), at(0.5), at(0.95),
                at(0.99), at(1.0),
                static_cast<double>(iterations) / static_cast<double>(seconds.size()));
  }
  double median() const { return seconds[seconds.size() / 2]; }
};

void run(std::size_t intervals, double step) {
  const AnyPath path = course();
  FollowLimits limits;
  limits.speed = 15.0;
  limits.acceleration = 3.0;
  limits.braking = 5.0;
  limits.lateral_acceleration = 5.0;
  limits.offset = 1.5;
  HorizonOptions options;
  options.intervals = intervals;
  options.step = step;
  RecedingHorizon warm = RecedingHorizon::make(path, limits, options).value();
  bench::Numbers numbers;
  FollowStart state;
  state.speed = 5.0;
  Latencies next, fresh;
  constexpr int plans = 150;
  for (int i = 0; i < plans; ++i) {
    const HorizonPlan plan = warm.plan(state).value();
    if (i > 0) {
      next.seconds.push_back(plan.latency_s);
      next.iterations += plan.iterations;
      // The same state from cold, by a solver that knows nothing yet.
      RecedingHorizon cold = RecedingHorizon::make(path, limits, options).value();
      const HorizonPlan first = cold.plan(state).value();
      fresh.seconds.push_back(first.latency_s);
      fresh.iterations += first.iterations;
    }
    state = warm.predicted();
    if (state.xi > path.xi_end()) state.xi -= path.xi_end() - path.xi_begin();
    constexpr double share = 0.02;  // of the limits, as disturbance
    state.offset[0] += share * limits.offset * numbers.within(-1, 1);
    state.heading += share * numbers.within(-1, 1);
    state.speed =
        std::clamp(state.speed + share * limits.speed * numbers.within(-1, 1), 0.0, limits.speed);
  }
  std::printf("%zu steps of %.1f s ahead; ms\n  %-8s %8s %8s %8s %8s %8s   %6s\n", intervals, step,
              "", "least", "median", "95 %", "99 %", "most", "iter.");
  next.print("warm");
  fresh.print("cold");
  std::printf("  cold/warm %.2f\n", fresh.median() / next.median());
}

}  // namespace

int main() {
  run(25, 0.2);
  run(40, 0.1);
}
#else
int main() { std::puts("built without the component control"); }
#endif
