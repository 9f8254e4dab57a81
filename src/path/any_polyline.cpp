// SPDX-License-Identifier: MIT
// Of hodograph/path/any_sampling.hpp the polylines within a tolerance.
#include "hodograph/path/any_sampling.hpp"

namespace hodograph {

Result<std::vector<double>> polyline_parameters(const AnyPath& path, double tolerance) {
  return path.visit([&](const auto& p) { return polyline_parameters(p, tolerance); });
}

}  // namespace hodograph
