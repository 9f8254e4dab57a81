// SPDX-License-Identifier: MIT
// What is wrong with the two points between which a construction is asked for.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/foundation/fault.hpp"

namespace hodograph::planar_detail {

/// What a refusal names is tried: the bound itself, or that much more of it where rounding, or a
/// shape that takes room, is in the way of less.
inline constexpr double tried_excesses[] = {0.0, 0x1.0p-40, 0x1.0p-30, 0x1.0p-20, 0x1.0p-10};

/// Of points with a `position` and a `direction`, in the plane or in space. Faults: not_finite,
/// outside_domain (a direction of zero), with the point's index.
template <class Point>
std::optional<Fault> directed_points_fault(const Point& begin, const Point& end) {
  const Point* points[] = {&begin, &end};
  for (std::size_t i = 0; i < 2; ++i) {
    const bool place = is_finite(points[i]->position);
    const char* what = place ? "direction" : "position";
    if (!place || !is_finite(points[i]->direction)) {
      return Fault{FaultCode::not_finite,
                   std::string("the ") + what + " of point " + std::to_string(i) + " is not finite",
                   i,
                   what,
                   std::nullopt,
                   std::nullopt};
    }
    if (largest_component(points[i]->direction) == 0.0) {
      return Fault{FaultCode::outside_domain,
                   "the direction of point " + std::to_string(i) +
                       " is zero; give it a vector with a length",
                   i,
                   what,
                   0.0,
                   std::nullopt};
    }
  }
  return std::nullopt;
}

/// Of points with a `position` in space whose place over ground is checked elsewhere. Faults:
/// not_finite, with the point's index.
template <class Point>
std::optional<Fault> altitude_fault(const Point& begin, const Point& end) {
  const Point* points[] = {&begin, &end};
  for (std::size_t i = 0; i < 2; ++i) {
    if (std::isfinite(points[i]->position.z)) continue;
    return Fault{FaultCode::not_finite,
                 "the altitude of point " + std::to_string(i) + " is not finite",
                 i,
                 "position",
                 std::nullopt,
                 std::nullopt};
  }
  return std::nullopt;
}

}  // namespace hodograph::planar_detail
