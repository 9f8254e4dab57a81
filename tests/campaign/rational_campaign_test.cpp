// SPDX-License-Identifier: MIT
// Two thousand spaces of rational PH curves, generic and special, by the
// residue system and by systems (6), (7) and (8): the same dimension, and every
// element solves all of them.
#include <gtest/gtest.h>

#include "support/rational_systems.hpp"

namespace hodograph {
namespace {

using test::Random;

TEST(RationalCampaign, AllSystemsAgreeOnRandomInput) {
  Random random("rational campaign");
  test::compare_systems_on_random_input(random, 1000);
}

TEST(RationalCampaign, AllSystemsAgreeOnSpecialInput) {
  Random random("special rational campaign");
  test::compare_systems_on_special_input(random, 1000);
}

}  // namespace
}  // namespace hodograph
