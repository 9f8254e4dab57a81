// SPDX-License-Identifier: MIT
// Interpolating splines: what they reproduce, how smooth they are, how they converge, what is
// refused.
#include "hodograph/construction/interpolating_spline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/compare.hpp"
#include "tests/support/curves.hpp"
#include "tests/support/random.hpp"

namespace hodograph {
namespace {

using test::growth;
using test::Random;

constexpr double eps = epsilon<double>();

/// Increasing parameters with steps that vary by a factor of 3.
std::vector<double> random_parameters(Random& random, std::size_t count, double begin, double end) {
  std::vector<double> t{0.0};
  while (t.size() < count) t.push_back(t.back() + random.uniform(0.5, 1.5));
  const double last = t.back();
  for (double& x : t) x = begin + (end - begin) * (x / last);
  t.back() = end;
  return t;
}

template <class Gamma>
std::vector<Vector3<double>> samples_of(const Gamma& gamma, const std::vector<double>& t) {
  std::vector<Vector3<double>> points;
  for (const double x : t) points.push_back(gamma(x));
  return points;
}

/// The samples are met, and derivatives 0 ... p-1 agree at the breakpoints, both to a few ε of the
/// largest coefficient; those of neighbouring pieces come from the same control points, and each
/// passes p convex combinations.
template <std::size_t p>
void expect_spline(const InterpolatingSpline<p>& spline, const std::vector<double>& t,
                   const std::vector<Vector3<double>>& points) {
  const double roundings = 16.0 * static_cast<double>(p);
  double size = 0.0;
  for (const auto& piece : spline.pieces()) {
    for (const auto& c : piece.coefficients()) size = std::max(size, largest_component(c));
  }
  for (std::size_t i = 0; i < t.size(); ++i) {
    EXPECT_CLOSE(spline(t[i])[0], points[i], roundings, size) << "sample " << i;
  }
  const auto& knots = spline.breakpoints();
  const std::size_t pieces = spline.pieces().size();
  ASSERT_EQ(knots.size(), pieces + 1);
  for (std::size_t k = spline.is_periodic() ? 0 : 1; k < pieces; ++k) {
    const std::size_t before = (k == 0 ? pieces : k) - 1;
    const double h_before = knots[before + 1] - knots[before], h_after = knots[k + 1] - knots[k];
    const auto end = spline.pieces()[before].template jet<p - 1>(1.0);
    const auto begin = spline.pieces()[k].template jet<p - 1>(0.0);
    const double h = std::min(h_before, h_after);
    for (std::size_t r = 0; r < p; ++r) {
      const auto power = static_cast<int>(r);
      EXPECT_CLOSE(Vector3<double>(std::pow(h / h_after, power) * begin[r]),
                   Vector3<double>(std::pow(h / h_before, power) * end[r]),
                   roundings * growth(p, r), size)
          << "knot " << k << ", derivative " << r;
    }
  }
}

template <std::size_t p>
void check_open_and_periodic(Random& random) {
  for (const std::size_t count : {p + 1, p + 2, p + 3, std::size_t{40}, std::size_t{200}}) {
    const auto t = random_parameters(random, count, -1.0, 3.0);
    std::vector<Vector3<double>> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back(random.vector3(1.0));
    const auto open = InterpolatingSpline<p>::through(t, points);
    ASSERT_TRUE(open) << open.fault().sentence;
    EXPECT_FALSE(open->is_periodic());
    EXPECT_EQ(open->begin(), t.front());
    EXPECT_EQ(open->end(), t.back());
    expect_spline<p>(*open, t, points);
    if (count < p + 2) continue;
    points.back() = points.front();
    const auto closed = InterpolatingSpline<p>::through(t, points, SplineEnds::periodic);
    ASSERT_TRUE(closed) << closed.fault().sentence;
    EXPECT_TRUE(closed->is_periodic());
    expect_spline<p>(*closed, t, points);
  }
}

TEST(InterpolatingSpline, MeetsRandomSamplesSmoothly) {
  Random random("interpolating spline");
  check_open_and_periodic<5>(random);
  check_open_and_periodic<7>(random);
}

TEST(InterpolatingSpline, ReproducesPolynomialsOfItsDegree) {
  Random random("spline polynomials");
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::array<Vector3<double>, 6> power{};
    for (auto& c : power) c = random.vector3(1.0);
    const auto quintic = [&](double x) {
      Vector3<double> sum = power[5];
      for (std::size_t j = 5; j-- > 0;) sum = x * sum + power[j];
      return sum;
    };
    const auto t = random_parameters(random, 12, -1.0, 1.0);
    const auto spline = InterpolatingSpline<5>::through(t, samples_of(quintic, t)).value();
    // Lebesgue constants of 12 points with mesh ratio 3 stay below 2^6.
    constexpr double condition = 64.0;
    for (int i = 0; i <= 100; ++i) {
      const double x = std::min(1.0, -1.0 + i / 50.0);
      EXPECT_CLOSE(spline(x)[0], quintic(x), 16.0 * condition, 6.0);
    }
  }
}

/// The largest error of derivative r against curve (23) over the middle half.
template <std::size_t p>
double curve_error(std::size_t count) {
  std::vector<double> t;
  for (std::size_t i = 0; i < count; ++i) {
    t.push_back(static_cast<double>(i) / static_cast<double>(count - 1));
  }
  const auto spline = InterpolatingSpline<p>::through(t, samples_of(test::Curve23{}, t)).value();
  double worst = 0.0;
  for (int i = 0; i <= 2000; ++i) {
    const double x = i / 2000.0;
    worst = std::max(worst, norm(spline(x)[0] - test::Curve23{}(x)));
  }
  return worst;
}

TEST(InterpolatingSpline, ConvergesWithOrderDegreePlusOne) {
  // Between 40 and 80 intervals; a twentieth of an order is left to the higher terms.
  EXPECT_GE(std::log2(curve_error<5>(41) / curve_error<5>(81)), 6.0 - 0.3);
  EXPECT_GE(std::log2(curve_error<7>(41) / curve_error<7>(81)), 8.0 - 0.4);
}

TEST(InterpolatingSpline, GivesGenuineFourthDerivatives) {
  // A spline of degree 4 would be wrong by a few parts in 10³ at its knots; this one is continuous
  // there and within the fourth derivative's own order h² of the curve's.
  std::vector<double> t;
  for (int i = 0; i <= 256; ++i) t.push_back(i / 256.0);
  const auto spline = InterpolatingSpline<5>::through(t, samples_of(test::Curve23{}, t)).value();
  for (int i = 40; i <= 216; i += 8) {
    const double x = t[static_cast<std::size_t>(i)];
    const auto left = spline(std::nextafter(x, 0.0)), right = spline(x);
    // 9^4 and 1.5·7.2^4 are the sizes of the fourth derivatives; coefficients near 3 are amplified.
    const double amplified = 16.0 * eps * 3.0 * growth(5, 4) * std::pow(256.0, 4);
    EXPECT_LE(largest_component(left[4] - right[4]), amplified + 9.0 * 6561.0 * 9.0 * eps);
  }
}

// ---- what is refused
// -------------------------------------------------------------------------------

std::string sentence_of(const std::vector<double>& t, const std::vector<Vector3<double>>& points,
                        SplineEnds ends = SplineEnds::not_a_knot) {
  const auto spline = InterpolatingSpline<5>::through(t, points, ends);
  return spline ? "accepted" : spline.fault().sentence;
}

TEST(InterpolatingSplineRefusals, SayWhatIsWrong) {
  std::vector<double> t{0, 1, 2, 3, 4, 5, 6, 7};
  std::vector<Vector3<double>> points;
  for (const double x : t) points.push_back({x, x * x, 1.0});
  EXPECT_EQ(sentence_of(t, points), "accepted");
  EXPECT_EQ(sentence_of({0, 1, 2}, points), "8 points need as many parameters; got 3");
  EXPECT_EQ(sentence_of({0, 1, 2, 3, 4}, {points.begin(), points.begin() + 5}),
            "a spline of degree 5 needs at least 6 samples; got 5");
  EXPECT_EQ(
      sentence_of({0, 1, 2, 3, 4, 5}, {points.begin(), points.begin() + 6}, SplineEnds::periodic),
      "a spline of degree 5 needs at least 7 samples; got 6");
  auto bad = points;
  bad[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(sentence_of(t, bad), "sample 3 is not finite");
  auto same = t;
  same[5] = same[4];
  EXPECT_EQ(sentence_of(same, points),
            "sample parameters must increase strictly; sample 5 is at 4 after 4");
  EXPECT_EQ(sentence_of(t, points, SplineEnds::periodic)
                .find("a periodic curve must end where it began; the last sample is 49 from the "
                      "first, at most "),
            0U);
  const auto spline = InterpolatingSpline<5>::through(t, points).value();
  EXPECT_THROW(spline(7.5), Error);
  EXPECT_THROW(spline(std::numeric_limits<double>::quiet_NaN()), Error);
  try {
    spline(-0.5);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "the spline parameter -0.5 is outside [0, 7]");
  }
}

TEST(InterpolatingSplineRefusals, NeverNanOnHostileParameters) {
  Random random("hostile spline");
  for (int repeat = 0; repeat < 2000; ++repeat) {
    std::vector<double> t;
    for (int i = 0; i < 12; ++i) t.push_back(random.chance(0.5) ? random.hostile() : random.unit());
    std::sort(t.begin(), t.end());
    std::vector<Vector3<double>> points;
    for (std::size_t i = 0; i < t.size(); ++i) {
      points.push_back(random.chance(0.2) ? Vector3<double>{random.hostile(), 0.0, 1.0}
                                          : random.vector3(1.0));
    }
    for (const SplineEnds ends : {SplineEnds::not_a_knot, SplineEnds::periodic}) {
      if (ends == SplineEnds::periodic) points.back() = points.front();
      const auto spline = InterpolatingSpline<5>::through(t, points, ends);
      if (!spline) {
        EXPECT_FALSE(spline.fault().sentence.empty());
        continue;
      }
      for (const auto& piece : spline->pieces()) {
        for (const auto& c : piece.coefficients()) EXPECT_TRUE(is_finite(c));
      }
    }
  }
}

}  // namespace
}  // namespace hodograph
