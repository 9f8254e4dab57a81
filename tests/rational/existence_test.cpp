// SPDX-License-Identifier: MIT
// Theorem 4.6: existence with its reason, and the dimension of every space, predicted and
// confirmed.
#include "hodograph/rational/existence.hpp"

#include <gtest/gtest.h>

#include <string>

#include "hodograph/rational/motion_polynomial.hpp"
#include "hodograph/rational/solution_space.hpp"
#include "support/rational_golden.hpp"

namespace hodograph {
namespace {

using namespace test;

TEST(Existence, MatchesEveryGoldenCase) {
  const Json file = golden_file("rational.json");
  for (const Json& c : file["cases"].list()) {
    SCOPED_TRACE(c["name"].string());
    const Existence answer =
        existence(golden_quaternion(c["A"]), golden_polynomial(c["alpha"])).value();
    const Json& expected = c["theorem46"];
    EXPECT_EQ(answer.exists, expected["exists"].number() == 1.0);
    EXPECT_EQ(static_cast<double>(answer.freedom), expected["N"].number());
    ASSERT_EQ(answer.strata.size(), expected["strata"].size());
    for (std::size_t i = 0; i < answer.strata.size(); ++i) {
      const Json& s = expected["strata"][i];
      EXPECT_EQ(static_cast<double>(answer.strata[i].order), s["n"].number());
      EXPECT_EQ(answer.strata[i].poles, golden_polynomial(s["s"]));
      EXPECT_EQ(answer.strata[i].rank_two, golden_polynomial(s["rank_le_2"]));
      EXPECT_EQ(answer.strata[i].rank_one, golden_polynomial(s["rank_le_1"]));
    }
    const Json& predicted = c["generic_formula_by_degB"];
    for (std::size_t d = 0; d < predicted.size(); ++d) {
      const auto dimension = answer.dimension(d);
      EXPECT_EQ(static_cast<double>(dimension.value), predicted[d].number()) << d;
      if (dimension.exact) {
        EXPECT_EQ(static_cast<double>(dimension.value), c["dims_by_degB"][d].number()) << d;
      } else {
        EXPECT_LE(static_cast<double>(dimension.value), c["dims_by_degB"][d].number()) << d;
      }
    }
  }
}

TEST(Existence, SaysWhyInASentence) {
  const auto t = RationalPolynomial::monomial(1, 1);
  const QuaternionPolynomial a{t * t, -t, -t, 1};  // Examples 5.1 and 5.3
  const auto sentence = [&](const QuaternionPolynomial& preimage, const RationalPolynomial& alpha) {
    return existence(preimage, alpha).value().reason;
  };
  EXPECT_EQ(sentence(a, t.power(3)),
            "truly rational curves exist: the pole t = 0 has order 3, and order 3 or more always "
            "admits one");
  EXPECT_EQ(sentence(a, (t + 1).power(2)),
            "truly rational curves exist: the pole t = -1 has order 2 and the indicatrix has an "
            "inflection there");
  EXPECT_EQ(
      sentence(a, (t - 3).power(2) * (t * t + 5)),
      "every curve is polynomial: the poles at the roots of t^2 + 5 have order 1 and the "
      "indicatrix has no cusp at any of them; the pole t = 3 has order 2 and the indicatrix has no "
      "inflection there");
  EXPECT_EQ(sentence(a, 4), "alpha is constant, so every curve is polynomial");
  const QuaternionPolynomial cusp{t * t - 1, RationalPolynomial(3) * t, 2, 1};  // Example 5.4
  EXPECT_EQ(sentence(cusp, t * t + 1),
            "truly rational curves exist: the poles at the roots of t^2 + 1 have order 1 and the "
            "indicatrix has a cusp at each of them");
  const QuaternionPolynomial planar{1, {}, {}, t};
  EXPECT_EQ(sentence(planar, (t - 2).power(2)),
            "truly rational curves exist: the pole t = 2 has order 2, which is enough since the "
            "indicatrix lies in a plane");
}

TEST(Existence, PredictsEveryDimension) {
  Random random("predicted dimensions");
  const auto t = RationalPolynomial::monomial(1, 1);
  for (int i = 0; i < 60; ++i) {
    auto a = random_quaternion_polynomial(random, 1 + random.index(3), 3);
    if (i % 3 == 1) a = QuaternionPolynomial{1, {}, {}, {}} + (t * t) * a;
    if (i % 3 == 2) a.x = a.y = RationalPolynomial();
    auto alpha = t.power(random.index(4)) * random_polynomial(random, 1, 3).power(random.index(4)) *
                 random_polynomial(random, 2, 3).power(random.index(3));
    const Existence answer = existence(a, alpha).value();
    bool found = false;
    for (std::size_t d = 0; d <= answer.alpha_degree + answer.indicatrix_degree + 3; ++d) {
      const SolutionSpace space = solve(a, alpha, d).value();
      const auto predicted = answer.dimension(d);
      if (predicted.exact) {
        EXPECT_EQ(space.dimension(), predicted.value);
      } else {
        EXPECT_GE(space.dimension(), predicted.value);
      }
      found = found || space.rational_dimension() > 0;
      for (const auto& b : space.basis()) {
        EXPECT_TRUE(answer.exists || kind_of(b, alpha) != CurveKind::rational);
      }
    }
    EXPECT_EQ(found, answer.exists) << answer.reason;
  }
}

TEST(Existence, RefusesZero) {
  EXPECT_EQ(existence({}, 1).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(existence({1, {}, {}, {}}, {}).fault().code, FaultCode::outside_domain);
}

}  // namespace
}  // namespace hodograph
