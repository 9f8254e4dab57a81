// SPDX-License-Identifier: MIT
// Tables of numbers as text.
#include "hodograph/io/table.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "foreign_text.hpp"
#include "number.hpp"

namespace hodograph {
namespace {

using io_detail::in_quotes;
using io_detail::NumberKind;
using io_detail::parse_number;

constexpr char blank = ' ';
constexpr std::string_view blanks = " \t";
constexpr std::size_t most_columns = 10000;

Fault malformed(std::string sentence, const char* quantity = "table") {
  return {FaultCode::malformed_document, std::move(sentence), std::nullopt, quantity};
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Takes the next line off a text; CR LF, LF and CR end one.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find_first_of("\r\n");
  const std::string_view line = text.substr(0, end);
  if (end == std::string_view::npos) {
    text = {};
  } else {
    text.remove_prefix(end + (text.substr(end, 2) == "\r\n" ? 2 : 1));
  }
  return line;
}

char separator_of(std::string_view line) {
  bool inside_quotes = false;
  bool comma = false, semicolon = false, tab = false;
  for (const char c : line) {
    if (c == '"') inside_quotes = !inside_quotes;
    if (inside_quotes) continue;
    comma = comma || c == ',';
    semicolon = semicolon || c == ';';
    tab = tab || c == '\t';
  }
  return tab ? '\t' : semicolon ? ';' : comma ? ',' : blank;
}

struct Field {
  std::string_view text;  // without blanks and quotes around it
  bool was_quoted = false;
};

/// Splits a line; false where a quote does not close. `storage` is reused.
bool split(std::string_view line, char separator, std::vector<Field>& fields) {
  fields.clear();
  line = separator == blank ? trimmed(line) : line;
  while (true) {
    if (separator == blank) {
      const std::size_t first = line.find_first_not_of(blanks);
      if (first == std::string_view::npos) return true;
      line.remove_prefix(first);
    }
    const std::size_t first = line.find_first_not_of(separator == '\t' ? " " : blanks);
    if (first != std::string_view::npos && line[first] == '"') {
      std::size_t close = first + 1;
      while (close < line.size() && (line[close] != '"' || line.substr(close, 2) == "\"\"")) {
        close += line[close] == '"' ? 2 : 1;
      }
      if (close >= line.size()) return false;
      const std::string_view rest = line.substr(close + 1);
      const std::size_t next =
          separator == blank ? rest.find_first_of(blanks) : rest.find(separator);
      if (!trimmed(rest.substr(0, next)).empty()) return false;
      fields.push_back({trimmed(line.substr(first + 1, close - first - 1)), true});
      if (next == std::string_view::npos) return true;
      line = rest.substr(next + 1);
    } else {
      const std::size_t next =
          separator == blank ? line.find_first_of(blanks) : line.find(separator);
      fields.push_back({trimmed(line.substr(0, next)), false});
      if (next == std::string_view::npos) return true;
      line.remove_prefix(next + 1);
    }
  }
}

std::string unquoted(const Field& field) {
  std::string out;
  for (std::size_t i = 0; i < field.text.size(); ++i) {
    out += field.text[i];
    if (field.was_quoted && field.text.substr(i, 2) == "\"\"") ++i;
  }
  return out;
}

bool is_number_like(const Field& field) {
  return parse_number(field.text).kind != NumberKind::not_a_number;
}

/// Why a field is refused, after "line 3, column 'x': ".
std::string complaint(const Field& field, NumberKind kind, char separator) {
  if (field.text.empty()) return "the field is empty; a number is needed";
  const std::string text = in_quotes(field.text);
  if (kind == NumberKind::too_large) return text + " is beyond the largest double";
  if (kind == NumberKind::not_finite) return text + " is not a finite number";
  std::string with_point(field.text);
  if (separator != ',' && std::count(with_point.begin(), with_point.end(), ',') == 1) {
    with_point[with_point.find(',')] = '.';
    if (parse_number(with_point).kind == NumberKind::finite) {
      return text + " has a decimal comma; write " + with_point;
    }
  }
  return text + " is not a number";
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

/// "Time (TU)" → {"Time ", "TU"}; the unit is empty where there is none.
std::pair<std::string_view, std::string_view> name_and_unit(std::string_view name) {
  name = trimmed(name);
  if (name.empty() || (name.back() != ')' && name.back() != ']')) return {name, {}};
  const std::size_t open = name.rfind(name.back() == ')' ? '(' : '[');
  if (open == std::string_view::npos || open == 0) return {name, {}};
  return {trimmed(name.substr(0, open)), trimmed(name.substr(open + 1, name.size() - open - 2))};
}

}  // namespace

std::string Table::title(std::size_t column) const {
  if (column < names.size() && !names[column].empty()) return in_quotes(names[column]);
  return std::to_string(column + 1);
}

Result<std::size_t> Table::column(std::string_view name) const {
  const std::string wanted = lower_case(trimmed(name));
  std::vector<std::size_t> whole, without_unit;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (lower_case(trimmed(names[i])) == wanted) whole.push_back(i);
    if (lower_case(name_and_unit(names[i]).first) == wanted) without_unit.push_back(i);
  }
  const std::vector<std::size_t>& found = whole.empty() ? without_unit : whole;
  if (found.size() == 1) return found[0];
  if (found.size() > 1) {
    return malformed("two columns are called " + in_quotes(name) + ": number " +
                         std::to_string(found[0] + 1) + " and number " +
                         std::to_string(found[1] + 1) + "; give the number",
                     "column");
  }
  const auto number = parse_number(wanted);
  if (number.kind == NumberKind::finite && number.value >= 1.0 &&
      number.value <= static_cast<double>(column_count) &&
      number.value == std::floor(number.value)) {
    return static_cast<std::size_t>(number.value) - 1;
  }
  std::string there;
  constexpr std::size_t most_listed = 12;
  for (std::size_t i = 0; i < std::min(column_count, most_listed); ++i) {
    there += (i == 0 ? "" : ", ") + title(i);
  }
  if (column_count > most_listed) there += ", ...";
  return malformed("there is no column " + in_quotes(name) + "; the columns are " + there,
                   "column");
}

Result<Table> read_table(std::string_view text, const std::string& source) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    return malformed(source + " is UTF-16; save it as UTF-8");
  }
  Table table;
  std::vector<Field> fields;
  char separator = blank;
  bool first_row = true;
  std::size_t first_line = 0;
  for (std::size_t line_number = 1; !text.empty(); ++line_number) {
    const std::string_view line = take_line(text);
    const std::string_view content = trimmed(line);
    if (content.empty() || content[0] == '#' || content[0] == '%') continue;
    const std::string place = source + ", line ";
    if (line_number > std::numeric_limits<std::uint32_t>::max()) {
      return malformed(source + " has more lines than can be counted");
    }
    if (first_row) separator = separator_of(content);
    if (!split(separator == '\t' ? line : content, separator, fields)) {
      return malformed(place + std::to_string(line_number) +
                       ": a quote is not closed, or text follows it");
    }
    if (first_row) {
      first_row = false;
      first_line = line_number;
      if (fields.size() > most_columns) {
        return malformed(place + std::to_string(line_number) + " has " +
                         std::to_string(fields.size()) + " fields; at most " +
                         std::to_string(most_columns) + " are read");
      }
      table.column_count = fields.size();
      if (std::none_of(fields.begin(), fields.end(), is_number_like)) {
        if (!io_detail::is_utf8(line)) {
          return malformed(place + std::to_string(line_number) + ": the text is not UTF-8");
        }
        std::transform(fields.begin(), fields.end(), std::back_inserter(table.names), unquoted);
        continue;
      }
    }
    if (fields.size() != table.column_count) {
      return malformed(place + std::to_string(line_number) + " has " +
                       std::to_string(fields.size()) + (fields.size() == 1 ? " field" : " fields") +
                       "; line " + std::to_string(first_line) + " has " +
                       std::to_string(table.column_count));
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const auto number = parse_number(fields[i].text);
      if (number.kind != NumberKind::finite) {
        return malformed(place + std::to_string(line_number) + ", column " + table.title(i) + ": " +
                         complaint(fields[i], number.kind, separator));
      }
      table.values.push_back(number.value);
    }
    table.lines.push_back(static_cast<std::uint32_t>(line_number));
  }
  if (table.lines.empty()) {
    return malformed(table.names.empty() ? source + " is empty"
                                         : source + " has a header and no row of numbers");
  }
  return table;
}

void append_csv_row(std::string& out, std::span<const double> row) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) out += ',';
    io_detail::append_number(out, row[i]);
  }
  out += '\n';
}

void append_csv_header(std::string& out, std::span<const std::string> names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) out += ',';
    const std::string& name = names[i];
    if (name.find_first_of(",;\t\"\r\n#%") == std::string::npos) {
      out += name;
      continue;
    }
    out += '"';
    for (const char c : name) {
      if (c == '"') out += '"';
      out += c == '\r' || c == '\n' ? ' ' : c;
    }
    out += '"';
  }
  out += '\n';
}

std::string to_csv(const Table& table) {
  assert(table.values.size() == table.row_count() * table.column_count);
  std::string out;
  if (!table.names.empty()) append_csv_header(out, table.names);
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    append_csv_row(out,
                   std::span(table.values).subspan(row * table.column_count, table.column_count));
  }
  return out;
}

std::string unit_of(std::string_view column_name) {
  return std::string(name_and_unit(column_name).second);
}

Result<CurveSamples> curve_samples(const Table& table, const SampleColumns& columns,
                                   const std::string& source) {
  std::vector<std::size_t> chosen;
  const auto choose = [&](std::string_view name) -> std::optional<Fault> {
    auto found = table.column(name);
    if (!found) {
      Fault fault = found.fault();
      fault.sentence = source + ": " + fault.sentence;
      return fault;
    }
    chosen.push_back(*found);
    return std::nullopt;
  };
  if (table.column_count < 3 && columns.coordinates.empty()) {
    return malformed(source + " has " + std::to_string(table.column_count) +
                     (table.column_count == 1 ? " column" : " columns") +
                     "; a parameter and two or three coordinates are needed");
  }
  if (auto fault = choose(columns.parameter.empty() ? "1" : columns.parameter)) return *fault;
  if (!columns.coordinates.empty()) {
    if (columns.coordinates.size() != 2 && columns.coordinates.size() != 3) {
      return malformed("two or three coordinate columns are needed; got " +
                       std::to_string(columns.coordinates.size()));
    }
    for (const std::string& name : columns.coordinates) {
      if (auto fault = choose(name)) return *fault;
    }
  } else if (table.column("x") && table.column("y")) {
    chosen.push_back(*table.column("x"));
    chosen.push_back(*table.column("y"));
    if (table.column("z")) chosen.push_back(*table.column("z"));
  } else {
    for (std::size_t i = 0; i < table.column_count && chosen.size() < 4; ++i) {
      if (i != chosen[0]) chosen.push_back(i);
    }
  }

  const std::size_t rows = table.row_count();
  if (rows < 2) {
    return Fault{FaultCode::too_few,
                 source + " has one row; a curve needs at least two",
                 std::nullopt,
                 "rows",
                 1.0,
                 2.0};
  }
  CurveSamples samples;
  samples.dimension = chosen.size() - 1;
  if (!table.names.empty()) {
    samples.parameter_unit = unit_of(table.names[chosen[0]]);
    samples.length_unit = unit_of(table.names[chosen[1]]);
  }
  samples.parameters.reserve(rows);
  samples.points.reserve(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    const double parameter = table.at(row, chosen[0]);
    if (row > 0 && !(samples.parameters.back() < parameter)) {
      return Fault{FaultCode::not_increasing,
                   source + ", line " + std::to_string(table.lines[row]) + ": the parameter " +
                       table.title(chosen[0]) + " must increase; " + to_text(parameter) +
                       " follows " + to_text(samples.parameters.back()),
                   row,
                   "parameter",
                   parameter,
                   samples.parameters.back()};
    }
    samples.parameters.push_back(parameter);
    samples.points.push_back({table.at(row, chosen[1]), table.at(row, chosen[2]),
                              chosen.size() > 3 ? table.at(row, chosen[3]) : 0.0});
  }
  return samples;
}

}  // namespace hodograph
