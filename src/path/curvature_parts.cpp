// SPDX-License-Identifier: MIT
// The curvature bound of the parts of a segment, for any degree, in the plane and in space.
#include "hodograph/path/curvature_parts.hpp"

#include <cmath>
#include <limits>
#include <memory>

#include "hodograph/bernstein/binomial.hpp"
#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/path/detail/enclosed_curve.hpp"

namespace hodograph {
namespace {

constexpr std::size_t most_degree = 30;  // binomial coefficients of 2n are exact to 61
constexpr std::size_t most_components = 4;
using Coefficients = std::array<std::array<Enclosure, most_components>, most_degree + 1>;

/// De Casteljau's algorithm at u in [0, 1]: the part on [0, u] (left) or on [u, 1].
void cut(Coefficients& c, std::size_t n, std::size_t components, const Enclosure& u, bool left) {
  const Enclosure v = Enclosure(1.0) - u;
  for (std::size_t j = 0; j < components; ++j) {
    std::array<Enclosure, most_degree + 1> row;
    for (std::size_t i = 0; i <= n; ++i) row[i] = c[i][j];
    for (std::size_t r = 1; r <= n; ++r) {
      for (std::size_t i = 0; i + r <= n; ++i) row[i] = v * row[i] + u * row[i + 1];
      (left ? c[r][j] : c[n - r][j]) = left ? row[0] : row[n - r];
    }
  }
}

/// C(m, i) C(n, j)/C(m + n, i + j), enclosed.
Enclosure product_weight(std::size_t m, std::size_t i, std::size_t n, std::size_t j) {
  const auto number = [](std::size_t a, std::size_t b) {  // below 2^63, so one rounding
    const double value = static_cast<double>(binomial(a, b));
    return Enclosure(Enclosure::down(value), Enclosure::up(value));
  };
  return number(m, i) * number(n, j) / number(m + n, i + j);
}

struct ProductTables {
  std::size_t n;
  std::array<std::array<Enclosure, most_degree + 1>, most_degree + 1> square, with_derivative;
  explicit ProductTables(std::size_t degree) : n(degree) {
    for (std::size_t i = 0; i <= n; ++i) {
      for (std::size_t j = 0; j <= n; ++j) square[i][j] = product_weight(n, i, n, j);
      for (std::size_t j = 0; j < n; ++j) {
        with_derivative[i][j] = product_weight(n, i, n - 1, j);
      }
    }
  }
};

const ProductTables& tables_of(std::size_t n) {
  thread_local std::array<std::unique_ptr<ProductTables>, most_degree + 1> tables;
  if (!tables[n]) tables[n] = std::make_unique<ProductTables>(n);
  return *tables[n];
}

/// max |V_k| of vec(B* B') without its first component in space, ' = d/dv; an upper bound.
double largest_turning(const Coefficients& c, const ProductTables& tables, std::size_t components) {
  const std::size_t n = tables.n;
  std::array<std::array<Enclosure, 2>, 2 * most_degree> turning{};
  for (std::size_t j = 0; j < n; ++j) {
    std::array<Enclosure, most_components> d;  // B'/n
    for (std::size_t q = 0; q < components; ++q) d[q] = c[j + 1][q] - c[j][q];
    for (std::size_t i = 0; i <= n; ++i) {
      const Enclosure& weight = tables.with_derivative[i][j];
      const auto& a = c[i];
      if (components == 2) {
        turning[i + j][0] += weight * (a[0] * d[1] - a[1] * d[0]);
      } else {
        turning[i + j][0] += weight * ((a[0] * d[2] - a[2] * d[0]) - (a[3] * d[1] - a[1] * d[3]));
        turning[i + j][1] += weight * ((a[0] * d[3] - a[3] * d[0]) - (a[1] * d[2] - a[2] * d[1]));
      }
    }
  }
  double largest = 0.0;
  for (std::size_t k = 0; k < 2 * n; ++k) {
    const double size = components == 2
                            ? turning[k][0].magnitude()
                            : sqrt(square(turning[k][0]) + square(turning[k][1])).upper();
    largest = std::max(largest, size);
  }
  return Enclosure::up(static_cast<double>(n) * largest);
}

/// A lower bound of |B|², 0 at least.
double smallest_speed(const Coefficients& c, const ProductTables& tables, std::size_t components) {
  const std::size_t n = tables.n;
  std::array<Enclosure, 2 * most_degree + 1> speed{};
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = i; j <= n; ++j) {
      Enclosure sum(0.0);
      for (std::size_t q = 0; q < components; ++q) {
        sum += i == j ? square(c[i][q]) : c[i][q] * c[j][q];
      }
      const Enclosure term = tables.square[i][j] * sum;
      speed[i + j] += i == j ? term : term + term;
    }
  }
  double least = speed[0].lower();
  for (std::size_t k = 1; k <= 2 * n; ++k) least = std::min(least, speed[k].lower());
  return std::max(0.0, least);
}

}  // namespace

void bound_curvature_of_parts(std::span<const double> preimage, std::size_t components, double step,
                              std::span<double> most_curvature) {
  const std::size_t n = preimage.size() / components - 1, count = most_curvature.size();
  if (n == 0) {  // straight, but for a preimage of zero, which does not move
    std::fill(most_curvature.begin(), most_curvature.end(), 0.0);
    return;
  }
  double size = 0.0;
  for (const double x : preimage) size = std::max(size, std::abs(x));
  int exponent = 0;
  std::frexp(size, &exponent);
  const ProductTables& tables = tables_of(n);
  for (std::size_t part = 0; part < count; ++part) {
    // With B = 2^-exponent A: κ = 2|vec(B* B')|/(h w |B|⁴) · 4^-exponent, w the part's length in u.
    Coefficients c;
    for (std::size_t i = 0; i <= n; ++i) {
      for (std::size_t j = 0; j < components; ++j) {
        const double x = preimage[i * components + j], b = std::ldexp(x, -exponent);
        c[i][j] = std::ldexp(b, exponent) == x ? Enclosure(b)
                                               : Enclosure(Enclosure::down(b), Enclosure::up(b));
      }
    }
    const Enclosure parts(static_cast<double>(count));
    const Enclosure begin = Enclosure(static_cast<double>(part)) / parts;
    const Enclosure end = Enclosure(static_cast<double>(part + 1)) / parts;
    if (part + 1 < count) cut(c, n, components, end, true);
    if (part > 0) cut(c, n, components, begin / end, false);
    const double turning = largest_turning(c, tables, components);
    const double speed = smallest_speed(c, tables, components);
    if (turning == 0.0) {
      most_curvature[part] = 0.0;
    } else if (speed == 0.0) {
      most_curvature[part] = std::numeric_limits<double>::infinity();
    } else {
      const Enclosure bound = Enclosure(2.0 * turning) * parts /
                              (Enclosure(step) * square(Enclosure(speed))) *
                              path_detail::power_of_two(-2 * exponent);
      most_curvature[part] = bound.upper();
    }
  }
}

}  // namespace hodograph
