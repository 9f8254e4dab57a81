// SPDX-License-Identifier: MIT
// Pictures of swarms: the paths, the separations of pairs in time, and the flight as an animation.
#pragma once

#include <string>

#include "cli/swarms.hpp"
#include "hodograph/io/svg.hpp"

namespace hodograph::cli {

/// The paths as seen from above, and the distances of the closest pairs against time.
Plot path_picture(const SwarmFacts& facts);
Plot pair_picture(const SwarmFacts& facts);

/// The flight as seen from above, again and again, as an SVG file that moves by itself; vehicles
/// that are too close to another are marked while they are.
std::string animated_svg(const SwarmFacts& facts);

/// The same in an HTML page with a slider; it needs nothing but itself.
std::string animated_html(const SwarmFacts& facts);

}  // namespace hodograph::cli
