// SPDX-License-Identifier: MIT
// The path above a plan whose degree is known only when the program runs, and the plan below a
// helical segment: what construction/lift.hpp and path/helix.hpp offer, for AnyPath. Formulas,
// faults and accuracy are those of the functions of the same names there; what is said here is
// added. Compiled once, in the library, for every degree.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodograph/algebra/complex.hpp"
#include "hodograph/algebra/quaternion.hpp"
#include "hodograph/algebra/vector.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/any_path.hpp"

namespace hodograph {

/// The path above a planar path from an altitude on, with one slope (the tangent of the climb
/// angle) for each segment. Faults: also unsupported (a path in space).
Result<AnyPath> lifted(const AnyPath& plan, double altitude, std::span<const double> slopes);

/// HelicalDecomposition of one segment; `plan` holds the Bernstein coefficients of w.
struct HelicalPlan {
  Vector3<double> axis{0.0, 0.0, 1.0};
  double sine = 0.0, cosine = 1.0;  ///< of the climb angle
  Quaternion<double> upright{1.0, 0.0, 0.0, 0.0};
  std::vector<Complex<double>> plan{};
  double roll = 0.0;      ///< radians
  double residual = 0.0;  ///< in units of the largest |A_i|
};

/// Faults: also unsupported (a planar path), outside_domain (a segment that the path does not
/// have).
Result<HelicalPlan> helical_decomposition(const AnyPath& path, std::size_t segment,
                                          const Vector3<double>& axis);

}  // namespace hodograph
