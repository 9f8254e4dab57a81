// SPDX-License-Identifier: MIT
// The quintics along a skeleton of arcs and lines.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "arc_skeleton.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph::turn_detail {

/// The longest piece of an arc for one quintic, and a bound of how much its curvature may exceed
/// the arc's: 1.04e-5 of it for a twelfth of a turn, falling with the fourth power of the angle
/// (tests/construction/turn_limited_test.cpp); the rest is for the rounding of short arcs. The
/// finer ones are for lengths just above the least.
struct ArcPieces {
  double longest, margin;
};
/// Above 1 + 1.04e-5 for a twelfth of a turn.
inline constexpr double coarse_margin = 1.0 + 0x1.0p-16;
/// Above 1 + 6.5e-7 for half of that.
inline constexpr double fine_margin = 1.0 + 0x1.0p-20;
inline constexpr ArcPieces coarse_pieces{turn / 12.0, coarse_margin};
inline constexpr ArcPieces fine_pieces{turn / 24.0, fine_margin};
using PlanPreimage = BernsteinPolynomial<Complex<double>, 2>;

/// Collects spans that follow one another; parameter steps so that |dr/dξ| = 1 at their ends.
class Spans {
 public:
  explicit Spans(const Vector2<double>& start) : at_(start) {}

  /// A span whose preimage is one for the parameter step 1.
  void add(PlanPreimage w) {
    const double speed = dot(w.front(), w.front());
    const double factor = 1.0 / std::sqrt(speed);
    const bool flip = !curves_.empty() && dot(curves_.back().preimage().back(), w.front()) < 0.0;
    w = w.mapped([&](const Complex<double>& c) { return (flip ? -factor : factor) * c; });
    const double knot = knots_.back() + speed;
    curves_.emplace_back(at_, w, knot - knots_.back());
    knots_.push_back(knot);
    at_ = curves_.back().end();
  }
  Result<PlanarPath<2>> path() && {
    return PlanarPath<2>::create(std::move(knots_), std::move(curves_), false);
  }

 private:
  Vector2<double> at_;
  std::vector<double> knots_{0.0};
  std::vector<PlanarPhCurve<2>> curves_;
};

/// The path along a skeleton; `unit` is the skeleton's unit of length. Faults: numbers out of
/// range.
Result<PlanarPath<2>> spans_along(const Skeleton& skeleton, const ArcPieces& pieces,
                                  const DirectedPoint& begin, double unit);

}  // namespace hodograph::turn_detail
