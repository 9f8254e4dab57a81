// SPDX-License-Identifier: MIT
// The legs of corners keep their bounds and lines, and no other choice does better.
#include "hodograph/planning/corner_sizes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hodograph/foundation/accuracy.hpp"
#include "tests/support/random.hpp"

namespace hodograph {
namespace {

using test::Random;

struct Chain {
  std::vector<double> lines;
  std::vector<CornerRoom> corners;
};

/// A chain that has a solution: the lines are at least as long as the least legs need.
Chain random_chain(Random& random, std::size_t count) {
  Chain chain;
  for (std::size_t k = 0; k < count; ++k) {
    CornerRoom c;
    c.least = random.uniform(0.0, 1.0);
    c.most = c.least + random.uniform(0.0, 3.0);
    c.saving = random.uniform(0.0, 1.0);
    c.peak_curvature = random.uniform(0.0, 2.0);
    chain.corners.push_back(c);
  }
  for (std::size_t k = 0; k <= count; ++k) {
    const double needed =
        (k > 0 ? chain.corners[k - 1].least : 0.0) + (k < count ? chain.corners[k].least : 0.0);
    chain.lines.push_back(needed + random.uniform(0.0, 3.0));
  }
  return chain;
}

void expect_fits(const Chain& chain, const std::vector<double>& legs) {
  ASSERT_EQ(legs.size(), chain.corners.size());
  for (std::size_t k = 0; k < legs.size(); ++k) {
    EXPECT_GE(legs[k], chain.corners[k].least);
    EXPECT_LE(legs[k], chain.corners[k].most);
  }
  for (std::size_t k = 0; k < chain.lines.size(); ++k) {
    const double used = (k > 0 ? legs[k - 1] : 0.0) + (k < legs.size() ? legs[k] : 0.0);
    EXPECT_LE(used, chain.lines[k] * (1.0 + 2.0 * epsilon<double>()));
  }
}

double saving(const Chain& chain, const std::vector<double>& legs) {
  double sum = 0.0;
  for (std::size_t k = 0; k < legs.size(); ++k) sum += chain.corners[k].saving * legs[k];
  return sum;
}
double peak(const Chain& chain, const std::vector<double>& legs) {
  double most = 0.0;
  for (std::size_t k = 0; k < legs.size(); ++k) {
    most = std::max(most, chain.corners[k].peak_curvature / legs[k]);
  }
  return most;
}

/// Legs that fit, drawn in a random order of corners.
std::vector<double> random_legs(Random& random, const Chain& chain) {
  std::vector<double> legs;
  for (const CornerRoom& c : chain.corners) legs.push_back(c.least);
  for (std::size_t round = 0; round < 3 * legs.size(); ++round) {
    const auto k = random.index(legs.size());
    const double before = chain.lines[k] - (k > 0 ? legs[k - 1] : 0.0);
    const double after = chain.lines[k + 1] - (k + 1 < legs.size() ? legs[k + 1] : 0.0);
    const double most = std::min({chain.corners[k].most, before, after});
    const double t = random.uniform(0.0, 1.25);  // often all there is
    legs[k] = std::max(chain.corners[k].least,
                       chain.corners[k].least + std::min(1.0, t) * (most - chain.corners[k].least));
  }
  return legs;
}

TEST(CornerSizes, NoOtherChoiceDoesBetter) {
  Random random("corner sizes");
  for (int round = 0; round < 300; ++round) {
    const Chain chain = random_chain(random, 1 + static_cast<std::size_t>(round) % 8);
    const auto of = [&](CornerAim aim) {
      const auto legs = corner_sizes(chain.lines, chain.corners, aim);
      EXPECT_TRUE(legs) << legs.fault().sentence;
      expect_fits(chain, *legs);
      return *legs;
    };
    const auto smallest = of(CornerAim::smallest), shortest = of(CornerAim::least_length);
    const auto gentlest = of(CornerAim::least_peak_curvature), largest = of(CornerAim::largest);
    for (std::size_t k = 0; k < smallest.size(); ++k) {
      EXPECT_EQ(smallest[k], chain.corners[k].least);
      EXPECT_GE(largest[k], smallest[k]);
    }
    // Every corner of `largest` is stopped by something.
    for (std::size_t k = 0; k < largest.size(); ++k) {
      const double before = chain.lines[k] - largest[k] - (k > 0 ? largest[k - 1] : 0.0);
      const double after =
          chain.lines[k + 1] - largest[k] - (k + 1 < largest.size() ? largest[k + 1] : 0.0);
      const double left = std::min({chain.corners[k].most - largest[k], before, after});
      EXPECT_LE(left, 32.0 * epsilon<double>() * (chain.lines[k] + chain.lines[k + 1]));
    }
    for (int other = 0; other < 60; ++other) {
      const auto legs = random_legs(random, chain);
      expect_fits(chain, legs);
      EXPECT_LE(saving(chain, legs), saving(chain, shortest) * (1.0 + 64.0 * epsilon<double>()));
      EXPECT_GE(peak(chain, legs), peak(chain, gentlest) * (1.0 - 64.0 * epsilon<double>()));
    }
  }
}

TEST(CornerSizes, TheRoomOfOneLineGoesToTheCornerThatSavesMore) {
  const std::vector<double> lines{10.0, 3.0, 10.0};
  const std::vector<CornerRoom> corners{{0.5, 5.0, 0.2, 1.0}, {0.5, 5.0, 0.3, 1.0}};
  const auto legs = corner_sizes(lines, corners, CornerAim::least_length);
  ASSERT_TRUE(legs);
  EXPECT_EQ((*legs)[0], 0.5);
  EXPECT_EQ((*legs)[1], 2.5);
  const auto gentle = corner_sizes(lines, corners, CornerAim::least_peak_curvature);
  ASSERT_TRUE(gentle);
  EXPECT_EQ((*gentle)[0], 1.5);
  EXPECT_EQ((*gentle)[1], 1.5);
}

TEST(CornerSizes, RefusesWithTheNumbers) {
  const std::vector<CornerRoom> corners{{1.0, 2.0, 0.0, 0.0}, {1.5, 2.0, 0.0, 0.0}};
  const auto crowded = corner_sizes(std::vector<double>{9.0, 2.0, 9.0}, corners, {});
  ASSERT_FALSE(crowded);
  EXPECT_EQ(crowded.fault().code, FaultCode::no_interpolant);
  EXPECT_EQ(crowded.fault().index, 1U);
  EXPECT_EQ(crowded.fault().value, 2.5);
  EXPECT_EQ(crowded.fault().bound, 2.0);
  const auto torn = corner_sizes(std::vector<double>{9.0, 9.0}, corners, {});
  ASSERT_FALSE(torn);
  EXPECT_EQ(torn.fault().code, FaultCode::mismatched_size);
  const auto nan = corner_sizes(
      std::vector<double>{9.0, std::numeric_limits<double>::quiet_NaN(), 9.0}, corners, {});
  ASSERT_FALSE(nan);
  EXPECT_EQ(nan.fault().code, FaultCode::outside_domain);
  const std::vector<CornerRoom> none{{2.0, 1.0, 0.0, 0.0}};
  const auto empty = corner_sizes(std::vector<double>{9.0, 9.0}, none, {});
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.fault().index, 0U);
  // No corner at all.
  const auto straight = corner_sizes(std::vector<double>{9.0}, {}, CornerAim::largest);
  ASSERT_TRUE(straight);
  EXPECT_TRUE(straight->empty());
}

}  // namespace
}  // namespace hodograph
