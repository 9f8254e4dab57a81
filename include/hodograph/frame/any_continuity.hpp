// SPDX-License-Identifier: MIT
// How smooth a path and its frame are whose dimension and degree are known only when the program
// runs: what path/continuity.hpp, frame/continuity.hpp, holonomy.hpp and frenet.hpp offer, for
// AnyPath. Formulas, domains, faults and accuracy are those of the functions of the same names
// there; what is said here is added. Compiled once, in the library, for every degree.
#pragma once

#include <cstddef>
#include <optional>

#include "hodograph/foundation/result.hpp"
#include "hodograph/frame/continuity.hpp"
#include "hodograph/frame/frenet.hpp"
#include "hodograph/frame/holonomy.hpp"
#include "hodograph/path/any_path.hpp"

namespace hodograph {

PathContinuity<double> continuity(const AnyPath& path);
FrameContinuity<double> frame_continuity(const AnyPath& path);

/// Faults: outside_domain (no segments meet at a knot of this number).
Result<KnotJumps<double>> jumps_at_knot(const AnyPath& path, std::size_t k);
Result<FrameKnotJumps<double>> frame_jumps_at_knot(const AnyPath& path, std::size_t k);

/// Faults: also unsupported (a planar path).
Result<Holonomy<double>> holonomy(const AnyPath& path);
Result<LinearRoll<double>> closing_roll(const AnyPath& path);

/// Throws Error: also unsupported (a planar path).
std::optional<FrenetState<double>> frenet(const AnyPath& path, double xi);

}  // namespace hodograph
