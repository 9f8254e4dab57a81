// SPDX-License-Identifier: MIT
// What can be wrong with the knots of a path, before there is one.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "hodograph/foundation/fault.hpp"
#include "hodograph/foundation/scalar.hpp"

namespace hodograph::path_detail {

inline Fault fault_at(FaultCode code, std::size_t index, const char* quantity, double value,
                      std::string sentence) {
  return {code, std::move(sentence), index, quantity, value, std::nullopt};
}

/// The first knot that is not finite (not_finite), not above the one before it (not_increasing), or
/// farther from it than a number can hold (not_finite); nothing where all serve.
template <class S>
std::optional<Fault> knots_fault(std::span<const S> knots) {
  for (std::size_t k = 0; k < knots.size(); ++k) {
    const double knot = to_double(knots[k]);
    if (!is_finite(knots[k])) {
      return fault_at(FaultCode::not_finite, k, "knot", knot,
                      "knot " + std::to_string(k) + " is not a finite number");
    }
    if (k == 0) continue;
    const double before = to_double(knots[k - 1]);
    if (!(knots[k - 1] < knots[k])) {
      return fault_at(FaultCode::not_increasing, k, "knot", knot,
                      "knots must increase strictly; knot " + std::to_string(k) + " is " +
                          to_text(knot) + " after " + to_text(before));
    }
    if (!is_finite(S(knots[k] - knots[k - 1]))) {
      return fault_at(FaultCode::not_finite, k, "knot", knot,
                      "the step from knot " + to_text(before) + " to " + to_text(knot) +
                          " exceeds the range of numbers");
    }
  }
  return std::nullopt;
}

}  // namespace hodograph::path_detail
