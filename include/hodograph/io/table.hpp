// SPDX-License-Identifier: MIT
// Tables of numbers as text: CSV and its relatives, in and out, and the samples of a curve in one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/foundation/result.hpp"

namespace hodograph {

/// Rows of finite numbers in named columns.
struct Table {
  std::vector<std::string> names;  ///< of the columns, as in the header; empty without a header
  std::size_t column_count = 0;
  std::vector<double> values;        ///< row by row
  std::vector<std::uint32_t> lines;  ///< the line of the text on which each row stands, from 1

  std::size_t row_count() const { return lines.size(); }
  double at(std::size_t row, std::size_t column) const {
    return values[row * column_count + column];
  }
  /// How a column is called in sentences: its name, or its number from 1.
  std::string title(std::size_t column) const;
  /// The column with this name, or with this number from 1. Case, surrounding blanks and a unit in
  /// brackets do not matter: "time" finds "Time (TU)".
  /// Faults: malformed_document, with the columns there are; also where two columns fit.
  Result<std::size_t> column(std::string_view name) const;
};

/// A table from text. Fields are separated by commas, semicolons, tabs or blanks: whichever the
/// first row uses (a tab before a semicolon before a comma before blanks). Fields may be quoted (""
/// is a quote inside). A first row without any number is the header. Empty lines and lines that
/// start with # or % are skipped; CR LF, CR and a byte order mark are understood. Numbers are
/// decimal with a point, and are rounded correctly, also below the range of normal numbers.
///
/// Faults: malformed_document, with the line and the column: a field that is no number, is infinite
/// or not a number; a row with too few or too many fields; no row at all; text that is not UTF-8.
/// `source` is how sentences call the text, for example the file's name.
Result<Table> read_table(std::string_view text, const std::string& source = "the table");

/// The table as CSV: a header if it has names, numbers as the shortest decimals that read back to
/// the same doubles.
std::string to_csv(const Table& table);

/// One line of CSV: the numbers, shortest decimals, and a line feed, appended to `out`.
void append_csv_row(std::string& out, std::span<const double> row);
/// One line of CSV with the names of the columns, quoted where needed.
void append_csv_header(std::string& out, std::span<const std::string> names);

/// The unit a name states in brackets: "TU" of "Time (TU)"; empty where there is none.
std::string unit_of(std::string_view column_name);

/// Which columns of a table are the parameter and the coordinates, by name or by number from 1.
/// Left empty: the parameter is the first column; the coordinates are the columns named x, y and z
/// if they exist, else the second, third and (where there is one) fourth column.
struct SampleColumns {
  std::string parameter;
  std::vector<std::string> coordinates;  ///< two or three, or none
};

/// Points of a curve at increasing parameters, with what the table said about their units.
struct CurveSamples {
  std::vector<double> parameters;
  std::vector<Vector3<double>> points;  ///< z = 0 where the dimension is 2
  std::size_t dimension = 3;            ///< 2 or 3
  std::string parameter_unit, length_unit;
};

/// The samples that a table holds. Domain: at least two rows.
/// Faults: malformed_document (a column that is missing), too_few, not_increasing (with the row's
/// index; the sentence has its line).
Result<CurveSamples> curve_samples(const Table& table, const SampleColumns& columns = {},
                                   const std::string& source = "the table");

}  // namespace hodograph
