// SPDX-License-Identifier: MIT
// The motion of a path whose type is known only when the program runs: every degree is compiled
// here, once.
#include "hodograph/path/any_path.hpp"
#include "hodograph/planning/swarm/timed_motion.hpp"

namespace hodograph {

Result<TimedMotion> TimedMotion::create(const AnyPath& path, TimingLaw law, Presence presence,
                                        double altitude) {
  return path.visit(
      [&](const auto& typed) { return create(typed, std::move(law), presence, altitude); });
}

}  // namespace hodograph
