// SPDX-License-Identifier: MIT
// One request: a line of bounded length and depth in, one line out.
#include "cli/requests/batch.hpp"

#include <locale.h>

#include <exception>
#include <mutex>
#include <optional>
#include <utility>

namespace hodograph::cli {
namespace {

Fault malformed(std::string sentence, const char* quantity = "json") {
  return {FaultCode::malformed_document,
          std::move(sentence),
          std::nullopt,
          quantity,
          std::nullopt,
          std::nullopt};
}

/// The depth of brackets, looked at before anything is built.
bool too_deep(std::string_view line) {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (in_string) {
      if (c == '\\') {
        ++i;
      } else if (c == '"') {
        in_string = false;
      }
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > deepest_request) return true;
    } else if ((c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
  return false;
}

/// Builds the tree as nlohmann's parser would, but refuses repeated members and keeps the sign of
/// "-0".
class TreeBuilder {
 public:
  explicit TreeBuilder(Json& root) : root_(root) {}
  const std::string& problem() const { return problem_; }

  bool null() { return add(Json()); }
  bool boolean(bool value) { return add(Json(value)); }
  bool number_integer(std::int64_t value) { return add(value == 0 ? Json(-0.0) : Json(value)); }
  bool number_unsigned(std::uint64_t value) { return add(Json(value)); }
  bool number_float(double value, const std::string&) { return add(Json(value)); }
  bool string(std::string& value) { return add(Json(std::move(value))); }
  bool binary(std::vector<std::uint8_t>&) { return false; }
  bool start_object(std::size_t) { return open(Json::object()); }
  bool start_array(std::size_t) { return open(Json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(std::string& name) {
    if (open_.back()->contains(name)) {
      problem_ = "the member \"" + name + "\" stands there twice";
      return false;
    }
    key_ = std::move(name);
    return true;
  }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) {
    constexpr int out_of_range = 406;
    problem_ =
        error.id == out_of_range
            ? "a number is beyond the range of double, before character " + std::to_string(position)
            : "this is no JSON, from character " + std::to_string(position) + " on";
    return false;
  }

 private:
  Json* place(Json value) {
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Json& parent = *open_.back();
    if (parent.is_array()) {
      parent.push_back(std::move(value));
      return &parent.back();
    }
    return &(parent[key_] = std::move(value));
  }
  bool add(Json value) {
    place(std::move(value));
    return true;
  }
  bool open(Json value) {
    open_.push_back(place(std::move(value)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  Json& root_;
  std::vector<Json*> open_;
  std::string key_, problem_;
};

/// A multi-line document as one line: line breaks inside strings are escaped, so every one is
/// layout.
void append_one_line(std::string& out, std::string_view text) {
  bool at_start = false;
  for (const char c : text) {
    if (c == '\n') {
      at_start = true;
    } else if (!(at_start && c == ' ')) {
      at_start = false;
      out += c;
    }
  }
}

std::string fault_line(const Json& id, const std::string& kind, const Fault& fault) {
  Json answer = Json::object();
  if (!id.is_null()) answer["id"] = id;
  if (!kind.empty()) answer["request"] = kind;
  answer["ok"] = false;
  answer["fault"] = json_of(fault);
  std::string line;
  append_json(line, answer);
  return line;
}

/// Numbers are read and written with a point while it lives, whatever the process has chosen: a
/// Python program may have called locale.setlocale().
class PointsInNumbers {
 public:
  PointsInNumbers() : before_(::uselocale(plain())) {}
  ~PointsInNumbers() { ::uselocale(before_); }
  PointsInNumbers(const PointsInNumbers&) = delete;
  PointsInNumbers& operator=(const PointsInNumbers&) = delete;

 private:
  static locale_t plain() {
    static const locale_t locale = ::newlocale(LC_ALL_MASK, "C", nullptr);
    return locale;  // null, where there is no memory for it, changes nothing
  }
  locale_t before_;
};

Answer answered(const Json& request, std::string& kind) {
  Members members(request, "");
  kind = members.text("request");
  for (const RequestKind& known : request_kinds()) {
    if (known.name == kind) {
      static std::mutex one_at_a_time;
      std::unique_lock lock(one_at_a_time, std::defer_lock);
      if (known.runs == RequestRuns::one_at_a_time) lock.lock();
      return known.answer(members);
    }
  }
  std::string names;
  for (const RequestKind& known : request_kinds()) {
    names += (names.empty() ? "" : ", ") + std::string(known.name);
  }
  members.refuse("request", in_quotes(kind) + " is no request; there are " + names);
}

}  // namespace

Json parsed_json(std::string_view text, const std::string& what) {
  if (too_deep(text)) {
    throw Error(malformed(what + " nests brackets deeper than " + std::to_string(deepest_request) +
                          " levels"));
  }
  Json value;
  TreeBuilder builder(value);
  if (!Json::sax_parse(text.begin(), text.end(), &builder))
    throw Error(malformed(builder.problem()));
  return value;
}

AnsweredLine answered_line(std::string_view line, bool too_long) {
  const PointsInNumbers points;
  Json request, id;
  std::string kind;
  const auto refused = [&](Fault fault) {
    std::string text = fault_line(id, kind, fault);
    return AnsweredLine{std::move(text), std::move(fault)};
  };
  try {
    if (too_long) {
      return refused(
          malformed("the line is longer than " + std::to_string(longest_request) + " bytes"));
    }
    request = parsed_json(line, "the request");
    if (request.is_object() && request.contains("id")) {
      id = request["id"];
      if (!id.is_string() && !id.is_number()) {
        id = Json();
        return refused(malformed("the id should be a string or a number", "/id"));
      }
      request.erase("id");
    }
    const Answer answer = answered(request, kind);
    std::string out = "{";
    if (!id.is_null()) {
      out += "\"id\": ";
      append_json(out, id);
      out += ", ";
    }
    out += "\"request\": \"" + kind + "\", \"ok\": true, \"result\": ";
    append_json(out, answer.result);
    if (!answer.document.empty()) {
      out.pop_back();
      out += answer.result.empty() ? "\"document\": " : ", \"document\": ";
      append_one_line(out, answer.document);
      out += '}';
    }
    return {out + "}", std::nullopt};
  } catch (const Error& error) {
    return refused(error.fault());
  } catch (const std::bad_alloc&) {
    return refused(malformed("there is not enough memory for this request", "memory"));
  } catch (const std::exception& error) {
    return refused(malformed(error.what()));
  }
}

}  // namespace hodograph::cli
