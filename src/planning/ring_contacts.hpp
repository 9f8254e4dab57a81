// SPDX-License-Identifier: MIT
// Do the rings of one polygon bound a region? And how sentences call obstacles and rings.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hodograph/foundation/fault.hpp"
#include "hodograph/planning/world.hpp"

namespace hodograph::planning_detail {

/// "obstacle 3 ('shed')" or "the bounds". Control characters of the name are shown as '?', and a
/// long name is cut.
std::string obstacle_text(std::uint32_t obstacle, const std::string& name);
/// ", outer ring", ", hole 2"; nothing for the bounds.
std::string ring_text(std::uint32_t obstacle, std::uint32_t ring);

/// The fault of rings (outer one first; each cleaned, the solid to its left) that do not bound a
/// region together: rings that cross, turn straight back or leave walls without thickness, holes
/// outside. Where rings touch, the solid sectors of two passes through the point must not overlap,
/// or the free ones: then the winding number takes two neighbouring values, solid and free.
/// The bounds, solid outside, come as clockwise. Contacts found are appended.
std::optional<Fault> ring_conflict(const std::vector<const Ring*>& rings, const World& world,
                                   std::uint32_t obstacle, std::vector<RingContact>& contacts);

}  // namespace hodograph::planning_detail
