// SPDX-License-Identifier: MIT
// Rational numbers, polynomials, rational functions: arithmetic, factors, integrals, text.
#include "hodograph/rational/polynomial.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "hodograph/rational/rational_function.hpp"
#include "support/rational_golden.hpp"

namespace hodograph {
namespace {

using test::Random;
using test::random_polynomial;

RationalPolynomial operator""_t(const char* degree) {
  return RationalPolynomial::monomial(1, static_cast<std::size_t>(std::stoi(degree)));
}

TEST(Rational, ReadsAndWritesText) {
  EXPECT_EQ(to_text(Rational::parse("-6/4").value()), "-3/2");
  EXPECT_EQ(to_text(Rational::parse("+0.75").value()), "3/4");
  EXPECT_EQ(to_text(Rational::parse("123456789012345678901234567890").value()),
            "123456789012345678901234567890");
  for (const char* text : {"", "-", "1/", "1/0", "1/-2", "x", "1.", ".5", "1/2/3", "1 "}) {
    const auto parsed = Rational::parse(text);
    ASSERT_FALSE(parsed) << text;
    EXPECT_EQ(parsed.fault().code, FaultCode::malformed_document);
    EXPECT_NE(parsed.fault().sentence.find("\"" + std::string(text) + "\""), std::string::npos);
  }
}

TEST(Rational, ConvertsFromAndToDoubles) {
  Random random("rational and double");
  for (int i = 0; i < 1000; ++i) {
    const double x = random.hostile();
    const Rational exact = Rational::exactly(x).value();
    const double back = exact.to_double();
    if (std::abs(x) >= std::numeric_limits<double>::min()) {
      EXPECT_EQ(back, x);
    } else {
      EXPECT_LE(std::abs(back - x), std::numeric_limits<double>::denorm_min());
    }
  }
  EXPECT_EQ(Rational(1, 3).to_double(), 1.0 / 3.0);
  EXPECT_FALSE(Rational::exactly(std::nan("")));
  EXPECT_FALSE(Rational::exactly(std::numeric_limits<double>::infinity()));
}

TEST(Rational, DividesByZeroWithAnException) {
  EXPECT_THROW(Rational(1) / Rational(0), std::domain_error);
  EXPECT_THROW(Rational(1, 0), std::domain_error);
  EXPECT_THROW(RationalPolynomial(1) / RationalPolynomial(), std::domain_error);
  EXPECT_LT(Rational(1, 3), Rational(1, 2));
  EXPECT_EQ(Rational(2, -4), Rational(-1, 2));
}

TEST(RationalPolynomial, IsARingWithDivision) {
  Random random("rational polynomials");
  for (int i = 0; i < 100; ++i) {
    const auto a = random_polynomial(random, random.index(8), 9);
    const auto b = random_polynomial(random, random.index(5), 9);
    const auto c = random_polynomial(random, random.index(5), 9);
    EXPECT_EQ((a + b) * c, a * c + b * c);
    EXPECT_EQ((a / b) * b + a % b, a);
    EXPECT_LT((a % b).degree(), b.degree() == 0 ? 0 : b.degree());
    EXPECT_EQ((a * b).derivative(), a.derivative() * b + a * b.derivative());
    EXPECT_EQ(a.integral().derivative(), a);
    EXPECT_EQ(a.shifted(Rational(2, 3)).value(Rational(1, 5)), a.value(Rational(13, 15)));
    EXPECT_EQ(a.taylor_coefficient(2).value(Rational(2, 3)),
              a.shifted(Rational(2, 3)).coefficient(2));
    EXPECT_TRUE(divides(gcd(a * c, b * c), a * c));
    EXPECT_TRUE(divides(c, gcd(a * c, b * c)));
  }
}

TEST(RationalPolynomial, IsWrittenHighestPowerFirst) {
  EXPECT_EQ(to_text(3_t - RationalPolynomial(2) * 1_t + RationalPolynomial(Rational(1, 2))),
            "t^3 - 2*t + 1/2");
  EXPECT_EQ(to_text(RationalPolynomial()), "0");
  EXPECT_EQ(to_text(-2_t - 0_t, "s"), "-s^2 - 1");
}

TEST(RationalPolynomial, FactorsByMultiplicityAndIntoIrreducibles) {
  const auto p = RationalPolynomial(6) * 4_t * (1_t - 1) * (1_t - 1) * (2_t + 1).power(2) *
                 (RationalPolynomial(2) * 1_t + 3).power(4);
  const auto strata = square_free_factors(p);
  ASSERT_EQ(strata.size(), 2u);
  EXPECT_EQ(strata[0], (PolynomialFactor{(1_t - 1) * (2_t + 1), 2}));
  EXPECT_EQ(strata[1], (PolynomialFactor{1_t * (1_t + Rational(3, 2)), 4}));
  EXPECT_EQ(radical(p), 1_t * (1_t - 1) * (2_t + 1) * (1_t + Rational(3, 2)));
  EXPECT_EQ(irreducible_factors(p).size(), 4u);
  EXPECT_TRUE(square_free_factors(RationalPolynomial(7)).empty());
  RationalPolynomial product(p.leading());
  for (const auto& f : irreducible_factors(p)) product *= f.factor.power(f.multiplicity);
  EXPECT_EQ(product, p);
}

TEST(RationalFunction, IntegratesUpToSimplePoles) {
  Random random("rational integrals");
  for (int i = 0; i < 60; ++i) {
    const auto q = random_polynomial(random, 1 + random.index(2), 4).power(1 + random.index(3)) *
                   random_polynomial(random, random.index(3), 4);
    const RationalFunction f(random_polynomial(random, random.index(9), 9), q);
    const auto parts = integral(f);
    EXPECT_EQ(parts.rational.derivative() + parts.obstruction, f);
    const RationalPolynomial& d = parts.obstruction.denominator();
    EXPECT_TRUE(gcd(d, d.derivative()).is_one());
    EXPECT_TRUE(integral(f.derivative()).obstruction.is_zero());
    const auto split = partial_fractions(f);
    RationalFunction sum(split.polynomial);
    for (const auto& part : split.parts) sum = sum + part.value;
    EXPECT_EQ(sum, f);
  }
}

}  // namespace
}  // namespace hodograph
