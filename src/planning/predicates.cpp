// SPDX-License-Identifier: MIT
// What the filters leave open, in exact arithmetic.
#include "predicates.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <limits>

namespace hodograph::planning_detail {
namespace {

using boost::multiprecision::cpp_int;

constexpr int digits = std::numeric_limits<double>::digits;
/// Every finite double is a whole multiple of 2^-1074.
constexpr int lowest_exponent = std::numeric_limits<double>::min_exponent - digits;

/// The exponent e of the last bit that may be set: x is a whole multiple of 2^e.
int last_bit(double x) {
  if (x == 0.0) return std::numeric_limits<int>::max();
  return std::max(lowest_exponent, std::ilogb(x) - (digits - 1));
}

/// x / 2^exponent, a whole number by the choice of the exponent.
cpp_int scaled(double x, int exponent) {
  if (x == 0.0) return 0;
  const int last = last_bit(x);
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(x, -last));
  return cpp_int(mantissa) << static_cast<unsigned>(last - exponent);
}

/// a - b where it is a double, else nothing (the difference of two doubles and its rounding error).
bool exact_difference(double a, double b, double& difference) {
  difference = a - b;
  const double b_part = a - difference;
  const double a_part = difference + b_part;
  return a - a_part == 0.0 && b_part - b == 0.0;
}

int sign_of(double x) { return x > 0.0 ? 1 : x < 0.0 ? -1 : 0; }

/// True where the product is 0 or its rounding error is certainly a double.
bool product_is_safe(double a, double b, double product) {
  return a == 0.0 || b == 0.0 || std::fabs(product) >= smallest_filtered;
}

int whole_number_orientation(const Point& a, const Point& b, const Point& c) {
  int exponent = std::numeric_limits<int>::max();
  for (const double x : {a.x, a.y, b.x, b.y, c.x, c.y}) exponent = std::min(exponent, last_bit(x));
  if (exponent == std::numeric_limits<int>::max()) return 0;
  const auto at = [exponent](double x) { return scaled(x, exponent); };
  const cpp_int cx = at(c.x), cy = at(c.y);
  const cpp_int left = (at(a.x) - cx) * (at(b.y) - cy), right = (at(a.y) - cy) * (at(b.x) - cx);
  return left.compare(right) > 0 ? 1 : left.compare(right) < 0 ? -1 : 0;
}

/// 0 along `zero`, 1 to its left, 2 straight back, 3 to its right.
int quarter(const Point& apex, const Point& zero, const Point& p) {
  const int side = orientation(apex, zero, p);
  if (side != 0) return side > 0 ? 1 : 3;
  return same_side(apex, zero, p) ? 0 : 2;
}

}  // namespace

int exact_orientation(const Point& a, const Point& b, const Point& c) {
  if (a == b || b == c || a == c) return 0;
  double ax = 0.0, ay = 0.0, bx = 0.0, by = 0.0;
  const bool exact = exact_difference(a.x, c.x, ax) && exact_difference(a.y, c.y, ay) &&
                     exact_difference(b.x, c.x, bx) && exact_difference(b.y, c.y, by);
  if (exact) {
    const double left = ax * by, right = ay * bx;
    if (product_is_safe(ax, by, left) && product_is_safe(ay, bx, right)) {
      // Rounding is monotonic: where the rounded products differ, so do the products.
      if (left != right) return left > right ? 1 : -1;
      return sign_of(std::fma(ax, by, -left) - std::fma(ay, bx, -right));
    }
  }
  return whole_number_orientation(a, b, c);
}

int compare_angles(const Point& apex, const Point& zero, const Point& p, const Point& q) {
  const int of_p = quarter(apex, zero, p), of_q = quarter(apex, zero, q);
  if (of_p != of_q) return of_p < of_q ? -1 : 1;
  if (of_p == 0 || of_p == 2) return 0;
  return -orientation(apex, p, q);
}

bool disjoint(const Point& apex, const Sector& a, const Sector& b) {
  // Anticlockwise from a.begin: a ends before b begins, and b ends before a begins again.
  const auto full = [&](const Sector& s) {
    return compare_angles(apex, s.begin, s.begin, s.end) == 0;
  };
  if (full(a) || full(b)) return false;
  if (compare_angles(apex, a.begin, b.begin, a.end) < 0) return false;
  return compare_angles(apex, a.begin, b.end, a.begin) == 0 ||
         compare_angles(apex, a.begin, b.end, b.begin) > 0;
}

int area_sign(std::span<const std::vector<Point>* const> rings) {
  double sum = 0.0, size = 0.0;
  std::size_t count = 0;
  for (const auto* ring : rings) {
    const std::vector<Point>& points = *ring;
    count += points.size();
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const Point a = points[i] - points[0], b = points[i + 1] - points[0];
      sum += a.x * b.y - a.y * b.x;
      size += std::fabs(a.x * b.y) + std::fabs(a.y * b.x);
    }
  }
  // Each product passes 4 roundings, and at most `count` more in the sums.
  const double error = (4.0 + static_cast<double>(count)) * std::numeric_limits<double>::epsilon();
  if (size >= smallest_filtered && std::fabs(sum) > error * size) return sign_of(sum);
  int exponent = std::numeric_limits<int>::max();
  for (const auto* ring : rings) {
    for (const Point& p : *ring) exponent = std::min({exponent, last_bit(p.x), last_bit(p.y)});
  }
  cpp_int total = 0;
  for (const auto* ring : rings) {
    for (std::size_t i = 0; i < ring->size(); ++i) {
      const Point &p = (*ring)[i], &q = (*ring)[i + 1 == ring->size() ? 0 : i + 1];
      total += scaled(p.x, exponent) * scaled(q.y, exponent) -
               scaled(p.y, exponent) * scaled(q.x, exponent);
    }
  }
  return total.sign();
}

}  // namespace hodograph::planning_detail
