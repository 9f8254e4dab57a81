// SPDX-License-Identifier: MIT
// A path as numbers for the search for its distance to itself, and that search's entry.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "hodograph/path/continuity.hpp"
#include "hodograph/path/curvature_parts.hpp"
#include "hodograph/path/self_distance.hpp"

namespace hodograph {

namespace path_detail {

/// The control points of a path's segments, of one degree: (x, y, z, arc length), z = 0 in the
/// plane, relative to the first, one after the other.
struct Strand {
  std::size_t degree = 0;
  bool closed = false;
  std::vector<double> knots, control;
  double error = 0.0;  ///< no coordinate of the exact path is further than this from these

  std::size_t segment_count() const { return knots.size() - 1; }
};

/// The stored coefficients are sums of 2n + 1 numbers, each a sum of at most n + 1 products of size
/// at most 2 M, M the speed bound: (3n + 14) ε h M a component is more than their rounding. The
/// start, the arc length at the knot and the shift of the origin add two roundings of their sizes.
template <class A, std::size_t n>
Strand strand_of(const Path<A, n>& path) {
  Strand strand;
  strand.degree = 2 * n + 1;
  strand.closed = path.is_closed();
  strand.knots = path.knots();
  strand.control.reserve(path.segment_count() * (2 * n + 2) * 4);
  const point_t<A> origin = path.segment(0).start();
  double rounding = arc_length_rounding(path), size = path.arc_length();
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const auto& curve = path.segment(k);
    rounding = std::max(rounding, static_cast<double>(3 * n + 14) * epsilon<double>() *
                                      curve.parameter_step() * curve.speed_bound());
    const point_t<A> start = curve.start() - origin;
    size = std::max({size, largest_component(curve.start()), largest_component(start)});
    for (const auto& c : curve.integral().coefficients()) {
      const point_t<A> p = start + c.displacement;
      for (std::size_t j = 0; j < 3; ++j) {
        strand.control.push_back(j < point_t<A>::dimension ? p[j] : 0.0);
      }
      strand.control.push_back(path.knot_arc_lengths()[k] + c.arc_length);
      size = std::max({size, largest_component(p), std::abs(strand.control.back())});
    }
  }
  strand.error = rounding + 4.0 * epsilon<double>() * size;
  return strand;
}

/// The least distance of points at least `separation` apart, or `cutoff` where it is not smaller:
/// the upper end is then infinite. Nothing where no two points are so far apart.
/// Domain: separation > 0; finite control points.
std::optional<SelfDistance> search_self_distance(const Strand& strand, double separation,
                                                 double cutoff, const RangeGoal& goal);

Fault no_such_parts(double separation, double length, bool closed);
std::optional<Fault> separation_fault(double separation);

/// The knot where the tangent breaks by more than rounding, if there is one.
template <class A, std::size_t n>
std::optional<std::size_t> corner_of(const Path<A, n>& path) {
  std::optional<std::size_t> corner;
  for_each_meeting(path, [&](std::size_t k) {
    const auto meeting = meeting_at(path, k);
    const auto &before = meeting.before->preimage(), &after = meeting.after->preimage();
    const bool moves =
        largest_component(before.back()) > 0.0 && largest_component(after.front()) > 0.0;
    if (!corner && moves && preimage_turn(before, after).is_break()) corner = k;
  });
  return corner;
}

}  // namespace path_detail

template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
Result<SelfDistance> self_distance(const Path<A, n>& path, double separation,
                                   const RangeGoal& goal) {
  if (auto fault = path_detail::separation_fault(separation)) return *std::move(fault);
  const auto found = path_detail::search_self_distance(
      path_detail::strand_of(path), separation, std::numeric_limits<double>::infinity(), goal);
  if (!found) return path_detail::no_such_parts(separation, path.arc_length(), path.is_closed());
  return *found;
}

template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
TubeRadius largest_tube_radius(const Path<A, n>& path, const RangeGoal& goal) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  TubeRadius result;
  if (const auto corner = path_detail::corner_of(path)) {
    result.limit = TubeLimit::corner;
    result.knot = *corner;
    result.radius = Enclosure(0.0);
    result.curvature = Enclosure(std::numeric_limits<double>::max(), infinity);
    return result;
  }
  const Extremes curvature = curvature_extremes(path, goal);
  // In the plane signed: the larger of the two sizes.
  const Enclosure low = abs(curvature.minimum), high = abs(curvature.maximum);
  result.curvature = {std::max(low.lower(), high.lower()), std::max(low.upper(), high.upper())};
  const Enclosure& kappa = result.curvature;
  const auto inverse_below = [](double x) {  // a lower bound of 1/x
    return x > 0.0 ? Enclosure::down(1.0 / x) : std::numeric_limits<double>::max();
  };
  const double most = kappa.lower() > 0.0 ? Enclosure::up(1.0 / kappa.lower()) : infinity;
  if (!(kappa.upper() < infinity)) {
    result.limit = TubeLimit::standstill;
    result.radius = {0.0, most};
    return result;
  }
  result.radius = {std::max(0.0, inverse_below(kappa.upper())), most};
  if (kappa.upper() == 0.0) return result;
  const double separation = std::numbers::pi * inverse_below(kappa.upper());
  if (!(separation < infinity)) return result;
  result.distance =
      path_detail::search_self_distance(path_detail::strand_of(path), separation, 2.0 * most, goal);
  if (!result.distance) return result;
  const Enclosure& distance = result.distance->distance;  // halved without rounding
  if (0.5 * distance.upper() < result.radius.upper()) result.limit = TubeLimit::distance;
  result.radius = {std::min(0.5 * distance.lower(), result.radius.lower()),
                   std::min(0.5 * distance.upper(), result.radius.upper())};
  return result;
}

}  // namespace hodograph
