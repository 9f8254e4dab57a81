// SPDX-License-Identifier: MIT
// The bound from one derivative: its constants, that it holds, and how sharp it is.
#include "hodograph/construction/hermite_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/curves.hpp"
#include "tests/support/true_error.hpp"

namespace hodograph {
namespace {

using test::Curve23;
using test::Wide;

template <std::size_t m>
Wide hermite_function(std::size_t r, const Wide& u) {
  Wide sum(0), power(1), factorial(1);
  for (std::size_t j = 0; j + r <= m; ++j) {
    sum += Wide(static_cast<double>(binomial(m + j, j))) * power;
    power *= u;
  }
  for (std::size_t j = 2; j <= r; ++j) factorial *= Wide(static_cast<double>(j));
  return pow(u, static_cast<int>(r)) / factorial * pow(Wide(1) - u, static_cast<int>(m + 1)) * sum;
}

template <std::size_t m>
void check_constants() {
  for (std::size_t r = 0; r <= m; ++r) {
    Wide largest(0);
    for (int i = 0; i <= 4000; ++i) {
      const Wide value = hermite_function<m>(r, Wide(i) / Wide(4000));
      if (largest < value) largest = value;
    }
    const Wide weight(HermiteConstants<m>::end_weight[r]);
    EXPECT_LE(largest, weight) << "m = " << m << ", r = " << r;
    // Near its top H_r falls short of it by at most |H_r''| (1/8000)²/2, |H_r''| < 100 c_r.
    constexpr double grid_error = 100.0 / (2.0 * 8000.0 * 8000.0);
    EXPECT_LE(weight, largest * Wide(1.0 + grid_error)) << "m = " << m << ", r = " << r;
  }
}

TEST(HermiteError, Constants) {
  check_constants<1>();
  check_constants<2>();
  check_constants<4>();
  // 10! 2^10
  EXPECT_TRUE(hermite_remainder_factor<4>().contains(1.0 / 3715891200.0));
  EXPECT_TRUE(hermite_remainder_factor<1>().contains(1.0 / 384.0));
}

/// Enclosures of the first m derivatives of curve (23), from 60 digits.
template <std::size_t m>
HermitePoint<m, Enclosure> enclosed(const Wide& xi) {
  const auto series = Curve23{}(Taylor<Wide, m>::variable(xi));
  const auto around = [](const Wide& x) {
    const double nearest = static_cast<double>(x);
    return Enclosure(Enclosure::down(nearest), Enclosure::up(nearest));
  };
  HermitePoint<m, Enclosure> point;
  for (std::size_t r = 0; r <= m; ++r) {
    point[r] = {around(series.x.derivative(r)), around(series.y.derivative(r)),
                around(series.z.derivative(r))};
  }
  return point;
}

/// The largest ratio bound/error wanted of the largest bound and the largest error of a path.
template <std::size_t m>
double sharpness(int segments, HermiteChoice choice) {
  constexpr std::size_t order = 2 * m + 2;
  const auto path = test::fitted_path<m>(Curve23{}, test::even_knots(0.0, 1.0, segments), choice);
  double largest_bound = 0.0;
  Wide largest_error(0);
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const double begin = path.knots()[k], h = path.segment(k).parameter_step();
    // The largest derivative of order 2m + 2: sampled, and raised by more than it can vary between.
    Wide derivative(0);
    for (int i = 0; i <= 32; ++i) {
      const Wide xi = Wide(begin) + Wide(h) * Wide(i) / Wide(32);
      const auto series = Curve23{}(Taylor<Wide, order>::variable(xi));
      const Wide size = norm(Vector3<Wide>{series.x.derivative(order), series.y.derivative(order),
                                           series.z.derivative(order)});
      if (derivative < size) derivative = size;
    }
    const double raised = static_cast<double>(derivative) * (1.0 + 1.0 / 128.0);
    const double bound = hermite_error_bound<m>(path.segment(k), enclosed<m>(Wide(begin)),
                                                enclosed<m>(Wide(begin) + Wide(h)), raised);
    const Wide error =
        test::true_segment_error(Curve23{}, path.segment(k), begin, path.knots()[k + 1], 24);
    EXPECT_LE(error, Wide(bound)) << "segment " << k << " of " << segments;
    largest_bound = std::max(largest_bound, bound);
    if (largest_error < error) largest_error = error;
  }
  return largest_bound / static_cast<double>(largest_error);
}

TEST(HermiteError, HoldsAndIsSharp) {
  EXPECT_LE(sharpness<4>(16, HermiteChoice::order_ten), 2.5);
  EXPECT_LE(sharpness<4>(64, HermiteChoice::order_ten), 1.25);
  EXPECT_LE(sharpness<4>(64, HermiteChoice::order_six), 1.45);
  EXPECT_LE(sharpness<2>(64, HermiteChoice::order_ten), 2.5);
  EXPECT_LE(sharpness<1>(64, HermiteChoice::order_ten), 2.5);
}

TEST(HermiteError, IsInfiniteWhereNothingIsKnown) {
  const auto path =
      test::fitted_path<4>(Curve23{}, test::even_knots(0.0, 1.0, 4), HermiteChoice::order_ten);
  auto begin = enclosed<4>(Wide(0)), end = enclosed<4>(Wide(0.25));
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(hermite_error_bound<4>(path.segment(0), begin, end, infinity), infinity);
  begin[3].y = Enclosure::whole_line();
  EXPECT_EQ(hermite_error_bound<4>(path.segment(0), begin, end, 1.0), infinity);
}

}  // namespace
}  // namespace hodograph
