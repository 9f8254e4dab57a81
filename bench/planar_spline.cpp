// SPDX-License-Identifier: MIT
// How long does the C² spline through points take, against the plain way: the same Newton
// iteration in std::complex, row by row with a divided pivot each, from the same kind of start?
#include "hodograph/construction/planar_spline.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "support/measure.hpp"

namespace {

using namespace hodograph;
using Number = std::complex<double>;

/// A walk that turns by up to 45° at a time.
std::vector<Vector2<double>> walk(std::size_t count) {
  bench::Numbers numbers;
  std::vector<Vector2<double>> points(1);
  double angle = 0.0;
  while (points.size() < count) {
    angle += numbers.within(-0.8, 0.8);
    const double step = numbers.within(0.5, 1.5);
    points.push_back(points.back() +
                     Vector2<double>{step * std::cos(angle), step * std::sin(angle)});
  }
  return points;
}

/// Around a circle, and around a flower of 200 petals where there are enough points for it.
std::vector<Vector2<double>> flower(std::size_t count) {
  std::vector<Vector2<double>> points;
  while (points.size() < count) {
    const double t =
        2.0 * std::numbers::pi * static_cast<double>(points.size()) / static_cast<double>(count);
    const double r = 1.0 + 0.1 * std::cos(200.0 * t) * (count > 10000 ? 1.0 : 0.0);
    points.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return points;
}

/// Solves the tridiagonal system; the pivots are in `diagonal` afterwards.
template <class T>
void solve(const std::vector<T>& lower, std::vector<T>& diagonal, const std::vector<T>& upper,
           std::vector<Number>& right) {
  for (std::size_t i = 1; i < right.size(); ++i) {
    const T factor = lower[i] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    right[i] -= factor * right[i - 1];
  }
  right.back() /= diagonal.back();
  for (std::size_t i = right.size() - 1; i-- > 0;) {
    right[i] = (right[i] - upper[i] * right[i + 1]) / diagonal[i];
  }
}

/// 3x² + 27z² + 3y² + xy + 13xz + 13zy = 60 Δq, x and y the neighbours of z, beyond the ends
/// 2z_1 - z_2: Newton from the cubic spline.
std::pair<std::vector<Number>, int> plain_spline(const std::vector<Vector2<double>>& points) {
  const std::size_t size = points.size() - 1;
  std::vector<Number> chord(size), d(size + 1), z(size), right(size);
  for (std::size_t i = 0; i < size; ++i) {
    chord[i] = {points[i + 1].x - points[i].x, points[i + 1].y - points[i].y};
  }
  std::vector<double> below(size + 1, 1.0), middle(size + 1, 4.0), above(size + 1, 1.0);
  middle.front() = middle.back() = 1.0;
  d.front() = 2.0 * chord.front();
  d.back() = 2.0 * chord.back();
  for (std::size_t k = 1; k < size; ++k) d[k] = 3.0 * (chord[k - 1] + chord[k]);
  solve(below, middle, above, d);
  for (std::size_t i = 0; i < size; ++i) {
    z[i] = std::sqrt(0.25 * (6.0 * chord[i] - d[i] - d[i + 1]));
    if (i > 0 && (std::conj(z[i - 1]) * z[i]).real() < 0.0) z[i] = -z[i];
  }
  std::vector<Number> lower(size), diagonal(size), upper(size);
  for (int steps = 0;; ++steps) {
    double worst = 0.0;
    for (std::size_t i = 0; i < size; ++i) {
      const Number b = z[i], a = i > 0 ? z[i - 1] : 2.0 * b - z[1],
                   c = i + 1 < size ? z[i + 1] : 2.0 * b - a;
      right[i] =
          60.0 * chord[i] - (3.0 * a * a + 27.0 * b * b + 3.0 * c * c + a * c + 13.0 * b * (a + c));
      lower[i] = 6.0 * a + 13.0 * b + c;
      upper[i] = 6.0 * c + 13.0 * b + a;
      diagonal[i] = 54.0 * b + 13.0 * (a + c);
      if (i == 0) {
        diagonal[i] += 2.0 * lower[i];
        upper[i] -= lower[i];
      }
      if (i + 1 == size) {
        diagonal[i] += 2.0 * upper[i];
        lower[i] -= upper[i];
      }
      worst = std::max(worst, std::abs(right[i]) / (81.0 * std::norm(b)));
    }
    constexpr double settled = 8e-15;  // some ten roundings
    constexpr int most_steps = 20;
    if (worst < settled || steps == most_steps) return {z, steps};
    solve(lower, diagonal, upper, right);
    for (std::size_t i = 0; i < size; ++i) z[i] += right[i];
  }
}

void run(std::size_t count, bool closed) {
  const auto points = closed ? flower(count) : walk(count);
  PlanarSplineOptions options;
  options.closed = closed;
  const auto items = static_cast<double>(count);
  std::vector<bench::Rival> rivals;
  if (!closed) {
    rivals.push_back(
        {"std::complex, row by row", [&] { bench::keep(plain_spline(points)); }, items});
  }
  rivals.push_back({"planar_spline_preimage",
                    [&] { bench::keep(planar_spline_preimage(points, options)); }, items});
  rivals.push_back({"planar_spline, with the path and its tables",
                    [&] { bench::keep(planar_spline(points, options)); }, items});
  bench::compare(std::to_string(count) + (closed ? " points, closed" : " points"), rivals,
                 count > 100000 ? 5 : 101);
  const auto made = planar_spline(points, options).value();
  std::printf("  %zu Newton steps, residual %.1e; plain: %d steps; path: %.0f bytes a point\n\n",
              made.report.newton_steps, made.report.residual, plain_spline(points).second,
              static_cast<double>(made.path.memory()) / items);
}

}  // namespace

int main() {
  run(1000, false);
  run(1000, true);
  run(1000000, false);
  run(1000000, true);
}
