// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "hodograph/control/reference_path.hpp"
#include "hodograph/path/bounds.hpp"

namespace hodograph {

OffsetLimits offset_limits(const AnyPath& path) {
  // An offset limit is known to this share of itself.
  constexpr double share = 0x1p-30;
  const RangeGoal goal{share};
  const Extremes curvature =
      path.visit([&goal](const auto& known) { return curvature_extremes(known, goal); });
  const auto limit = [](double bend) {
    if (!(bend > 0.0)) return std::numeric_limits<double>::infinity();
    return std::nextafter(1.0 / bend, 0.0);
  };
  const double up = curvature.maximum.upper(), down = -curvature.minimum.lower();
  const bool planar = path.dimension() == 2;
  return {limit(up), planar ? limit(down) : limit(up), curvature.minimum, curvature.maximum};
}

}  // namespace hodograph
