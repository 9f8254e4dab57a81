// SPDX-License-Identifier: MIT
// A certificate for a fit: a rigorous enclosure of max |γ(ξ) - p(ξ)| for a curve γ that is a
// template on its scalar.
//
// Method. On an interval with midpoint m and half width w, ξ = m + w s, Taylor's theorem gives for
// every component, with a_k the coefficients at m and a_K one of the members of the coefficient of
// order K taken over the whole interval as a ball,
//   γ(ξ) = Σ_{k<K} a_k s^k + a_K s^K,   |s| ≤ 1.
// The difference of this polynomial and the stored displacement is one Bernstein polynomial, whose
// largest norm is enclosed by its control points and its values (largest_norm); the radii of the
// a_k and all roundings are added. Intervals on which the remainder dominates are halved. Nothing
// is assumed of how p was made, so the bound holds for every construction and degree, and stays
// sharp down to the rounding of the stored coefficients. Segments so short that rounding rules
// their errors share one Taylor polynomial.
#pragma once

#include <cstddef>
#include <vector>

#include "hodograph/certify/ball.hpp"
#include "hodograph/certify/detail/segment_certifier.hpp"
#include "hodograph/construction/error_bound.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// An enclosure of the largest |γ(ξ) - p(ξ)| over ξ_k ≤ ξ ≤ ξ_{k+1} for one segment p(ξ) = r(u),
/// u = (ξ - ξ_k)/h clamped to [0, 1], h the segment's parameter step as stored.
///
/// γ: callable with `template <class S> Vector3<S> operator()(const S& xi) const` (Vector2 in the
/// plane). Where γ cannot be shown to have K derivatives (a pole, √ξ at 0, |ξ| at 0, a branch on ξ)
/// the upper end is ∞ and `certified` is false: never a wrong number.
/// Accuracy: upper/lower is about 1.02 where the error exceeds the rounding of positions.
template <class Curve, PreimageAlgebra A, std::size_t n>
ErrorBound segment_error(const Curve& gamma, const PhCurve<A, n>& segment, double xi_begin,
                         double xi_end) {
  return certify_detail::SegmentCertifier<Curve, A, n>(gamma, segment, xi_begin, xi_end).run();
}

/// The bound of every segment of a path, in order.
template <class Curve, PreimageAlgebra A, std::size_t n>
std::vector<ErrorBound> segment_errors(const Curve& gamma, const Path<A, n>& path) {
  certify_detail::PathCertifier<Curve, A, n> certifier(gamma, path);
  std::vector<ErrorBound> errors;
  errors.reserve(path.segment_count());
  for (std::size_t k = 0; k < path.segment_count(); ++k) errors.push_back(certifier.next());
  return errors;
}

/// An enclosure of the largest |γ(ξ) - p(ξ)| over the whole path; see segment_error.
template <class Curve, PreimageAlgebra A, std::size_t n>
ErrorBound certified_error(const Curve& gamma, const Path<A, n>& path) {
  certify_detail::PathCertifier<Curve, A, n> certifier(gamma, path);
  ErrorBound total = certifier.next();
  for (std::size_t k = 1; k < path.segment_count(); ++k) {
    total = larger_error(total, certifier.next());
  }
  return total;
}

}  // namespace hodograph
