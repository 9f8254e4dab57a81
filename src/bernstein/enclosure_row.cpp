// SPDX-License-Identifier: MIT
// Subdivision, restriction and evaluation of Bernstein polynomials with enclosures as coefficients.
#include "enclosure_row.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace hodograph {

EnclosureRow::EnclosureRow(std::span<const Enclosure> coefficients)
    : EnclosureRow(coefficients.size()) {
  for (std::size_t i = 0; i < size(); ++i) set(i, coefficients[i]);
}

Enclosure EnclosureRow::hull() const {
  return {*std::min_element(lower_.begin(), lower_.end()),
          *std::max_element(upper_.begin(), upper_.end())};
}

double EnclosureRow::noise() const {
  double width = 0.0;
  for (std::size_t i = 0; i < size(); ++i) width = std::max(width, upper_[i] - lower_[i]);
  return width;
}

EnclosureRow EnclosureRow::derivative() const {
  EnclosureRow result(size() > 1 ? size() - 1 : 1);
  const Enclosure factor(static_cast<double>(degree()));
  for (std::size_t i = 0; i + 1 < size(); ++i) {
    result.set(i, factor * ((*this)[i + 1] - (*this)[i]));
  }
  return result;
}

namespace {

/// Σ c_i C(n,i) u^i (1-u)^(n-i), in the arithmetic of the number u.
template <class Number, class Coefficient>
Number bernstein_sum(std::size_t size, const Number& u, const Coefficient& coefficient) {
  const Number v = Number(1.0) - u;
  std::vector<Number> power_of_v(size, Number(1.0));
  for (std::size_t i = 1; i < size; ++i) power_of_v[i] = power_of_v[i - 1] * v;
  const std::size_t n = size - 1;
  Number power_of_u(1.0), ways(1.0), sum(0.0);
  for (std::size_t i = 0; i <= n; ++i) {
    sum = sum + (ways * (power_of_u * power_of_v[n - i])) * coefficient(i);
    power_of_u = power_of_u * u;
    ways = ways * Number(static_cast<double>(n - i)) / Number(static_cast<double>(i + 1));
  }
  return sum;
}

}  // namespace

Enclosure EnclosureRow::value(const Enclosure& u) const {
  return bernstein_sum(size(), u, [this](std::size_t i) { return (*this)[i]; });
}

double EnclosureRow::approximate_value(double u) const {
  return bernstein_sum(size(), u, [this](std::size_t i) { return (*this)[i].middle(); });
}

EnclosureRow EnclosureRow::restricted(const Enclosure& a, const Enclosure& b) const {
  std::vector<Enclosure> point(size());
  for (std::size_t i = 0; i < size(); ++i) point[i] = (*this)[i];
  // To [0, b]: what is left at index 0 after r steps at b is coefficient r.
  std::vector<Enclosure> left(size());
  const Enclosure one(1.0);
  if (b == one) {
    left = point;
  } else {
    const Enclosure v = one - b;
    left[0] = point[0];
    for (std::size_t r = 1; r < size(); ++r) {
      for (std::size_t i = 0; i + r < size(); ++i) point[i] = v * point[i] + b * point[i + 1];
      left[r] = point[0];
    }
  }
  // To [a/b, 1] of that; a/b is at most 1.
  if (!a.is_zero()) {
    const Enclosure ratio = b == one ? a : a / b;
    const Enclosure u(std::max(ratio.lower(), 0.0), std::min(ratio.upper(), 1.0));
    const Enclosure v = one - u;
    for (std::size_t r = 1; r < size(); ++r) {
      for (std::size_t i = 0; i + r < size(); ++i) left[i] = v * left[i] + u * left[i + 1];
    }
  }
  return EnclosureRow(left);
}

namespace {

/// One end of every coefficient of the halves by de Casteljau's algorithm: `right` holds those of
/// the whole on entry. Each mean of two ends moves outwards: the sum s by at least one ulp, |s|
/// 2^-52 (see Enclosure), its half, inexact only among the subnormals, by the smallest of them.
template <int outward>
void halve(std::vector<double>& left, std::vector<double>& right) {
  constexpr double relative_step = outward * 0x1.0p-52;  // one ulp, as in Enclosure
  constexpr double smallest = outward * std::numeric_limits<double>::denorm_min();
  double* point = right.data();
  left[0] = point[0];
  for (std::size_t r = 1; r < right.size(); ++r) {
    for (std::size_t i = 0; i + r < right.size(); ++i) {
      const double sum = point[i] + point[i + 1];
      point[i] = 0.5 * (sum + relative_step * std::abs(sum)) + smallest;
    }
    left[r] = point[0];
  }
}

}  // namespace

EnclosureRow EnclosureRow::split_off_left_half() {
  EnclosureRow left(size());
  halve<-1>(left.lower_, lower_);
  halve<+1>(left.upper_, upper_);
  return left;
}

Enclosure scaled(const Enclosure& x, int exponent) {
  const auto end = [&](double value, double outward) {
    const double result = std::ldexp(value, exponent);
    if (!std::isfinite(result) || std::ldexp(result, -exponent) == value) return result;
    return result + outward;
  };
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  const double lower = end(x.lower(), -smallest), upper = end(x.upper(), smallest);
  return {std::min(lower, std::numeric_limits<double>::max()),
          std::max(upper, -std::numeric_limits<double>::max())};
}

int largest_exponent(std::span<const Enclosure> numbers) {
  double size = 0.0;
  for (const Enclosure& x : numbers) size = std::max(size, x.magnitude());
  assert(std::isfinite(size));
  int exponent = 0;
  if (size > 0.0) std::frexp(size, &exponent);
  return exponent;
}

}  // namespace hodograph
