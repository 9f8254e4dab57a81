// SPDX-License-Identifier: MIT
// The second-order scalar against Taylor series along lines and against differences of 40 digits.
#include "hodograph/foundation/second_order.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "hodograph/foundation/scalar.hpp"
#include "support/compare.hpp"
#include "support/random.hpp"

namespace hodograph {
namespace {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<40>,
                                           boost::multiprecision::et_off>;
constexpr std::size_t variables = 4;
using Jet = SecondOrder<double, variables>;
static_assert(Scalar<Jet>);
static_assert(Scalar<SecondOrder<Wide, 2>>);

/// Something of every operation, twice differentiable for arguments in (0.1, 2).
template <class T>
T everything(const std::array<T, variables>& z) {
  using std::abs;
  using std::atan;
  using std::atan2;
  using std::cos;
  using std::exp;
  using std::log;
  using std::pow;
  using std::sin;
  using std::sqrt;
  using std::tan;
  const T a = (2.0 - z[0]) * z[1] / (z[2] + 1.5) - z[3] * 0.75 + 3.0 / z[1];
  const T b = sqrt(z[0] * z[1] + 0.5) * exp(-z[2]) + log(z[3] + z[0]) / 4.0;
  const T c = sin(z[0] * z[1]) * cos(z[2] - z[3]) + tan(z[0] / 4.0);
  const T d = atan(z[1] - z[2]) + atan2(z[3] + 0.1, z[0] - 1.0) + abs(-z[2]);
  const T half_power = pow(z[3], typename RealOf<T>::type(0.5));
  return a * b + c / (d + 4.0) - (-half_power) * 2.0 + (a - b) * (c + d);
}

/// Both derivatives by central differences in 40 digits: steps of 1e-10 leave errors of 1e-20.
TEST(SecondOrder, AgreesWithDifferencesOfFortyDigits) {
  test::Random random("second order: everything");
  const Wide h("1e-10");  // not a tolerance
  constexpr double operations = 400.0;
  for (int round = 0; round < 50; ++round) {
    std::array<double, variables> at;
    std::array<Jet, variables> jets;
    std::array<Wide, variables> wide;
    for (std::size_t i = 0; i < variables; ++i) {
      at[i] = random.uniform(0.2, 1.9);
      jets[i] = Jet::variable(at[i], i);
      wide[i] = at[i];
    }
    const auto f = [&](std::size_t i, int di, std::size_t j, int dj) {
      std::array<Wide, variables> moved = wide;
      moved[i] += di * h;
      moved[j] += dj * h;
      return everything(moved);
    };
    const Jet jet = everything(jets);
    EXPECT_TRUE(is_finite(jet));
    double size = 0.0;
    for (std::size_t k = 0; k < Jet::size; ++k) size = std::max(size, std::abs(jet.data()[k]));
    EXPECT_CLOSE(jet.value(), everything(at), operations, size);
    for (std::size_t i = 0; i < variables; ++i) {
      const Wide first = (f(i, 1, i, 0) - f(i, -1, i, 0)) / (2 * h);
      EXPECT_CLOSE(jet.gradient(i), static_cast<double>(first), operations, size);
      for (std::size_t j = 0; j <= i; ++j) {
        const Wide second =
            (f(i, 1, j, 1) - f(i, 1, j, -1) - f(i, -1, j, 1) + f(i, -1, j, -1)) / (4 * h * h);
        EXPECT_CLOSE(jet.hessian(i, j), static_cast<double>(second), operations, size);
      }
    }
  }
}

TEST(SecondOrder, JoinsAFunctionOfFewArgumentsToTheSameNumbers) {
  test::Random random("second order: joined");
  const auto pair = []<class T>(const std::array<T, 2>& z) {
    using std::sqrt;
    return std::array<T, 2>{z[0] / sqrt(z[0] * z[0] + z[1] * z[1]), z[0] * z[1] * z[1]};
  };
  std::array<Jet, variables> z;
  for (std::size_t i = 0; i < variables; ++i) z[i] = Jet::variable(random.uniform(0.5, 2), i);
  const std::array<Jet, 2> arguments{z[0] * z[1] + z[2], z[3] * z[0] - z[1] * 3.0};
  const auto apart = evaluated_apart(pair, arguments), direct = pair(arguments);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < Jet::size; ++k) {
      EXPECT_CLOSE(apart[i].data()[k], direct[i].data()[k], 64, 100.0);
    }
  }
  const std::array<double, 2> plain{1.5, 2.5};
  EXPECT_EQ(evaluated_apart(pair, plain), pair(plain));
}

TEST(SecondOrder, ConstantsHaveNoDerivativesAndNonFiniteOnesAreSeen) {
  const Jet three = 3;
  EXPECT_EQ(three.value(), 3.0);
  for (std::size_t k = 1; k < Jet::size; ++k) EXPECT_EQ(three.data()[k], 0.0);
  Jet x = Jet::variable(0.0, 2);
  EXPECT_TRUE(is_finite(x * x));
  EXPECT_FALSE(is_finite(1.0 / x));
  EXPECT_FALSE(is_finite(sqrt(x)));
  x.hessian(1, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_finite(x));
  EXPECT_TRUE(x < 1.0 && x >= 0.0 && x == 0.0);
  EXPECT_EQ(value_of(x), 0.0);
}

}  // namespace
}  // namespace hodograph
