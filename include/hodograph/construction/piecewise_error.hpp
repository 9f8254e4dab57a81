// SPDX-License-Identifier: MIT
// The certified error of a path against a piecewise polynomial curve (a spline): the pieces are
// split at the knots of both, and the control points of each difference bounded.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "hodograph/construction/error_bound.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// An enclosure of the largest |f(v) - r(u)| over ξ in [xi_begin, xi_end], the part of one segment
/// that lies in one piece: u = (ξ - segment_begin)/h clamped to [0, 1], h the segment's stored
/// parameter step, and v = (ξ - piece_begin)/(piece_end - piece_begin). Domain: segment_begin,
/// piece_begin ≤ xi_begin < xi_end ≤ piece_end, segment_begin + h (rounded).
///
/// Derivation: both polynomials are restricted to the interval in double precision, the piece
/// relative to the segment's start. A restriction is two runs of de Casteljau's algorithm, three
/// roundings a level; parameters are wrong by at most 4ε, which moves a point by that times the
/// largest derivative.
template <std::size_t d, PreimageAlgebra A, std::size_t n>
ErrorBound piece_error(const BernsteinPolynomial<point_t<A>, d>& piece, double piece_begin,
                       double piece_end, const PhCurve<A, n>& segment, double segment_begin,
                       double xi_begin, double xi_end) {
  using V = point_t<A>;
  constexpr std::size_t degree = std::max(d, PhCurve<A, n>::degree);
  constexpr double eps = epsilon<double>();
  const double h = segment.parameter_step();
  const auto clamp = [](double x) { return std::min(1.0, std::max(0.0, x)); };

  BernsteinPolynomial<V, d> from_start = piece;
  double piece_size = 0.0, piece_step = 0.0;
  for (std::size_t i = 0; i <= d; ++i) {
    from_start[i] = piece[i] - segment.start();
    error_detail::raise_to(piece_size, largest_component(from_start[i]));
    if (i > 0) error_detail::raise_to(piece_step, largest_component(piece[i] - piece[i - 1]));
  }
  const auto displacement = segment.displacement();
  double displacement_size = 0.0;
  for (const V& c : displacement.coefficients()) {
    error_detail::raise_to(displacement_size, largest_component(c));
  }
  const double piece_width = piece_end - piece_begin;
  const auto on_piece = from_start.restricted(clamp((xi_begin - piece_begin) / piece_width),
                                              clamp((xi_end - piece_begin) / piece_width));
  const auto on_segment = displacement.restricted(clamp((xi_begin - segment_begin) / h),
                                                  clamp((xi_end - segment_begin) / h));
  const auto difference =
      on_piece.template elevated<degree>() - on_segment.template elevated<degree>();

  // Parameters: difference, width and quotient rounded, and the quotient inside restricted(): 4 ε/2
  // each for both ends. |df/dv| ≤ d max|Δc|; the factors 2 cover √3 and the roundings of the bound.
  const Enclosure moved =
      Enclosure(4.0 * eps) * (Enclosure(2.0 * static_cast<double>(d) * piece_step) +
                              Enclosure(2.0 * largest_rate(segment)));
  const Enclosure rounded =
      Enclosure(2.0) *
      (error_detail::roundings(6 * d + d + 5) * Enclosure(piece_size) +
       error_detail::roundings(6 * PhCurve<A, n>::degree + PhCurve<A, n>::degree + 5) *
           Enclosure(displacement_size) +
       Enclosure(static_cast<double>(16 * degree) * std::numeric_limits<double>::denorm_min()));
  const NormBound bound = largest_norm(difference, (moved + rounded).upper());
  const Enclosure allowance(position_error(segment));
  const double upper = (Enclosure(bound.norm.upper()) + allowance).upper();
  const double lower = std::max(0.0, (Enclosure(bound.norm.lower()) - allowance).lower());
  return {Enclosure(lower, upper), upper < std::numeric_limits<double>::infinity(),
          std::min(xi_end, xi_begin + bound.at * (xi_end - xi_begin))};
}

namespace error_detail {

/// The fault of a list of pieces that does not cover [xi_begin, xi_end], if there is one.
inline std::optional<Fault> cover_fault(std::span<const double> knots, std::size_t pieces,
                                        double xi_begin, double xi_end) {
  if (pieces == 0 || knots.size() != pieces + 1) {
    return Fault{FaultCode::mismatched_size,
                 std::to_string(pieces) + " polynomial pieces need " + std::to_string(pieces + 1) +
                     " knots and at least one piece; got " + std::to_string(knots.size()) +
                     " knots",
                 std::nullopt,
                 "knots",
                 static_cast<double>(knots.size()),
                 static_cast<double>(pieces + 1)};
  }
  for (std::size_t j = 0; j + 1 < knots.size(); ++j) {
    if (!(knots[j] < knots[j + 1])) {
      return Fault{FaultCode::not_increasing,
                   "the knots of the pieces must increase strictly; knot " + std::to_string(j + 1) +
                       " is " + to_text(knots[j + 1]) + " after " + to_text(knots[j]),
                   j + 1,
                   "knots",
                   knots[j + 1],
                   knots[j]};
    }
  }
  if (!(knots.front() <= xi_begin) || !(xi_end <= knots.back())) {
    return Fault{FaultCode::outside_domain,
                 "the path runs over [" + to_text(xi_begin) + ", " + to_text(xi_end) +
                     "], outside the pieces on [" + to_text(knots.front()) + ", " +
                     to_text(knots.back()) + "]",
                 std::nullopt,
                 "xi",
                 xi_begin,
                 knots.front()};
  }
  return std::nullopt;
}

}  // namespace error_detail

/// An enclosure of the largest distance between a path and the curve that is, on [κ_j, κ_{j+1}],
/// pieces[j] in its local parameter (ξ - κ_j)/(κ_{j+1} - κ_j); `knots` are the κ_j. Certified.
/// Faults: mismatched_size, not_increasing, outside_domain (the pieces do not cover the path).
template <std::size_t d, PreimageAlgebra A, std::size_t n>
Result<ErrorBound> piecewise_error(std::span<const double> knots,
                                   std::span<const BernsteinPolynomial<point_t<A>, d>> pieces,
                                   const Path<A, n>& path) {
  if (auto fault =
          error_detail::cover_fault(knots, pieces.size(), path.xi_begin(), path.xi_end())) {
    return *fault;
  }
  ErrorBound total{Enclosure(0.0), true, path.xi_begin()};
  std::size_t j = 0;
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const double begin = path.knots()[k], end = path.knots()[k + 1];
    while (!(begin < knots[j + 1])) ++j;
    for (std::size_t i = j; i < pieces.size() && knots[i] < end; ++i) {
      total =
          larger_error(total, piece_error(pieces[i], knots[i], knots[i + 1], path.segment(k), begin,
                                          std::max(begin, knots[i]), std::min(end, knots[i + 1])));
    }
  }
  return total;
}

}  // namespace hodograph
