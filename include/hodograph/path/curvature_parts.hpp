// SPDX-License-Identifier: MIT
// A path cut into parts by arc length, each with a rigorous bound of its curvature: what a speed
// profile and a separation check need to know of a path's shape.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "hodograph/foundation/accuracy.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// Part i lies between arc_lengths[i] and arc_lengths[i + 1]; every segment has `per_segment` parts
/// of equal length in u. Part i of the exact curve of the stored numbers (see path/bounds.hpp) has
/// |κ| ≤ most_curvature[i], rounding included; infinite where the speed may vanish.
struct CurvatureParts {
  std::size_t per_segment = 0;
  std::vector<double> arc_lengths, most_curvature;
  /// No stored arc length is further than this from the exact path's.
  double arc_length_error = 0.0;
};

/// The bounds of one segment's parts, κ ≤ 2 max|V_k|/(h min σ_k²) with V = vec(A* A'), the k-th
/// Bernstein coefficients of each on the part, in Enclosure arithmetic. `preimage` holds the
/// coefficients one after the other, 2 (plane) or 4 (space) numbers each. Domain: n ≤ 30.
void bound_curvature_of_parts(std::span<const double> preimage, std::size_t components, double step,
                              std::span<double> most_curvature);

/// The rounding of arc length along a path: of each segment's polynomial and of their sum.
template <class A, std::size_t n>
double arc_length_rounding(const Path<A, n>& path) {
  double sum = 2.0 * epsilon<double>() * path.arc_length();
  for (const auto& curve : path.segments()) {
    sum += accuracy::arc_length_error<double>(n) * (curve.parameter_step() * curve.speed_bound());
  }
  return sum;
}

/// Cuts every segment into `per_segment` parts. The bounds exceed the largest curvature of a part
/// by an amount that falls with the square of its length. Cost: about a microsecond a part of a
/// planar quintic. Domain: per_segment ≥ 1.
template <class A, std::size_t n>
CurvatureParts curvature_parts(const Path<A, n>& path, std::size_t per_segment) {
  static_assert(n <= 30);
  CurvatureParts parts;
  parts.per_segment = per_segment;
  parts.arc_length_error = arc_length_rounding(path);
  const std::size_t count = path.segment_count() * per_segment;
  parts.arc_lengths.reserve(count + 1);
  parts.most_curvature.resize(count);
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const auto& curve = path.segment(k);
    std::array<double, (n + 1) * A::dimension> numbers;
    for (std::size_t i = 0; i <= n; ++i) {
      for (std::size_t j = 0; j < A::dimension; ++j) {
        numbers[i * A::dimension + j] = curve.preimage()[i][j];
      }
    }
    bound_curvature_of_parts(
        numbers, A::dimension, curve.parameter_step(),
        std::span<double>(parts.most_curvature).subspan(k * per_segment, per_segment));
    for (std::size_t i = 0; i < per_segment; ++i) {
      const double u = static_cast<double>(i) / static_cast<double>(per_segment);
      const double s = i == 0 ? path.knot_arc_lengths()[k]
                              : std::min(path.knot_arc_lengths()[k] + curve.arc_length(u),
                                         path.knot_arc_lengths()[k + 1]);
      parts.arc_lengths.push_back(
          parts.arc_lengths.empty() ? s : std::max(s, parts.arc_lengths.back()));
    }
  }
  parts.arc_lengths.push_back(path.arc_length());
  return parts;
}

}  // namespace hodograph
