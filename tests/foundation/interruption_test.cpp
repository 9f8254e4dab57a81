// SPDX-License-Identifier: MIT
// Work that is stopped from outside: who is asked, what is thrown, and that searches ask.
#include "hodograph/foundation/interruption.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "hodograph/foundation/fault.hpp"

namespace hodograph {
namespace {

TEST(Interruption, WithoutAScopeNothingIsStopped) {
  EXPECT_FALSE(interruption_wanted());
  EXPECT_NO_THROW(check_interruption());
}

TEST(Interruption, TheInnermostScopeIsAsked) {
  int outer_asked = 0;
  const InterruptionScope outer([&] { return ++outer_asked > 0; });
  {
    const InterruptionScope inner([] { return false; });
    EXPECT_FALSE(interruption_wanted());
    EXPECT_EQ(outer_asked, 0);
  }
  EXPECT_TRUE(interruption_wanted());
  EXPECT_EQ(outer_asked, 1);
}

TEST(Interruption, StoppingThrowsCancelled) {
  const InterruptionScope scope([] { return true; });
  try {
    check_interruption();
    FAIL() << "it went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.fault().code, FaultCode::cancelled);
    EXPECT_FALSE(error.fault().sentence.empty());
  }
}

TEST(Interruption, AScopeIsThatOfItsThread) {
  const InterruptionScope scope([] { return true; });
  bool wanted_elsewhere = true;
  std::thread([&] { wanted_elsewhere = interruption_wanted(); }).join();
  EXPECT_FALSE(wanted_elsewhere);
}

}  // namespace
}  // namespace hodograph
