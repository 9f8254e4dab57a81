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
  return real_of_t<S>(static_cast<double>(3 * degree + 2)) * epsilon<S>() / real_of_t<S>(2);
}

/// The computed arc length of a curve of preimage degree n, and the target its inverse meets, are
/// within arc_length_error<S>(n) * M of the integral of |A|², M = h max|A_i|²: a control value is
/// h/(2n+1) times a sum of up to 2n + 1 means of products, (3n + 10) ε/2 M; evaluation adds
/// (6n + 5) ε/2 M, replacing the curve by a tangent n ε/2 M.
template <class S>
constexpr real_of_t<S> arc_length_error(std::size_t preimage_degree) {
  return real_of_t<S>(static_cast<double>(5 * preimage_degree + 8)) * epsilon<S>();
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

/// A rotation given as a unit quaternion may miss length 1 by this much (64 roundings, as above);
/// more is not a rotation.
template <class S>
constexpr real_of_t<S> unit_error() {
  return join_error<S>();
}

/// A Hermite interpolant is refused where the fibre it needs is opposite to the one it has within
/// this angle (radians): the projection then keeps fewer than half of the digits.
template <class S>
real_of_t<S> opposite_fibre_angle() {
  using std::sqrt;
  return sqrt(epsilon<S>());
}

/// A Hermite interpolant is refused when its control speeds sum to more than this many times the
/// size of its data (the displacement and the terms h^r |p^(r)|/r!): ε^(-1/4), 8192 for double. It
/// would wander that far to meet them and lose as many digits; a speed that nearly vanishes
/// beside the acceleration does that.
template <class S>
real_of_t<S> wild_interpolant() {
  using std::sqrt;
  return real_of_t<S>(1) / sqrt(sqrt(epsilon<S>()));
}

/// A Hermite curve's stored end may miss its datum by this fraction of the largest displacement
/// coefficient: half of what continuity_error allows a knot.
template <class S>
constexpr real_of_t<S> settled_end() {
  return real_of_t<S>(2) * epsilon<S>();
}

}  // namespace hodograph::accuracy
