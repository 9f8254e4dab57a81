// SPDX-License-Identifier: MIT
// How smooth a path is at its knots: the jumps of its derivatives there, and which of them are
// rounding.
//
// A jump is stated as |f^(r)(ξ+) - f^(r)(ξ-)| h^r / M, where h is the shorter of the two steps that
// meet, M the largest local coefficient of f and |.| the largest component. It counts as zero up to
// accuracy::continuity_error(degree, r), the step of the position itself up to what rounding makes
// of the end of a segment (path_detail::end_error). Both are numbers without unit: scaling the path
// or its parameter changes neither.
#pragma once

#include <array>
#include <cstddef>

#include "hodograph/path/detail/preimage_turn.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// The jumps of f, f', ..., f^(count-1) at one knot, and what rounding may make of each.
template <class S, std::size_t count>
struct ScaledJumps {
  std::array<S, count> jump{}, allowed{};

  bool is_rounding(std::size_t r) const { return jump[r] <= allowed[r]; }
  /// The largest r for which f ... f^(r) are continuous (at most count - 1), -1 where f jumps.
  int order() const {
    std::size_t r = 0;
    while (r < count && is_rounding(r)) ++r;
    return static_cast<int>(r) - 1;
  }
};

/// The worst jump of every derivative over the knots of a path.
template <class S, std::size_t count>
struct WorstJumps : ScaledJumps<S, count> {
  std::array<std::size_t, count> knot{};  ///< where; the closing knot is 0

  /// Takes the jumps at a knot in.
  void include(const ScaledJumps<S, count>& jumps, std::size_t at) {
    for (std::size_t r = 0; r < count; ++r) {
      // jump/allowed grows; multiplied out, since both may be zero.
      const bool first = this->jump[r] == S(0) && this->allowed[r] == S(0);
      if (first || this->jump[r] * jumps.allowed[r] < jumps.jump[r] * this->allowed[r]) {
        this->jump[r] = jumps.jump[r];
        this->allowed[r] = jumps.allowed[r];
        knot[r] = at;
      }
    }
  }
};

/// The jumps at one knot.
template <class S>
struct KnotJumps {
  ScaledJumps<S, 5> position;  ///< r, r', ..., r''''
  ScaledJumps<S, 4> preimage;  ///< A, A', A'', A'''; at the closing knot up to the common sign
  bool antiperiodic = false;   ///< closing knot: the preimage is compared with its negative
};

/// The jumps at knot k. Domain: 1 ≤ k < N, or k = 0 on a closed path (its closing knot).
template <PreimageAlgebra A, std::size_t n>
KnotJumps<typename A::Scalar> jumps_at_knot(const Path<A, n>& path, std::size_t k);

/// The worst jumps over all inner knots, and the closing one of a closed path. Without such
/// knots there are no jumps, and every order is the largest looked at.
template <class S>
struct PathContinuity {
  WorstJumps<S, 5> position;
  WorstJumps<S, 4> preimage;
  bool antiperiodic = false;  ///< a closed path whose preimage returns to its negative
};
template <PreimageAlgebra A, std::size_t n>
PathContinuity<typename A::Scalar> continuity(const Path<A, n>& path);

// ------------------------------------------------------------------------------------------------

namespace path_detail {

/// The two curves that meet at a knot, before and after.
template <PreimageAlgebra A, std::size_t n>
struct Meeting {
  const PhCurve<A, n>* before;
  const PhCurve<A, n>* after;
  typename A::Scalar step;  ///< the shorter one
};
template <PreimageAlgebra A, std::size_t n>
Meeting<A, n> meeting_at(const Path<A, n>& path, std::size_t k) {
  const auto& before = path.segment((k == 0 ? path.segment_count() : k) - 1);
  const auto& after = path.segment(k);
  return {&before, &after,
          before.parameter_step() < after.parameter_step() ? before.parameter_step()
                                                           : after.parameter_step()};
}

/// The end of a curve of preimage degree n is its start and the integral of its hodograph. It is
/// within end_error<S>(n) M of where exact numbers would have it, M = h max|A_i|², where every A_i
/// carries 4 roundings and those of a degree elevation (at most (n/2 + 3) ε/2 of the largest):
/// twice that relatively, (n/2 + 11) ε; and the integral h/(2n+1) times a sum of 2n + 1 means of
/// products adds (3n + 14) ε/2, as in accuracy::arc_length_error. That may be much more than a few
/// ε of the coordinates: A turns, and what its square gives cancels.
template <class S>
S end_error(std::size_t n) {
  return S(static_cast<double>(2 * n + 18)) * S(epsilon<S>());
}

/// Calls visit(k) for every knot where two segments meet.
template <class P, class Visit>
void for_each_meeting(const P& path, const Visit& visit) {
  if (path.is_closed()) visit(std::size_t{0});
  for (std::size_t k = 1; k < path.segment_count(); ++k) visit(k);
}

/// A, A' h, A'' h², ... at u for the given h instead of the curve's own step, which is at least h:
/// no power of h is formed, so the range of the numbers stays that of the preimage.
template <std::size_t K, PreimageAlgebra A, std::size_t n>
PreimageJet<A, K> jet_in_steps(const PhCurve<A, n>& curve, const typename A::Scalar& u,
                               const typename A::Scalar& h) {
  PreimageJet<A, K> jet = curve.preimage().template jet<K>(u);
  const typename A::Scalar share = h / curve.parameter_step();
  typename A::Scalar power(1);
  for (std::size_t r = 1; r <= K; ++r) {
    power = power * share;
    jet[r] = power * jet[r];
  }
  return jet;
}

/// |a_r - b_r| / size for r = 0, 1, ...; a zero size (a point) leaves the jump unscaled.
template <class S, class V, std::size_t count>
ScaledJumps<S, count> scaled_jumps(const std::array<V, count>& a, const std::array<V, count>& b,
                                   const S& size, std::size_t degree) {
  ScaledJumps<S, count> result;
  for (std::size_t r = 0; r < count; ++r) {
    const S jump = largest_component(b[r] - a[r]);
    result.jump[r] = S(0) < size ? S(jump / size) : jump;
    result.allowed[r] = S(accuracy::continuity_error<S>(degree, r));
  }
  return result;
}

/// r, r' h, r'' h², ... from the preimage's A, A' h, ...
template <class A, std::size_t size>
std::array<point_t<A>, size + 1> position_jet(const point_t<A>& position,
                                              const std::array<A, size>& preimage,
                                              const typename A::Scalar& h) {
  std::array<point_t<A>, size + 1> result;
  const auto derivatives = hodograph_derivatives(preimage);
  result[0] = position;
  for (std::size_t r = 0; r < size; ++r) result[r + 1] = h * derivatives[r];
  return result;
}

}  // namespace path_detail

template <PreimageAlgebra A, std::size_t n>
KnotJumps<typename A::Scalar> jumps_at_knot(const Path<A, n>& path, std::size_t k) {
  using S = typename A::Scalar;
  const auto [before, after, step] = path_detail::meeting_at(path, k);
  KnotJumps<S> result;

  auto end = path_detail::jet_in_steps<3>(*before, S(1), step);
  const auto begin = path_detail::jet_in_steps<3>(*after, S(0), step);
  // Positions are stored relative to the start of their segment: so are their coefficients, but the
  // position itself (r = 0) also carries the rounding of its coordinates.
  S size(0), coordinate = largest_component(before->end());
  for (const auto* curve : {before, after}) {
    const auto displacement = curve->displacement();
    for (const auto& c : displacement.coefficients()) {
      if (const S component = largest_component(c); size < component) size = component;
    }
  }
  if (coordinate < size) coordinate = size;
  result.position = path_detail::scaled_jumps(
      path_detail::position_jet(before->end(), end, step),
      path_detail::position_jet(after->start(), begin, step), size, PhCurve<A, n>::degree);
  const S gap = largest_component(after->start() - before->end());
  result.position.jump[0] = S(0) < coordinate ? S(gap / coordinate) : gap;
  // h |A|² with the range of the path's own numbers.
  const S turning = path_detail::largest_coefficient(before->preimage());
  const S integrated = (before->parameter_step() * turning) * turning;
  if (S(0) < coordinate) {
    const S more = path_detail::end_error<S>(n) * (integrated / coordinate);
    // What a path may be made of (Path::create) is the most.
    const S most = S(accuracy::join_error<S>());
    const S allowed = result.position.allowed[0] + more;
    result.position.allowed[0] = allowed < most ? allowed : most;
  }

  if (k == 0 && dot(end[0], begin[0]) < S(0)) {
    result.antiperiodic = true;
    for (A& a : end) a = -a;
  }
  const S first = path_detail::largest_coefficient(before->preimage());
  const S second = path_detail::largest_coefficient(after->preimage());
  result.preimage = path_detail::scaled_jumps(end, begin, first < second ? second : first, n);
  return result;
}

template <PreimageAlgebra A, std::size_t n>
PathContinuity<typename A::Scalar> continuity(const Path<A, n>& path) {
  PathContinuity<typename A::Scalar> result;
  path_detail::for_each_meeting(path, [&](std::size_t k) {
    const auto jumps = jumps_at_knot(path, k);
    result.position.include(jumps.position, k);
    result.preimage.include(jumps.preimage, k);
    result.antiperiodic = result.antiperiodic || jumps.antiperiodic;
  });
  return result;
}

}  // namespace hodograph
