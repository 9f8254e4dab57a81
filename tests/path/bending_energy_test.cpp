// SPDX-License-Identifier: MIT
// Bending energy: golden values, and enclosures against quadrature in 50 digits.
#include "hodograph/path/bending_energy.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/planar_golden.hpp"
#include "tests/support/quadrature.hpp"

namespace hodograph {
namespace {

using test::agrees;
using test::Json;
using test::path_of;
using test::Random;
using Real = boost::multiprecision::cpp_bin_float_50;

/// ∫ h²/σ³ by adaptive halving of 30-node rules, to 40 digits.
template <std::size_t n>
Real exact_energy(const BernsteinPolynomial<Complex<double>, n>& preimage, double step) {
  static const auto rule = test::gauss_legendre<Real, 30>();
  BernsteinPolynomial<Complex<Real>, n> w;
  for (std::size_t i = 0; i <= n; ++i) w[i] = {Real(preimage[i].re), Real(preimage[i].im)};
  const auto integrate = [&](double a, double b) {
    Real sum(0);
    for (const auto& [x, weight] : rule) {
      const Real u = Real(a) + (Real(b) - Real(a)) * x;
      const auto jet = w.template jet<1>(u);
      const Real speed = dot(jet[0], jet[0]);
      const Real h = Real(2) * (jet[0].re * jet[1].im - jet[0].im * jet[1].re);
      sum += weight * h * h / (speed * speed * speed);
    }
    return Real((Real(b) - Real(a)) * sum);
  };
  const Real wanted = boost::multiprecision::pow(Real(10), -38);
  Real total(0);
  std::vector<std::array<double, 2>> open{{0.0, 1.0}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    const double c = 0.5 * (a + b);
    const Real whole = integrate(a, b), halves = integrate(a, c) + integrate(c, b);
    if (abs(Real(whole - halves)) <= wanted * (halves + total)) {
      total += halves;
    } else {
      open.push_back({c, b});
      open.push_back({a, c});
    }
  }
  return Real(total / Real(step));
}

TEST(BendingEnergy, IsGolden) {
  const Json file = test::golden_file("planar_energy.json");
  for (const Json& entry : file["energy"].list()) {
    SCOPED_TRACE(entry["name"].string());
    const auto path = path_of(test::quintic_preimage(entry["input"]["w"]));
    const double expected = entry["expected"]["energy"].number();
    const double rel_tol = entry["rel_tol"].number();
    const auto energy = bending_energy(path);
    const auto enclosure = bending_energy_enclosure(path);
    ASSERT_TRUE(energy.has_value());
    ASSERT_TRUE(enclosure.has_value());
    EXPECT_TRUE(agrees(*energy, expected, rel_tol)) << *energy;
    EXPECT_TRUE(agrees(enclosure->lower(), expected, rel_tol)) << enclosure->lower();
    EXPECT_TRUE(agrees(enclosure->upper(), expected, rel_tol)) << enclosure->upper();
  }
}

template <std::size_t n>
void judge(const BernsteinPolynomial<Complex<double>, n>& w, double step) {
  const auto path = path_of(w, {}, step);
  const auto enclosure = bending_energy_enclosure(path);
  const auto energy = bending_energy(path);
  ASSERT_TRUE(enclosure.has_value());
  ASSERT_TRUE(energy.has_value());
  const Real truth = exact_energy(w, step);
  EXPECT_LE(Real(enclosure->lower()), truth);
  EXPECT_GE(Real(enclosure->upper()), truth);
  // The double is as good as the enclosure is narrow.
  constexpr double roundings = 256;
  EXPECT_LE(std::abs(*energy - enclosure->middle()),
            2 * enclosure->width() +
                roundings * std::numeric_limits<double>::epsilon() * enclosure->magnitude());
}

TEST(BendingEnergy, EnclosuresHoldInEveryDegree) {
  Random random("bending energy: degrees");
  for (int i = 0; i < 12; ++i) {
    const double step = random.uniform(0.1, 3.0);
    judge(test::tame_preimage<Complex<double>, 1>(random), step);
    judge(test::tame_preimage<Complex<double>, 2>(random), step);
    judge(test::wild_preimage<Complex<double>, 2>(random), step);
    judge(test::wild_preimage<Complex<double>, 3>(random), step);
    judge(test::wild_preimage<Complex<double>, 4>(random), step);
  }
}

TEST(BendingEnergy, EnclosuresHoldNearCuspsAndLines) {
  Random random("bending energy: cusps and lines");
  for (int i = 0; i < 10; ++i) {
    const double small = std::exp2(random.uniform(-30.0, -2.0));
    const Complex<double> a{random.uniform(0.0, 1.0), small}, b = random.complex(2.0);
    const Complex<double> one{1.0, 0.0};
    judge(BernsteinPolynomial<Complex<double>, 2>({a * b, -0.5 * (a + b), (one - a) * (one - b)}),
          1.0);
    auto w = test::tame_preimage<Complex<double>, 2>(random);
    for (std::size_t k = 0; k <= 2; ++k) w[k].im *= small;
    judge(w, 1.0);
  }
}

TEST(BendingEnergy, IsNarrowOnTameCurves) {
  Random random("bending energy: width");
  for (int i = 0; i < 200; ++i) {
    const auto path = test::random_path<PlanarPath<2>>(random, 5, 0);
    const auto energy = bending_energy_enclosure(path);
    ASSERT_TRUE(energy.has_value());
    EXPECT_LE(energy->width(), 4096 * std::numeric_limits<double>::epsilon() * energy->upper());
    const auto value = bending_energy(path);
    ASSERT_TRUE(value.has_value());
    EXPECT_CLOSE(*value, energy->middle(), 256, energy->middle());
  }
}

TEST(BendingEnergy, FractionsAgreeWithTheEnclosureOrSayNothing) {
  Random random("bending energy: fractions");
  int said = 0;
  const auto check = [&](const auto& w) {
    const auto value = path_detail::energy_by_fractions(w);
    if (!value) return;
    constexpr std::size_t n = std::remove_cvref_t<decltype(w)>::degree;
    const auto truth = bending_energy_enclosure(path_of(w));
    ASSERT_TRUE(truth.has_value());
    ++said;
    EXPECT_CLOSE(
        4.0 * n * n * *value, truth->middle(),
        1024 + 2 * truth->width() / truth->middle() / std::numeric_limits<double>::epsilon(),
        truth->middle());
  };
  for (int i = 0; i < 500; ++i) {
    check(test::wild_preimage<Complex<double>, 2>(random));
    check(test::tame_preimage<Complex<double>, 2>(random));
    check(test::wild_preimage<Complex<double>, 1>(random));
    // Roots near a double one, near conjugates, near the curve.
    const double small = std::exp2(random.uniform(-40.0, -1.0));
    const Complex<double> a = random.complex(1.0), one{1.0, 0.0};
    for (const Complex<double>& b :
         {a + small * random.complex(1.0), conjugate(a) + small * random.complex(1.0),
          Complex<double>{a.re, small}}) {
      check(BernsteinPolynomial<Complex<double>, 2>(
          {a * b, -0.5 * ((one - a) * b + (one - b) * a), (one - a) * (one - b)}));
    }
  }
  EXPECT_GT(said, 500);
}

TEST(BendingEnergy, ScalesWithTheInverseOfLength) {
  Random random("bending energy: scale");
  const auto w = test::tame_preimage<Complex<double>, 2>(random);
  const double base = bending_energy(path_of(w)).value();
  for (const int exponent : {-300, -40, 40, 300}) {
    const auto scaled = std::ldexp(1.0, exponent) * w;
    EXPECT_EQ(bending_energy(path_of(scaled)).value(), std::ldexp(base, -2 * exponent));
    EXPECT_TRUE(bending_energy_enclosure(path_of(scaled))
                    .value()
                    .contains(std::ldexp(bending_energy_enclosure(path_of(w)).value().middle(),
                                         -2 * exponent)));
  }
}

TEST(BendingEnergy, OfACuspIsRefusedAndOfALineIsZero) {
  using Linear = BernsteinPolynomial<Complex<double>, 1>;
  // w = u - 1/2 turned: a straight line that comes back; τ is exactly 0.
  const auto back = path_of(Linear({Complex<double>{-0.5, -0.25}, {0.5, 0.25}}));
  EXPECT_TRUE(!bending_energy(back) || *bending_energy(back) == 0.0);
  // w = (u - 1/2)(1 + i u): a cusp on a curve that turns.
  const Complex<double> one{1.0, 0.0}, end{1.0, 1.0};
  const BernsteinPolynomial<Complex<double>, 2> cusp(
      {-0.5 * one, 0.5 * (0.5 * one) - 0.25 * end, 0.5 * end});
  const auto path = path_of(cusp);
  for (const auto& fault : {bending_energy(path).fault(), bending_energy_enclosure(path).fault()}) {
    EXPECT_EQ(fault.code, FaultCode::zero_speed);
    EXPECT_EQ(fault.index, 0U);
  }
  EXPECT_EQ(bending_energy_enclosure(path_of(Linear({one, 3.0 * one}))).value(), Enclosure(0.0));
  EXPECT_EQ(bending_energy(path_of(BernsteinPolynomial<Complex<double>, 0>({end}))).value(), 0.0);
}

TEST(BendingEnergy, OfAStopAtAnEndIsRefused) {
  // Quadratic preimages that vanish at the end, at the beginning, and both.
  const Complex<double> none{}, one{1.0, 0.0}, turned{0.5, 0.5};
  using Quadratic = BernsteinPolynomial<Complex<double>, 2>;
  for (const Quadratic& stop : {Quadratic({one, turned, none}), Quadratic({none, turned, one}),
                                Quadratic({none, one, none})}) {
    const auto energy = bending_energy(path_of(stop));
    const auto enclosure = bending_energy_enclosure(path_of(stop));
    const bool straight = stop[0] == none && stop[2] == none;
    EXPECT_EQ(energy.has_value(), straight);
    EXPECT_EQ(enclosure.has_value(), straight);
    if (!straight) {
      EXPECT_EQ(enclosure.fault().code, FaultCode::zero_speed);
    }
  }
}

}  // namespace
}  // namespace hodograph
