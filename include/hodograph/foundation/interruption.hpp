// SPDX-License-Identifier: MIT
// Stopping from outside what takes long: the caller says for a scope what is to be asked, and the
// work asks.
#pragma once

#include <functional>

namespace hodograph {

/// While it lives, work of this thread that can be stopped calls wanted() now and then, and gives
/// up where it returns true: it throws Error with the code `cancelled`. What was to be made is not
/// made, and nothing else is changed. Scopes nest; the innermost is asked. Not to be moved to
/// another thread. Domain: wanted() does not throw, and once it is true it stays true.
/// Searches of planning, swarms, surfaces and exact solutions ask, at most some milliseconds of
/// work apart; most other functions are done sooner.
class InterruptionScope {
 public:
  explicit InterruptionScope(std::function<bool()> wanted);
  ~InterruptionScope();
  InterruptionScope(const InterruptionScope&) = delete;
  InterruptionScope& operator=(const InterruptionScope&) = delete;

 private:
  friend bool interruption_wanted();
  std::function<bool()> wanted_;
  InterruptionScope* outer_;
};

/// Whether the innermost scope of this thread wants the work stopped; false without one. Some
/// nanoseconds, and the time of wanted().
bool interruption_wanted();
/// Throws Error (cancelled) where it does.
void check_interruption();

}  // namespace hodograph
