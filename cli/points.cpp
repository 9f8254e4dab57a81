// SPDX-License-Identifier: MIT
#include "cli/points.hpp"

#include "cli/options.hpp"
#include "cli/refuse.hpp"
#include "cli/requests/members.hpp"
#include "hodograph/io/file.hpp"
#include "hodograph/io/table.hpp"

namespace hodograph::cli {
namespace {

std::vector<Vector2<double>> from_json(const std::string& text, const std::string& name) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) {
    refuse(name + " begins like JSON but cannot be read as a list of points [x, y]", "points");
  }
  const bool named = json.is_object() && json.contains("points");
  const Json& list = named ? json["points"] : json;
  if (!list.is_array()) {
    refuse(name +
               " has no list of points; JSON should be a list of [x, y], alone or as the member "
               "\"points\" of an object",
           "points");
  }
  std::vector<Vector2<double>> points;
  for (const Json& p : list) {
    if (!p.is_array() || p.size() != 2 || !p[0].is_number() || !p[1].is_number()) {
      refuse(name + ", at " + (named ? "/points/" : "/") + std::to_string(points.size()) +
                 ": a point is two numbers [x, y]; here is " + in_quotes(p.dump()),
             "points");
    }
    points.push_back({p[0].get<double>(), p[1].get<double>()});
  }
  return points;
}

std::vector<Vector2<double>> from_table(const Table& table,
                                        const std::vector<std::string>& columns) {
  std::size_t x = 0, y = 1;
  if (!columns.empty()) {
    x = table.column(columns.at(0)).value();
    y = table.column(columns.at(1)).value();
  } else if (const auto named_x = table.column("x"), named_y = table.column("y");
             named_x && named_y) {
    x = *named_x;
    y = *named_y;
  } else if (table.column_count < 2) {
    refuse("a table of points needs two columns; this one has one", "points");
  }
  std::vector<Vector2<double>> points;
  points.reserve(table.row_count());
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    points.push_back({table.at(row, x), table.at(row, y)});
  }
  return points;
}

}  // namespace

void PointsFlags::add_columns_to(Command& command) {
  command
      .option("--columns", columns, "X,Y",
              "columns of the coordinates, by name or number (default: x and y, or the first two)")
      .list(2, 2);
}

std::string PointsFlags::name() const { return input_name(file); }

std::vector<Vector2<double>> PointsFlags::read() const {
  const std::string text = read_file(file).value();
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && (text[first] == '[' || text[first] == '{')) {
    return from_json(text, name());
  }
  return from_table(read_table(text, name()).value(), columns);
}

}  // namespace hodograph::cli
