// SPDX-License-Identifier: MIT
// What a planar path is beyond what every path is: how it turns, bends, and what it goes round,
// each enclosed.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "cli/json.hpp"
#include "hodograph/bernstein/range.hpp"
#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/path/any_path.hpp"
#include "hodograph/path/intersection.hpp"

namespace hodograph::cli {

/// A place where the curvature vanishes or is stationary.
struct CurvaturePlace {
  double xi = 0.0;
  Enclosure xi_range, curvature;
  std::string_view kind;
};

struct PlanarFacts {
  Enclosure rotation_index, absolute_rotation_index;  ///< ∫κ ds and ∫|κ| ds
  std::optional<Enclosure> bending_energy;            ///< none where the path may stand still
  Enclosure signed_area;
  Enclosure smallest_curvature, largest_curvature;  ///< signed
  Enclosure offset_limit_left, offset_limit_right;  ///< distances of offsets without a cusp
  std::vector<CurvaturePlace> inflections, curvature_extremes;
  std::vector<PathIntersection> self_intersections;
};

/// Nothing for a path in space.
std::optional<PlanarFacts> planar_facts_of(const AnyPath& path);

/// "yes", "no" or "undecided" (within rounding): whether |curvature| ≤ limit everywhere on a planar
/// path.
std::string_view keeps_curvature_limit(const AnyPath& path, double limit);

Json json_of(const PlanarFacts& facts);
/// A place where two paths meet: xi, other_xi, their ranges, the point and the kind.
Json json_of(const PathIntersection& at);
/// "crossing" or "undecided".
const char* name_of(IntersectionKind kind);

}  // namespace hodograph::cli
