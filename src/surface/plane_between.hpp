// SPDX-License-Identifier: MIT
// A plane that keeps the convex hulls of two sets of points apart.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "hodograph/algebra/vector.hpp"

namespace hodograph::surface_detail {

/// Whether a plane across `direction`, of any length, has all points of `a` on one side and all of
/// `b` on the other, where every coordinate may be wrong by `off`. False for no direction.
inline bool plane_between(const std::vector<Vector3<double>>& a,
                          const std::vector<Vector3<double>>& b, const Vector3<double>& direction,
                          double off) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double length = largest_component(direction);
  if (!(length > 0.0) || !std::isfinite(1.0 / length)) return false;
  const Vector3<double> d = (1.0 / length) * direction;
  struct Span {
    double low = infinity, high = -infinity;
  };
  const auto span_of = [&d](const std::vector<Vector3<double>>& points) {
    Span span;
    for (const auto& p : points) {
      const double at = dot(p, d);
      span.low = std::min(span.low, at);
      span.high = std::max(span.high, at);
    }
    return span;
  };
  const Span first = span_of(a), second = span_of(b);
  constexpr double components = 4.0;  // three, and the rounding of their sum
  const double gap = components * norm(d) * off;
  return first.high + gap < second.low || second.high + gap < first.low;
}

}  // namespace hodograph::surface_detail
