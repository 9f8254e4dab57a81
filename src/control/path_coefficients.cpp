// SPDX-License-Identifier: MIT
#include "path_coefficients.hpp"

namespace hodograph::control_detail {

std::vector<double> integral_coefficients(const AnyPath& path) {
  std::vector<double> result;
  path.visit([&result](const auto& known) {
    for (const auto& curve : known.segments()) {
      for (const auto& c : curve.integral().coefficients()) {
        for (std::size_t i = 0; i < c.dimension; ++i) result.push_back(c[i]);
      }
    }
  });
  return result;
}

}  // namespace hodograph::control_detail
