// SPDX-License-Identifier: MIT
// Where to take the points of a path whose dimension and degree are known only when the program
// runs: what path/sampling.hpp offers, for AnyPath. Formulas, faults and accuracy are those of the
// functions of the same names there. Compiled once, in the library, for every degree.
#pragma once

#include <cstddef>
#include <vector>

#include "hodograph/foundation/result.hpp"
#include "hodograph/path/any_path.hpp"
#include "hodograph/path/sampling.hpp"

namespace hodograph {

Result<std::vector<double>> parameters_even_in_xi(const AnyPath& path, std::size_t count);
Result<std::vector<double>> parameters_even_in_arc_length(const AnyPath& path, std::size_t count);
Result<std::vector<double>> parameters_by_arc_length_step(const AnyPath& path, double step);
Result<std::vector<double>> parameters_per_segment(const AnyPath& path, std::size_t count);
Result<std::vector<double>> polyline_parameters(const AnyPath& path, double tolerance);

}  // namespace hodograph
