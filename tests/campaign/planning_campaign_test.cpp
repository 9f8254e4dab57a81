// SPDX-License-Identifier: MIT
// A thousand random worlds of each kind, degenerate ones among them: shortest polylines equal to
// the full visibility graph's, and no plan that breaks its limits at dense samples.
#include <gtest/gtest.h>

#include "tests/support/plan_judge.hpp"
#include "tests/support/polyline_judge.hpp"

namespace hodograph::test {
namespace {

TEST(PlanningCampaign, PolylinesAreShortestInAThousandGenericWorlds) {
  compare_with_graph("campaign of generic worlds", 2000.0, 8, 1000);
}
TEST(PlanningCampaign, PolylinesAreShortestInAThousandDegenerateWorlds) {
  compare_with_graph("campaign of coarse lattices", 12.0, 9, 1000);
  compare_with_graph("campaign of very coarse lattices", 6.0, 6, 1000);
}
TEST(PlanningCampaign, PlansKeepTheirLimitsInAThousandWorlds) {
  plan_in_degenerate_worlds("campaign of plans", 1000);
}

}  // namespace
}  // namespace hodograph::test
