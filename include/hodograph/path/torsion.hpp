// SPDX-License-Identifier: MIT
// Rigorous bounds of the torsion of a path in space.
//
// The curve is the exact one of the stored numbers, as in path/bounds.hpp. With V = vec(A* A') the
// Frenet frame is the Euler-Rodrigues frame rolled by atan2(-V₂, V₃), so that
//   τ = N/(σ² B),  B = V₂² + V₃² = κ² σ⁴/4,  N = 2 V₁ B + σ (V₂ V₃' - V₃ V₂').
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "hodograph/path/bounds.hpp"
#include "hodograph/path/detail/turning_polynomial.hpp"

namespace hodograph {

namespace path_detail {

/// With V = n v: b = v₂² + v₃², 2 n v₁ b + σ (v₂ v₃' - v₃ v₂') and σ² b of one curve, or of a part
/// of one, in the units of EnclosedCurve with ' = d/du.
template <std::size_t n>
class TorsionParts {
 public:
  static constexpr std::size_t bend_degree = 4 * n - 4;
  static constexpr std::size_t numerator_degree = n > 1 ? 6 * n - 5 : 2;

  explicit TorsionParts(const EnclosedCurve<Quaternion<double>, n>& exact)
      : step_(exact.step()), unit_(power_of_two(-exact.exponent())) {
    const auto times = [](const Enclosure& a, const Enclosure& b) { return a * b; };
    const auto rate = turning_polynomial(exact.preimage());
    const auto v1 = rate.mapped([](const auto& v) { return v.x; });
    const auto v2 = rate.mapped([](const auto& v) { return v.y; });
    const auto v3 = rate.mapped([](const auto& v) { return v.z; });
    const auto speed = exact.speed();
    bend_ = symmetric_square(v2, times) + symmetric_square(v3, times);
    const auto turn = product(v2, v3.derivative(), times) - product(v3, v2.derivative(), times);
    numerator_ = (Enclosure(2.0 * static_cast<double>(n)) * product(v1, bend_, times))
                     .template elevated<numerator_degree>() +
                 product(speed, turn, times);
    denominator_ = product(symmetric_square(speed, times), bend_, times);
  }

  const BernsteinPolynomial<Enclosure, bend_degree>& bend() const { return bend_; }
  bool has_numerator() const {
    return std::any_of(numerator_.coefficients().begin(), numerator_.coefficients().end(),
                       [](const Enclosure& c) { return !c.is_zero(); });
  }
  BernsteinQuotient quotient() const {
    return BernsteinQuotient::of(numerator_, denominator_)
        .times(((Enclosure(1.0) / step_) * unit_) * unit_);
  }

 private:
  Enclosure step_, unit_;
  BernsteinPolynomial<Enclosure, bend_degree> bend_;
  BernsteinPolynomial<Enclosure, numerator_degree> numerator_;
  BernsteinPolynomial<Enclosure, 8 * n - 4> denominator_;
};

/// The parts of a path on each of which σ and B vary by a bounded factor; next to a zero of either
/// the division ends at a depth.
template <std::size_t n>
std::vector<SegmentPart> evenly_bent_parts(const SpatialPath<n>& path) {
  constexpr double most_variation = 65536.0;  // 16 bits
  constexpr double least_part = 0x1.0p-20;    // a zero of κ: B there is 2^-40 of its size
  std::vector<SegmentPart> open = evenly_fast_parts(path), parts;
  while (!open.empty()) {
    const SegmentPart part = open.back();
    open.pop_back();
    const EnclosedCurve<Quaternion<double>, n> exact(path.segment(part.segment));
    const TorsionParts<n> torsion(exact.restricted(part.a, part.b));
    const Enclosure range = coefficient_hull(torsion.bend());
    if (range.upper() <= most_variation * range.lower() || part.b - part.a <= least_part ||
        !torsion.has_numerator()) {
      parts.push_back(part);
    } else {
      const double middle = 0.5 * (part.a + part.b);
      open.push_back({part.segment, middle, part.b});
      open.push_back({part.segment, part.a, middle});
    }
  }
  return parts;
}

}  // namespace path_detail

/// The smallest and the largest torsion τ = (r' × r'')·r'''/|r' × r''|², signed. Where the
/// curvature or the speed may vanish on a part of the path on which N is not exactly zero, the
/// torsion may be unbounded and so are both ends; a part on which N is exactly zero (as in a
/// coordinate plane) counts with torsion 0. At a knot the torsion may jump: both sides count.
/// Domain: preimage degree 1 to 8 (higher denominators leave the range of the weights).
/// Method: best-first subdivision of N/(σ² B). Cost: some 0.4 ms a segment of degree 7.
template <std::size_t n>
  requires(n >= 1 && n <= 8)
Extremes torsion_extremes(const SpatialPath<n>& path, const RangeGoal& goal) {
  using namespace path_detail;
  std::vector<SegmentPart> parts;
  bool flat = false;
  for (const SegmentPart& part : evenly_bent_parts(path)) {
    const EnclosedCurve<Quaternion<double>, n> exact(path.segment(part.segment));
    if (TorsionParts<n>(exact.restricted(part.a, part.b)).has_numerator()) {
      parts.push_back(part);
    } else {
      flat = true;
    }
  }
  const Extremes none{Enclosure(0.0), Enclosure(0.0)};
  if (parts.empty()) return none;
  const Extremes found =
      extremes_over_parts(path, parts, RangeMeasure::value, goal,
                          [](const auto& exact) { return TorsionParts<n>(exact).quotient(); });
  if (!flat) return found;
  const auto smaller = [](const Enclosure& e) {
    return Enclosure(std::min(e.lower(), 0.0), std::min(e.upper(), 0.0));
  };
  const auto larger = [](const Enclosure& e) {
    return Enclosure(std::max(e.lower(), 0.0), std::max(e.upper(), 0.0));
  };
  return {smaller(found.minimum), larger(found.maximum)};
}

}  // namespace hodograph
