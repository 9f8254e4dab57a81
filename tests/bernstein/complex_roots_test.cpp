// SPDX-License-Identifier: MIT
#include "hodograph/bernstein/complex_roots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hodograph/foundation/scalar.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {
namespace {

using Number = std::complex<double>;

/// ∏ (z - r), the coefficients by rising powers.
std::vector<Number> with_roots(const std::vector<Number>& roots) {
  std::vector<Number> a{1.0};
  for (const Number& r : roots) {
    a.insert(a.begin(), 0.0);
    for (std::size_t k = 0; k + 1 < a.size(); ++k) a[k] -= r * a[k + 1];
  }
  return a;
}

TEST(ComplexRoots, FindsEveryRootBackwardStably) {
  Random random("complex roots");
  for (int repeat = 0; repeat < 300; ++repeat) {
    const auto degree = static_cast<std::size_t>(random.integer(1, 24));
    std::vector<Number> a;
    for (std::size_t k = 0; k <= degree; ++k) {
      a.push_back(std::ldexp(1.0, static_cast<int>(random.integer(-20, 20))) *
                  Number(random.uniform(-1, 1), random.uniform(-1, 1)));
    }
    const auto roots = complex_roots(a);
    ASSERT_TRUE(roots);
    ASSERT_EQ(roots->size(), degree);
    for (const Number& z : *roots) {
      Number value = 0.0;
      double size = 0.0;
      for (std::size_t k = degree + 1; k-- > 0;) {
        value = value * z + a[k];
        size = size * std::abs(z) + std::abs(a[k]);
      }
      EXPECT_LE(std::abs(value), 8.0 * static_cast<double>(degree) * epsilon<double>() * size);
    }
  }
}

TEST(ComplexRoots, KnownRoots) {
  const std::vector<Number> expected{{0.5, 1.0}, {0.5, -1.0}, {-3.0, 0.0}, {0.0, 0.0}, {2.0, 0.25}};
  auto roots = complex_roots(with_roots(expected)).value();
  ASSERT_EQ(roots.size(), expected.size());
  for (const Number& r : expected) {
    const double nearest = std::abs(*std::min_element(roots.begin(), roots.end(),
                                                      [&](const Number& a, const Number& b) {
                                                        return std::abs(a - r) < std::abs(b - r);
                                                      }) -
                                    r);
    EXPECT_LE(nearest, 256 * epsilon<double>());
  }
  // A leading zero is no root.
  EXPECT_EQ(complex_roots({-1.0, 1.0, 0.0})->size(), 1U);
  EXPECT_EQ(complex_roots({3.0})->size(), 0U);
}

TEST(ComplexRoots, Refusals) {
  EXPECT_FALSE(complex_roots({}));
  EXPECT_FALSE(complex_roots({0.0, 0.0}));
  EXPECT_FALSE(complex_roots({1.0, std::numeric_limits<double>::infinity()}));
  EXPECT_FALSE(complex_roots({1.0, std::nan("")}));
}

}  // namespace
}  // namespace hodograph::test
