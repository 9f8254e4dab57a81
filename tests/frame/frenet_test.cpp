// SPDX-License-Identifier: MIT
#include "hodograph/frame/frenet.hpp"

#include <gtest/gtest.h>

#include "hodograph/path/operations.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

using test::Random;
using test::random_path;

TEST(Frenet, AgreesWithTheDerivativesOfThePosition) {
  Random random("frenet");
  for (int repeat = 0; repeat < 50; ++repeat) {
    const auto path = random_path<SpatialPath<4>>(random, 2);
    const double xi = path.xi_begin() + random.unit() * (path.xi_end() - path.xi_begin());
    const auto state = frenet(path, xi);
    ASSERT_TRUE(state);
    const auto r = path.position_derivatives<3>(xi);
    const auto b = cross(r[1], r[2]);
    const double speed = norm(r[1]), bend = norm(b);
    // The textbook formulas lose what the cross product cancels: that is the scale.
    const double loss = speed * norm(r[2]) / bend;
    constexpr double tolerance = 64;  // two products and their sums of n + 1 terms
    EXPECT_CLOSE(state->frame.e1, (1 / speed) * r[1], tolerance, 1.0);
    EXPECT_CLOSE(state->frame.e3, (1 / bend) * b, tolerance, loss);
    EXPECT_CLOSE(state->frame.e2, cross(state->frame.e3, state->frame.e1), tolerance, 1.0);
    EXPECT_CLOSE(state->curvature, bend / (speed * speed * speed), tolerance,
                 loss * state->curvature);
    EXPECT_CLOSE(state->torsion, dot(b, r[3]) / (bend * bend), tolerance,
                 loss * loss * norm(r[3]) / bend);
    EXPECT_CLOSE(rolled(euler_rodrigues_frame(path.preimage_jet<0>(xi)), state->roll), state->frame,
                 tolerance, 1.0);
    EXPECT_EQ(state->body_rate_per_arc_length(),
              (Vector3<double>{state->torsion, 0, state->curvature}));
    EXPECT_CLOSE(state->world_rate_per_arc_length(),
                 state->torsion * state->frame.e1 + state->curvature * state->frame.e3, 0.0, 1.0);
  }
}

TEST(Frenet, AStraightLineHasNone) {
  Random random("frenet line");
  for (int repeat = 0; repeat < 200; ++repeat) {
    // One direction, any positive speed, turned so that every coefficient is rounded.
    const auto direction = random.rotation();
    BernsteinPolynomial<Quaternion<double>, 6> a;
    for (std::size_t i = 0; i <= 6; ++i) a[i] = random.uniform(0.5, 2.0) * direction;
    const double h =
        std::ldexp(random.uniform(1.0, 2.0), static_cast<int>(random.integer(-20, 20)));
    const auto path =
        SpatialPath<6>::create({0.0, h}, {{random.vector3(1.0), a, h}}, false).value();
    for (const double u : {0.0, 0.1, 0.5, 0.77, 1.0}) {
      EXPECT_FALSE(frenet(path, u * h));
      EXPECT_FALSE(frenet(moved(path, random.rotation(), {}).value(), u * h));
    }
  }
}

TEST(Frenet, AnInflectionAndAStandstillHaveNone) {
  // w = 1 + i u² in the plane z = 0: the curvature vanishes at u = 0 and nowhere else.
  const BernsteinPolynomial<Complex<double>, 2> w({Complex<double>{1, 0}, {1, 0}, {1, 1}});
  const auto bent =
      lifted(PlanarPath<2>::create({0.0, 1.0}, {{{}, w, 1.0}}, false).value()).value();
  EXPECT_FALSE(frenet(bent, 0.0));
  EXPECT_TRUE(frenet(bent, std::ldexp(1.0, -40)));
  EXPECT_EQ(frenet(bent, 0.5)->frame.e3, (Vector3<double>{0, 0, 1}));
  EXPECT_EQ(frenet(bent, 0.5)->torsion, 0.0);

  const BernsteinPolynomial<Complex<double>, 1> v({Complex<double>{}, {1, 1}});
  const auto from_rest =
      lifted(PlanarPath<1>::create({0.0, 1.0}, {{{}, v, 1.0}}, false).value()).value();
  EXPECT_FALSE(frenet(from_rest, 0.0));
}

TEST(Frenet, ALittleCurvatureIsStillFound) {
  // An arc of radius about 1e6 and length 1 bends by far more than rounding.
  const double slope = std::ldexp(1.0, -21);
  const BernsteinPolynomial<Complex<double>, 1> w({Complex<double>{1, 0}, {1, slope}});
  const auto arc = lifted(PlanarPath<1>::create({0.0, 1.0}, {{{}, w, 1.0}}, false).value()).value();
  ASSERT_TRUE(frenet(arc, 0.5));
  EXPECT_CLOSE(frenet(arc, 0.5)->curvature, 2 * slope, 8.0, 1.0);
}

}  // namespace
}  // namespace hodograph
