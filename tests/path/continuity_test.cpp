// SPDX-License-Identifier: MIT
#include "hodograph/path/continuity.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "hodograph/path/operations.hpp"
#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

using test::Random;
using test::random_path;

template <class P>
class PathContinuityOf : public testing::Test {};
using Paths = testing::Types<PlanarPath<8>, SpatialPath<4>, SpatialPath<8>>;
TYPED_TEST_SUITE(PathContinuityOf, Paths);

TYPED_TEST(PathContinuityOf, MeasuresTheOrderThatWasBuilt) {
  Random random("continuity");
  for (int order = -1; order <= 3; ++order) {
    for (int repeat = 0; repeat < 20; ++repeat) {
      const auto path = random_path<TypeParam>(random, 4, order);
      const auto found = continuity(path);
      EXPECT_EQ(found.preimage.order(), order);
      EXPECT_EQ(found.position.order(), order + 1);
      EXPECT_FALSE(found.antiperiodic);
    }
  }
}

TYPED_TEST(PathContinuityOf, DoesNotDependOnUnits) {
  Random random("continuity units");
  for (int order = 0; order <= 2; ++order) {
    const auto path = random_path<TypeParam>(random, 3, order);
    // 4^k, so that the preimage is scaled by a power of two, too.
    const auto small = scaled(path, std::ldexp(1.0, -400)).value();
    EXPECT_EQ(continuity(small).preimage.order(), order);
    EXPECT_EQ(continuity(small).position.order(), order + 1);
    EXPECT_EQ(continuity(small).preimage.jump, continuity(path).preimage.jump);
    const auto back = reversed(path).value();
    EXPECT_EQ(continuity(back).preimage.order(), order);
    EXPECT_EQ(continuity(back).position.order(), order + 1);
  }
}

TEST(PathContinuity, NamesTheWorstKnot) {
  Random random("continuity worst");
  const auto path = random_path<SpatialPath<4>>(random, 5, 3);
  auto segments = path.segments();
  const std::size_t torn = 3;
  for (std::size_t k = torn; k < 5; ++k) {
    auto preimage = segments[k].preimage();
    if (k == torn) preimage[1] = 1.125 * preimage[1];
    segments[k] = {segments[k - 1].end(), preimage, segments[k].parameter_step()};
  }
  const auto bent = SpatialPath<4>::create(path.knots(), segments, false).value();
  const auto found = continuity(bent);
  EXPECT_EQ(found.preimage.order(), 0);
  EXPECT_EQ(found.position.order(), 1);
  EXPECT_EQ(found.preimage.knot[1], torn);
  EXPECT_EQ(found.position.knot[2], torn);
  EXPECT_GT(found.preimage.jump[1], found.preimage.allowed[1]);
  // Knot 3 is told apart from the others.
  EXPECT_EQ(jumps_at_knot(bent, torn).preimage.order(), 0);
  EXPECT_EQ(jumps_at_knot(bent, 1).preimage.order(), 3);
}

TEST(PathContinuity, TheClosingKnotOfAClosedPathCounts) {
  const auto once = test::ring(7);
  const auto found = continuity(once);
  EXPECT_TRUE(found.antiperiodic);
  EXPECT_EQ(found.preimage.order(), 0);
  EXPECT_EQ(found.position.order(), 1);
  EXPECT_EQ(jumps_at_knot(once, 0).preimage.order(), 0);

  // Twice round, the preimage is periodic.
  const auto open = with_closure(once, false).value();
  const auto twice = with_closure(joined(open, open).value(), true).value();
  EXPECT_FALSE(continuity(twice).antiperiodic);
  EXPECT_EQ(continuity(twice).preimage.order(), 0);
}

TEST(PathContinuity, APathWithoutInnerKnotsHasNoJumps) {
  Random random("continuity one");
  const auto found = continuity(random_path<PlanarPath<2>>(random, 1));
  EXPECT_EQ(found.position.order(), 4);
  EXPECT_EQ(found.preimage.order(), 3);
}

TEST(PathContinuity, AConstantPreimageHasNoDerivatives) {
  const BernsteinPolynomial<Quaternion<double>, 0> a({Quaternion<double>{1, 2, 3, 4}});
  const SpatialPhCurve<0> first({0, 0, 0}, a, 0.5), second(first.end(), a, 2.0);
  const auto line = SpatialPath<0>::create({0.0, 0.5, 2.5}, {first, second}, false).value();
  EXPECT_EQ(continuity(line).position.order(), 4);
  EXPECT_EQ(continuity(line).preimage.order(), 3);
}

}  // namespace
}  // namespace hodograph
