// SPDX-License-Identifier: MIT
// The first 20 000 sets of the campaign in tests/campaign/.
#include <gtest/gtest.h>

#include "tests/support/hermite_campaign.hpp"

namespace hodograph::test {
namespace {

TEST(HermiteRandom, EverySetIsMetOrRightlyRefused) {
  Random random("hermite campaign");
  const auto counts = run_campaign(
      random, cases(20000), [](const std::string& complaint) { ADD_FAILURE() << complaint; });
  // The harmless kinds are all accepted by the default.
  for (const DataKind kind : {DataKind::tame, DataKind::scaled}) {
    const CampaignCount& count = counts[static_cast<std::size_t>(kind)];
    EXPECT_GE(count.accepted, count.sets * 9 / 10) << name_of(kind);
  }
  if (::testing::Test::HasFailure()) print_campaign(counts);
}

TEST(HermiteRandom, PathsMeetHostileDataOrRefuseThem) {
  Random random("hostile hermite paths");
  std::size_t accepted = 0;
  for (int repeat = 0; repeat < cases(3000); ++repeat) {
    std::vector<double> knots;
    std::vector<HermitePoint<4>> points;
    const RandomCurve curve(random);
    for (int k = 0; k <= 10; ++k) {
      knots.push_back(0.25 * k);
      points.push_back(derivatives_of<4, double>(curve, knots.back()));
    }
    if (random.chance(0.8))
      points[random.index(11)][random.index(5)][random.index(3)] = random.hostile();
    for (const HermiteChoice choice : {HermiteChoice::order_ten, HermiteChoice::order_six}) {
      const auto path =
          hermite_path<4, double>(knots, std::span<const HermitePoint<4>>(points), choice);
      if (!path) {
        EXPECT_TRUE(is_no_solution(path.fault().code) || path.fault().code == FaultCode::zero_speed)
            << path.fault().sentence;
        continue;
      }
      ++accepted;
      for (std::size_t k = 0; k < path->segment_count(); ++k) {
        Verdict verdict;
        const HermiteSet<4> set{points[k], points[k + 1], knots[k + 1] - knots[k]};
        judge_accepted<4>(set, path->segment(k), verdict);
        EXPECT_EQ(verdict.complaint, "") << "segment " << k << ": " << text_of<4>(set);
      }
    }
  }
  EXPECT_GE(accepted, cases(1200U));
}

}  // namespace
}  // namespace hodograph::test
