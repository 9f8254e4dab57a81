// SPDX-License-Identifier: MIT
// How long does one ascent from the Moon take to solve from cold?
#include <cstdio>
#include <string>
#include <vector>

#include "support/measure.hpp"
#if defined(HODOGRAPH_HAS_CONTROL)
#include "hodograph/control/powered_ascent.hpp"
#include "hodograph/control/tracking_ascent.hpp"

namespace {

using namespace hodograph;

void solutions(const AscentReference& reference) {
  constexpr int repetitions = 5;
  const auto starts = ascent_starts();
  std::vector<bench::Rival> tracking, energy, time;
  for (const AscentStart& start : starts) {
    tracking.push_back({"(25) as published, from " + start.name,
                        [&reference, start] {
                          TrackingOptions options;
                          options.solving.guesses = 1;
                          bench::keep(tracking_ascent(reference, start, options));
                        },
                        1.0});
    for (const auto objective : {PoweredObjective::least_energy, PoweredObjective::least_time}) {
      const bool least_time = objective == PoweredObjective::least_time;
      (least_time ? time : energy)
          .push_back({std::string("with gravity, least ") + (least_time ? "time" : "energy") +
                          ", from " + start.name,
                      [&reference, start, objective] {
                        PoweredOptions options;
                        options.objective = objective;
                        options.solving.guesses = 1;
                        bench::keep(powered_ascent(reference, start, options));
                      },
                      1.0});
    }
  }
  bench::compare("one solution from cold, first guess", tracking, repetitions);
  bench::compare("one solution from cold, first guess", energy, repetitions);
  bench::compare("one solution from cold, first guess", time, repetitions);
}

}  // namespace

int main() {
  const AscentReference reference = AscentReference::gateway().value();
  solutions(reference);
}
#else
int main() { std::puts("built without the component control"); }
#endif
