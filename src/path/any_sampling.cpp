// SPDX-License-Identifier: MIT
#include "hodograph/path/any_sampling.hpp"

namespace hodograph {

Result<std::vector<double>> parameters_even_in_xi(const AnyPath& path, std::size_t count) {
  return path.visit([&](const auto& p) { return parameters_even_in_xi(p, count); });
}

Result<std::vector<double>> parameters_even_in_arc_length(const AnyPath& path, std::size_t count) {
  return path.visit([&](const auto& p) { return parameters_even_in_arc_length(p, count); });
}

Result<std::vector<double>> parameters_by_arc_length_step(const AnyPath& path, double step) {
  return path.visit([&](const auto& p) { return parameters_by_arc_length_step(p, step); });
}

Result<std::vector<double>> parameters_per_segment(const AnyPath& path, std::size_t count) {
  return path.visit([&](const auto& p) { return parameters_per_segment(p, count); });
}

}  // namespace hodograph
