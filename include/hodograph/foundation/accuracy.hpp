// SPDX-License-Identifier: MIT
// Every tolerance of the library, named, derived, and scaled by the scalar's epsilon.
#pragma once

#include "hodograph/foundation/scalar.hpp"

namespace hodograph::accuracy {

/// Bernstein-Horner evaluation of degree n of coefficients of size M returns the value to
/// within evaluation_error<S>(n) * M: each of the n + 1 terms passes at most 3n + 2 roundings, and
/// the weights sum to 1.
template <class S>
constexpr real_of_t<S> evaluation_error(std::size_t degree) {
  return real_of_t<S>(static_cast<double>(3 * degree + 2)) * epsilon<S>() /
         real_of_t<S>(2);
}

/// Continuity of a fitted path (and the check of it): the jump of derivative r across a knot, times
/// (shorter h)^r, is at most continuity_error<S>(n, r) times the largest local coefficient.
/// The r-th derivative of degree n sums coefficients with weights of total 2^r n!/(n-r)!, and each
/// end coefficient carries at most 4 roundings.
template <class S>
constexpr real_of_t<S> continuity_error(std::size_t degree, std::size_t order) {
  real_of_t<S> weight = real_of_t<S>(4) * epsilon<S>();
  for (std::size_t j = 0; j < order; ++j) {
    weight = weight * real_of_t<S>(2) * real_of_t<S>(static_cast<double>(degree - j));
  }
  return weight;
}

/// Segments that meet may differ by this fraction of the largest coordinate or displacement at the
/// join: 64 roundings, enough for data that were themselves computed; more is a gap.
template <class S>
constexpr real_of_t<S> join_error() {
  return real_of_t<S>(64) * epsilon<S>();
}

/// A Hermite interpolant is refused where the fibre it needs is opposite to the one it has within
/// this angle (radians): the projection then keeps fewer than half of the digits.
template <class S>
real_of_t<S> opposite_fibre_angle() {
  using std::sqrt;
  return sqrt(epsilon<S>());
}

/// A speed counts as zero at a Hermite end when the acceleration would turn the velocity round
/// within this fraction of the parameter step: |v| ≤ slow_end · h |a| makes arc lengths grow like
/// 1/slow_end (errata, "zero speed at an end").
template <class S>
real_of_t<S> slow_end() {
  using std::sqrt;
  return sqrt(epsilon<S>());
}

}  // namespace hodograph::accuracy
