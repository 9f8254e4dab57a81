// SPDX-License-Identifier: MIT
// Points of the plane from a file: CSV or JSON.
#pragma once

#include <string>
#include <vector>

#include "hodograph/algebra/vector.hpp"

namespace hodograph::cli {

/// The points of a file ("-": standard input), in order.
/// JSON: a list of [x, y], alone or as the member "points" of an object. CSV: the columns named x
/// and y if they exist, else the first two; or the two `columns`, by name or number.
/// Throws Error: malformed_document, with the line or the JSON pointer.
std::vector<Vector2<double>> read_points(const std::string& file,
                                         const std::vector<std::string>& columns = {});

}  // namespace hodograph::cli
