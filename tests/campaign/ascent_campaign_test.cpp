// SPDX-License-Identifier: MIT
// Both ascents from all six starts; the suite solves some of them.
#include <gtest/gtest.h>

#include "support/ascent_judge.hpp"

namespace hodograph {
namespace {

class AscentCampaign : public ::testing::TestWithParam<std::size_t> {};

TEST_P(AscentCampaign, TracksTheOrbitAtTheKnownMinimum) {
  test::judge_tracking(GetParam(), AscentSolving{}.guesses);
}
TEST_P(AscentCampaign, FliesWithTheKnownLeastEnergy) {
  test::judge_least_energy(GetParam(), AscentSolving{}.guesses);
}
TEST_P(AscentCampaign, FliesInTheKnownLeastTime) {
  test::judge_least_time(GetParam(), AscentSolving{}.guesses);
}

INSTANTIATE_TEST_SUITE_P(Starts, AscentCampaign, ::testing::Range<std::size_t>(0, 6));

}  // namespace
}  // namespace hodograph
