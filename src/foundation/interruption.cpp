// SPDX-License-Identifier: MIT
#include "hodograph/foundation/interruption.hpp"

#include <utility>

#include "hodograph/foundation/fault.hpp"

namespace hodograph {
namespace {

thread_local InterruptionScope* innermost = nullptr;

}  // namespace

InterruptionScope::InterruptionScope(std::function<bool()> wanted)
    : wanted_(std::move(wanted)), outer_(innermost) {
  innermost = this;
}

InterruptionScope::~InterruptionScope() { innermost = outer_; }

bool interruption_wanted() { return innermost != nullptr && innermost->wanted_(); }

void check_interruption() {
  if (!interruption_wanted()) return;
  throw Error(Fault{FaultCode::cancelled, "the work was stopped on request", std::nullopt, "",
                    std::nullopt, std::nullopt});
}

}  // namespace hodograph
