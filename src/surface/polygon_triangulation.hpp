// SPDX-License-Identifier: MIT
// The inside of a simple polygon as triangles.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hodograph/algebra/vector.hpp"

namespace hodograph::surface_detail {

/// n - 2 triangles between the corners of a simple polygon that runs counterclockwise, each
/// counterclockwise, without further points; nothing where the polygon is not simple beyond
/// rounding. Ear clipping, every other ear first: n times the number of reflex corners in time.
std::optional<std::vector<std::array<std::uint32_t, 3>>> triangulated(
    std::span<const Vector2<double>> corners);

}  // namespace hodograph::surface_detail
