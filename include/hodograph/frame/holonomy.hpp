// SPDX-License-Identifier: MIT
// What is left over when the frame has gone once round a closed path, and the roll that takes it
// away.
#pragma once

#include "hodograph/foundation/result.hpp"
#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/path/detail/preimage_turn.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// A(ξ_N) = c · sign · A(ξ_0) (cos roll/2 + i sin roll/2), c > 0: round the path the ERF rolls by
/// `roll` about the tangent, radians in (-π, π], and the preimage may change its sign besides. With
/// roll = 0 the frame is periodic, and the preimage periodic (sign 1) or antiperiodic (sign -1).
template <class S>
struct Holonomy {
  S roll{};
  int sign = 1;
};

/// The holonomy of a closed path, from conj(A(ξ_0)) A(ξ_N), by atan2: no arccos, so that a small
/// roll keeps its digits. Accuracy: a few ε |A_max|/|A(ξ_0)|. Faults: unsupported (an open path),
/// zero_speed (index 0: no frame at the closing knot), not_continuous (index 0: the tangent does
/// not return).
template <class S, std::size_t n>
Result<Holonomy<S>> holonomy(const SpatialPath<n, S>& path) {
  using std::atan2;
  if (!path.is_closed()) {
    return Fault{FaultCode::unsupported, "the frame of an open path does not return: no holonomy",
                 std::nullopt,           "closed",
                 std::nullopt,           std::nullopt};
  }
  const auto& last = path.segments().back().preimage();
  const auto& first = path.segments().front().preimage();
  if (!(S(0) < largest_component(last.back())) || !(S(0) < largest_component(first.front()))) {
    return Fault{FaultCode::zero_speed,
                 "the path stands still at its closing knot: no frame exists there",
                 0,
                 "speed",
                 0.0,
                 std::nullopt};
  }
  const auto turn = path_detail::preimage_turn(last, first);
  if (turn.is_break()) {
    return path_detail::tangent_fault(turn, 0, "the end of the closed path meets its start");
  }
  Holonomy<S> result;
  S cosine = turn.q.w, sine = turn.q.x;
  // Of ±Q take the one with half angle in (-π/2, π/2].
  if (cosine < S(0) || (!(S(0) < cosine) && sine < S(0))) {
    result.sign = -1;
    cosine = -cosine;
    sine = -sine;
  }
  result.roll = S(2) * S(atan2(sine, cosine));
  return result;
}

/// The roll that distributes the holonomy evenly over ξ, from 0 at ξ_0 to -holonomy at ξ_N: the ERF
/// turned by it is periodic. Faults: those of holonomy.
template <class S, std::size_t n>
Result<LinearRoll<S>> closing_roll(const SpatialPath<n, S>& path) {
  const auto left_over = holonomy(path);
  if (!left_over) return left_over.fault();
  return LinearRoll<S>{path.xi_begin(), S(0),
                       S(-left_over->roll / (path.xi_end() - path.xi_begin()))};
}

}  // namespace hodograph
