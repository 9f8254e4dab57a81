// SPDX-License-Identifier: MIT
#include "hodograph/surface/any_offset.hpp"

#include <algorithm>
#include <string>

#include "hodograph/path/any_bounds.hpp"
#include "hodograph/path/detail/any_degree.hpp"

namespace hodograph {

namespace {

bool is_finite(const RationalBezier& curve) {
  return std::all_of(curve.weights.begin(), curve.weights.end(),
                     [](double w) { return std::isfinite(w); }) &&
         std::all_of(
             curve.control_points.begin(), curve.control_points.end(),
             [](const Vector2<double>& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

template <std::size_t n>
RationalBezier bezier_of(const OffsetPiece<n>& piece) {
  const auto points = piece.curve.control_points();
  const auto& weights = piece.curve.weight.coefficients();
  return {piece.xi_begin,
          piece.xi_end,
          {points.begin(), points.end()},
          {weights.begin(), weights.end()}};
}

template <std::size_t n>
Result<std::vector<RationalOffsetPiece>> pieces_of(const PlanarPath<n>& path, double distance) {
  const auto offset = rational_offset(path, distance);
  if (!offset) return offset.fault();
  std::vector<RationalOffsetPiece> pieces;
  pieces.reserve(offset->size());
  for (const auto& piece : *offset) {
    pieces.push_back({piece.segment, bezier_of(piece)});
    if (!is_finite(pieces.back().curve)) {
      return Fault{FaultCode::not_finite,
                   "the offset at " + to_text(distance) + " of segment " +
                       std::to_string(piece.segment) + " exceeds the range of numbers",
                   piece.segment,
                   "distance",
                   distance,
                   std::nullopt};
    }
  }
  return pieces;
}

}  // namespace

Result<std::vector<RationalOffsetPiece>> rational_offset(const AnyPath& path, double distance) {
  if (path.dimension() != 2) return path_detail::of_other_dimension("an offset", 3);
  using namespace path_detail;
  return in_degree<Planar, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, maximum_dynamic_degree>(
      path, [&](const auto& p) { return pieces_of(p, distance); });
}

CuspFreeOffsets cusp_free_offsets(const AnyPath& path, const RangeGoal& goal) {
  if (path.dimension() != 2) throw Error(path_detail::of_other_dimension("an offset", 3));
  return cusp_free_offsets(curvature_extremes(path, goal));
}

void offset_positions(const AnyPath& path, double distance, std::span<const double> xi,
                      std::span<double> points) {
  if (points.size() != 2 * xi.size()) {
    throw Error(Fault{FaultCode::mismatched_size,
                      std::to_string(xi.size()) + " points have twice as many coordinates; got " +
                          std::to_string(points.size()),
                      std::nullopt, "points", static_cast<double>(points.size()),
                      static_cast<double>(2 * xi.size())});
  }
  path.visit([&]<class P>(const P& p) {
    if constexpr (P::Point::dimension == 2) {
      for (std::size_t i = 0; i < xi.size(); ++i) {
        const Vector2<double> point = offset_position(p, xi[i], distance);
        points[2 * i] = point.x;
        points[2 * i + 1] = point.y;
      }
    } else {
      throw Error(path_detail::of_other_dimension("an offset", 3));
    }
  });
}

}  // namespace hodograph
