// SPDX-License-Identifier: MIT
// Reads a path document as a stream of JSON events: no tree is built, every event is checked where
// it happens, and the first thing wrong ends the reading.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "document_members.hpp"
#include "foreign_text.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/io/file.hpp"

namespace hodograph {
namespace {

using io_detail::document_members;
using io_detail::find_member;
using io_detail::in_quotes;
using io_detail::Member;
using io_detail::MemberKind;

using Value = std::variant<std::monostate, bool, double, std::string>;
using Values = std::map<std::string, Value, std::less<>>;

std::string_view name_of(MemberKind kind) {
  switch (kind) {
    case MemberKind::text:
      return "a string";
    case MemberKind::truth:
      return "true or false";
    case MemberKind::whole_number:
      return "a whole number";
    case MemberKind::number:
      return "a number";
    case MemberKind::object:
      return "an object";
    case MemberKind::knots:
    case MemberKind::segments:
    case MemberKind::rows:
    case MemberKind::point:
      return "an array";
  }
  return "";
}

std::string escaped(std::string_view key) {  // RFC 6901
  std::string out;
  for (const char c : key) {
    if (c == '~') {
      out += "~0";
    } else if (c == '/') {
      out += "~1";
    } else {
      out += c;
    }
  }
  return out;
}

/// The fault of a place in the document.
Fault at_pointer(const std::string& source, const std::string& pointer, const std::string& what,
                 FaultCode code = FaultCode::malformed_document) {
  const std::string place = pointer.empty() ? ": " : ", at " + [&] {
    const std::string shown = in_quotes(pointer);
    return shown.substr(1, shown.size() - 2);
  }() + ": ";
  return {code, source + place + what, std::nullopt, pointer};
}

/// Receives the events of nlohmann's parser; a member function that returns false stops it.
class EventHandler {
 public:
  EventHandler(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  // ---- scalars -------------------------------------------------------------------------------
  bool null() { return scalar(Value{}, "null"); }
  bool boolean(bool value) { return scalar(value, value ? "true" : "false"); }
  bool number_integer(std::int64_t value) {
    // A negative literal whose value is 0 was "-0".
    return number(value == 0 ? -0.0 : static_cast<double>(value));
  }
  bool number_unsigned(std::uint64_t value) { return number(static_cast<double>(value)); }
  bool number_float(double value, const std::string&) { return number(value); }
  bool string(std::string& value) { return scalar(std::move(value), "a string"); }
  bool binary(std::vector<std::uint8_t>&) { return fail("a number or a string is needed"); }

  // ---- structure -----------------------------------------------------------------------------
  bool start_object(std::size_t) {
    if (levels_.empty()) {
      levels_.push_back({});
      return true;
    }
    if (bulk_ == MemberKind::segments && levels_.size() == 2) {
      levels_.push_back({});
      has_start_ = has_preimage_ = false;
      return true;
    }
    if (bulk_ != MemberKind::object) return wrong_bulk_type("an object");
    const Member* member = current_member();
    if (member == nullptr) return false;
    if (member->kind != MemberKind::object) return wrong_type(*member, "an object");
    values_.emplace(pointer(), Value{});
    levels_.push_back({});
    return true;
  }

  bool key(std::string& name) {
    Level& level = levels_.back();
    level.key = escaped(name);
    if (bulk_ == MemberKind::segments) {
      bool* const seen = name == "start"      ? &has_start_
                         : name == "preimage" ? &has_preimage_
                                              : nullptr;
      if (seen == nullptr) {
        return fail("this member is unknown; a segment has \"start\" and \"preimage\"");
      }
      if (std::exchange(*seen, true)) return fail("this member stands here twice");
      return true;
    }
    if (values_.contains(pointer())) return fail("this member stands here twice");
    return true;
  }

  bool end_object() {
    levels_.pop_back();
    if (bulk_ == MemberKind::segments) {
      if (!has_start_) return fail("the segment has no \"start\"");
      if (!has_preimage_) return fail("the segment has no \"preimage\"");
    }
    next_element();
    return true;
  }

  bool start_array(std::size_t) {
    if (levels_.empty()) return not_an_object("an array");
    if (bulk_ == MemberKind::object) {
      const Member* member = current_member();
      if (member == nullptr) return false;
      if (member->kind != MemberKind::knots && member->kind != MemberKind::segments &&
          member->kind != MemberKind::rows && member->kind != MemberKind::point) {
        return wrong_type(*member, "an array");
      }
      values_.emplace(pointer(), Value{});
      bulk_ = member->kind;
    } else if (!(bulk_ == MemberKind::segments &&
                 (levels_.size() == 3 || (levels_.size() == 4 && in_preimage()))) &&
               !(bulk_ == MemberKind::rows && levels_.size() == rows_depth)) {
      return wrong_bulk_type("an array");
    }
    Level level;
    level.is_array = true;
    levels_.push_back(level);
    return true;
  }

  bool end_array() {
    const std::size_t count = levels_.back().index;
    levels_.pop_back();
    if (bulk_ == MemberKind::point) {
      bulk_ = MemberKind::object;
      return true;
    }
    if (bulk_ == MemberKind::rows) {
      if (levels_.size() < rows_depth) {
        bulk_ = MemberKind::object;
        return true;
      }
      return count == numbers_a_row ? next_element()
                                    : fail(std::string(row_words()) + " are needed; got " +
                                           std::to_string(count) + " numbers");
    }
    if (levels_.size() == 1) {
      bulk_ = MemberKind::object;
    } else if (levels_.size() == 4) {
      return fits(count, components_, "a preimage coefficient", "number") && next_element();
    } else if (in_preimage()) {
      return fits(count, coefficients_, "the preimage", "coefficient");
    } else {
      return fits(count, dimension_, "the start", "coordinate");
    }
    return true;
  }

  // ---- broken JSON ---------------------------------------------------------------------------
  bool parse_error(std::size_t position, const std::string& last_token,
                   const nlohmann::detail::exception& error) {
    constexpr int number_overflow = 406;
    if (error.id == number_overflow)
      return fail(in_quotes(last_token) + " is beyond the largest double");
    const std::size_t end = position == 0 ? 0 : std::min(position - 1, text_.size());
    const std::string_view before = text_.substr(0, end);
    const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
    const std::size_t line_start = before.rfind('\n');
    const std::size_t column =
        end - (line_start == std::string_view::npos ? 0 : line_start + 1) + 1;
    fault_ = Fault{FaultCode::malformed_document,
                   source_ + ", line " + std::to_string(line) + ", column " +
                       std::to_string(column) + ": " + syntax_complaint(end, error.what()),
                   std::nullopt, "json"};
    return false;
  }

  /// The first fault, if there is one.
  const std::optional<Fault>& fault() const { return fault_; }
  const Values& values() const { return values_; }
  PathNumbers& numbers() { return numbers_; }
  /// The rows of the one member of that kind, one after the other.
  const std::vector<double>& rows() const { return rows_; }
  static constexpr std::size_t numbers_a_row = 3;
  /// The coordinates of the one member that is a point.
  const std::vector<double>& point() const { return point_; }
  std::size_t coefficients() const { return coefficients_; }
  std::size_t components() const { return components_; }
  std::size_t dimension() const { return dimension_; }
  std::size_t segment_count() const { return segment_count_; }

 private:
  struct Level {
    bool is_array = false;
    std::size_t index = 0;  // of the current element
    std::string key{};      // of the current member, escaped
  };

  std::string pointer() const {
    std::string out;
    for (const Level& level : levels_) {
      out += '/';
      out += level.is_array ? std::to_string(level.index) : level.key;
    }
    return out;
  }
  bool fail(const std::string& what) {
    fault_ = at_pointer(source_, pointer(), what);
    return false;
  }
  bool not_an_object(const std::string& got) {
    return fail("a path document is a JSON object; got " + got);
  }
  bool wrong_type(const Member& member, const std::string& got) {
    return fail(std::string(name_of(member.kind)) + " is needed; got " + got);
  }
  bool in_preimage() const { return levels_[2].key == "preimage"; }

  /// What belongs at a place inside knots or segments where something else stands.
  bool wrong_bulk_type(const std::string& got) {
    const std::size_t depth = levels_.size();
    std::string needed = "a number";
    if (bulk_ == MemberKind::rows && depth == rows_depth) {
      needed = "a row, an array of " + std::string(row_words()) + ",";
    }
    if (bulk_ == MemberKind::segments) {
      if (depth == 2) needed = "a segment, an object with \"start\" and \"preimage\",";
      if (depth == 3) needed = "an array";
      if (depth == 4 && in_preimage()) needed = "a coefficient, an array of numbers,";
    }
    return fail(needed + " is needed; got " + got);
  }

  /// What a row holds.
  const char* row_words() const {
    return levels_.size() > 2 && levels_[1].key == "helix" ? "a segment number and two bounds"
                                                           : "an obstacle number and two bounds";
  }

  /// The member that stands at the current place; null, with a fault, where none belongs there.
  const Member* current_member() {
    const Member* member = find_member(pointer());
    if (member == nullptr) fail("this member is unknown");
    return member;
  }

  bool next_element() {
    if (!levels_.empty() && levels_.back().is_array) {
      ++levels_.back().index;
      if (levels_.size() == 2) segment_count_ = levels_.back().index;
    }
    return true;
  }

  /// Every segment has as many of these as the first one.
  bool fits(std::size_t count, std::size_t& common, const char* what, const char* unit) {
    if (common == unknown) common = count;
    if (count == common) return true;
    return fail(std::string(what) + " has " + std::to_string(count) + " " + unit +
                (count == 1 ? "" : "s") + ", the one before it " + std::to_string(common));
  }

  bool number(double value) {
    if (bulk_ == MemberKind::object) return scalar(value, to_text(value));
    if (bulk_ == MemberKind::knots) {
      numbers_.knots.push_back(value);
    } else if (bulk_ == MemberKind::point) {
      if (levels_.back().index >= most_coordinates) return fail("at most 3 coordinates are needed");
      point_.push_back(value);
    } else if (bulk_ == MemberKind::rows) {
      if (levels_.size() != rows_depth + 1) return wrong_bulk_type("a number");
      rows_.push_back(value);
    } else if (levels_.size() == 4 && !in_preimage()) {
      if (levels_.back().index >= most_coordinates) return fail("at most 3 coordinates are needed");
      numbers_.starts.push_back(value);
    } else if (levels_.size() == 5) {
      if (levels_.back().index >= most_components) return fail("at most 4 numbers are needed");
      numbers_.preimages.push_back(value);
    } else {
      return wrong_bulk_type("a number");
    }
    ++levels_.back().index;
    return true;
  }

  bool scalar(Value value, const std::string& shown) {
    if (levels_.empty()) return not_an_object(shown);
    if (bulk_ != MemberKind::object) return wrong_bulk_type(shown);
    const Member* member = current_member();
    if (member == nullptr) return false;
    const bool fitting =
        (member->kind == MemberKind::text && std::holds_alternative<std::string>(value)) ||
        (member->kind == MemberKind::truth && std::holds_alternative<bool>(value)) ||
        (member->kind == MemberKind::number && std::holds_alternative<double>(value)) ||
        (member->kind == MemberKind::whole_number && std::holds_alternative<double>(value) &&
         std::get<double>(value) == std::floor(std::get<double>(value)));
    if (!fitting) return wrong_type(*member, shown);
    if (!acceptable(member->pointer, value)) return false;
    values_.emplace(member->pointer, std::move(value));
    return true;
  }

  /// What decides at once whether the rest is worth reading.
  bool acceptable(std::string_view place, const Value& value) {
    if (place == "/format" && std::get<std::string>(value) != document_format) {
      return fail("the format is " + in_quotes(std::get<std::string>(value)) +
                  "; a path document has '" + std::string(document_format) + "'");
    }
    if (place == "/version" && std::get<double>(value) != document_version) {
      fault_ = at_pointer(source_, std::string(place),
                          "the document has version " + to_text(std::get<double>(value)) +
                              "; this program reads version " + std::to_string(document_version),
                          FaultCode::unsupported);
      return false;
    }
    return true;
  }

  /// The parser's sentence without its prefix; what it quotes of the text is made harmless.
  std::string syntax_complaint(std::size_t position, const std::string& sentence) const {
    const std::size_t token = text_.find_last_of(" \t\r\n,:[{", position == 0 ? 0 : position);
    const std::string_view near =
        text_.substr(token == std::string_view::npos ? 0 : std::min(token + 1, text_.size()));
    for (const std::string_view name : {"NaN", "nan", "Infinity", "-Infinity", "inf", "-inf"}) {
      if (near.starts_with(name)) return "'" + std::string(name) + "' is not a finite number";
    }
    std::string what = "this is no JSON";
    const std::size_t dash = sentence.find(" - ");
    if (dash == std::string::npos) return what;
    std::string_view rest = std::string_view(sentence).substr(dash + 3);
    std::string_view expected;
    if (const std::size_t at = rest.find("; expected "); at != std::string_view::npos) {
      expected = rest.substr(at);
      rest = rest.substr(0, at);
    }
    if (const std::size_t at = rest.find("; last read: "); at != std::string_view::npos) {
      const std::size_t begin = at + std::string_view("; last read: '").size();
      const std::size_t tail = std::max(begin, rest.size() - std::min(rest.size(), longest_token));
      const std::string_view read = rest.substr(tail, rest.size() - tail - 1);
      return what + ": " + std::string(rest.substr(0, at)) + " after " + in_quotes(read) +
             std::string(expected);
    }
    return what + ": " + std::string(rest) + std::string(expected);
  }

  static constexpr std::size_t unknown = static_cast<std::size_t>(-1);
  static constexpr std::size_t rows_depth = 4;  // of what a row stands in
  static constexpr std::size_t most_coordinates = 3;
  static constexpr std::size_t most_components = 4;
  static constexpr std::size_t longest_token = 24;

  std::string_view text_;
  const std::string& source_;
  std::optional<Fault> fault_;
  std::vector<Level> levels_;  // the open objects and arrays
  Values values_;              // the small members by pointer; objects and arrays as monostate
  MemberKind bulk_ = MemberKind::object;  // knots or segments while inside them
  bool has_start_ = false, has_preimage_ = false;
  PathNumbers numbers_;
  std::vector<double> rows_, point_;
  std::size_t dimension_ = unknown, coefficients_ = unknown, components_ = unknown;
  std::size_t segment_count_ = 0;
};

/// Turns the collected members into a document.
class Assembler {
 public:
  Assembler(EventHandler& events, const std::string& source)
      : values_(events.values()), events_(events), source_(source) {}

  Result<PathDocument> document() {
    if (auto fault = missing_member()) return *fault;
    if (auto fault = complete_numbers()) return *fault;
    auto path = AnyPath::create(events_.numbers());
    if (!path) {
      Fault fault = path.fault();
      fault.sentence = source_ + ": " + fault.sentence;
      return fault;
    }
    PathDocument document{std::move(*path)};
    document.name = text("/name");
    document.length_unit = text("/units/length");
    document.parameter_unit = text("/units/parameter");
    document.provenance = {text("/provenance/program"), text("/provenance/source"),
                           text("/provenance/method"), text("/provenance/choice"),
                           optional_number("/provenance/tolerance")};
    if (values_.contains("/frame/roll")) {
      if (text("/frame/roll/kind") != "linear") {
        return at_pointer(source_, "/frame/roll/kind",
                          in_quotes(text("/frame/roll/kind")) + " is unknown; a roll is 'linear'",
                          FaultCode::unsupported);
      }
      if (document.path.dimension() == 2) {
        return at_pointer(source_, "/frame/roll", "a path in the plane has no roll");
      }
      document.roll =
          LinearRoll<double>{number("/frame/roll/xi_begin"), number("/frame/roll/theta_begin"),
                             number("/frame/roll/rate")};
    }
    if (auto fault = read_promises(document.promises, document.path.dimension())) return *fault;
    if (document.promises.helix &&
        document.promises.helix->sines.back().first_segment >= document.path.segment_count()) {
      return at_pointer(source_, "/promises/helix/sines", "there are fewer segments than that");
    }
    return document;
  }

 private:
  std::optional<Fault> missing_member() const {
    for (const Member& member : document_members) {
      const std::string parent(member.pointer.substr(0, member.pointer.rfind('/')));
      if (member.required && !values_.contains(member.pointer) &&
          (parent.empty() || values_.contains(parent))) {
        return at_pointer(source_, parent,
                          "the member \"" + std::string(member.pointer.substr(parent.size() + 1)) +
                              "\" is missing");
      }
    }
    return std::nullopt;
  }

  std::optional<Fault> complete_numbers() {
    PathNumbers& numbers = events_.numbers();
    const std::string algebra = text("/algebra");
    if (algebra != "complex" && algebra != "quaternion") {
      return at_pointer(source_, "/algebra",
                        in_quotes(algebra) +
                            " is unknown; it is 'complex' in the plane, "
                            "'quaternion' in space");
    }
    numbers.dimension = algebra == "complex" ? 2 : 3;
    numbers.closed = std::get<bool>(values_.at("/closed"));
    const double degree = number("/preimage_degree");
    if (!(degree >= 0.0 && degree <= static_cast<double>(maximum_dynamic_degree))) {
      Fault fault = at_pointer(source_, "/preimage_degree",
                               "the degree is " + to_text(degree) + "; 0 to " +
                                   std::to_string(maximum_dynamic_degree) + " can be read",
                               FaultCode::unsupported);
      fault.value = degree;
      return fault;
    }
    numbers.preimage_degree = static_cast<std::size_t>(degree);
    const std::size_t segments = events_.segment_count();
    if (segments == 0) return at_pointer(source_, "/segments", "a path needs at least one segment");
    if (numbers.knots.size() != segments + 1) {
      return at_pointer(
          source_, "/knots",
          std::to_string(segments) + (segments == 1 ? " segment needs " : " segments need ") +
              std::to_string(segments + 1) + " knots; got " + std::to_string(numbers.knots.size()));
    }
    const auto mismatch = [&](const char* place, const char* what, std::size_t needed,
                              std::size_t count,
                              const std::string& because) -> std::optional<Fault> {
      if (count == needed) return std::nullopt;
      return at_pointer(source_, place,
                        because + " needs " + std::to_string(needed) + " " + what + "; got " +
                            std::to_string(count));
    };
    const std::string in_algebra = "the algebra '" + algebra + "'";
    if (auto fault = mismatch("/segments/0/start", "coordinates", numbers.dimension,
                              events_.dimension(), in_algebra)) {
      return fault;
    }
    if (auto fault = mismatch("/segments/0/preimage", "coefficients", numbers.preimage_degree + 1,
                              events_.coefficients(), "the preimage degree " + to_text(degree))) {
      return fault;
    }
    return mismatch("/segments/0/preimage/0", "numbers", numbers.components_per_coefficient(),
                    events_.components(), in_algebra);
  }

  std::optional<Fault> read_promises(Promises& promises, std::size_t dimension) const {
    if (values_.contains("/promises/continuity")) {
      ContinuityOrders orders;
      for (const auto& [name, order] :
           {std::pair{"position", &orders.position}, std::pair{"preimage", &orders.preimage},
            std::pair{"frame", &orders.frame},
            std::pair{"angular_velocity", &orders.angular_velocity}}) {
        const std::string place = std::string("/promises/continuity/") + name;
        const double value = number(place);
        constexpr int highest_order = 100;
        if (!(value >= -1 && value <= highest_order)) {
          return at_pointer(source_, place,
                            "an order of continuity is -1 to " + std::to_string(highest_order) +
                                "; got " + to_text(value));
        }
        *order = static_cast<int>(value);
      }
      promises.continuity = orders;
    }
    std::optional<Enclosure> distance, bounds;
    for (const auto& [name, bound] :
         {std::pair{"error", &distance}, std::pair{"arc_length", &promises.arc_length},
          std::pair{"smallest_speed", &promises.smallest_speed},
          std::pair{"largest_speed", &promises.largest_speed},
          std::pair{"largest_curvature", &promises.largest_curvature},
          std::pair{"clearance/bounds", &bounds}}) {
      const std::string place = std::string("/promises/") + name;
      if (!values_.contains(place)) continue;
      auto read = enclosure(number(place + "/lower"), number(place + "/upper"), place);
      if (!read) return read.fault();
      *bound = *read;
    }
    if (values_.contains("/promises/end")) {
      const std::vector<double>& end = events_.point();
      if (end.size() != dimension) {
        return at_pointer(source_, "/promises/end",
                          std::to_string(dimension) + " coordinates are needed; got " +
                              std::to_string(end.size()));
      }
      promises.end = Vector3<double>{end[0], end[1], dimension == 3 ? end[2] : 0.0};
    }
    if (values_.contains("/promises/clearance")) {
      if (dimension != 2) {
        return at_pointer(source_, "/promises/clearance",
                          "a path in space has no clearance from the obstacles of a plane");
      }
      if (values_.contains("/promises/helix")) {
        return at_pointer(source_, "/promises/helix", "a path in the plane does not climb");
      }
      if (auto fault = read_clearance(promises, bounds)) return fault;
    }
    if (values_.contains("/promises/helix")) {
      if (dimension != 3) {
        return at_pointer(source_, "/promises/helix", "a path in the plane does not climb");
      }
      if (auto fault = read_helix(promises)) return fault;
    }
    if (distance) {
      promises.error =
          ErrorPromise{*distance, std::get<bool>(values_.at("/promises/error/certified")),
                       text("/promises/error/against")};
    }
    promises.curvature_bound = optional_number("/promises/curvature_bound");
    for (const auto& [place, value] :
         {std::pair{"/promises/curvature_bound", promises.curvature_bound},
          std::pair{"/provenance/tolerance", optional_number("/provenance/tolerance")}}) {
      if (value && !(*value >= 0.0)) {
        return at_pointer(source_, place, to_text(*value) + " is negative");
      }
    }
    return std::nullopt;
  }

  Result<Enclosure> enclosure(double lower, double upper, const std::string& place) const {
    if (0.0 <= lower && lower <= upper) return Enclosure(lower, upper);
    return at_pointer(source_, place,
                      "the bounds should be 0 <= lower <= upper; got lower " + to_text(lower) +
                          " and upper " + to_text(upper));
  }

  std::optional<Fault> read_clearance(Promises& promises,
                                      const std::optional<Enclosure>& bounds) const {
    ClearancePromise clearance;
    clearance.world = text("/promises/clearance/world");
    clearance.reach = number("/promises/clearance/reach");
    clearance.bounds = bounds;
    if (!(clearance.reach >= 0.0)) {
      return at_pointer(source_, "/promises/clearance/reach",
                        to_text(clearance.reach) + " is negative");
    }
    const std::vector<double>& rows = events_.rows();
    double last = -1.0;
    for (std::size_t i = 0; i + 2 < rows.size(); i += EventHandler::numbers_a_row) {
      const std::string place =
          "/promises/clearance/obstacles/" + std::to_string(i / EventHandler::numbers_a_row);
      constexpr double most = 0x1p32;
      if (!(rows[i] > last && rows[i] == std::floor(rows[i]) && rows[i] < most)) {
        return at_pointer(
            source_, place,
            "the obstacle numbers should be whole and increase; got " + to_text(rows[i]));
      }
      last = rows[i];
      auto distance = enclosure(rows[i + 1], rows[i + 2], place);
      if (!distance) return distance.fault();
      clearance.obstacles.push_back({static_cast<std::size_t>(rows[i]), *distance});
    }
    promises.clearance = std::move(clearance);
    return std::nullopt;
  }

  std::optional<Fault> read_helix(Promises& promises) const {
    HelixPromise helix;
    helix.axis = {number("/promises/helix/axis/x"), number("/promises/helix/axis/y"),
                  number("/promises/helix/axis/z")};
    if (!(largest_component(helix.axis) > 0.0)) {
      return at_pointer(source_, "/promises/helix/axis", "an axis is not zero");
    }
    const std::vector<double>& rows = events_.rows();
    double last = -1.0;
    for (std::size_t i = 0; i + 2 < rows.size(); i += EventHandler::numbers_a_row) {
      const std::string place =
          "/promises/helix/sines/" + std::to_string(i / EventHandler::numbers_a_row);
      constexpr double most = 0x1p32;
      if (!(rows[i] > last && rows[i] == std::floor(rows[i]) && rows[i] < most) ||
          (i == 0 && rows[0] != 0.0)) {
        return at_pointer(
            source_, place,
            "the segment numbers should be whole and increase from 0; got " + to_text(rows[i]));
      }
      last = rows[i];
      if (!(rows[i + 1] <= rows[i + 2])) {
        return at_pointer(source_, place,
                          "the bounds should be lower <= upper; got lower " + to_text(rows[i + 1]) +
                              " and upper " + to_text(rows[i + 2]));
      }
      helix.sines.push_back(
          {static_cast<std::size_t>(rows[i]), Enclosure(rows[i + 1], rows[i + 2])});
    }
    if (helix.sines.empty()) {
      return at_pointer(source_, "/promises/helix/sines", "at least one row is needed");
    }
    promises.helix = std::move(helix);
    return std::nullopt;
  }

  std::string text(std::string_view place) const {
    const auto found = values_.find(place);
    return found == values_.end() ? std::string() : std::get<std::string>(found->second);
  }
  double number(std::string_view place) const {
    return std::get<double>(values_.find(place)->second);
  }
  std::optional<double> optional_number(std::string_view place) const {
    if (!values_.contains(place)) return std::nullopt;
    return number(place);
  }

  const Values& values_;
  EventHandler& events_;
  const std::string& source_;
};

Result<PathDocument> parse(std::string_view text, const std::string& source) {
  EventHandler events(text, source);
  const bool complete = nlohmann::json::sax_parse(text.begin(), text.end(), &events);
  if (!complete || events.fault()) {
    const Fault& fault = *events.fault();
    // JSON of another kind deserves to be told so, not which of its members is unknown first.
    if (fault.quantity != "json" && text.find(document_format) == std::string_view::npos) {
      return at_pointer(source, "",
                        "this is no path document: it has no member \"format\": \"" +
                            std::string(document_format) + "\"");
    }
    return fault;
  }
  return Assembler(events, source).document();
}

}  // namespace

Result<PathDocument> parse_document(std::string_view text, const std::string& source) {
  try {
    return parse(text, source);
  } catch (const std::bad_alloc&) {
    return Fault{FaultCode::malformed_document,
                 source + " needs more memory than there is (" + std::to_string(text.size()) +
                     " bytes of text)",
                 std::nullopt, "memory", static_cast<double>(text.size())};
  } catch (const std::exception& error) {
    return Fault{FaultCode::malformed_document, source + ": " + in_quotes(error.what()),
                 std::nullopt, "json"};
  }
}

Result<PathDocument> load_document(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return text.fault();
  return parse_document(*text, path == "-" ? "standard input" : in_quotes(path));
}

}  // namespace hodograph
