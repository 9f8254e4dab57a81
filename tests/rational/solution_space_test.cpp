// SPDX-License-Identifier: MIT
// The space of solutions: systems (6), (7), (8) against the residue system, bad input.
#include "hodograph/rational/solution_space.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/rational_systems.hpp"

namespace hodograph {
namespace {

using test::Random;

TEST(SolutionSpace, AgreesWithSystemsSixSevenEightOnRandomInput) {
  Random random("systems 6, 7, 8");
  test::compare_systems_on_random_input(random, 60);
}

TEST(SolutionSpace, AgreesWithThemOnSpecialInput) {
  Random random("special systems");
  test::compare_systems_on_special_input(random, 30);
}

TEST(SolutionSpace, ReducesItsInputAndSaysSo) {
  const auto t = RationalPolynomial::monomial(1, 1);
  const QuaternionPolynomial a{t * t, -t, -t, 1};
  const QuaternionPolynomial turn{t, -1, {}, {}};
  const auto plain = solve(a, t.power(3), 9).value();
  const auto turned = solve(a * turn, t.power(3), 9).value();
  EXPECT_EQ(turned.canonical_basis(), plain.canonical_basis());
  EXPECT_TRUE(plain.preimage_reduction().was_reduced());
  EXPECT_EQ(turned.preimage_reduction().re, t);
  EXPECT_EQ(turned.preimage_reduction().im, RationalPolynomial(-1));
}

TEST(SolutionSpace, RefusesHostileInput) {
  const auto t = RationalPolynomial::monomial(1, 1);
  const QuaternionPolynomial a{t, 1, {}, {}};
  EXPECT_EQ(solve({}, t, 3).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(solve(a, {}, 3).fault().code, FaultCode::outside_domain);
  const auto large = solve(a, t, 1000000);
  ASSERT_FALSE(large);
  EXPECT_EQ(large.fault().code, FaultCode::unsupported);
  EXPECT_NE(large.fault().sentence.find("1000000"), std::string::npos);
  EXPECT_EQ(solve(a, t.power(65), 3).fault().code, FaultCode::unsupported);
  EXPECT_EQ(solve(QuaternionPolynomial{t.power(65), 1, 1, {}}, t, 3).fault().code,
            FaultCode::unsupported);
  // A constant denominator: polynomial curves alone.
  const auto polynomial = solve(a, 7, 4).value();
  EXPECT_EQ(polynomial.rational_dimension(), 0u);
  EXPECT_EQ(polynomial.dimension(), 7u);
}

}  // namespace
}  // namespace hodograph
