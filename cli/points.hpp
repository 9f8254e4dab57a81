// SPDX-License-Identifier: MIT
// Points of the plane from a file: CSV or JSON; and the options that name it.
#pragma once

#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "hodograph/algebra/vector.hpp"

namespace hodograph::cli {

/// The points that a command takes.
struct PointsFlags {
  std::string file;                  ///< "-": standard input
  std::vector<std::string> columns;  ///< none, or two

  /// The option --columns.
  void add_columns_to(Command& command);
  /// What sentences call the file.
  std::string name() const;
  /// The points, in order. JSON: a list of [x, y], alone or as the member "points" of an object.
  /// CSV: the columns named x and y if they exist, else the first two; or the two `columns`, by
  /// name or number. Throws Error: malformed_document, with the line or the JSON pointer.
  std::vector<Vector2<double>> read() const;
};

}  // namespace hodograph::cli
