// SPDX-License-Identifier: MIT
// The Hermite constructions over every scalar: the same curve, the order of convergence in 50
// digits, and its derivative with respect to the data.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "hodograph/construction/hermite.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/hermite_data.hpp"
#include "tests/support/hermite_golden.hpp"

namespace hodograph {
namespace {

namespace mp = boost::multiprecision;
using Float50 = mp::number<mp::cpp_bin_float<50>, mp::et_off>;
using Float100 = mp::number<mp::cpp_bin_float<100>, mp::et_off>;
using test::Random;

constexpr std::array<HermiteChoice, 2> choices{HermiteChoice::order_ten, HermiteChoice::order_six};

// Tame data pass roundings on with a factor of the order of one: fewer than this many ε.
constexpr double roundings = 256.0;

template <class T, std::size_t m>
SpatialPhCurve<2 * m, T> curve_of(const test::HermiteSet<m>& set, HermiteChoice choice) {
  const auto wide = test::converted_set<T, m>(set);
  return hermite_curve<m, T>(wide.begin, wide.end, wide.h, choice).value();
}

/// The numbers of a curve in a narrower scalar against those in a wider one.
template <std::size_t n, class S, class T>
void expect_same(const SpatialPhCurve<n, S>& actual, const SpatialPhCurve<n, T>& expected) {
  T size(0);
  for (const auto& c : expected.displacement().coefficients()) {
    if (size < largest_component(c)) size = largest_component(c);
  }
  EXPECT_CLOSE(actual.displacement().coefficients(), expected.displacement().coefficients(),
               roundings, size);
  EXPECT_CLOSE(actual.arc_length(), expected.arc_length(), roundings, size);
}

template <std::size_t m>
void compare_scalars(Random& random, int repeats) {
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const auto set = test::tame_set<m>(random);
    for (const HermiteChoice choice : choices) {
      const auto finest = curve_of<Float100, m>(set, choice);
      expect_same(curve_of<double, m>(set, choice), finest);
      expect_same(curve_of<long double, m>(set, choice), finest);
      expect_same(curve_of<Float50, m>(set, choice), finest);
    }
  }
}

TEST(HermiteScalars, TheSameCurveInEveryPrecision) {
  Random random("hermite scalars");
  compare_scalars<4>(random, 60);
  compare_scalars<2>(random, 20);
  compare_scalars<1>(random, 20);
}

// ---- order of convergence
// --------------------------------------------------------------------------

template <std::size_t m, class Gamma>
Float50 largest_error(const Gamma& gamma, HermiteChoice choice, int segments) {
  // Over [1/4, 5/4], where none of the curves has a symmetry.
  const Float50 h = Float50(1) / Float50(segments);
  Float50 worst(0);
  auto begin = derivatives_of<m, Float50>(gamma, Float50(0.25));
  for (int k = 0; k < segments; ++k) {
    const Float50 xi = Float50(0.25) + Float50(k) * h;
    const auto end = derivatives_of<m, Float50>(gamma, Float50(xi + h));
    const auto curve = hermite_curve<m, Float50>(begin, end, h, choice).value();
    for (int i = 1; i < 8; ++i) {
      const Float50 u = Float50(i) / Float50(8);
      const Float50 error = norm(gamma(Float50(xi + u * h)) - curve.position(u));
      if (worst < error) worst = error;
    }
    begin = end;
  }
  return worst;
}

template <std::size_t m, class Gamma>
double measured_order(const Gamma& gamma, HermiteChoice choice, int segments) {
  return std::log2(static_cast<double>(Float50(largest_error<m>(gamma, choice, segments) /
                                               largest_error<m>(gamma, choice, 2 * segments))));
}

template <class Gamma>
void expect_orders(const Gamma& gamma, const std::string& name) {
  SCOPED_TRACE(name);
  // Measured orders approach the true one from either side as h²; at this many segments they are
  // within a fifth.
  constexpr int segments = 24;
  constexpr double near = 0.2;
  EXPECT_NEAR(measured_order<4>(gamma, HermiteChoice::order_ten, segments), 10.0, near);
  EXPECT_NEAR(measured_order<4>(gamma, HermiteChoice::order_six, segments), 6.0, near);
  EXPECT_NEAR(measured_order<2>(gamma, HermiteChoice::order_ten, segments), 6.0, near);
  EXPECT_NEAR(measured_order<2>(gamma, HermiteChoice::order_six, segments), 6.0, near);
  EXPECT_NEAR(measured_order<1>(gamma, HermiteChoice::order_ten, segments), 4.0, near);
  EXPECT_NEAR(measured_order<1>(gamma, HermiteChoice::order_six, segments), 4.0, near);
}

TEST(HermiteOrder, OfKnownCurves) {
  expect_orders(test::Helix{}, "helix");
  expect_orders(test::TorusKnot{}, "torus knot");
  expect_orders(test::Viviani{}, "Viviani's curve");
}

// ---- the derivative with respect to the data
// ---------------------------------------------------------

/// The data plus t times a direction.
template <class T, std::size_t m>
test::HermiteSet<m, T> moved(const test::HermiteSet<m>& set, const test::HermiteSet<m>& direction,
                             const T& t) {
  auto result = test::converted_set<T, m>(set);
  const auto along = test::converted_set<T, m>(direction);
  for (std::size_t r = 0; r <= m; ++r) {
    result.begin[r] += t * along.begin[r];
    result.end[r] += t * along.end[r];
  }
  result.h = result.h + t * along.h;
  return result;
}

template <std::size_t m>
void compare_sensitivity(Random& random, int repeats) {
  using Dual = Taylor<double, 1>;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const auto set = test::tame_set<m>(random);
    test::HermiteSet<m> direction;
    for (auto* point : {&direction.begin, &direction.end}) {
      for (auto& v : *point) v = random.vector3(1.0);
    }
    direction.h = random.uniform(-0.25, 0.25);
    for (const HermiteChoice choice : choices) {
      const auto dual = moved<Dual, m>(set, direction, Dual::variable(0.0));
      const auto curve = hermite_curve<m, Dual>(dual.begin, dual.end, dual.h, choice).value();
      // Central differences in 50 digits: truncated at t² = 2^-80, rounded at 2^-166 / t.
      const Float50 t = ldexp(Float50(1), -40);
      const auto ahead = moved<Float50, m>(set, direction, t);
      const auto behind = moved<Float50, m>(set, direction, Float50(-t));
      const auto a = hermite_curve<m, Float50>(ahead.begin, ahead.end, ahead.h, choice).value();
      const auto b = hermite_curve<m, Float50>(behind.begin, behind.end, behind.h, choice).value();
      double size = 0.0;
      for (const auto& c : curve.displacement().coefficients()) {
        for (std::size_t i = 0; i < 3; ++i) {
          size = std::max({size, std::abs(c[i][0]), std::abs(c[i][1])});
        }
      }
      for (std::size_t k = 0; k <= 4 * m + 1; ++k) {
        for (std::size_t i = 0; i < 3; ++i) {
          const Float50 slope =
              (a.displacement()[k][i] - b.displacement()[k][i]) / (Float50(2) * t);
          // A derivative of the roundings: their factor once more.
          EXPECT_CLOSE(curve.displacement()[k][i][1], slope, roundings * 16.0, size);
        }
      }
    }
  }
}

TEST(HermiteSensitivity, AgreesWithDifferencesIn50Digits) {
  Random random("hermite sensitivity");
  compare_sensitivity<4>(random, 40);
  compare_sensitivity<2>(random, 20);
  compare_sensitivity<1>(random, 20);
}

TEST(HermiteScalars, PathsInMultiprecision) {
  using Point = HermitePoint<4, Float50>;
  std::vector<Float50> knots;
  std::vector<Point> points;
  for (int k = 0; k <= 5; ++k) {
    knots.push_back(Float50(k * k) / Float50(25));
    points.push_back(derivatives_of<4, Float50>(test::Curve23{}, knots.back()));
  }
  const auto path = hermite_path<4, Float50>(knots, std::span<const Point>(points)).value();
  EXPECT_CLOSE(path.position(Float50(1)), test::Curve23{}(Float50(1)), 4.0, 3.0);
  EXPECT_LT(path.arc_length(), Float50(16));
}

}  // namespace
}  // namespace hodograph
