// SPDX-License-Identifier: MIT
// Motion polynomials: the Study condition, the action on points, framing motions; reduction.
#include "hodograph/rational/motion_polynomial.hpp"

#include <gtest/gtest.h>

#include "hodograph/rational/reduction.hpp"
#include "support/rational_golden.hpp"

namespace hodograph {
namespace {

using test::Random;
using test::random_polynomial;
using test::random_quaternion_polynomial;
using test::random_vector_polynomial;

RationalVector point(Random& random) {
  return {Rational(random.integer(-9, 9)), Rational(random.integer(-9, 9)),
          Rational(random.integer(-9, 9))};
}

TEST(MotionPolynomial, TheStudyConditionHoldsExactlyForVectorialTranslations) {
  Random random("study condition");
  for (int i = 0; i < 30; ++i) {
    const auto a = random_quaternion_polynomial(random, 2, 5);
    const auto alpha = random_polynomial(random, 2, 5);
    const auto b = random_vector_polynomial(random, 3, 5);
    const auto c = framing_motion(a, alpha, b);
    EXPECT_TRUE(is_motion_polynomial(c));
    EXPECT_TRUE(norm(c).dual.is_zero());
    EXPECT_EQ(norm(c).primal, alpha * alpha * norm_polynomial(a));
    // Lemma 3.1: the origin moves along -2 B / alpha.
    EXPECT_EQ(trajectory(c, {}), VectorFunction(RationalPolynomial(-2) * b, alpha));
    DualQuaternionPolynomial off = c;
    off.dual += a;
    EXPECT_FALSE(satisfies_study_condition(off));
    EXPECT_EQ((c * conjugate(c)).primal.w, norm(c).primal);
  }
}

TEST(MotionPolynomial, MovesPointsRigidlyAndComposes) {
  Random random("rigid motions");
  for (int i = 0; i < 20; ++i) {
    const auto c =
        framing_motion(random_quaternion_polynomial(random, 1, 4), random_polynomial(random, 1, 4),
                       random_vector_polynomial(random, 2, 4));
    const auto d = framing_motion(random_quaternion_polynomial(random, 1, 4), 1,
                                  random_vector_polynomial(random, 1, 4));
    const auto x = point(random), y = point(random);
    const VectorFunction gap = trajectory(c, x) - trajectory(c, y);
    EXPECT_EQ(dot(gap, gap), RationalFunction(RationalPolynomial(dot(x - y, x - y))));
    // The product moves by d first, then by c.
    const Rational t(random.integer(1, 9), 7);
    if (norm(c).primal.value(t).is_zero() || norm(d).primal.value(t).is_zero()) continue;
    EXPECT_EQ(trajectory(c * d, x).value(t), trajectory(c, trajectory(d, x).value(t)).value(t));
  }
}

TEST(Reduction, DividesOutWhatTurnsAboutTheTangent) {
  Random random("reduction");
  for (int i = 0; i < 40; ++i) {
    const auto a = random_quaternion_polynomial(random, 1 + random.index(3), 5);
    const auto own = reduction(a).value();
    const QuaternionPolynomial factor{random_polynomial(random, random.index(3), 3).monic(),
                                      random_polynomial(random, random.index(2), 3),
                                      {},
                                      {}};
    const auto found = reduction(a * factor).value();
    const QuaternionPolynomial divisor{found.re, found.im, {}, {}};
    EXPECT_EQ(found.reduced * divisor, a * factor);
    EXPECT_TRUE(content(indicatrix(found.reduced)).is_one());
    EXPECT_EQ(content(indicatrix(a * factor)), found.content());
    EXPECT_TRUE(reduction(found.reduced).value().was_reduced());
    EXPECT_EQ(found.content(), (own.content() * norm_polynomial(factor)).monic());
    // The same direction everywhere.
    EXPECT_LT(degree(cross(indicatrix(found.reduced), indicatrix(a))), 0);
  }
  const auto zero = reduction({});
  ASSERT_FALSE(zero);
  EXPECT_EQ(zero.fault().code, FaultCode::outside_domain);
}

}  // namespace
}  // namespace hodograph
