// SPDX-License-Identifier: MIT
// A million random and hostile Hermite data sets: no NaN, every refusal justified, every accepted
// curve meets its data.
#include <gtest/gtest.h>

#include "tests/support/hermite_campaign.hpp"

namespace hodograph::test {
namespace {

TEST(HermiteCampaign, AMillionSets) {
  Random random("hermite campaign");
  const auto counts = run_campaign(
      random, 1000000, [](const std::string& complaint) { ADD_FAILURE() << complaint; });
  print_campaign(counts);
}

}  // namespace
}  // namespace hodograph::test
