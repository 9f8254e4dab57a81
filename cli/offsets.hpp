// SPDX-License-Identifier: MIT
// The offsets of a planar path of any degree, as plain numbers: what the subcommand and the request
// "offset" have in common.
#pragma once

#include <cstddef>
#include <vector>

#include "cli/json.hpp"
#include "hodograph/io/dxf.hpp"
#include "hodograph/path/any_path.hpp"
#include "hodograph/surface/offset.hpp"

namespace hodograph::cli {

/// One offset: rational pieces in sequence, each within a segment of the path, and its cusps.
struct PathOffset {
  double distance = 0.0;
  std::size_t degree = 0;
  std::vector<RationalBezier> pieces;
  std::vector<std::size_t> segments;  ///< of the pieces
  std::vector<OffsetCusp> cusps;
};

/// Throws Error: unsupported (a path in space); not_finite (the distance, or an offset beyond the
/// range of numbers); zero_speed.
PathOffset offset_of(const AnyPath& path, double distance);

/// Throws Error (unsupported) for a path in space.
CuspFreeOffsets cusp_free_offsets_of(const AnyPath& path);

/// The points of the offset at these ξ of the path. Throws Error: unsupported, zero_speed,
/// outside_domain.
std::vector<Vector2<double>> offset_points(const AnyPath& path, double distance,
                                           const std::vector<double>& xi);

/// {"degree", "pieces": [{"segment", "xi", "weights", "control_points"}], "cusps": [{"xi",
/// "xi_range", "kind"}]}.
Json json_of(const PathOffset& offset);

/// Throws Error (outside_domain) for a distance of 0, whose offset is the path.
void require_distances(const std::vector<double>& distances);

}  // namespace hodograph::cli
