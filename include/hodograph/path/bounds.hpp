// SPDX-License-Identifier: MIT
// Rigorous bounds of what a path itself is: length, speed, box, curvature, angular rate.
//
// What is enclosed is the exact curve of the stored numbers: on every segment the real curve
// r(u) = start + h ∫ hodograph_form(A, A), A the polynomial with exactly the stored coefficients, h
// and start exactly as stored. (The displacement and arc length that a segment holds for evaluation
// are this, rounded.) Every enclosure holds, rounding included; RangeGoal says how far it is
// refined. Extremes over the whole path are found together: only segments that matter are
// subdivided. Where the speed falls to 2^-24 of its largest value on a segment, rounding ends the
// refinement of rates and curvatures at about 2^-24 of themselves; elsewhere far below.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hodograph/bernstein/range.hpp"
#include "hodograph/path/detail/enclosed_curve.hpp"
#include "hodograph/path/detail/quick_curvature.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// The arc length h ∫ |A|² du = h · mean of the 2n + 1 coefficients of |A|² of one curve, to a few
/// roundings.
template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
Enclosure arc_length_enclosure(const PhCurve<A, n>& curve) {
  const path_detail::EnclosedCurve<A, n> exact(curve);
  const Enclosure size = path_detail::power_of_two(exact.exponent());
  return ((exact.step() * size) * size) * exact.speed().integral();
}

/// The arc length of the whole path; its relative width grows with the logarithm of the number of
/// segments.
template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
Enclosure arc_length_enclosure(const Path<A, n>& path) {
  std::vector<Enclosure> lengths;
  for (const auto& curve : path.segments()) lengths.push_back(arc_length_enclosure(curve));
  for (std::size_t stride = 1; stride < lengths.size(); stride *= 2) {  // sums of halves
    for (std::size_t k = 0; k + stride < lengths.size(); k += 2 * stride) {
      lengths[k] += lengths[k + stride];
    }
  }
  return lengths[0];
}

namespace path_detail {

/// The extremes over parts of segments of the quotient that `make` builds from them.
template <class A, std::size_t n, class Make>
Extremes extremes_over_parts(const Path<A, n>& path, const std::vector<SegmentPart>& parts,
                             RangeMeasure measure, const RangeGoal& goal, const Make& make) {
  return extremes(
      parts.size(),
      [&](std::size_t i) {
        const EnclosedCurve<A, n> exact(path.segment(parts[i].segment));
        return make(exact.restricted(parts[i].a, parts[i].b));
      },
      measure, goal);
}
/// The same over all segments.
template <class A, std::size_t n, class Make>
Extremes extremes_over_parts(const Path<A, n>& path, RangeMeasure measure, const RangeGoal& goal,
                             const Make& make) {
  return extremes_over_parts(path, evenly_fast_parts(path), measure, goal, make);
}

/// 2 vec(A* A')/(h σ^power), ' = d/du, as a quotient of vectors: `pick` takes the components
/// wanted.
template <class A, std::size_t n, class Pick>
BernsteinQuotient rate_quotient(const EnclosedCurve<A, n>& exact, int power, const Pick& pick) {
  const auto rate = exact.body_rate().mapped(pick);
  const auto speed = exact.speed();
  const Enclosure factor = Enclosure(2.0) / exact.step();
  if (power == 1) return BernsteinQuotient::of(rate, speed).times(factor);
  const auto square =
      symmetric_square(speed, [](const Enclosure& a, const Enclosure& b) { return a * b; });
  const Enclosure unit = power_of_two(-exact.exponent());
  return BernsteinQuotient::of(rate, square).times((factor * unit) * unit);
}

}  // namespace path_detail

/// The smallest and the largest parametric speed σ = |A|², per unit ξ.
template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
Extremes speed_extremes(const Path<A, n>& path, const RangeGoal& goal) {
  const Extremes found =
      path_detail::extremes_over_parts(path, RangeMeasure::value, goal, [](const auto& exact) {
        const Enclosure size = path_detail::power_of_two(exact.exponent());
        return BernsteinQuotient::of(exact.speed()).times(size).times(size);
      });
  const auto not_negative = [](const Enclosure& e) {
    return Enclosure(std::max(0.0, e.lower()), std::max(0.0, e.upper()));
  };
  return {not_negative(found.minimum), not_negative(found.maximum)};
}

/// The extremes of each coordinate of r: the smallest box with sides along the axes that holds the
/// path lies between the boxes that their ends span.
template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
std::array<Extremes, point_t<A>::dimension> bounding_box(const Path<A, n>& path,
                                                         const RangeGoal& goal) {
  std::array<Extremes, point_t<A>::dimension> box;
  for (std::size_t j = 0; j < box.size(); ++j) {
    const auto coordinate = [&](std::size_t k) {
      const path_detail::EnclosedCurve<A, n> exact(path.segment(k));
      const Enclosure size = path_detail::power_of_two(exact.exponent());
      const Enclosure factor = (exact.step() * size) * size;
      const Enclosure start(path.segment(k).start()[j]);
      const auto displacement =
          exact.hodograph().mapped([j](const auto& h) { return h[j]; }).antiderivative();
      return BernsteinQuotient::of(
          displacement.mapped([&](const Enclosure& d) { return start + factor * d; }));
    };
    box[j] = extremes(path.segment_count(), coordinate, RangeMeasure::value, goal);
  }
  return box;
}

namespace path_detail {

/// 2nτ/(hσ²), the curvature in the plane.
template <std::size_t n>
BernsteinQuotient turning_quotient(const EnclosedCurve<Complex<double>, n>& exact) {
  const auto square =
      symmetric_square(exact.speed(), [](const Enclosure& a, const Enclosure& b) { return a * b; });
  const Enclosure unit = power_of_two(-exact.exponent());
  const Enclosure factor = Enclosure(2.0 * std::max(1.0, static_cast<double>(n))) / exact.step();
  return BernsteinQuotient::of(turning_polynomial(exact.preimage()), square)
      .times((factor * unit) * unit);
}

/// Whether both enclosures are as narrow as the goal asks.
inline bool reaches(const Extremes& found, const RangeGoal& goal) {
  for (const Enclosure& e : {found.minimum, found.maximum}) {
    if (!(e.upper() - e.lower() <= goal.relative_width * e.magnitude())) return false;
  }
  return true;
}

/// The extremes of the curvature of a planar path: quickly on the segments where that settles, by
/// subdivision on the others; nothing where that does not reach the goal.
template <std::size_t n>
std::optional<Extremes> quick_curvature_extremes(const PlanarPath<n>& path, const RangeGoal& goal) {
  std::optional<Extremes> all;
  const auto include = [&all](const Extremes& found) { all = all ? joined(*all, found) : found; };
  if constexpr (n > 0) {
    std::vector<SegmentPart> open;
    for (std::size_t k = 0; k < path.segment_count(); ++k) {
      if (const auto found = QuickCurvature<n>(path.segment(k)).extremes()) {
        include(*found);
      } else {
        add_evenly_fast_parts(path, k, open);
      }
    }
    if (!all) return std::nullopt;
    if (!open.empty()) {
      include(extremes_over_parts(path, open, RangeMeasure::value, goal,
                                  [](const auto& exact) { return turning_quotient(exact); }));
    }
    if (!reaches(*all, goal)) return std::nullopt;
  }
  return all;
}

}  // namespace path_detail

/// The extremes of the curvature: in the plane signed, positive to the left, 2 Im(w* w')/σ²; in
/// space κ = 2 |(V₂, V₃)|/σ² ≥ 0 with V = vec(A* A'), ' = d/dξ. The upper end of the maximum (in
/// the plane also the lower end of the minimum) is infinite where the speed may vanish.
///
/// Method: in the plane, the isolated roots of f = σ h' - 2 h σ' (h = κσ²; "Path planning with
/// Pythagorean-hodograph curves for unmanned or autonomous vehicles", section 6) in double
/// precision with known bounds of the rounding; on segments where that does not settle, where it
/// does not reach the goal, and in space, best-first subdivision.
template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
Extremes curvature_extremes(const Path<A, n>& path, const RangeGoal& goal) {
  constexpr bool planar = A::dimension == 2;
  if constexpr (planar) {
    if (const auto found = path_detail::quick_curvature_extremes(path, goal)) return *found;
  }
  return path_detail::extremes_over_parts(
      path, planar ? RangeMeasure::value : RangeMeasure::norm, goal, [](const auto& exact) {
        if constexpr (planar) {
          return path_detail::turning_quotient(exact);
        } else {
          return path_detail::rate_quotient(exact, 2, [](const auto& v) {
            return Vector2<Enclosure>{v.y, v.z};
          });
        }
      });
}

/// The extremes of |χ|, the angular rate of the Euler-Rodrigues frame in radians per unit ξ:
/// 2 |vec(A* A')|/σ. Infinite where the speed may vanish.
template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
Extremes angular_rate_extremes_per_xi(const Path<A, n>& path, const RangeGoal& goal) {
  return path_detail::extremes_over_parts(path, RangeMeasure::norm, goal, [](const auto& exact) {
    return path_detail::rate_quotient(exact, 1, [](const auto& v) { return v; });
  });
}

/// The same in radians per unit arc length: 2 |vec(A* A')|/σ².
template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
Extremes angular_rate_extremes_per_arc_length(const Path<A, n>& path, const RangeGoal& goal) {
  return path_detail::extremes_over_parts(path, RangeMeasure::norm, goal, [](const auto& exact) {
    return path_detail::rate_quotient(exact, 2, [](const auto& v) { return v; });
  });
}

#define HODOGRAPH_COMPILED_BOUNDS(prefix, n)                                           \
  prefix template Enclosure arc_length_enclosure(const PlanarPath<n>&);                \
  prefix template Enclosure arc_length_enclosure(const SpatialPath<n>&);               \
  prefix template Extremes speed_extremes(const PlanarPath<n>&, const RangeGoal&);     \
  prefix template Extremes speed_extremes(const SpatialPath<n>&, const RangeGoal&);    \
  prefix template Extremes curvature_extremes(const PlanarPath<n>&, const RangeGoal&); \
  prefix template Extremes curvature_extremes(const SpatialPath<n>&, const RangeGoal&);
HODOGRAPH_FOR_COMPILED_DEGREES(HODOGRAPH_COMPILED_BOUNDS, extern)

}  // namespace hodograph
