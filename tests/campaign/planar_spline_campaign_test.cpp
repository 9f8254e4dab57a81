// SPDX-License-Identifier: MIT
// A hundred thousand sets of hostile points: every planar spline C² with a residual of rounding, or
// refused with reason.
#include <gtest/gtest.h>

#include "tests/support/planar_spline_campaign.hpp"

namespace hodograph::test {
namespace {

TEST(PlanarSplineCampaign, AHundredThousandSets) {
  Random random("planar spline campaign");
  const auto campaign = run_spline_campaign(
      random, 100000, [](const std::string& complaint) { ADD_FAILURE() << complaint; });
  print_spline_campaign(campaign);
}

}  // namespace
}  // namespace hodograph::test
