// SPDX-License-Identifier: MIT
// The ascent from all six starts, in rectangular coordinates and in the orbit's own: the same
// minima, and at most as many iterations in at least five of six.
#include "hodograph/control/framed_ascent.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace hodograph {
namespace {

TEST(FramedAscentCampaign, TheOrbitsCoordinatesFindTheSameMinimaFromAllStarts) {
  const AscentReference reference = AscentReference::gateway().value();
  constexpr double steps = 1e-5;  // not a tolerance of ours: ten times the steps' own error
  std::size_t no_slower = 0;
  for (const AscentStart& start : ascent_starts()) {
    for (const auto objective : {PoweredObjective::least_energy, PoweredObjective::least_time}) {
      PoweredOptions options;
      options.objective = objective;
      const PoweredAscent rectangular = powered_ascent(reference, start, options).value();
      const PoweredAscent framed = powered_ascent_along_path(reference, start, options).value();
      EXPECT_LE(framed.solved.objective, (1.0 + steps) * rectangular.solved.objective)
          << start.name;
      EXPECT_LE(framed.again.orbit_error_km, 0.01) << start.name;
      EXPECT_LE(framed.again.orbit_velocity_error_m_s, 0.01) << start.name;
      if (objective == PoweredObjective::least_energy) {
        no_slower += framed.solved.iterations <= rectangular.solved.iterations ? 1 : 0;
      }
    }
  }
  EXPECT_GE(no_slower, 5u);
}

}  // namespace
}  // namespace hodograph
