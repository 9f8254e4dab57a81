// SPDX-License-Identifier: MIT
// The path document as text, written straight from the path's numbers.
#include <array>
#include <cassert>
#include <cmath>
#include <span>
#include <utility>

#include "foreign_text.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/io/file.hpp"
#include "number.hpp"

namespace hodograph {
namespace {

using io_detail::append_number;
using io_detail::utf8_length;

void append_string(std::string& out, std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  constexpr unsigned char first_printable = 0x20;
  out += '"';
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const auto first = static_cast<unsigned char>(text[0]);
    if (length == 0) {
      out += "\xef\xbf\xbd";  // U+FFFD
    } else if (first == '"' || first == '\\') {
      out += '\\';
      out += text[0];
    } else if (first == '\n') {
      out += "\\n";
    } else if (first < first_printable) {
      out += "\\u00";
      out += digits[first >> 4U];
      out += digits[first & 0xfU];
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  out += '"';
}

void append_array(std::string& out, std::span<const double> numbers) {
  out += '[';
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) out += ", ";
    append_number(out, numbers[i]);
  }
  out += ']';
}

/// Writes the members of objects, with commas and indentation.
class Writer {
 public:
  explicit Writer(std::string& out) : out_(out) { open(); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void text(std::string_view key, std::string_view value) {
    member(key);
    append_string(out_, value);
  }
  void optional_text(std::string_view key, std::string_view value) {
    if (!value.empty()) text(key, value);
  }
  void truth(std::string_view key, bool value) {
    member(key);
    out_ += value ? "true" : "false";
  }
  void number(std::string_view key, double value) {
    member(key);
    append_number(out_, value);
  }
  void optional_number(std::string_view key, const std::optional<double>& value) {
    if (value && std::isfinite(*value)) number(key, *value);
  }
  void enclosure(std::string_view key, const std::optional<Enclosure>& value) {
    if (!value || !is_finite(*value)) return;
    begin(key);
    ends(*value);
    end();
  }
  void ends(const Enclosure& value) {
    number("lower", value.lower());
    number("upper", value.upper());
  }
  void numbers(std::string_view key, std::span<const double> values) {
    member(key);
    append_array(out_, values);
  }
  /// A list of rows of numbers, one a line.
  template <class Rows, class Numbers>
  void rows(std::string_view key, const Rows& rows, const Numbers& numbers_of) {
    member(key);
    out_ += '[';
    bool first = true;
    for (const auto& row : rows) {
      out_ += first ? "\n" : ",\n";
      first = false;
      out_.append(2 * depth_ + 2, ' ');
      append_array(out_, numbers_of(row));
    }
    if (!first) {
      out_ += '\n';
      out_.append(2 * depth_, ' ');
    }
    out_ += ']';
  }
  void begin(std::string_view key) {
    member(key);
    open();
  }
  void end() {
    --depth_;
    out_ += '\n';
    out_.append(2 * depth_, ' ');
    out_ += '}';
    first_ = false;
  }
  /// Starts a member; its value is to be appended to the text.
  void member(std::string_view key) {
    out_ += first_ ? "\n" : ",\n";
    first_ = false;
    out_.append(2 * depth_, ' ');
    append_string(out_, key);
    out_ += ": ";
  }

 private:
  void open() {
    out_ += '{';
    ++depth_;
    first_ = true;
  }
  std::string& out_;
  std::size_t depth_ = 0;
  bool first_ = true;
};

void append_knots(std::string& out, std::span<const double> knots) {
  constexpr std::size_t knots_a_line = 8;
  out += '[';
  for (std::size_t k = 0; k < knots.size(); k += knots_a_line) {
    out += k == 0 ? "\n    " : ",\n    ";
    for (std::size_t i = k; i < std::min(knots.size(), k + knots_a_line); ++i) {
      if (i > k) out += ", ";
      append_number(out, knots[i]);
    }
  }
  out += "\n  ]";
}

void append_segments(std::string& out, const PathNumbers& numbers) {
  const std::size_t components = numbers.components_per_coefficient();
  const std::size_t coefficients = numbers.preimage_degree + 1;
  const std::span<const double> starts = numbers.starts, preimages = numbers.preimages;
  out += '[';
  for (std::size_t k = 0; k + 1 < numbers.knots.size(); ++k) {
    out += k == 0 ? "\n    {\"start\": " : ",\n    {\"start\": ";
    append_array(out, starts.subspan(k * numbers.dimension, numbers.dimension));
    out += ", \"preimage\": [";
    for (std::size_t i = 0; i < coefficients; ++i) {
      if (i > 0) out += ", ";
      append_array(out, preimages.subspan((k * coefficients + i) * components, components));
    }
    out += "]}";
  }
  out += "\n  ]";
}

void write_clearance(Writer& json, const ClearancePromise& clearance) {
  json.begin("clearance");
  json.optional_text("world", clearance.world);
  json.number("reach", clearance.reach);
  json.rows("obstacles", clearance.obstacles, [](const ObstacleDistance& row) {
    return std::array{static_cast<double>(row.obstacle), row.distance.lower(),
                      row.distance.upper()};
  });
  json.enclosure("bounds", clearance.bounds);
  json.end();
}

void write_helix(Writer& json, const HelixPromise& helix) {
  json.begin("helix");
  json.begin("axis");
  json.number("x", helix.axis.x);
  json.number("y", helix.axis.y);
  json.number("z", helix.axis.z);
  json.end();
  json.rows("sines", helix.sines, [](const HelixSine& row) {
    return std::array{static_cast<double>(row.first_segment), row.sine.lower(), row.sine.upper()};
  });
  json.end();
}

void write_promises(Writer& json, const Promises& promises, std::size_t dimension) {
  json.begin("promises");
  if (const auto& orders = promises.continuity) {
    json.begin("continuity");
    json.number("position", orders->position);
    json.number("preimage", orders->preimage);
    json.number("frame", orders->frame);
    json.number("angular_velocity", orders->angular_velocity);
    json.end();
  }
  if (promises.error && is_finite(promises.error->distance)) {
    json.begin("error");
    json.ends(promises.error->distance);
    json.truth("certified", promises.error->certified);
    json.optional_text("against", promises.error->against);
    json.end();
  }
  json.enclosure("arc_length", promises.arc_length);
  json.enclosure("smallest_speed", promises.smallest_speed);
  json.enclosure("largest_speed", promises.largest_speed);
  json.optional_number("curvature_bound", promises.curvature_bound);
  if (promises.end && is_finite(*promises.end)) {
    const std::array numbers{promises.end->x, promises.end->y, promises.end->z};
    json.numbers("end", std::span(numbers).first(dimension));
  }
  json.enclosure("largest_curvature", promises.largest_curvature);
  if (promises.clearance) write_clearance(json, *promises.clearance);
  if (promises.helix) write_helix(json, *promises.helix);
  json.end();
}

}  // namespace

std::string to_json(const PathDocument& document) {
  std::string out;
  Writer json(out);
  json.text("format", document_format);
  json.number("version", document_version);
  json.optional_text("name", document.name);
  if (!document.length_unit.empty() || !document.parameter_unit.empty()) {
    json.begin("units");
    json.optional_text("length", document.length_unit);
    json.optional_text("parameter", document.parameter_unit);
    json.end();
  }
  if (const Provenance& from = document.provenance; !from.empty()) {
    json.begin("provenance");
    json.optional_text("program", from.program);
    json.optional_text("source", from.source);
    json.optional_text("method", from.method);
    json.optional_text("choice", from.choice);
    json.optional_number("tolerance", from.tolerance);
    json.end();
  }
  if (!document.promises.empty()) {
    write_promises(json, document.promises, document.path.dimension());
  }
  if (const auto& roll = document.roll) {
    assert(std::isfinite(roll->xi_begin) && std::isfinite(roll->theta_begin) &&
           std::isfinite(roll->rate));
    json.begin("frame");
    json.begin("roll");
    json.text("kind", "linear");
    json.number("xi_begin", roll->xi_begin);
    json.number("theta_begin", roll->theta_begin);
    json.number("rate", roll->rate);
    json.end();
    json.end();
  }
  const PathNumbers numbers = document.path.numbers();
  json.text("algebra", numbers.dimension == 2 ? "complex" : "quaternion");
  json.number("preimage_degree", static_cast<double>(numbers.preimage_degree));
  json.truth("closed", numbers.closed);
  json.member("knots");
  append_knots(out, numbers.knots);
  json.member("segments");
  append_segments(out, numbers);
  json.end();
  out += '\n';
  return out;
}

std::optional<Fault> save_document(const PathDocument& document, const std::string& path) {
  auto file =
      OutputFile::create(path);  // before the work: a name that cannot be written costs none
  if (!file) return file.fault();
  file->write(to_json(document));
  return file->commit();
}

}  // namespace hodograph
