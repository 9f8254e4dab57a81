// SPDX-License-Identifier: MIT
// Taylor series against derivatives known in closed form and against the same functions in 50
// digits.
#include "hodograph/foundation/taylor.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "hodograph/foundation/enclosure.hpp"
#include "support/compare.hpp"
#include "support/random.hpp"

namespace hodograph {
namespace {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                           boost::multiprecision::et_off>;
constexpr std::size_t order = 6;
using T = Taylor<double, order>;
using WideT = Taylor<Wide, order>;

/// The factor by which the recurrences up to `order` amplify rounding on the arguments used here,
/// where every intermediate coefficient is at most about the largest one of the result: each of 2 ·
/// order terms rounds three times, and each coefficient feeds the later ones.
constexpr double amplification = 3.0 * 2 * order * order;

double largest(const T& t) {
  double size = 0.0;
  for (std::size_t k = 0; k <= order; ++k) size = std::max(size, std::abs(t[k]));
  return size;
}

TEST(Taylor, KnowsTheDerivativesOfPowersAndExponentials) {
  const T x = T::variable(0.5);
  const T cube = x * x * x;
  EXPECT_EQ(cube.derivative(0), 0.125);
  EXPECT_EQ(cube.derivative(1), 0.75);
  EXPECT_EQ(cube.derivative(2), 3.0);
  EXPECT_EQ(cube.derivative(3), 6.0);
  EXPECT_EQ(cube.derivative(4), 0.0);
  EXPECT_EQ(pow(x, 3)[1], 0.75);
  EXPECT_EQ(pow(x, 0)[0], 1.0);
  EXPECT_CLOSE(pow(x, -1).derivative(2), 16.0, 4, 16.0);
  const T e = exp(x);
  for (std::size_t k = 0; k <= order; ++k) {
    EXPECT_CLOSE(e.derivative(k), std::exp(0.5), amplification, 2.0);
  }
  const T reciprocal = 1.0 / x;  // (-1)^k k!/x^(k+1)
  double expected = 2.0;
  for (std::size_t k = 0; k <= order; ++k) {
    EXPECT_CLOSE(reciprocal.derivative(k), expected, amplification, expected);
    expected *= -2.0 * static_cast<double>(k + 1);
  }
}

TEST(Taylor, AgreesWithFiftyDigits) {
  test::Random random("taylor: functions");
  const auto compare = [](const char* name, const auto& function, double x) {
    SCOPED_TRACE(name);
    const T actual = function(T::variable(x));
    const WideT expected = function(WideT::variable(Wide(x)));
    EXPECT_CLOSE(actual, expected, amplification, largest(actual)) << "at " << x;
  };
  for (int i = 0; i < 200; ++i) {
    const double x = random.uniform(0.6, 2.5), y = random.uniform(-0.6, 0.6);
    compare(
        "sqrt", [](const auto& t) { return sqrt(t); }, x);
    compare(
        "exp", [](const auto& t) { return exp(t); }, y);
    compare(
        "log", [](const auto& t) { return log(t); }, x);
    compare(
        "sin", [](const auto& t) { return sin(t); }, x);
    compare(
        "cos", [](const auto& t) { return cos(t); }, x);
    compare(
        "tan", [](const auto& t) { return tan(t); }, y);
    compare(
        "sinh", [](const auto& t) { return sinh(t); }, y);
    compare(
        "cosh", [](const auto& t) { return cosh(t); }, y);
    compare(
        "tanh", [](const auto& t) { return tanh(t); }, y);
    compare(
        "atan", [](const auto& t) { return atan(t); }, y);
    compare(
        "asin", [](const auto& t) { return asin(t); }, y);
    compare(
        "acos", [](const auto& t) { return acos(t); }, y);
    compare(
        "pow", [](const auto& t) { return pow(t, 5); }, y);
    compare(
        "abs", [](const auto& t) { return abs(t); }, -x);
    compare(
        "atan2",
        [](const auto& t) {
          using U = std::remove_cvref_t<decltype(t)>;
          return atan2(sin(t), U(2) + cos(t));
        },
        x);
    compare(
        "quotient",
        [](const auto& t) {
          using U = std::remove_cvref_t<decltype(t)>;
          return (t * t - U(1)) / (U(2) + cos(t));
        },
        x);
  }
}

TEST(Taylor, OfARealPowerMatchesTheSquareRoot) {
  const T x = T::variable(1.7);
  EXPECT_CLOSE(pow(x, 0.5), sqrt(x), amplification, 1.5);
}

TEST(Taylor, EvaluatesToTheShiftedFunction) {
  // Σ c_k h^k = f(x + h) up to O(h^7).
  const double x = 0.8, h = 0x1.0p-8;  // not a tolerance: h^7 is 2^-56
  const T f = exp(sin(T::variable(x)));
  double sum = 0.0;
  for (std::size_t k = order + 1; k-- > 0;) sum = sum * h + f[k];
  EXPECT_CLOSE(sum, std::exp(std::sin(x + h)), 8, 3.0);
}

TEST(Taylor, NestsAndDifferentiatesInTwoDirections) {
  using Inner = Taylor<double, 1>;
  using Outer = Taylor<Inner, 1>;
  // f(x, y) = x² y: ∂²f/∂x∂y = 2x.
  const Outer x = Outer::variable(Inner(3.0)), y(Inner::variable(5.0));
  const Outer f = x * x * y;
  EXPECT_EQ(f[1][1], 6.0);
  EXPECT_EQ(to_double(f), 45.0);
}

TEST(Taylor, OverEnclosuresEnclosesTheDerivatives) {
  using E = Taylor<Enclosure, order>;
  const auto f = [](const auto& t) {
    using U = std::remove_cvref_t<decltype(t)>;
    return sqrt(t * t + U(1)) / (t + U(3));
  };
  const E enclosed = f(E::variable(Enclosure(0.3)));
  const WideT exact = f(WideT::variable(Wide(0.3)));
  for (std::size_t k = 0; k <= order; ++k) {
    EXPECT_LE(Wide(enclosed[k].lower()), exact[k]) << k;
    EXPECT_GE(Wide(enclosed[k].upper()), exact[k]) << k;
  }
}

TEST(Taylor, ComparesByValueAndReportsWhatIsNotFinite) {
  EXPECT_LT(T::variable(1.0), T(2.0));
  EXPECT_TRUE(T::variable(1.0) == T(1.0));
  EXPECT_TRUE(is_finite(T::variable(1.0)));
  EXPECT_FALSE(is_finite(sqrt(T::variable(0.0))));
}

}  // namespace
}  // namespace hodograph
