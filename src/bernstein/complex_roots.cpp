// SPDX-License-Identifier: MIT
// Aberth's iteration for all roots of a polynomial.
#include "hodograph/bernstein/complex_roots.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "hodograph/foundation/scalar.hpp"

namespace hodograph {

std::optional<std::vector<std::complex<double>>> complex_roots(
    std::vector<std::complex<double>> a) {
  using Number = std::complex<double>;
  double largest = 0.0;
  for (const Number& c : a) {
    if (!std::isfinite(c.real()) || !std::isfinite(c.imag())) return std::nullopt;
    largest = std::max(largest, std::abs(c));
  }
  std::vector<Number> roots;
  while (!a.empty() && std::abs(a.back()) == 0.0) a.pop_back();
  if (a.empty()) return std::nullopt;
  std::size_t zeros = 0;
  while (std::abs(a[zeros]) == 0.0) ++zeros;
  a.erase(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(zeros));
  const std::size_t n = a.size() - 1;
  if (n == 0) return std::vector<Number>(zeros);

  // Guesses (Bini 1996) on circles whose radii the upper convex hull of the points (k, log |a_k|)
  // gives: as many on each as its edge is long, about as many roots as there are of that size.
  const auto height = [&](std::size_t k) { return std::log(std::abs(a[k])); };
  std::vector<std::size_t> hull;
  for (std::size_t k = 0; k <= n; ++k) {
    if (std::abs(a[k]) == 0.0) continue;
    const auto is_below = [&](std::size_t first, std::size_t middle) {
      return (height(middle) - height(first)) * static_cast<double>(k - first) <=
             (height(k) - height(first)) * static_cast<double>(middle - first);
    };
    while (hull.size() > 1 && is_below(hull[hull.size() - 2], hull.back())) hull.pop_back();
    hull.push_back(k);
  }
  constexpr double offset = 0.7;  // no guess on an axis of symmetry
  for (std::size_t edge = 0; edge + 1 < hull.size(); ++edge) {
    const std::size_t count = hull[edge + 1] - hull[edge];
    const auto m = static_cast<double>(count);
    const double radius = std::exp((height(hull[edge]) - height(hull[edge + 1])) / m);
    if (!std::isfinite(radius) || !(radius > 0.0)) return std::nullopt;
    for (std::size_t i = 0; i < count; ++i) {
      const double turn = static_cast<double>(i) / m + static_cast<double>(edge) / (m + 1.0);
      roots.push_back(std::polar(radius, 2.0 * std::numbers::pi * turn + offset));
    }
  }
  constexpr int most_steps = 120;
  std::vector<bool> settled(n, false);
  std::vector<int> close(n, 0);
  std::size_t open = n;
  for (int step = 0; step < most_steps && open > 0; ++step) {
    for (std::size_t i = 0; i < n; ++i) {
      if (settled[i]) continue;
      const Number z = roots[i];
      const double r = std::abs(z);
      Number value = 0.0, slope = 0.0;
      double size = 0.0;
      for (std::size_t k = n + 1; k-- > 0;) {
        slope = slope * z + value;
        value = value * z + a[k];
        size = size * r + std::abs(a[k]);
      }
      if (!std::isfinite(size)) return std::nullopt;
      // The value is rounding: nothing better can be found. Up to the bound of it, two more steps.
      const double value_size = std::abs(value);
      if (value_size <= static_cast<double>(n + 1) * epsilon<double>() * size) ++close[i];
      if (value_size <= 2.0 * epsilon<double>() * size || close[i] > 2) {
        settled[i] = true;
        --open;
        continue;
      }
      Number others = 0.0;
      for (std::size_t j = 0; j < n; ++j) {
        if (j != i && roots[j] != z) others += 1.0 / (z - roots[j]);
      }
      const Number change = value / (slope - value * others);
      if (!std::isfinite(change.real()) || !std::isfinite(change.imag())) return std::nullopt;
      roots[i] = z - change;
      if (std::abs(change) <= 0.5 * epsilon<double>() * r) {
        settled[i] = true;
        --open;
      }
    }
  }
  if (open > 0) return std::nullopt;
  roots.insert(roots.end(), zeros, Number(0.0));
  return roots;
}

}  // namespace hodograph
