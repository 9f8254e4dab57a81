// SPDX-License-Identifier: MIT
// How long do certified bounds of the curvature of a planar quintic take, and the test of a limit,
// against 1000 samples without any certainty?
#include <cmath>

#include "hodograph/path/planar_curvature.hpp"
#include "support/measure.hpp"

namespace {

using namespace hodograph;
using Curve = PlanarPhCurve<2>;

/// The largest |κ| at 1000 samples, by the preimage and its derivative.
double sampled(const Curve& curve) {
  constexpr int samples = 1000;
  const auto& w = curve.preimage();
  double most = 0.0;
  for (int i = 0; i <= samples; ++i) {
    const double u = static_cast<double>(i) / samples, v = 1.0 - u;
    const auto left = v * w[0] + u * w[1], right = v * w[1] + u * w[2];
    const auto value = v * left + u * right, rate = 2.0 * (right - left);
    const double speed = dot(value, value);
    most = std::max(most, std::abs(value.re * rate.im - value.im * rate.re) / (speed * speed));
  }
  return 2.0 * most;
}

void run(double wildness) {
  constexpr std::size_t count = 1000;
  const auto curves = bench::random_quintics(count, wildness);
  std::vector<double> limits;
  constexpr RangeGoal goal{std::numeric_limits<float>::epsilon()};
  for (const auto& curve : curves)
    limits.push_back(curvature_extremes(curve, goal).range().magnitude());
  const auto test = [&](double factor) {
    return [&curves, &limits, factor] {
      for (std::size_t k = 0; k < count; ++k) {
        bench::keep(curvature_stays_within(curves[k], factor * limits[k]));
      }
    };
  };
  const auto items = static_cast<double>(count);
  bench::compare("quintics of wildness " + std::to_string(wildness),
                 {{"1000 samples",
                   [&] {
                     for (const auto& c : curves) bench::keep(sampled(c));
                   },
                   items},
                  {"curvature_extremes",
                   [&] {
                     for (const auto& c : curves) bench::keep(curvature_extremes(c, goal));
                   },
                   items},
                  {"curvature_stays_within, 2 times its maximum", test(2.0), items},
                  {"curvature_stays_within, 1.1 times its maximum", test(1.1), items},
                  {"curvature_stays_within, 0.9 times its maximum", test(0.9), items},
                  {"curvature_stays_within, 0.5 times its maximum", test(0.5), items}});
}

}  // namespace

int main() {
  run(0.3);
  run(0.6);
  run(1.0);
}
