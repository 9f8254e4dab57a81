// SPDX-License-Identifier: MIT
// What can be wrong with points that are to be joined at knots, before any is looked at, and with
// a parameter step.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "hodograph/foundation/fault.hpp"
#include "hodograph/foundation/scalar.hpp"
#include "hodograph/path/detail/knots_fault.hpp"

namespace hodograph::construction_detail {

/// outside_domain where h is no parameter step of a segment: not positive, or not finite.
template <class S>
std::optional<Fault> step_fault(const S& h, std::optional<std::size_t> segment = std::nullopt) {
  if (is_finite(h) && S(0) < h) return std::nullopt;
  return Fault{FaultCode::outside_domain,
               "the parameter step must be positive; got " + to_text(to_double(h)),
               segment,
               "parameter_step",
               to_double(h),
               0.0};
}

/// mismatched_size where there is not one of the numbers called `name` for every point.
inline std::optional<Fault> size_fault(std::size_t points, std::size_t numbers,
                                       const std::string& name) {
  if (numbers == points) return std::nullopt;
  return Fault{
      FaultCode::mismatched_size,
      std::to_string(points) + " points need as many " + name + "; got " + std::to_string(numbers),
      std::nullopt,
      name,
      static_cast<double>(numbers),
      static_cast<double>(points)};
}

/// too_few (less than two points), mismatched_size (not one knot a point), and those of
/// path_detail::knots_fault.
template <class S>
std::optional<Fault> points_on_knots_fault(std::size_t points, std::span<const S> knots) {
  if (points < 2) {
    return Fault{FaultCode::too_few,
                 "a path needs at least 2 points; got " + std::to_string(points),
                 std::nullopt,
                 "points",
                 static_cast<double>(points),
                 2.0};
  }
  if (auto fault = size_fault(points, knots.size(), "knots")) return fault;
  return path_detail::knots_fault(knots);
}

}  // namespace hodograph::construction_detail
