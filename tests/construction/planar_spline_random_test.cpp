// SPDX-License-Identifier: MIT
// Planar C² splines through hostile points: every one C² with a residual of rounding, or a refusal
// that the points justify.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "tests/support/planar_spline_campaign.hpp"

namespace hodograph::test {
namespace {

TEST(PlanarSplineRandom, HostilePointsAreInterpolatedOrRefusedWithReason) {
  Random random("planar spline hostile points");
  const auto campaign = run_spline_campaign(
      random, cases(2200), [](const std::string& complaint) { ADD_FAILURE() << complaint; });
  print_spline_campaign(campaign);
}

TEST(PlanarSplineRandom, NewtonTakesAtMostTwelveStepsOnRandomPoints) {
  Random random("planar spline steps");
  PlanarSplineOptions options;
  options.most_alternatives = 0;
  for (const std::size_t count : {10, 100, 1000, 10000, 100000}) {
    for (std::size_t repeat = 0; repeat < (count > 5000 ? 2U : 20U); ++repeat) {
      options.closed = repeat % 2 == 1;
      const auto walk = planar_spline_preimage(points_of_kind(random, 0, count), options).value();
      EXPECT_LE(walk.report.newton_steps, 12U);  // the closing chord may be long
      const auto wild = planar_spline_preimage(points_of_kind(random, 2, count), options).value();
      EXPECT_LE(wild.report.newton_steps, 12U);
      EXPECT_FALSE(wild.report.continued);
    }
  }
}

TEST(PlanarSplineRandom, AnyNumbersGiveAPathOrAFault) {
  Random random("planar spline hostile numbers");
  std::map<std::string, int> faults;
  for (int repeat = 0; repeat < cases(4000); ++repeat) {
    Points points = random_walk(random, 2 + random.index(10), 1.0);
    const double share = random.unit();
    for (auto& q : points) {
      if (random.chance(share)) q = {random.hostile(), random.hostile()};
    }
    PlanarSplineOptions options;
    options.closed = random.chance(0.5);
    options.repeated = RepeatedPoints::merge;
    if (random.chance(0.5)) options.parameters = SplineParameters::chord_length;
    const auto made = planar_spline(points, options);
    if (made) {
      EXPECT_TRUE(std::isfinite(made->path.arc_length()));
      EXPECT_LE(made->report.residual, 2048 * epsilon<double>());
    } else {
      ++faults[std::string(name_of(made.fault().code))];
      EXPECT_FALSE(made.fault().sentence.empty());
    }
  }
  for (const auto& [name, count] : faults) std::printf("%s: %d\n", name.c_str(), count);
}

}  // namespace
}  // namespace hodograph::test
