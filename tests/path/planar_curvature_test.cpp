// SPDX-License-Identifier: MIT
// Curvature of planar paths: golden extremes, and bounds against ball arithmetic.
#include "hodograph/path/planar_curvature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/arb_judge.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/planar_golden.hpp"

namespace hodograph {
namespace {

using test::agrees;
using test::Json;
using test::path_of;
using test::Random;
using Quintic = PlanarPhCurve<2>;

constexpr RangeGoal goal{std::numeric_limits<float>::epsilon()};
/// Twelve decimal digits, as wide as the quick bounds of these curves become.
constexpr RangeGoal fine{0x1.0p-40};
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The extremes by best-first subdivision alone.
template <std::size_t n>
Extremes by_subdivision(const PlanarPath<n>& path, const RangeGoal& wanted) {
  return path_detail::extremes_over_parts(path, RangeMeasure::value, wanted, [](const auto& exact) {
    return path_detail::rate_quotient(exact, 2, [](const auto& v) { return v; });
  });
}

bool overlap(const Enclosure& a, const Enclosure& b) { return !(a < b) && !(b < a); }

void expect_same(const Extremes& a, const Extremes& b) {
  EXPECT_TRUE(overlap(a.minimum, b.minimum))
      << a.minimum.lower() << ".." << a.minimum.upper() << " and " << b.minimum.lower() << ".."
      << b.minimum.upper();
  EXPECT_TRUE(overlap(a.maximum, b.maximum))
      << a.maximum.lower() << ".." << a.maximum.upper() << " and " << b.maximum.lower() << ".."
      << b.maximum.upper();
}

TEST(PlanarCurvature, StationaryPointsAreGolden) {
  const Json file = test::golden_file("planar_curvature.json");
  for (const char* section : {"curvature_extrema", "kmax_vs_S", "kmax_vs_l"}) {
    for (const Json& entry : file[section].list()) {
      SCOPED_TRACE(std::string(section) + ": " + entry["name"].string());
      const Json& expected = entry["expected"];
      const bool has_input = entry["input"].has("w");
      const auto path =
          path_of(test::quintic_preimage(has_input ? entry["input"]["w"] : expected["w"]));
      const double rel_tol = entry["rel_tol"].number();
      const auto points = curvature_stationary_points(path);
      ASSERT_EQ(points.size(), expected["roots"].size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_TRUE(agrees(points[i].xi, expected["roots"][i].number(), rel_tol));
        EXPECT_LE(points[i].xi_range.width(), rel_tol);
        EXPECT_TRUE(
            agrees(points[i].curvature.lower(), expected["kappa_at_roots"][i].number(), rel_tol));
        EXPECT_TRUE(
            agrees(points[i].curvature.upper(), expected["kappa_at_roots"][i].number(), rel_tol));
        EXPECT_NE(points[i].kind, CurvatureExtremeKind::undecided);
      }
      const double most =
          expected[expected.has("kappa_max") ? "kappa_max" : "kappa_max_abs"].number();
      const Enclosure range = curvature_extremes(path, fine).range();
      EXPECT_TRUE(agrees(range.magnitude(), most, rel_tol)) << range.magnitude();
      EXPECT_EQ(curvature_stays_within(path, most * (1 + rel_tol)), Answer::yes);
      if (most > 0) {
        EXPECT_EQ(curvature_stays_within(path, most * (1 - rel_tol)), Answer::no);
      }
    }
  }
}

TEST(PlanarCurvature, KindsAlternateAndInflectionsSeparateSigns) {
  Random random("planar curvature: kinds");
  for (int i = 0; i < test::cases(200); ++i) {
    const auto path = path_of(test::wild_preimage<Complex<double>, 2>(random), {}, 0.5);
    const auto points = curvature_stationary_points(path);
    for (std::size_t k = 1; k < points.size(); ++k) EXPECT_NE(points[k].kind, points[k - 1].kind);
    for (const Inflection& at : inflections(path)) {
      if (at.kind != RootKind::simple) continue;
      // No extreme lies at an inflection, and κ has opposite signs beside it.
      for (const auto& p : points) EXPECT_FALSE(overlap(p.xi_range, at.xi_range));
      const double reach = std::sqrt(std::numeric_limits<double>::epsilon());
      const auto kappa = [&](double xi) {
        const auto jet = path.preimage_jet<1>(path.clamped(xi));
        return body_rate_form(jet[0], jet[1]);
      };
      if (at.xi < reach || at.xi > 0.5 - reach) continue;
      EXPECT_LT(kappa(at.xi - reach) * kappa(at.xi + reach), 0);
    }
  }
}

TEST(PlanarCurvature, OfALineHasNoPoints) {
  const auto line =
      PlanarPath<2>::create(
          {0.0, 1.0}, {{{}, Quintic::Preimage({Complex<double>{1, 2}, {2, 4}, {0.5, 1}}), 1.0}},
          false)
          .value();
  EXPECT_TRUE(curvature_stationary_points(line).empty());
  EXPECT_TRUE(inflections(line).empty());
  EXPECT_EQ(curvature_extremes(line.segment(0), goal).range(), Enclosure(0.0));
  EXPECT_EQ(curvature_stays_within(line, 0.0), Answer::yes);
  const auto constant = path_of(BernsteinPolynomial<Complex<double>, 0>({Complex<double>{1, 1}}));
  EXPECT_TRUE(curvature_stationary_points(constant).empty());
  EXPECT_EQ(curvature_stays_within(constant, 0.0), Answer::yes);
}

TEST(PlanarCurvature, LimitsThatAreNone) {
  const auto path =
      path_of(BernsteinPolynomial<Complex<double>, 1>({Complex<double>{1, 0}, {1, 1}}));
  EXPECT_EQ(curvature_stays_within(path, -1.0), Answer::no);
  EXPECT_EQ(curvature_stays_within(path, std::nan("")), Answer::no);
  EXPECT_EQ(curvature_stays_within(path, infinity), Answer::yes);
  // κ = 2/(1 + u²)²: exactly 2 at the start.
  constexpr double beside = 0x1.0p-44;  // 256 roundings
  EXPECT_EQ(curvature_stays_within(path, 2.0 * (1 + beside)), Answer::yes);
  EXPECT_EQ(curvature_stays_within(path, 2.0 * (1 - beside)), Answer::no);
  // A cusp.
  const auto cusp =
      path_of(BernsteinPolynomial<Complex<double>, 1>({Complex<double>{-0.5, -0.25}, {0.5, 0.25}}));
  EXPECT_EQ(curvature_stays_within(cusp, 1.0), Answer::undecided);
}

TEST(PlanarCurvature, ALimitThatIsTouchedInsideIsSettledButForRounding) {
  // Symmetric, as a rounded corner: the largest curvature is in the middle.
  Random random("planar curvature: touched limit");
  for (int i = 0; i < 100; ++i) {
    const double a = random.uniform(0.1, 1.2), b = random.uniform(0.2, 1.0);
    const Complex<double> w0{std::cos(a), -std::sin(a)};
    const auto path = path_of(Quintic::Preimage({w0, {b, 0.0}, conjugate(w0)}));
    const double most = curvature_extremes(path, goal).range().magnitude();
    const double beside = 0x1.0p-36;  // 65536 roundings
    EXPECT_EQ(curvature_stays_within(path, most * (1 + beside)), Answer::yes);
    EXPECT_EQ(curvature_stays_within(path, most * (1 - beside)), Answer::no);
  }
}

#if HODOGRAPH_TEST_HAS_ARB

using test::encloses;
using test::Judge;

/// κ of the exact curve at u.
template <std::size_t n>
Judge exact_curvature(const PlanarPhCurve<n>& curve, double u) {
  BernsteinPolynomial<Complex<Judge>, n> w;
  for (std::size_t i = 0; i <= n; ++i) {
    w[i] = {Judge(curve.preimage()[i].re), Judge(curve.preimage()[i].im)};
  }
  const auto jet = w.template jet<1>(Judge(u));
  const Judge speed = dot(jet[0], jet[0]);
  return Judge(2.0) * (jet[0].re * jet[1].im - jet[0].im * jet[1].re) /
         (Judge(curve.parameter_step()) * speed * speed);
}

/// Judges the quick extremes and the limits at many points; returns whether they settled.
template <std::size_t n>
bool judge(const BernsteinPolynomial<Complex<double>, n>& preimage, double step) {
  const auto path = path_of(preimage, {}, step);
  const auto found = path_detail::QuickCurvature<n>(path.segment(0)).extremes();
  const Extremes all = curvature_extremes(path, goal);
  const Enclosure range = all.range();
  for (int k = 0; k <= 32; ++k) {
    const Judge kappa = exact_curvature(path.segment(0), k / 32.0);
    EXPECT_TRUE(encloses(range, kappa));
    if (found) {
      EXPECT_TRUE(encloses(found->range(), kappa));
    }
    for (const double limit : {0.25 * range.magnitude(), 0.75 * range.magnitude()}) {
      if (!std::isfinite(limit)) continue;
      const Answer answer = curvature_stays_within(path, limit);
      if (answer == Answer::yes) {
        EXPECT_TRUE(encloses({-limit, limit}, kappa));
      }
    }
  }
  if (found) {
    // Attained: the general search, which shares nothing with it but the numbers, agrees.
    expect_same(*found, by_subdivision(path, fine));
  }
  return found.has_value();
}

TEST(PlanarCurvature, QuickBoundsHold) {
  Random random("planar curvature: quick bounds");
  int settled = 0, count = 0;
  for (int i = 0; i < test::cases(400); ++i) {
    const double scale = std::exp2(random.uniform(-40.0, 40.0));
    const auto scaled = [&](auto w) { return scale * w; };
    const double step = random.uniform(0.01, 3.0);
    settled += judge(scaled(test::tame_preimage<Complex<double>, 2>(random)), step);
    settled += judge(scaled(test::wild_preimage<Complex<double>, 2>(random)), step);
    settled += judge(scaled(test::wild_preimage<Complex<double>, 1>(random)), step);
    settled += judge(scaled(test::wild_preimage<Complex<double>, 3>(random)), step);
    count += 4;
  }
  EXPECT_GT(settled, count * 9 / 10);
}

TEST(PlanarCurvature, QuickBoundsHoldNearCuspsSymmetryAndLines) {
  Random random("planar curvature: special quintics");
  for (int i = 0; i < test::cases(200); ++i) {
    const double small = std::exp2(random.uniform(-50.0, -2.0));
    auto w = test::wild_preimage<Complex<double>, 2>(random);
    w[1] = {w[1].re, small * w[1].im};  // symmetric but for a little
    w[2] = conjugate(w[0]);
    w[2].re += small;
    judge(w, 1.0);
    for (std::size_t k = 0; k <= 2; ++k) w[k].im *= small;  // nearly straight
    judge(w, 1.0);
    // A root of w close to the curve.
    const Complex<double> a{random.uniform(0.0, 1.0), small}, b = random.complex(2.0);
    judge(Quintic::Preimage(
              {a * b, -0.5 * (a + b), (Complex<double>{1, 0} - a) * (Complex<double>{1, 0} - b)}),
          1.0);
    // Equal and nearly equal coefficients: stationary at an end.
    const auto v = random.complex(1.0);
    judge(Quintic::Preimage({v, v, v + small * random.complex(1.0)}), 1.0);
    judge(Quintic::Preimage({v, v, random.complex(1.0)}), 1.0);
  }
}

TEST(PlanarCurvature, LinesAndRoundedCornersSettleQuickly) {
  Random random("planar curvature: corners");
  for (int i = 0; i < test::cases(200); ++i) {
    const auto v = random.complex(1.0);
    EXPECT_TRUE(judge(Quintic::Preimage({v, v, v}), 1.0));
    // Straight at both ends, the peak half-way.
    EXPECT_TRUE(judge(Quintic::Preimage({v, {}, random.complex(1.0)}), 1.0));
  }
}

TEST(PlanarCurvature, SegmentsThatDoNotSettleAreSubdividedAlone) {
  Random random("planar curvature: mixed paths");
  for (int i = 0; i < 50; ++i) {
    std::vector<double> knots{0.0};
    std::vector<Quintic> curves;
    Vector2<double> start{};
    // Sizes beyond 2^100 are left to the subdivision; whether they hold the extremes or not.
    constexpr double large = 0x1p60;
    for (const double scale : {1.0, large, i % 2 == 0 ? 1.0 / large : 1.0}) {
      const auto w = scale * test::tame_preimage<Complex<double>, 2>(random);
      knots.push_back(knots.back() + 1.0);
      curves.emplace_back(start, w, 1.0);
      start = curves.back().end();
    }
    const auto path = PlanarPath<2>::create(std::move(knots), std::move(curves), false).value();
    for (const RangeGoal& wanted : {goal, fine}) {
      const Extremes found = curvature_extremes(path, wanted);
      expect_same(found, by_subdivision(path, wanted));
      EXPECT_TRUE(path_detail::reaches(found, wanted));
    }
  }
}

TEST(PlanarCurvature, HoldsOnHostilePreimages) {
  Random random("planar curvature: hostile preimages");
  for (int i = 0; i < test::cases(300); ++i) {
    Quintic::Preimage preimage;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t j = 0; j < 2; ++j) {
        preimage[k][j] = random.chance(0.3) ? random.hostile() : random.uniform(-1.0, 1.0);
      }
    }
    const double step = std::exp2(random.uniform(-60.0, 60.0));
    const auto path = PlanarPath<2>::create({0.0, step}, {{{}, preimage, step}}, false);
    if (!path) continue;
    const Extremes all = curvature_extremes(*path, goal);
    for (const auto& p : curvature_stationary_points(*path)) {
      EXPECT_TRUE(p.xi_range.contains(p.xi));
      EXPECT_FALSE(p.curvature < all.range() || all.range() < p.curvature);
    }
    for (const Inflection& p : inflections(*path)) EXPECT_TRUE(p.xi_range.contains(p.xi));
    for (int k = 0; k <= 8; ++k) {
      const Complex<double> value = preimage.value(k / 8.0);
      if (value.re == 0.0 && value.im == 0.0) continue;
      const Judge kappa = exact_curvature(path->segment(0), k / 8.0);
      EXPECT_TRUE(encloses(all.range(), kappa));
    }
  }
}

#endif  // HODOGRAPH_TEST_HAS_ARB

}  // namespace
}  // namespace hodograph
