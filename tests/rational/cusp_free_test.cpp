// SPDX-License-Identifier: MIT
// Cusp-free curves and proofs that there are none: every certificate recomputed.
#include "hodograph/rational/cusp_free.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hodograph/rational/motion_polynomial.hpp"
#include "support/rational_golden.hpp"

namespace hodograph {
namespace {

using test::Random;
using test::random_polynomial;
using test::random_quaternion_polynomial;
using Outcome = CuspFreeAnswer::Outcome;
using Reason = CuspFreeAnswer::Reason;

// The preimage of the golden problems G1: tangents from i to (1, 2, 2)/3.
QuaternionPolynomial golden_preimage() {
  return {RationalPolynomial{0, -1}, RationalPolynomial{1, 1}, RationalPolynomial{0, {3, 2}},
          RationalPolynomial{0, {1, 2}}};
}
RationalPolynomial one_plus_t() { return {1, 1}; }

HermiteCurves curves_of(const QuaternionPolynomial& a, const RationalPolynomial& alpha,
                        std::size_t degree, const RationalHermiteData& data) {
  return HermiteCurves::create(solve(a, alpha, degree).value(), data).value();
}

/// ∫ λ F over [0, 1] for a polynomial λ.
RationalVector chord_of(const VectorPolynomial& f, const RationalPolynomial& lambda) {
  RationalVector chord;
  for (std::size_t c = 0; c < 3; ++c) chord[c] = (lambda * f[c]).integral().value(1);
  return chord;
}

TEST(ConeTest, KnowsChordsOfCuspFreeCurvesToBeInside) {
  Random random("inside");
  for (int i = 0; i < 40; ++i) {
    const auto a = random_quaternion_polynomial(random, 1 + random.index(3), 4);
    const VectorPolynomial f = indicatrix(reduction(a).value().reduced);
    // A square and a constant: λ > 0.
    const RationalPolynomial root = random_polynomial(random, random.index(3), 5);
    const RationalVector chord = chord_of(f, root * root + RationalPolynomial({1, 7}));
    const ConeTest answer = cone_test(f, chord, 0, 1);
    EXPECT_EQ(answer.outcome, ConeTest::Outcome::inside) << answer.sentence;
    EXPECT_TRUE(holds(answer, f, chord, 0, 1));
    EXPECT_FALSE(holds(answer, f, chord + RationalVector{1, 0, 0}, 0, 1));
  }
}

TEST(ConeTest, DecidesRandomChordsWithAProof) {
  Random random("cone");
  std::size_t outside = 0, inside = 0;
  for (int i = 0; i < 150; ++i) {
    const auto a = random_quaternion_polynomial(random, 1 + random.index(3), 4);
    const VectorPolynomial f = indicatrix(reduction(a).value().reduced);
    // Anywhere, or not far from the inside.
    RationalVector chord{random.integer(-5, 5), random.integer(-5, 5), random.integer(-5, 5)};
    if (i % 2 == 0) chord += value(f, {1, 3}) + value(f, {3, 4});
    const ConeTest answer = cone_test(f, chord, 0, 1);
    ASSERT_NE(answer.outcome, ConeTest::Outcome::undecided) << answer.sentence;
    EXPECT_TRUE(holds(answer, f, chord, 0, 1)) << answer.sentence;
    ++(answer.outcome == ConeTest::Outcome::inside ? inside : outside);
  }
  EXPECT_GT(inside, 20u);
  EXPECT_GT(outside, 20u);
}

TEST(ConeTest, DecidesTheBoundary) {
  const VectorPolynomial f = indicatrix(golden_preimage());
  // The directions at the ends are on the boundary; so is the chord 0 of a cone that is pointed.
  for (const RationalVector& chord :
       {value(f, 0), value(f, 1), RationalVector{}, value(f, 0) + value(f, 1)}) {
    const ConeTest answer = cone_test(f, chord, 0, 1);
    EXPECT_EQ(answer.outcome, ConeTest::Outcome::outside) << answer.sentence;
    EXPECT_TRUE(holds(answer, f, chord, 0, 1));
  }
  // Every direction of a cone over a conic, or over this arc, is on its boundary.
  const VectorPolynomial arc =
      indicatrix({RationalPolynomial{0, 1, -2}, RationalPolynomial{1, 0, 1},
                  RationalPolynomial{0, {2, 3}, {5, 6}}, RationalPolynomial{0, 0, {1, 2}}});
  for (const VectorPolynomial* each : {&f, &arc}) {
    for (const Rational& t : {Rational(1, 3), Rational(17, 101)}) {
      const ConeTest answer = cone_test(*each, value(*each, t), 0, 1);
      EXPECT_EQ(answer.outcome, ConeTest::Outcome::outside) << answer.sentence;
      EXPECT_TRUE(holds(answer, *each, value(*each, t), 0, 1));
    }
  }
  // Planar tangents: beside their plane, on it inside and outside the angle they fill.
  const VectorPolynomial circle = indicatrix({1, {}, {}, RationalPolynomial{0, 1}});
  EXPECT_EQ(cone_test(circle, {1, 1, 1}, 0, 1).outcome, ConeTest::Outcome::outside);
  EXPECT_EQ(cone_test(circle, {1, 1, 0}, 0, 1).outcome, ConeTest::Outcome::inside);
  EXPECT_EQ(cone_test(circle, {1, -1, 0}, 0, 1).outcome, ConeTest::Outcome::outside);
  EXPECT_EQ(cone_test(circle, {1, 0, 0}, 0, 1).outcome, ConeTest::Outcome::outside);
  // A straight line: forwards, backwards, beside, nowhere.
  const VectorPolynomial line{2, 1, {}};
  EXPECT_EQ(cone_test(line, {4, 2, 0}, 0, 1).outcome, ConeTest::Outcome::inside);
  for (const RationalVector& chord :
       {RationalVector{-4, -2, 0}, RationalVector{4, 2, 1}, RationalVector{}}) {
    const ConeTest answer = cone_test(line, chord, 0, 1);
    EXPECT_EQ(answer.outcome, ConeTest::Outcome::outside);
    EXPECT_TRUE(holds(answer, line, chord, 0, 1)) << answer.sentence;
  }
}

TEST(ConeTest, SaysWhenItHasNotDecided) {
  // Between F(t) at irrational t that touch the boundary from within: no rational normal decides.
  const VectorPolynomial f = indicatrix(golden_preimage());
  const ConeTest answer = cone_test(f, value(f, 0), 0, 1, 0);
  EXPECT_EQ(answer.outcome, ConeTest::Outcome::undecided);
  EXPECT_FALSE(holds(answer, f, value(f, 0), 0, 1));
}

TEST(CuspFree, CertifiesOrRefutesRandomSpaces) {
  Random random("cusp-free");
  std::size_t found = 0, none = 0;
  for (int i = 0; i < 40; ++i) {
    const auto a = random_quaternion_polynomial(random, 1 + random.index(2), 3);
    const VectorPolynomial f = indicatrix(reduction(a).value().reduced);
    const RationalPolynomial root = random_polynomial(random, 1, 4);
    const RationalVector chord = chord_of(f, root * root + RationalPolynomial({1, 9}));
    const RationalPolynomial alpha =
        RationalPolynomial{random.integer(1, 3), 1}.power(random.index(6));
    const std::size_t d =
        static_cast<std::size_t>(degree(f) + alpha.degree()) + 1 + random.index(6);
    const HermiteCurves curves =
        curves_of(a, alpha, d, {{1, 2, 3}, chord + RationalVector{1, 2, 3}, {}, {}});
    const CuspFreeAnswer answer = cusp_free_curve(curves).value();
    SCOPED_TRACE(answer.sentence);
    ASSERT_NE(answer.outcome, Outcome::undecided);
    EXPECT_TRUE(holds(answer, curves));
    ++(answer.outcome == Outcome::found ? found : none);
    if (answer.outcome == Outcome::found) {
      EXPECT_EQ(answer.curve->position(), curves.curve(answer.parameters).position());
      // The least speed at nodes cannot prove the contrary.
      EXPECT_GT(fastest_at_nodes(curves, equidistant(0, 1, 7), 1).least_speed.sign(), 0);
    }
  }
  EXPECT_GT(found, 10u);
  EXPECT_GT(none, 5u);
}

TEST(CuspFree, FollowsDerivatives) {
  Random random("C1 data");
  const auto a = golden_preimage();
  const VectorPolynomial f = indicatrix(a);
  for (int i = 0; i < 8; ++i) {
    const RationalPolynomial root = random_polynomial(random, 1, 4);
    const RationalPolynomial lambda = root * root + RationalPolynomial({1, 5});
    const RationalHermiteData data{
        {}, chord_of(f, lambda), lambda.value(0) * value(f, 0), lambda.value(1) * value(f, 1)};
    // The λ above is of degree 2: one of the curves for deg B = 5; more room with poles.
    const HermiteCurves exact = curves_of(a, 1, 5, data);
    EXPECT_EQ(exact.equations(), 5u);
    const HermiteCurves curves = curves_of(a, one_plus_t().power(5), 14, data);
    for (const HermiteCurves* each : {&exact, &curves}) {
      const CuspFreeAnswer answer = cusp_free_curve(*each).value();
      EXPECT_TRUE(holds(answer, *each)) << answer.sentence;
    }
    EXPECT_EQ(cusp_free_curve(exact).value().outcome, Outcome::found);
  }
}

TEST(CuspFree, NamesTheReasonWhyThereIsNone) {
  const auto a = golden_preimage();
  const auto alpha = one_plus_t().power(5);
  const auto reason = [&](std::size_t d, const RationalVector& end) {
    const HermiteCurves curves = curves_of(a, alpha, d, {{}, end, {}, {}});
    const CuspFreeAnswer answer = cusp_free_curve(curves).value();
    EXPECT_EQ(answer.outcome, Outcome::none);
    EXPECT_TRUE(holds(answer, curves)) << answer.sentence;
    return answer.reason;
  };
  const RationalVector inside{2, {9, 4}, 2}, near{2, 2, {3, 2}};
  EXPECT_EQ(reason(3, inside), Reason::contradiction);
  EXPECT_EQ(reason(4, inside), Reason::single_curve);
  EXPECT_EQ(reason(10, near), Reason::weights);
  EXPECT_EQ(reason(10, {{5, 2}, 0, 2}), Reason::cone);
  EXPECT_EQ(reason(10, {}), Reason::cone);
}

TEST(CuspFree, IsNotFooledByCoarseNodes) {
  const HermiteCurves curves =
      curves_of(golden_preimage(), one_plus_t().power(5), 18, {{}, {2, 2, {3, 2}}, {}, {}});
  const CuspFreeAnswer answer = cusp_free_curve(curves).value();
  EXPECT_EQ(answer.outcome, Outcome::found);
  EXPECT_TRUE(holds(answer, curves));
}

TEST(CuspFree, NeedsNoFloatingPointWhereItHasNone) {
  // Numbers beyond the range of doubles: nothing can be proposed, and exact pivots do all the work.
  const Rational huge = Rational::parse("1" + std::string(400, '0')).value();
  const RationalVector end{2, 2, {3, 2}};
  for (const std::size_t degree : {10u, 11u, 12u}) {
    const auto alpha = one_plus_t().power(5);
    const HermiteCurves curves =
        curves_of(golden_preimage(), alpha, degree, {{}, huge * end, {}, {}});
    const CuspFreeAnswer answer = cusp_free_curve(curves).value();
    EXPECT_TRUE(holds(answer, curves));
    EXPECT_EQ(answer.outcome == Outcome::found, degree > 10);
    const auto nodes = equidistant(0, 1, 25);
    const HermiteCurves plain = curves_of(golden_preimage(), alpha, degree, {{}, end, {}, {}});
    EXPECT_EQ(fastest_at_nodes(curves, nodes, huge).least_speed,
              huge * fastest_at_nodes(plain, nodes, 1).least_speed);
  }
}

TEST(CuspFree, ClosedCurvesFromAnAThatTurnsAllTheWay) {
  // Tangents round the whole circle: a closed planar curve, and a cone that is the whole plane.
  const QuaternionPolynomial a{RationalPolynomial{1, 0, -4}, {}, {}, RationalPolynomial{0, 4}};
  RationalHermiteData data{{}, {}, {}, {}, -1, 1};
  const DegreeSearch search =
      smallest_cusp_free(a, data, {RationalPolynomial{5, 0, 1}, 0, 1, 24, {}}).value();
  ASSERT_TRUE(search.found) << search.sentence;
  EXPECT_TRUE(search.found->answer.speed_bound.has_value());
  EXPECT_EQ(search.found->answer.curve->position().value(-1),
            search.found->answer.curve->position().value(1));
}

TEST(CuspFree, SaysWhenTheRoundsAreSpent) {
  const HermiteCurves curves =
      curves_of(golden_preimage(), one_plus_t().power(5), 12, {{}, {2, 2, {3, 2}}, {}, {}});
  const CuspFreeAnswer answer = cusp_free_curve(curves, {0, 0}).value();
  EXPECT_EQ(answer.outcome, Outcome::undecided);
  EXPECT_FALSE(holds(answer, curves));
}

TEST(DegreeSearch, FindsTheSmallestSpaceAndProvesIt) {
  const auto a = golden_preimage();
  const RationalHermiteData data{{}, {2, 2, {3, 2}}, {}, {}};
  const DegreeSearch search = smallest_cusp_free(a, data, {one_plus_t(), 5, 5, 14, {}}).value();
  ASSERT_TRUE(search.found);
  EXPECT_TRUE(search.proved_smallest) << search.sentence;
  EXPECT_EQ(search.found->degree, 11u);
  for (const SearchedSpace& space : search.before) {
    EXPECT_TRUE(
        holds(space.answer, curves_of(a, one_plus_t().power(space.power), space.degree, data)))
        << space.answer.sentence;
  }
  // Too small a bound; no cone; a constant base, whose powers are all the same.
  EXPECT_FALSE(smallest_cusp_free(a, data, {one_plus_t(), 5, 5, 10, {}}).value().found);
  EXPECT_TRUE(
      smallest_cusp_free(a, {{}, {-1, 0, 0}, {}, {}}, {one_plus_t(), 0, 5, 30, {}}).value().cone);
  EXPECT_EQ(smallest_cusp_free(a, data, {1, 0, 9, 14, {}}).value().found->degree, 9u);
  EXPECT_EQ(smallest_cusp_free(a, data, {one_plus_t(), 2, 1, 14, {}}).fault().code,
            FaultCode::outside_domain);
}

TEST(HermiteCurves, RefuseWhatTheyCannotMeet) {
  const auto a = golden_preimage();
  const auto code = [&](const RationalPolynomial& alpha, const RationalHermiteData& data) {
    return HermiteCurves::create(solve(a, alpha, 8).value(), data).fault().code;
  };
  const RationalVector end{2, 2, 2};
  EXPECT_EQ(code(one_plus_t(), {{}, end, {}, {}, 1, 1}), FaultCode::not_increasing);
  EXPECT_EQ(code(one_plus_t(), {{}, end, {}, {}, -2, 1}), FaultCode::outside_domain);
  EXPECT_EQ(code({-1, 2}, {{}, end, {}, {}}), FaultCode::outside_domain);
  EXPECT_EQ(code({-2, 0, 9}, {{}, end, {}, {}}), FaultCode::outside_domain);
  EXPECT_EQ(code(one_plus_t(), {{}, end, RationalVector{}, {}}), FaultCode::zero_speed);
  EXPECT_EQ(code(one_plus_t(), {{}, end, RationalVector{-1, 0, 0}, {}}), FaultCode::outside_domain);
  EXPECT_EQ(code(one_plus_t(), {{}, end, {}, RationalVector{1, 0, 0}}), FaultCode::outside_domain);
  const HermiteCurves large = curves_of(a, 1, largest_freedom + 8, {{}, {2, {9, 4}, 2}, {}, {}});
  EXPECT_EQ(cusp_free_curve(large).fault().code, FaultCode::unsupported);
}

}  // namespace
}  // namespace hodograph
