// SPDX-License-Identifier: MIT
// The nearest point of a path whose dimension and degree are known only when the program runs: what
// path/nearest_point.hpp offers, for AnyPath. Formulas, faults and accuracy are those of the
// functions of the same names there; what is said here is added. Compiled once, in the library, in
// few degrees of the preimage: planar 0, 2, 4 and 12, in space 2, 3, 4, 8 and 12; a path of another
// degree is first written in the next one, to a few ε.
#pragma once

#include <span>
#include <vector>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/any_path.hpp"
#include "hodograph/path/nearest_point.hpp"

namespace hodograph {

/// The local extremes of the distance from q, ascending in ξ; a point of a planar path has z = 0.
/// Faults: also mismatched_size (q has another dimension than the path).
Result<std::vector<StationaryPoint<Vector3<double>>>> stationary_points(const AnyPath& path,
                                                                        std::span<const double> q);

/// The nearest point; of a planar path it has z = 0. Faults: also mismatched_size.
Result<NearestPoint<Vector3<double>>> nearest_point(const AnyPath& path, std::span<const double> q);

}  // namespace hodograph
