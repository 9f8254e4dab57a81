// SPDX-License-Identifier: MIT
// The powered ascent in the coordinates of the orbit's path: progress and offset take the place of
// the position, and arriving is η = 0.
#pragma once

#include "hodograph/control/powered_ascent.hpp"

namespace hodograph {

/// The problem of powered_ascent, with the state (ξ, η₂, η₃, v) of path_coordinates.hpp, time
/// independent: the same motion, constraints, objective and steps; the end is η = 0 with the
/// orbit's velocity, at a ξ that is free.
///
/// From the same guesses it needs about as many iterations as rectangular coordinates, or fewer:
/// the orbit is a straight line in these. Regular as long as h > 0; the orbit's tube, 7992 km,
/// holds all the Moon at the orbit's lowest point. Faults: those of powered_ascent.
Result<PoweredAscent> powered_ascent_along_path(const AscentReference& reference,
                                                const AscentStart& start,
                                                const PoweredOptions& options = {});

}  // namespace hodograph
