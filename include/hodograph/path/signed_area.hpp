// SPDX-License-Identifier: MIT
// The signed area that a planar path goes round: ½ ∮ (x dy - y dx).
//
// A closed path that turns left round a region counts its area once, positive; one that turns
// right, negative; a region gone round several times counts as often. An open path is closed by its
// chord, from its end straight back to its start. The area is that of the exact curve of the stored
// numbers (see path/bounds.hpp), with the gaps that rounding leaves at the knots closed by straight
// lines; it does not depend on where the origin is.
//
// On a segment r = p + h D, D the integral of w² (degree 2n + 1, D(0) = 0), so that with o the
// start of the path ½ ∫ (r - o) × r' = ½ h (p - o) × D(1) + ½ h² ∫ D × w² du, the mean of 4n + 2
// Bernstein coefficients: exact.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/path/detail/enclosed_curve.hpp"
#include "hodograph/path/detail/sum_by_halves.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

namespace path_detail {

/// ½ h² ∫ D × w² du of one segment, D the integral of the hodograph w².
template <class S, std::size_t m>
S half_swept(const BernsteinPolynomial<Vector2<S>, m>& hodograph, const S& step) {
  const auto swept = product(hodograph.antiderivative(), hodograph,
                             [](const Vector2<S>& a, const Vector2<S>& b) { return cross(a, b); });
  return ((S(0.5) * step) * step) * swept.integral();
}

}  // namespace path_detail

/// The signed area in double precision: within a small multiple of rounding of the largest product
/// of a displacement from the start and a segment's length, times the number of segments.
/// Domain: sizes whose squares are in the range of numbers.
template <std::size_t n, class S>
S signed_area(const Path<Complex<S>, n>& path) {
  const Vector2<S> origin = path.segment(0).start();
  std::vector<S> shares;
  shares.reserve(path.segment_count());
  for (const auto& curve : path.segments()) {
    const Vector2<S> chord = curve.integral().back().displacement;
    shares.push_back(S(0.5) * cross(curve.start() - origin, chord) +
                     path_detail::half_swept(curve.hodograph(), curve.parameter_step()));
  }
  return path_detail::sum_by_halves(std::move(shares));
}

/// The same in an enclosure, a few dozen roundings wide; the whole line out of the range of
/// numbers.
template <std::size_t n>
Enclosure signed_area_enclosure(const PlanarPath<n>& path) {
  using path_detail::enclosed;
  using Point = Vector2<Enclosure>;
  const Point origin = enclosed(path.segment(0).start());
  const Enclosure half(0.5);
  std::vector<Enclosure> shares;
  shares.reserve(2 * path.segment_count());
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const path_detail::EnclosedCurve<Complex<double>, n> exact(path.segment(k));
    const Enclosure unit = path_detail::power_of_two(exact.exponent());
    const Enclosure scale = (exact.step() * unit) * unit;
    const Point start = enclosed(path.segment(k).start()) - origin;
    const auto hodograph = exact.hodograph();
    const Point chord = scale * hodograph.integral();
    shares.push_back(half * cross(start, chord) + path_detail::half_swept(hodograph, scale));
    if (k + 1 < path.segment_count()) {
      // The gap to the next segment; the one that closes the path leads to o and counts nothing.
      const Point next = enclosed(path.segment(k + 1).start()) - origin;
      shares.push_back(half * cross(start + chord, next));
    }
  }
  return path_detail::sum_by_halves(std::move(shares));
}

}  // namespace hodograph
