// SPDX-License-Identifier: MIT
// How long does the point at a given arc length take, against Newton's iteration on adaptive
// Gauss-Kronrod quadrature of the same curve's speed, and how accurate is each?
#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "hodograph/path/batch.hpp"
#include "support/measure.hpp"

namespace {

using namespace hodograph;

/// The plain way: s(u) by quadrature of |r'|, Newton with bisection as a safeguard.
template <std::size_t n>
double by_quadrature(const SpatialPhCurve<n>& curve, double t) {
  using boost::math::quadrature::gauss_kronrod;
  // The quadrature's estimate of its own error is far too careful on a polynomial: asked for this
  // much it delivers rounding, asked for rounding it takes milliseconds.
  constexpr double tolerance = 0x1p-26;
  constexpr double small_step = 4 * std::numeric_limits<double>::epsilon();
  constexpr unsigned deepest = 5;
  const auto speed = [&](double u) { return curve.parameter_step() * curve.speed(u); };
  double u = t / curve.arc_length(), low = 0, high = 1;
  for (int step = 0; step < 60; ++step) {
    const double rest = t - gauss_kronrod<double, 15>::integrate(speed, 0.0, u, deepest, tolerance);
    (rest > 0 ? low : high) = u;
    const double next = u + rest / speed(u);
    const double change = std::abs(next - u);
    u = low <= next && next <= high ? next : 0.5 * (low + high);
    if (change <= small_step || std::abs(rest) <= small_step * curve.arc_length()) break;
  }
  return u;
}

template <std::size_t n>
void run(double wildness) {
  constexpr std::size_t count = 2048;
  const auto path = bench::random_path<n>(1000, wildness);
  bench::Numbers numbers;
  const auto random = numbers.many(count, 0.0, path.arc_length(), false);
  const auto sorted = numbers.many(64 * count, 0.0, path.arc_length(), true);
  std::vector<Vector3<double>> points(sorted.size());
  std::vector<double> parameters(sorted.size());
  const auto& lengths = path.knot_arc_lengths();
  const auto location = [&](double s) {  // the plain way finds the segment by binary search
    const auto above = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, s);
    const auto k = static_cast<std::size_t>(above - lengths.begin()) - 1;
    return PathLocation<double>{k, by_quadrature(path.segment(k), s - lengths[k])};
  };
  const auto items = static_cast<double>(count);
  char title[128];
  std::snprintf(title, sizeof title, "degree %zu, 1000 segments, preimages varying by %g",
                2 * n + 1, wildness);
  bench::compare(
      title,
      {{"point: Newton on Gauss-Kronrod (Boost)",
        [&] {
          for (const double s : random) bench::keep(path.position(location(s)));
        },
        items},
       {"point_at_arc_length, random",
        [&] {
          for (const double s : random) bench::keep(point_at_arc_length(path, s));
        },
        items},
       {"parameter_at_arc_length, random",
        [&] {
          for (const double s : random) bench::keep(parameter_at_arc_length(path, s));
        },
        items},
       {"point_at_arc_length, sorted",
        [&] {
          for (const double s : sorted) bench::keep(point_at_arc_length(path, s));
        },
        64 * items},
       {"points_at_arc_lengths, sorted batch",
        [&] {
          points_at_arc_lengths(path, std::span<const double>(sorted), std::span(points));
          bench::keep(points);
        },
        64 * items},
       {"parameters_at_arc_lengths, sorted batch",
        [&] {
          parameters_at_arc_lengths(path, std::span<const double>(sorted), std::span(parameters));
          bench::keep(parameters);
        },
        64 * items}},
      15);
  double quadrature_residual = 0, residual = 0;
  for (const double s : random) {
    // In long double, so that the judge does not round.
    const auto judge = [&](const PathLocation<double>& at) {
      const auto& curve = path.segment(at.segment);
      const auto wide = curve.preimage().mapped([](const Quaternion<double>& a) {
        return Quaternion<long double>{a.w, a.x, a.y, a.z};
      });
      const SpatialPhCurve<n, long double> exact({}, wide, curve.parameter_step());
      const long double t = s - path.knot_arc_lengths()[at.segment];
      return static_cast<double>(std::abs(exact.arc_length(static_cast<long double>(at.u)) - t) /
                                 exact.arc_length());
    };
    quadrature_residual = std::max(quadrature_residual, judge(location(s)));
    residual = std::max(residual, judge(location_at_arc_length(path, s)));
  }
  std::printf("  largest residual / segment length: Boost %.2g, exact inverse %.2g\n\n",
              quadrature_residual, residual);
}

}  // namespace

int main() {
  run<8>(0.3);
  run<8>(0.02);
  run<2>(0.3);
  run<2>(0.02);
}
