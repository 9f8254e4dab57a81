// SPDX-License-Identifier: MIT
#include "cli/offsets.hpp"

#include <cmath>
#include <optional>
#include <type_traits>

namespace hodograph::cli {
namespace {

/// The limits of offsets are refined to about this relative width, 2^-40: what people read off.
constexpr double shown_width = 0x1p-40;

[[noreturn]] void refuse_space() {
  throw Error(Fault{FaultCode::unsupported,
                    "the path is in space; only a path in the plane has offsets", std::nullopt,
                    "dimension", 3.0, 2.0});
}

/// Calls `function` with the planar path that is held. Throws Error (unsupported) for another.
template <class Function>
auto with_planar(const AnyPath& path, const Function& function) {
  using Returned = std::invoke_result_t<Function, const PlanarPath<1>&>;
  return path.visit([&](const auto& p) -> Returned {
    using P = std::remove_cvref_t<decltype(p)>;
    if constexpr (P::Point::dimension == 2) {
      return function(p);
    } else {
      refuse_space();
    }
  });
}

bool is_finite(const RationalBezier& piece) {
  for (std::size_t i = 0; i < piece.weights.size(); ++i) {
    const auto& p = piece.control_points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(piece.weights[i]))
      return false;
  }
  return true;
}

template <std::size_t n>
PathOffset offset_of_planar(const PlanarPath<n>& path, double distance) {
  PathOffset offset;
  offset.distance = distance;
  offset.degree = offset_degree(n);
  for (const auto& piece : rational_offset(path, distance).value()) {
    offset.pieces.push_back(rational_bezier(piece));
    offset.segments.push_back(piece.segment);
    if (!is_finite(offset.pieces.back())) {
      throw Error(Fault{FaultCode::not_finite,
                        "the offset at " + to_text(distance) + " of segment " +
                            std::to_string(piece.segment) + " exceeds the range of numbers",
                        piece.segment, "distance", distance, std::nullopt});
    }
  }
  offset.cusps = offset_cusps(path, distance);
  return offset;
}

}  // namespace

PathOffset offset_of(const AnyPath& path, double distance) {
  return with_planar(path, [&](const auto& p) { return offset_of_planar(p, distance); });
}

CuspFreeOffsets cusp_free_offsets_of(const AnyPath& path) {
  return with_planar(path,
                     [](const auto& p) { return cusp_free_offsets(p, RangeGoal{shown_width}); });
}

std::vector<Vector2<double>> offset_points(const AnyPath& path, double distance,
                                           const std::vector<double>& xi) {
  return with_planar(path, [&](const auto& p) {
    std::vector<Vector2<double>> points;
    points.reserve(xi.size());
    for (const double at : xi) points.push_back(offset_position(p, at, distance));
    return points;
  });
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
