// SPDX-License-Identifier: MIT
#include "hodograph/path/sampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "hodograph/path/operations.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

using test::Random;
using test::random_path;

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class P>
class Sampling : public testing::Test {};
using Paths = testing::Types<PlanarPath<2>, SpatialPath<0>, SpatialPath<8>>;
TYPED_TEST_SUITE(Sampling, Paths);

template <class P>
void expect_a_cover(const P& path, const std::vector<double>& xi) {
  ASSERT_GE(xi.size(), 2U);
  EXPECT_EQ(xi.front(), path.xi_begin());
  EXPECT_EQ(xi.back(), path.xi_end());
  EXPECT_TRUE(std::is_sorted(xi.begin(), xi.end()));
}

TYPED_TEST(Sampling, EvenInXi) {
  Random random("sampling xi");
  const auto path = random_path<TypeParam>(random, 3);
  for (const std::size_t count : {2U, 3U, 100U}) {
    const auto xi = parameters_even_in_xi(path, count).value();
    ASSERT_EQ(xi.size(), count);
    expect_a_cover(path, xi);
    const double gap = (path.xi_end() - path.xi_begin()) / static_cast<double>(count - 1);
    for (std::size_t j = 1; j < count; ++j) {
      EXPECT_CLOSE(xi[j] - xi[j - 1], gap, 8.0, path.xi_end() - path.xi_begin());
    }
  }
  EXPECT_EQ(parameters_even_in_xi(path, 1).fault().sentence,
            "the number of points must be at least 2; got 1");
  EXPECT_EQ(parameters_even_in_xi(path, maximum_sample_count + 1).fault().code,
            FaultCode::unsupported);
}

TYPED_TEST(Sampling, EvenInArcLength) {
  Random random("sampling arc length");
  const auto path = random_path<TypeParam>(random, 3);
  const std::size_t count = 50;
  const auto xi = parameters_even_in_arc_length(path, count).value();
  ASSERT_EQ(xi.size(), count);
  expect_a_cover(path, xi);
  for (std::size_t j = 0; j < count; ++j) {
    const double expected = path.arc_length() * static_cast<double>(j) / (count - 1);
    // The rounding of ξ itself moves the arc length by σ ε |ξ|.
    EXPECT_CLOSE(path.arc_length(xi[j]), expected, 64.0, path.arc_length());
  }
  EXPECT_EQ(parameters_even_in_arc_length(path, 0).fault().code, FaultCode::too_few);
}

TYPED_TEST(Sampling, ByArcLengthStep) {
  Random random("sampling step");
  const auto path = random_path<TypeParam>(random, 3);
  const double length = path.arc_length();
  for (const double parts : {0.5, 1.0, 2.0, 7.0, 7.25, 7.999}) {
    const auto xi = parameters_by_arc_length_step(path, length / parts).value();
    expect_a_cover(path, xi);
    EXPECT_EQ(xi.size(), static_cast<std::size_t>(std::ceil(parts)) + 1);
    for (std::size_t j = 0; j + 1 < xi.size(); ++j) {
      EXPECT_CLOSE(path.arc_length(xi[j]), static_cast<double>(j) * (length / parts), 64.0, length);
    }
  }
  for (const double step : {0.0, -1.0, infinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(parameters_by_arc_length_step(path, step).fault().code, FaultCode::outside_domain);
  }
  EXPECT_EQ(parameters_by_arc_length_step(path, std::ldexp(length, -30)).fault().code,
            FaultCode::unsupported);
}

TYPED_TEST(Sampling, PerSegmentHitsEveryKnot) {
  Random random("sampling segments");
  const auto path = random_path<TypeParam>(random, 4);
  const auto xi = parameters_per_segment(path, 5).value();
  expect_a_cover(path, xi);
  ASSERT_EQ(xi.size(), 21U);
  for (std::size_t k = 0; k <= 4; ++k) EXPECT_EQ(xi[5 * k], path.knots()[k]);
  EXPECT_EQ(parameters_per_segment(path, 0).fault().code, FaultCode::too_few);
  EXPECT_EQ(parameters_per_segment(path, maximum_sample_count / 2).fault().code,
            FaultCode::unsupported);
}

/// The distance of p from the stretch between a and b.
template <class V>
double distance(const V& p, const V& a, const V& b) {
  const V chord = b - a;
  const double square = dot(chord, chord);
  const double share = square > 0 ? std::clamp(dot(p - a, chord) / square, 0.0, 1.0) : 0.0;
  return norm(p - (a + share * chord));
}

TYPED_TEST(Sampling, PolylineKeepsItsTolerance) {
  Random random("sampling polyline");
  for (int repeat = 0; repeat < 5; ++repeat) {
    const auto path = random_path<TypeParam>(random, 3);
    std::size_t before = 0;
    for (int exponent = -1; exponent >= -22; exponent -= 3) {
      const double tolerance = std::ldexp(1.0, exponent);
      const auto xi = polyline_parameters(path, tolerance).value();
      expect_a_cover(path, xi);
      for (const double knot : path.knots()) {
        EXPECT_TRUE(std::binary_search(xi.begin(), xi.end(), knot));
      }
      EXPECT_GE(xi.size(), before);
      before = xi.size();
      const auto points = points_at(path, std::span<const double>(xi));
      double worst = 0.0;
      for (std::size_t j = 1; j < xi.size(); ++j) {
        for (int i = 1; i < 8; ++i) {
          const double at = xi[j - 1] + i * 0.125 * (xi[j] - xi[j - 1]);
          worst = std::max(worst, distance(path.position(at), points[j - 1], points[j]));
        }
      }
      EXPECT_LE(worst, tolerance);
    }
  }
}

TEST(Polyline, IsNotWasteful) {
  // A line at varying speed takes the knots alone; a gentle arc of angle α and radius R about
  // α √(R/(8 tolerance)) chords, of which halving may take twice as many.
  const BernsteinPolynomial<Complex<double>, 1> line({Complex<double>{1, 1}, {4, 4}});
  const auto straight = PlanarPath<1>::create({0.0, 1.0}, {{{}, line, 1.0}}, false).value();
  EXPECT_EQ(polyline_parameters(straight, std::ldexp(1.0, -30)).value().size(), 2U);

  const BernsteinPolynomial<Complex<double>, 1> arc({Complex<double>{1, 0}, {1, 0.25}});
  const auto bent = PlanarPath<1>::create({0.0, 1.0}, {{{}, arc, 1.0}}, false).value();
  const double tolerance = std::ldexp(1.0, -20);
  const double least = 0.5 * std::sqrt(2.0 / (8 * tolerance));
  const double found = static_cast<double>(polyline_parameters(bent, tolerance).value().size());
  EXPECT_GE(found, least);
  EXPECT_LE(found, 2.5 * least);
}

TEST(Polyline, TurnsBackWhereTheCurveDoes) {
  // A cusp: w = (1 - 2u) (1 + i u/8) goes forward, stops and comes back.
  const BernsteinPolynomial<Complex<double>, 2> w(
      {Complex<double>{1, 0}, {0, 0.0625}, {-1, -0.125}});
  const auto path = PlanarPath<2>::create({0.0, 1.0}, {{{}, w, 1.0}}, false).value();
  const double tolerance = std::ldexp(1.0, -12);
  const auto xi = polyline_parameters(path, tolerance).value();
  const auto points = points_at(path, std::span<const double>(xi));
  for (std::size_t j = 1; j < xi.size(); ++j) {
    const auto middle = path.position(0.5 * (xi[j - 1] + xi[j]));
    EXPECT_LE(distance(middle, points[j - 1], points[j]), tolerance);
  }
}

TEST(Polyline, RefusesWhatItCannotKeep) {
  Random random("polyline refused");
  const auto path = random_path<SpatialPath<4>>(random, 2);
  for (const double tolerance : {0.0, -1.0, infinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(polyline_parameters(path, tolerance).fault().code, FaultCode::outside_domain);
  }
  const auto rounding = polyline_parameters(path, std::ldexp(1.0, -60));
  ASSERT_FALSE(rounding);
  EXPECT_EQ(rounding.fault().code, FaultCode::tolerance_not_reached);
  EXPECT_NE(rounding.fault().sentence.find("is below the rounding of the points of segment 0"),
            std::string::npos);
  const auto far = moved(path, {1, 0, 0, 0}, {std::ldexp(1.0, 40), 0, 0}).value();
  EXPECT_EQ(polyline_parameters(far, std::ldexp(1.0, -16)).fault().code,
            FaultCode::tolerance_not_reached);
}

}  // namespace
}  // namespace hodograph
