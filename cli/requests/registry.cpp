// SPDX-License-Identifier: MIT
// The one table of requests.
#include <array>

#include "cli/requests/handlers.hpp"

namespace hodograph::cli {

std::span<const RequestKind> request_kinds() {
  static constexpr std::array kinds = {
      RequestKind{"hermite", "one curve from positions and derivatives at its ends",
                  answer_hermite},
      RequestKind{"hermite_path", "a path through points with their derivatives",
                  answer_hermite_path},
      RequestKind{"fit", "a path within a tolerance of a formula, samples or an orbit", answer_fit},
      RequestKind{"orbit", "a periodic orbit, corrected", answer_orbit},
      RequestKind{"evaluate", "everything at given points of a path", answer_evaluate},
      RequestKind{"sample", "points along a path", answer_sample},
      RequestKind{"nearest", "the points of a path that are nearest to a point", answer_nearest},
      RequestKind{"inspect", "lengths, bounds, continuity and holonomy of a path", answer_inspect},
      RequestKind{"operate", "a path reversed, cut, joined, moved, scaled, ...", answer_operate},
  };
  return kinds;
}

}  // namespace hodograph::cli
