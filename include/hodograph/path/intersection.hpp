// SPDX-License-Identifier: MIT
// A place where two planar paths, or a path and a line, meet.
#pragma once

#include "hodograph/algebra/vector.hpp"
#include "hodograph/foundation/enclosure.hpp"

namespace hodograph {

enum class IntersectionKind {
  crossing,   ///< exactly one common point, tangents not parallel
  undecided,  ///< within rounding, anything
};

/// Where two paths meet.
struct PathIntersection {
  double xi_first = 0.0, xi_second = 0.0;     ///< on the first and on the second path
  Enclosure xi_first_range, xi_second_range;  ///< contain the true parameters
  Vector2<double> point{};                    ///< of the first path at xi_first
  IntersectionKind kind = IntersectionKind::undecided;
};

/// Where a path meets the line q + t d.
struct LineIntersection {
  double xi = 0.0;
  Enclosure xi_range;  ///< contains the true parameter
  Enclosure t;         ///< contains the true place on the line
  Vector2<double> point{};
  IntersectionKind kind = IntersectionKind::undecided;
};

}  // namespace hodograph
