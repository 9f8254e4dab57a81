// SPDX-License-Identifier: MIT
// Bounds of the torsion: the torsion of wide arithmetic lies within, closely; planar and straight
// parts; inflections.
#include "hodograph/path/torsion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/curve/preimage_jet.hpp"
#include "tests/support/arb_judge.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {
namespace {

constexpr RangeGoal goal{0x1.0p-20};  // a millionth
/// Wide values' own rounding, and what a search to 2^-30 of the parameter leaves of a peak's height
/// besides the goal.
constexpr long double wide_rounding = 0x1.0p-48L;
constexpr double peak_error = 0x1.0p-18;  // of a search to last_step
/// Steps of that search end here.
constexpr double last_step = 0x1.0p-30;

/// The torsion of the exact curve at u, in long double.
template <std::size_t n>
long double wide_torsion(const SpatialPhCurve<n>& curve, double u) {
  using Wide = Quaternion<long double>;
  BernsteinPolynomial<Wide, n> preimage;
  for (std::size_t i = 0; i <= n; ++i) {
    const auto& a = curve.preimage()[i];
    preimage[i] = {a.w, a.x, a.y, a.z};
  }
  const SpatialPhCurve<n, long double> wide({}, preimage, curve.parameter_step());
  return torsion(wide.template preimage_jet<2>(static_cast<long double>(u))).value_or(0.0L);
}

template <std::size_t n>
SpatialPath<n> random_path(Random& random, std::size_t count, double scale) {
  std::vector<SpatialPhCurve<n>> segments;
  std::vector<double> knots{0.0};
  Vector3<double> at{};
  for (std::size_t k = 0; k < count; ++k) {
    BernsteinPolynomial<Quaternion<double>, n> preimage;
    for (std::size_t i = 0; i <= n; ++i) preimage[i] = random.quaternion(scale);
    const double step = std::exp2(static_cast<double>(random.integer(-3, 3)));
    segments.emplace_back(at, preimage, step);
    at = segments.back().end();
    knots.push_back(knots.back() + step);
  }
  return SpatialPath<n>::create(knots, segments, false).value();
}

/// The extremes hold on a grid, and where they are bounded they are reached within the goal by a
/// fine grid's values to second order.
template <std::size_t n>
void check(const SpatialPath<n>& path) {
  const Extremes found = torsion_extremes(path, goal);
  long double least = std::numeric_limits<long double>::infinity(), most = -least;
  constexpr int grid = 2000;
  for (const auto& curve : path.segments()) {
    for (const int sign : {-1, 1}) {
      double u = 0.0;
      long double best = -std::numeric_limits<long double>::infinity();
      const auto look = [&](double at) {
        if (at < 0.0 || at > 1.0) return;
        const long double tau = sign * wide_torsion(curve, at);
        if (tau > best) {
          best = tau;
          u = at;
        }
      };
      for (int i = 0; i <= grid; ++i) look(static_cast<double>(i) / grid);
      for (double step = 0.5 / grid; step > last_step; step *= 0.5) {  // uphill to the peak
        look(u - step);
        look(u + step);
      }
      (sign > 0 ? most : least) = sign > 0 ? std::max(most, best) : std::min(least, -best);
    }
  }
  // The wide values carry roundings of their own, far below double's.
  const long double size = std::max(std::abs(least), std::abs(most));
  const long double own = wide_rounding * size;
  EXPECT_LE(found.minimum.lower(), least + own);
  EXPECT_GE(found.maximum.upper(), most - own);
  EXPECT_LE(found.minimum.lower(), found.minimum.upper());
  if (found.minimum.is_bounded()) {
    EXPECT_LE(found.minimum.width(), 4 * goal.relative_width * found.minimum.magnitude());
    EXPECT_NEAR(found.minimum.middle(), static_cast<double>(least),
                peak_error * static_cast<double>(size));
  }
  if (found.maximum.is_bounded()) {
    EXPECT_NEAR(found.maximum.middle(), static_cast<double>(most),
                peak_error * static_cast<double>(size));
  }
}

TEST(TorsionExtremes, HoldOnRandomPaths) {
  Random random("torsion bounds");
  for (int i = 0; i < 8; ++i) {
    check(random_path<1>(random, 2, 1.0));
    check(random_path<2>(random, 2, 1.0));
    check(random_path<3>(random, 3, 0x1.0p+100));
    check(random_path<5>(random, 2, 0x1.0p-100));  // not a tolerance: a size of preimages
    check(random_path<8>(random, 2, 1.0));
  }
}

TEST(TorsionExtremes, HoldOnClosedLoops) {
  Random random("torsion bounds of loops");
  for (int i = 0; i < cases(60); ++i) {
    const LoopShape shape{random.uniform(-2.0, 2.0), random.uniform(-3.1, 3.1)};
    check(closed_loop(shape, {1.0, {}, random.rotation()}).value());
    const auto juncture = closed_loop_juncture(shape).value();
    const Extremes found = torsion_extremes(closed_loop(shape).value(), goal);
    constexpr double rounding = 0x1.0p-40;  // of a closed form with third powers
    const double own = rounding * (1.0 + std::abs(juncture.torsion_begin) + juncture.curvature);
    EXPECT_LE(found.minimum.lower(), juncture.torsion_begin + own);
    EXPECT_GE(found.maximum.upper(), juncture.torsion_end - own);
  }
}

#if HODOGRAPH_TEST_HAS_ARB

/// τ of the exact curve at u in ball arithmetic, the triple product of the first three derivatives
/// of r over |r' × r''|², by de Casteljau on the preimage.
template <std::size_t n>
Judge exact_torsion(const SpatialPhCurve<n>& curve, double u) {
  using Exact = Quaternion<Judge>;
  std::array<Exact, n + 1> point;
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j < 4; ++j) point[i][j] = Judge(curve.preimage()[i][j]);
  }
  const Judge t(u), v = Judge(1.0) - t, h(curve.parameter_step());
  for (std::size_t left = n; left > 2; --left) {
    for (std::size_t i = 0; i < left; ++i) point[i] = v * point[i] + t * point[i + 1];
  }
  const Judge degree(static_cast<double>(n)), below(static_cast<double>(n) - 1.0);
  const Exact first = v * point[0] + t * point[1], last = v * point[1] + t * point[2];
  const Exact a = v * first + t * last;
  const Exact da = (degree / h) * (last - first);
  const Exact dda = (degree * below / (h * h)) * (point[2] - (point[1] + point[1]) + point[0]);
  const auto r1 = hodograph_form(a, a);
  const auto r2 = Judge(2.0) * hodograph_form(a, da);
  const auto r3 = Judge(2.0) * (hodograph_form(da, da) + hodograph_form(a, dda));
  const auto normal = cross(r1, r2);
  return dot(normal, r3) / dot(normal, normal);
}

template <std::size_t n>
void expect_within_exactly(const SpatialPath<n>& path) {
  const Enclosure range = torsion_extremes(path, goal).range();
  for (const auto& curve : path.segments()) {
    for (int i = 0; i <= 64; ++i) EXPECT_TRUE(encloses(range, exact_torsion(curve, i / 64.0)));
  }
}

TEST(TorsionExtremes, HoldSaysBallArithmetic) {
  Random random("torsion bounds in ball arithmetic");
  for (int i = 0; i < 10; ++i) {
    expect_within_exactly(random_path<2>(random, 3, 1.0));
    expect_within_exactly(random_path<3>(random, 3, 1.0));
    expect_within_exactly(random_path<8>(random, 2, 1.0));
    const LoopShape shape{random.uniform(-6.0, 6.0), random.uniform(-3.1, 3.1)};
    expect_within_exactly(closed_loop(shape, {3.0, {}, random.rotation()}).value());
  }
}

#endif  // HODOGRAPH_TEST_HAS_ARB

TEST(TorsionExtremes, AreZeroInACoordinatePlane) {
  const auto oval = closed_loop({0.0, std::numbers::pi}).value();
  const Extremes none{Enclosure(0.0), Enclosure(0.0)};
  EXPECT_EQ(torsion_extremes(oval, goal), none);
  const auto eight = closed_loop({0.0, 0.0}).value();
  EXPECT_EQ(torsion_extremes(eight, goal), none);
  // In another plane it is zero to rounding, over the square of the curvature.
  constexpr double rounding = 0x1.0p-30;
  const auto turned =
      closed_loop({0.0, std::numbers::pi}, {1.0, {}, {0.5, 0.5, 0.5, -0.5}}).value();
  EXPECT_LE(torsion_extremes(turned, goal).maximum.magnitude(), rounding);
}

TEST(TorsionExtremes, AreUnboundedWhereTheCurvatureMayVanish) {
  // A straight start that bends out of its plane: A = 1 + u² (j + u k)/..., V(0) = 0.
  BernsteinPolynomial<Quaternion<double>, 3> preimage;
  preimage[0] = preimage[1] = {1.0, 0.0, 0.0, 0.0};
  preimage[2] = {1.0, 0.0, 0.5, 0.0};
  preimage[3] = {1.0, 0.0, 0.5, 0.75};
  const auto path =
      SpatialPath<3>::create({0.0, 1.0}, {SpatialPhCurve<3>({}, preimage, 1.0)}, false).value();
  const Extremes found = torsion_extremes(path, goal);
  EXPECT_FALSE(found.minimum.is_bounded() && found.maximum.is_bounded());
}

}  // namespace
}  // namespace hodograph::test
