// SPDX-License-Identifier: MIT
#include "cli/offsets.hpp"

#include <cmath>
#include <utility>

#include "hodograph/surface/any_offset.hpp"

namespace hodograph::cli {
namespace {

/// The limits of offsets are refined to about this relative width, 2^-40: what people read off.
constexpr double shown_limit_width = 0x1p-40;

}  // namespace

PathOffset offset_of(const AnyPath& path, double distance) {
  PathOffset offset;
  offset.distance = distance;
  for (auto& piece : rational_offset(path, distance).value()) {
    offset.degree = piece.curve.degree();
    offset.segments.push_back(piece.segment);
    offset.pieces.push_back(std::move(piece.curve));
  }
  offset.cusps = offset_cusps(path, distance);
  return offset;
}

CuspFreeOffsets cusp_free_offsets_of(const AnyPath& path) {
  return cusp_free_offsets(path, RangeGoal{shown_limit_width});
}

std::vector<Vector2<double>> offset_points(const AnyPath& path, double distance,
                                           const std::vector<double>& xi) {
  std::vector<double> flat(2 * xi.size());
  offset_positions(path, distance, xi, flat);
  std::vector<Vector2<double>> points(xi.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = {flat[2 * i], flat[2 * i + 1]};
  return points;
}

Json json_of(const PathOffset& offset) {
  Json json;
  json["degree"] = offset.degree;
  Json& pieces = json["pieces"] = Json::array();
  for (std::size_t i = 0; i < offset.pieces.size(); ++i) {
    const RationalBezier& piece = offset.pieces[i];
    Json one = {{"segment", offset.segments[i]}, {"xi", {piece.begin, piece.end}}};
    one["weights"] = piece.weights;
    one["control_points"] = Json::array();
    for (const auto& p : piece.control_points) one["control_points"].push_back(list_of(p));
    pieces.push_back(std::move(one));
  }
  Json& cusps = json["cusps"] = Json::array();
  for (const OffsetCusp& cusp : offset.cusps) {
    cusps.push_back({{"xi", cusp.xi},
                     {"xi_range", json_of(cusp.xi_range)},
                     {"kind", cusp.kind == RootKind::simple ? "simple" : "undecided"}});
  }
  return json;
}

void require_distances(const std::vector<double>& distances) {
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (std::isfinite(distances[i]) && distances[i] != 0.0) continue;
    const bool zero = distances[i] == 0.0;
    throw Error(Fault{zero ? FaultCode::outside_domain : FaultCode::not_finite,
                      "the offset distance is " + to_text(distances[i]) +
                          (zero ? ", whose offset is the path itself; it should be positive (to "
                                  "the left) or negative"
                                : "; it should be a finite number"),
                      i, "distance", distances[i], std::nullopt});
  }
}

}  // namespace hodograph::cli
