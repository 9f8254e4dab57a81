// SPDX-License-Identifier: MIT
// Bounds of paths whose dimension and degree are known only when the program runs: what
// path/bounds.hpp, torsion.hpp, bending_energy.hpp, self_distance.hpp and curvature_parts.hpp
// offer, for AnyPath. Formulas, domains, faults and accuracy are those of the functions of the same
// names there; what is said here is added. Compiled once, in the library.
//
// All but the first three work in few degrees of the preimage: planar 0, 2, 4 and 12, in space 2,
// 3, 4, 8 and 12. A path of another degree is first written in the next one (with_preimage_degree,
// coefficients to a few ε of the largest), and bounds are those of the path so written.
#pragma once

#include <cstddef>
#include <vector>

#include "hodograph/bernstein/range.hpp"
#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/any_path.hpp"
#include "hodograph/path/curvature_parts.hpp"
#include "hodograph/path/self_distance.hpp"

namespace hodograph {

Enclosure arc_length_enclosure(const AnyPath& path);
Extremes speed_extremes(const AnyPath& path, const RangeGoal& goal);
Extremes curvature_extremes(const AnyPath& path, const RangeGoal& goal);

/// The extremes of each of the 2 or 3 coordinates.
std::vector<Extremes> bounding_box(const AnyPath& path, const RangeGoal& goal);

/// Radians per unit ξ and per unit arc length.
Extremes angular_rate_extremes_per_xi(const AnyPath& path, const RangeGoal& goal);
Extremes angular_rate_extremes_per_arc_length(const AnyPath& path, const RangeGoal& goal);

/// Faults: unsupported (a planar path; a preimage degree above 8). In the degrees 3 and 8.
Result<Extremes> torsion_extremes(const AnyPath& path, const RangeGoal& goal);

/// Faults: also unsupported (in space: a preimage degree above 8). In space in the degrees 3 and 8.
Result<Enclosure> bending_energy_enclosure(const AnyPath& path);
Result<double> bending_energy(const AnyPath& path);

Result<SelfDistance> self_distance(const AnyPath& path, double separation, const RangeGoal& goal);
TubeRadius largest_tube_radius(const AnyPath& path, const RangeGoal& goal);

/// In every degree.
CurvatureParts curvature_parts(const AnyPath& path, std::size_t per_segment);

}  // namespace hodograph
