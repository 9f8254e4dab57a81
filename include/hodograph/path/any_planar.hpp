// SPDX-License-Identifier: MIT
// Planar paths whose degree is known only when the program runs: what path/rotation_index.hpp,
// signed_area.hpp, planar_curvature.hpp and intersections.hpp offer, for AnyPath. Formulas,
// domains, faults and accuracy are those of the functions of the same names there; what is said
// here is added. Compiled once, in the library.
//
// All throw Error (unsupported) for a path in space, or return it where they return a Result. They
// work in the preimage degrees 0, 2, 4 and 12: a path of another degree is first written in the
// next one (with_preimage_degree, coefficients to a few ε of the largest), and what is certain is
// so for the path so written.
#pragma once

#include <vector>

#include "hodograph/foundation/answer.hpp"
#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/any_path.hpp"
#include "hodograph/path/intersection.hpp"
#include "hodograph/path/planar_curvature.hpp"
#include "hodograph/path/rotation_index.hpp"

namespace hodograph {

/// Both indices of the exact curve of the stored numbers, enclosed, radians.
RotationIndices rotation_index_enclosures(const AnyPath& path);
/// Radians.
double absolute_rotation_index(const AnyPath& path);
double rotation_index(const AnyPath& path);

double signed_area(const AnyPath& path);
Enclosure signed_area_enclosure(const AnyPath& path);

/// None on a path of degree 1 (straight lines).
std::vector<CurvatureStationaryPoint> curvature_stationary_points(const AnyPath& path);
std::vector<Inflection> inflections(const AnyPath& path);
Answer curvature_stays_within(const AnyPath& path, double limit);

/// Both paths are written in the degree of the higher one.
std::vector<PathIntersection> intersections(const AnyPath& first, const AnyPath& second);
std::vector<PathIntersection> self_intersections(const AnyPath& path);
Result<std::vector<LineIntersection>> line_intersections(const AnyPath& path,
                                                         const Vector2<double>& q,
                                                         const Vector2<double>& d);
Result<std::vector<LineIntersection>> segment_intersections(const AnyPath& path,
                                                            const Vector2<double>& a,
                                                            const Vector2<double>& b);

}  // namespace hodograph
