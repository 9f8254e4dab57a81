// SPDX-License-Identifier: MIT
// Isolated roots against exact isolation of all complex roots by Arb: none is outside its interval.
#include "hodograph/bernstein/roots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/arb_judge.hpp"
#include "support/random.hpp"

#if HODOGRAPH_TEST_HAS_ARB
#include <acb.h>
#include <arb_fmpz_poly.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz_poly_factor.h>
#endif

namespace hodograph {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double ulp = std::numeric_limits<double>::epsilon();

std::vector<Enclosure> enclosures(const std::vector<double>& coefficients) {
  return {coefficients.begin(), coefficients.end()};
}

/// Σ_k over roots: the Bernstein coefficients, rounded, of scale Π (u - root).
std::vector<double> with_roots(const std::vector<double>& roots, double scale = 1.0) {
  std::vector<long double> c{1.0L};
  for (const double root : roots) {
    const std::size_t n = c.size();  // (u - root) has coefficients -root, 1 - root
    std::vector<long double> next(n + 1, 0.0L);
    for (std::size_t i = 0; i <= n; ++i) {
      const long double weight = static_cast<long double>(i) / static_cast<long double>(n);
      if (i < n) next[i] += (1 - weight) * c[i] * -static_cast<long double>(root);
      if (i > 0) next[i] += weight * c[i - 1] * (1 - static_cast<long double>(root));
    }
    c = next;
  }
  std::vector<double> result;
  for (const long double x : c) result.push_back(static_cast<double>(x * scale));
  return result;
}

TEST(IsolatedRoots, RefuseWhatIsNoPolynomial) {
  const auto none = isolated_roots(std::span<const Enclosure>());
  ASSERT_FALSE(none);
  EXPECT_EQ(none.fault().code, FaultCode::too_few);
  for (const double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    const auto result = isolated_roots(BernsteinPolynomial<double, 2>({1.0, -1.0, bad}));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.fault().code, FaultCode::not_finite);
    EXPECT_EQ(result.fault().index, 2u);
  }
  const auto zero = isolated_roots(BernsteinPolynomial<double, 3>());
  ASSERT_FALSE(zero);
  EXPECT_EQ(zero.fault().code, FaultCode::outside_domain);
  EXPECT_NE(zero.fault().sentence.find("every point of [0, 1]"), std::string::npos);
}

TEST(IsolatedRoots, KnowTheSimplestPolynomials) {
  const auto roots = [](std::vector<double> c) { return isolated_roots(enclosures(c)).value(); };
  EXPECT_TRUE(roots({1.0}).empty());
  EXPECT_TRUE(roots({1.0, 2.0}).empty());
  const auto line = roots({-1.0, 3.0});
  ASSERT_EQ(line.size(), 1u);
  EXPECT_EQ(line[0].kind, RootKind::simple);
  EXPECT_TRUE(line[0].u.contains(0.25));
  EXPECT_EQ(line[0].sign_before, -1);
  EXPECT_EQ(line[0].sign_after, 1);
  // u and 1 - u: exact zeros at the ends.
  EXPECT_EQ(roots({0.0, 1.0}),
            (std::vector<IsolatedRoot>{{Enclosure(0.0), RootKind::simple, -1, 1}}));
  EXPECT_EQ(roots({1.0, 0.0}),
            (std::vector<IsolatedRoot>{{Enclosure(1.0), RootKind::simple, 1, -1}}));
  // (u - 1/2)(u - 3/4): roots at the cuts of the subdivision.
  const auto cuts = roots(with_roots({0.5, 0.75}));
  ASSERT_EQ(cuts.size(), 2u);
  for (const auto& root : cuts) EXPECT_EQ(root.kind, RootKind::simple);
  // (u - 1/2)²: a cluster with the same sign on both sides.
  const auto pair = roots({1.0, -1.0, 1.0});
  ASSERT_EQ(pair.size(), 1u);
  EXPECT_EQ(pair[0].kind, RootKind::cluster);
  EXPECT_TRUE(pair[0].u.contains(0.5));
  EXPECT_EQ(pair[0].sign_before, 1);
  EXPECT_EQ(pair[0].sign_after, 1);
  EXPECT_LT(pair[0].u.width(), 8 * std::sqrt(ulp));
  // A number that is not distinguished from zero.
  const auto unknown = isolated_roots(std::vector<Enclosure>{{-1.0, 2.0}, {-1.0, 1.0}}).value();
  ASSERT_EQ(unknown.size(), 1u);
  EXPECT_EQ(unknown[0].u, Enclosure(0.0, 1.0));
}

TEST(IsolatedRoots, FindTinyRootsAtTheirOwnScale) {
  for (const double root : {1e-3, 1e-17, 1e-100, 1e-290}) {  // not a tolerance: roots
    const auto roots =
        isolated_roots(BernsteinPolynomial<double, 2>({-root, 0.5, 1.0 - root})).value();
    ASSERT_EQ(roots.size(), 1u) << root;
    EXPECT_EQ(roots[0].kind, RootKind::simple);
    EXPECT_TRUE(roots[0].u.lower() > 0.0);
    EXPECT_LT(roots[0].u.width(), 64 * ulp * root);
    EXPECT_NEAR(roots[0].u.middle(), root,
                32 * ulp * root + 3 * root * root);  // it is root (1 - 2 root + ...)
  }
}

TEST(IsolatedRoots, AreWithinAFewUlpsWhenWellConditioned) {
  const std::vector<double> planted = {0.1, 0.3, 0.55, 0.8};
  const auto roots = isolated_roots(enclosures(with_roots(planted))).value();
  ASSERT_EQ(roots.size(), planted.size());
  for (std::size_t i = 0; i < planted.size(); ++i) {
    EXPECT_EQ(roots[i].kind, RootKind::simple);
    EXPECT_LT(roots[i].u.width(), 256 * ulp);
    EXPECT_LT(std::abs(roots[i].u.middle() - planted[i]), 256 * ulp);
    EXPECT_EQ(roots[i].sign_after, i % 2 == 0 ? -1 : 1);
  }
}

TEST(IsolatedRoots, DoNotDependOnScale) {
  const std::vector<double> c = with_roots({0.2, 0.5, 0.7});
  const auto expected = isolated_roots(enclosures(c)).value();
  for (const int exponent : {-900, -500, 500, 1000}) {
    std::vector<double> moved;
    for (const double x : c) moved.push_back(std::ldexp(x, exponent));
    EXPECT_EQ(isolated_roots(enclosures(moved)).value(), expected) << exponent;
  }
}

#if HODOGRAPH_TEST_HAS_ARB

using test::Judge;

/// A real root of a polynomial with exactly known coefficients, and its multiplicity.
struct TrueRoot {
  Judge u;
  int multiplicity;
};

/// All real roots of Σ c_i B_i^n with the doubles c_i: exact conversion to the power basis over the
/// integers, square-free parts, isolation of all complex roots.
std::vector<TrueRoot> true_roots(const std::vector<double>& c) {
  const std::size_t n = c.size() - 1;
  fmpq_poly_t sum, term, u, v;
  fmpq_poly_init(sum);
  fmpq_poly_init(term);
  fmpq_poly_init(u);
  fmpq_poly_init(v);
  fmpq_poly_set_str(u, "2  0 1");
  fmpq_poly_set_str(v, "2  1 -1");
  int lowest = 0;
  for (const double x : c) {
    int exponent = 0;
    std::frexp(x, &exponent);
    if (x != 0.0) lowest = std::min(lowest, exponent);
  }
  for (std::size_t i = 0; i <= n; ++i) {
    fmpq_poly_t power;
    fmpq_poly_init(power);
    fmpq_poly_pow(term, u, i);
    fmpq_poly_pow(power, v, n - i);
    fmpq_poly_mul(term, term, power);
    fmpq_poly_clear(power);
    // c_i = mantissa · 2^exponent, in units of 2^(lowest - 64): an integer.
    int exponent = 0;
    const double mantissa = std::frexp(c[i], &exponent);
    fmpz_t weight;
    fmpz_init(weight);
    fmpz_set_d(weight, std::ldexp(mantissa, 53));
    fmpz_mul_2exp(weight, weight,
                  static_cast<ulong>(c[i] == 0.0 ? 0 : exponent - 53 - (lowest - 64)));
    fmpz_t ways;
    fmpz_init(ways);
    fmpz_bin_uiui(ways, n, i);
    fmpz_mul(weight, weight, ways);
    fmpq_poly_scalar_mul_fmpz(term, term, weight);
    fmpq_poly_add(sum, sum, term);
    fmpz_clear(weight);
    fmpz_clear(ways);
  }
  fmpz_poly_t integer;
  fmpz_poly_init(integer);
  fmpq_poly_get_numerator(integer, sum);

  std::vector<TrueRoot> result;
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  if (fmpz_poly_degree(integer) > 0) fmpz_poly_factor_squarefree(factors, integer);
  for (slong k = 0; k < factors->num; ++k) {
    const slong degree = fmpz_poly_degree(factors->p + k);
    if (degree < 1) continue;
    acb_ptr roots = _acb_vec_init(degree);
    arb_fmpz_poly_complex_roots(roots, factors->p + k, 0, 2 * Judge::bits);
    for (slong i = 0; i < degree; ++i) {
      if (arb_is_zero(acb_imagref(roots + i))) {
        result.push_back({Judge::from(acb_realref(roots + i)), static_cast<int>(factors->exp[k])});
      }
    }
    _acb_vec_clear(roots, degree);
  }
  fmpz_poly_factor_clear(factors);
  fmpz_poly_clear(integer);
  fmpq_poly_clear(sum);
  fmpq_poly_clear(term);
  fmpq_poly_clear(u);
  fmpq_poly_clear(v);
  return result;
}

/// Checks every promise of isolated_roots for one polynomial; returns the number of simple roots.
int check(const std::vector<double>& c) {
  const auto result = isolated_roots(enclosures(c));
  if (!result) {
    EXPECT_TRUE(std::all_of(c.begin(), c.end(), [](double x) { return x == 0.0; }));
    return 0;
  }
  const std::vector<IsolatedRoot>& found = *result;
  std::vector<int> held(found.size(), 0);
  std::vector<bool> uncertain(found.size(), false);
  for (const TrueRoot& root : true_roots(c)) {
    if (root.u < Judge(0.0) || Judge(1.0) < root.u) continue;
    // Known to be inside, not only within the judge's 200 bits of an end.
    const bool inside = root.u.certainly_in(0.0, 1.0);
    int homes = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
      if (test::encloses(found[k].u, root.u)) {
        ++homes;
        held[k] += root.multiplicity;
        uncertain[k] = uncertain[k] || !inside;
      }
    }
    EXPECT_LE(homes, 1);
    EXPECT_GE(homes, inside ? 1 : 0)
        << "the root " << root.u.text() << " is in " << homes << " intervals";
  }
  int simple = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_LE(0.0, found[k].u.lower());
    EXPECT_LE(found[k].u.upper(), 1.0);
    if (k > 0) {
      EXPECT_LT(found[k - 1].u.upper(), found[k].u.lower());
    }
    if (found[k].kind == RootKind::simple) {
      ++simple;
      EXPECT_EQ(held[k], 1) << "[" << found[k].u.lower() << ", " << found[k].u.upper() << "]";
      EXPECT_EQ(found[k].sign_before * found[k].sign_after, -1);
    } else if (found[k].sign_before * found[k].sign_after != 0 && !uncertain[k]) {
      EXPECT_EQ(held[k] % 2 == 1, found[k].sign_before != found[k].sign_after);
    }
  }
  return simple;
}

TEST(IsolatedRoots, HoldEveryRootOfRandomPolynomials) {
  test::Random random("roots: random coefficients");
  int simple = 0, clusters = 0;
  for (int i = 0; i < 150; ++i) {
    std::vector<double> c(static_cast<std::size_t>(random.integer(1, 34)));
    for (double& x : c) x = random.uniform(-1.0, 1.0);
    simple += check(c);
    const auto roots = isolated_roots(enclosures(c)).value();
    for (const auto& root : roots) clusters += root.kind == RootKind::cluster;
  }
  EXPECT_GT(simple, 150);
  EXPECT_EQ(clusters, 0);  // random roots are simple and well separated
}

TEST(IsolatedRoots, HoldEveryRootOfPlantedAndNearlyMultipleOnes) {
  test::Random random("roots: planted");
  for (int i = 0; i < 150; ++i) {
    std::vector<double> planted;
    const auto count = random.integer(1, 12);
    while (static_cast<std::int64_t>(planted.size()) < count) {
      double root = random.chance(0.3) ? std::ldexp(static_cast<double>(random.integer(0, 16)), -4)
                                       : random.uniform(-0.3, 1.3);
      if (!planted.empty() && random.chance(0.4)) root = planted.back();
      if (random.chance(0.3)) root = random.nearly(root);
      if (random.chance(0.1)) root = random.near(root);
      planted.push_back(root);
    }
    check(with_roots(planted, random.spread(-490, 490)));
  }
}

TEST(IsolatedRoots, HoldEveryRootOfHostilePolynomials) {
  test::Random random("roots: hostile coefficients");
  for (int i = 0; i < 25; ++i) {  // of low degree: the judge's integers have thousands of bits
    std::vector<double> c(static_cast<std::size_t>(random.integer(1, 6)));
    for (double& x : c) x = random.chance(0.4) ? random.hostile() : random.uniform(-1.0, 1.0);
    check(c);
  }
}

TEST(IsolatedRoots, HoldEveryRootOfPowers) {
  test::Random random("roots: powers");
  for (int i = 0; i < 20; ++i) {
    const auto power = static_cast<std::size_t>(random.integer(2, 33));
    check(with_roots(std::vector<double>(power, random.uniform(0.0, 1.0))));
  }
}

#endif  // HODOGRAPH_TEST_HAS_ARB

}  // namespace
}  // namespace hodograph
