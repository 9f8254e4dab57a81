// SPDX-License-Identifier: MIT
// A point of a path where the distance to a given point is stationary.
#pragma once

#include "hodograph/foundation/enclosure.hpp"

namespace hodograph {

/// What the distance |r(ξ) - q| does at a stationary point, by the signs of (r - q)·r' on both
/// sides; at an end of an open path, by the sign on the one side there is.
enum class StationaryKind {
  minimum,    ///< it falls before and rises after
  maximum,    ///< it rises before and falls after
  undecided,  ///< within rounding, anything: a multiple zero, a stretch of equal distance, or
              ///< nothing
};

/// One stationary point. `xi` lies in `xi_range`, which contains the true parameter; on a stretch
/// of equal distance it is one parameter of the stretch.
template <class Point>
struct StationaryPoint {
  double xi = 0.0;
  Enclosure xi_range;
  Point point{};          ///< r(xi)
  double distance = 0.0;  ///< |r(xi) - q|, to evaluation accuracy
  StationaryKind kind = StationaryKind::undecided;
};

}  // namespace hodograph
