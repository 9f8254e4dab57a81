// SPDX-License-Identifier: MIT
// A hundred thousand climb requests, nearly degenerate ones among them: none gives a NaN, each is
// met or refused for a true reason.
#include "tests/support/climb_campaign.hpp"

namespace hodograph::test {
namespace {

TEST(ClimbCampaign, AHundredThousandRequests) {
  Random random("climb campaign");
  const ClimbCampaign campaign = run_climb_campaign(
      random, 100000, [](const std::string& complaint) { ADD_FAILURE() << complaint; });
  print_climb_campaign(campaign);
}

}  // namespace
}  // namespace hodograph::test
