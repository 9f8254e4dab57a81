// SPDX-License-Identifier: MIT
// The powered ascent in the orbit's own coordinates finds what it finds in rectangular ones.
#include "hodograph/control/framed_ascent.hpp"

#include <gtest/gtest.h>

namespace hodograph {
namespace {

TEST(FramedAscent, FindsTheSameMinimumInNoMoreIterations) {
  const AscentReference reference = AscentReference::gateway().value();
  const AscentStart start = ascent_start("+y").value();
  PoweredOptions options;
  options.solving.guesses = 1;
  const PoweredAscent rectangular = powered_ascent(reference, start, options).value();
  const PoweredAscent framed = powered_ascent_along_path(reference, start, options).value();
  // Both have their own errors of the Runge-Kutta steps, of some 1e-6 of the objective.
  constexpr double steps = 1e-5;  // not a tolerance of ours: ten times that error
  EXPECT_NEAR(framed.solved.objective, rectangular.solved.objective,
              steps * rectangular.solved.objective);
  EXPECT_LE(framed.solved.iterations, rectangular.solved.iterations);
  EXPECT_LE(framed.solved.constraint_error, default_constraint_tolerance);
  // Followed again, it is as near the orbit, and above the surface.
  EXPECT_LE(framed.again.orbit_error_km, 0.01);
  EXPECT_LE(framed.again.orbit_velocity_error_m_s, 0.01);
  EXPECT_GE(framed.again.lowest_height_km, -0.001);
  EXPECT_EQ(framed.position.size(), options.intervals + 1);
}

TEST(FramedAscent, RefusesWhatThePoweredAscentRefuses) {
  const AscentReference reference = AscentReference::gateway().value();
  PoweredOptions options;
  options.thrust_limit_m_s2 = -1.0;
  EXPECT_EQ(powered_ascent_along_path(reference, ascent_starts()[0], options).fault().code,
            FaultCode::outside_domain);
}

}  // namespace
}  // namespace hodograph
