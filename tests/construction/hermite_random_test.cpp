// SPDX-License-Identifier: MIT
// The first 20 000 sets of the campaign in tests/campaign/.
#include <gtest/gtest.h>

#include "tests/support/hermite_campaign.hpp"

namespace hodograph::test {
namespace {

TEST(HermiteRandom, EverySetIsMetOrRightlyRefused) {
  Random random("hermite campaign");
  const auto counts =
      run_campaign(random, 20000, [](const std::string& complaint) { ADD_FAILURE() << complaint; });
  // The harmless kinds are all accepted by the default.
  for (const DataKind kind : {DataKind::tame, DataKind::scaled}) {
    const CampaignCount& count = counts[static_cast<std::size_t>(kind)];
    EXPECT_GE(count.accepted, count.sets * 9 / 10) << name_of(kind);
  }
  if (::testing::Test::HasFailure()) print_campaign(counts);
}

}  // namespace
}  // namespace hodograph::test
