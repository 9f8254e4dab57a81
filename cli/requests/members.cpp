// SPDX-License-Identifier: MIT
#include "cli/requests/members.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/terminal.hpp"

namespace hodograph::cli {
namespace {

std::string type_of(const Json& value) {
  switch (value.type()) {
    case Json::value_t::object:
      return "an object";
    case Json::value_t::array:
      return "an array";
    case Json::value_t::string:
      return "a string";
    case Json::value_t::boolean:
      return value.get<bool>() ? "true" : "false";
    case Json::value_t::null:
      return "null";
    default:
      return "the number " + to_text(value.get<double>());
  }
}

std::string item(const std::string& place, std::size_t i) {
  return place + "/" + std::to_string(i);
}

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string out = "'";
  out += on_one_line(text.substr(0, longest));
  return out + (text.size() > longest ? "...'" : "'");
}

Members::Members(const Json& json, std::string pointer, std::string whole)
    : json_(&json), pointer_(std::move(pointer)), whole_(std::move(whole)) {
  if (!json.is_object()) refuse_at(pointer_, "an object is needed; here is " + type_of(json));
}

void Members::refuse_at(const std::string& place, const std::string& what) const {
  throw Error(Fault{FaultCode::malformed_document,
                    (place.empty() ? whole_ : "at " + place) + ": " + what, std::nullopt,
                    place.empty() ? "request" : place, std::nullopt, std::nullopt});
}

void Members::refuse(std::string_view name, const std::string& what) const {
  refuse_at(pointer_ + "/" + std::string(name), what);
}

void Members::require_at_most(std::string_view name, std::size_t count, std::size_t limit) const {
  if (count <= limit) return;
  refuse(name, std::to_string(count) + " are too many for one request; at most " +
                   std::to_string(limit) + " are answered");
}

const Json* Members::find(std::string_view name) {
  known_.emplace_back(name);
  const auto found = json_->find(name);
  return found == json_->end() ? nullptr : &*found;
}

const Json& Members::need(std::string_view name) {
  const Json* const value = find(name);
  if (value == nullptr) {
    refuse_at(pointer_, "the member \"" + std::string(name) + "\" is missing");
  }
  return *value;
}

double Members::number_of(const Json& value, const std::string& place) const {
  if (!value.is_number()) refuse_at(place, "a number is needed; here is " + type_of(value));
  return value.get<double>();
}

double Members::number(std::string_view name) {
  return number_of(need(name), pointer_ + "/" + std::string(name));
}
double Members::number(std::string_view name, double otherwise) {
  return maybe_number(name).value_or(otherwise);
}
std::optional<double> Members::maybe_number(std::string_view name) {
  const Json* const value = find(name);
  if (value == nullptr) return std::nullopt;
  return number_of(*value, pointer_ + "/" + std::string(name));
}

bool Members::truth(std::string_view name, bool otherwise) {
  const Json* const value = find(name);
  if (value == nullptr) return otherwise;
  if (!value->is_boolean()) refuse(name, "true or false is needed; here is " + type_of(*value));
  return value->get<bool>();
}

std::size_t Members::count(std::string_view name) {
  const double value = number(name);
  constexpr double most = 1e15;  // any larger count is a mistake, and doubles count to 9e15
  if (!(value >= 0.0 && value <= most) || value != std::floor(value)) {
    refuse(name, "a whole number is needed, 0 or more; here is the number " + to_text(value));
  }
  return static_cast<std::size_t>(value);
}
std::size_t Members::count(std::string_view name, std::size_t otherwise) {
  return has(name) ? count(name) : otherwise;
}

std::string Members::text(std::string_view name) {
  const Json& value = need(name);
  if (!value.is_string()) refuse(name, "a string is needed; here is " + type_of(value));
  return value.get<std::string>();
}
std::string Members::text(std::string_view name, const std::string& otherwise) {
  if (!has(name)) {
    find(name);
    return otherwise;
  }
  return text(name);
}

std::string Members::word(std::string_view name, const std::vector<std::string>& words,
                          const std::string& otherwise) {
  std::string value = otherwise.empty() ? text(name) : text(name, otherwise);
  if (std::find(words.begin(), words.end(), value) == words.end()) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
      list += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    }
    refuse(name, in_quotes(value) + " is unknown; it is " + list);
  }
  return value;
}

std::vector<double> Members::numbers_of(const Json& value, const std::string& place) const {
  if (!value.is_array()) {
    refuse_at(place, "a list of numbers is needed; here is " + type_of(value));
  }
  std::vector<double> result;
  result.reserve(value.size());
  for (const Json& number : value) result.push_back(number_of(number, item(place, result.size())));
  return result;
}

std::vector<double> Members::numbers(std::string_view name) {
  return numbers_of(need(name), pointer_ + "/" + std::string(name));
}
std::vector<double> Members::numbers(std::string_view name, std::size_t count) {
  auto result = numbers(name);
  if (result.size() != count) {
    refuse(name, std::to_string(count) + " numbers are needed; here are " +
                     std::to_string(result.size()));
  }
  return result;
}

std::vector<std::vector<double>> Members::vectors(std::string_view name, std::size_t size) {
  const std::string place = pointer_ + "/" + std::string(name);
  const Json& value = need(name);
  if (!value.is_array()) refuse(name, "a list is needed; here is " + type_of(value));
  std::vector<std::vector<double>> result;
  for (const Json& row : value) {
    result.push_back(numbers_of(row, item(place, result.size())));
    if (result.back().size() != size) {
      refuse_at(item(place, result.size() - 1), std::to_string(size) +
                                                    " numbers are needed; here are " +
                                                    std::to_string(result.back().size()));
    }
  }
  return result;
}

Vector3<double> Members::point_of(const Json& value, const std::string& place) const {
  const auto numbers = numbers_of(value, place);
  if (numbers.size() != 3) {
    refuse_at(place, "three numbers are needed; here are " + std::to_string(numbers.size()));
  }
  return {numbers[0], numbers[1], numbers[2]};
}

Vector3<double> Members::point(std::string_view name) {
  return point_of(need(name), pointer_ + "/" + std::string(name));
}

std::vector<Vector3<double>> Members::jet_of(const Json& value, std::size_t count,
                                             const std::string& place) const {
  if (!value.is_array() || value.size() != count) {
    refuse_at(place,
              "a list of " + std::to_string(count) +
                  " vectors is needed (the point and its derivatives); here is " +
                  (value.is_array() ? "one of " + std::to_string(value.size()) : type_of(value)));
  }
  std::vector<Vector3<double>> result;
  for (const Json& vector : value) result.push_back(point_of(vector, item(place, result.size())));
  return result;
}

std::vector<Vector3<double>> Members::jet(std::string_view name, std::size_t count) {
  return jet_of(need(name), count, pointer_ + "/" + std::string(name));
}

std::vector<std::vector<Vector3<double>>> Members::jets(std::string_view name, std::size_t count) {
  const std::string place = pointer_ + "/" + std::string(name);
  const Json& value = need(name);
  if (!value.is_array()) refuse(name, "a list is needed; here is " + type_of(value));
  std::vector<std::vector<Vector3<double>>> result;
  for (const Json& jet : value) result.push_back(jet_of(jet, count, item(place, result.size())));
  return result;
}

Members Members::object(std::string_view name) {
  return {need(name), pointer_ + "/" + std::string(name)};
}

std::vector<Members> Members::objects(std::string_view name) {
  const Json& value = need(name);
  const std::string place = pointer_ + "/" + std::string(name);
  if (!value.is_array()) refuse_at(place, "a list is needed; here is " + type_of(value));
  std::vector<Members> result;
  for (const Json& one : value) result.emplace_back(one, item(place, result.size()));
  return result;
}

std::string Members::json_text(std::string_view name) { return need(name).dump(); }

PathDocument Members::document(std::string_view document, std::string_view file) {
  if (has(document) == has(file)) {
    refuse_at(pointer_, "give the path as \"" + std::string(document) +
                            "\", a path document, or as \"" + std::string(file) +
                            "\", the name of one" + (has(document) ? "; not both" : ""));
  }
  find(document);
  find(file);
  if (has(file)) return load_document(text(file)).value();
  std::string source;
  append_json(source, need(document));
  return parse_document(source, pointer_ + "/" + std::string(document)).value();
}

void Members::require_all_known() const {
  for (const auto& [key, value] : json_->items()) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    refuse_at(pointer_, "the member " + in_quotes(key) + " is unknown");
  }
}

}  // namespace hodograph::cli
