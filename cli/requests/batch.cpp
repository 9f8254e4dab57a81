// SPDX-License-Identifier: MIT
// The stream of requests: lines of bounded length and depth in, one line out for each.
#include "cli/requests/batch.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <limits>
#include <optional>
#include <utility>

#include "hodograph/io/file.hpp"

namespace hodograph::cli {
namespace {

/// Lines of a file descriptor. A line longer than the limit is passed over, and said to be so.
class LineReader {
 public:
  explicit LineReader(const std::string& name) : name_(name) {
    descriptor_ = name == "-" ? STDIN_FILENO : ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail();
  }
  ~LineReader() {
    if (descriptor_ > STDIN_FILENO) ::close(descriptor_);
  }
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  /// The next line, without its end; nothing at the end of the file. `too_long`: it was passed
  /// over.
  bool next(std::string& line, bool& too_long) {
    line.clear();
    too_long = false;
    bool any = false;
    for (;;) {
      if (position_ == size_ && !fill()) return any;
      any = true;
      const char* const begin = buffer_.data() + position_;
      const void* const end = std::memchr(begin, '\n', size_ - position_);
      const std::size_t length =
          end == nullptr ? size_ - position_
                         : static_cast<std::size_t>(static_cast<const char*>(end) - begin);
      if (line.size() + length > longest_request) {
        too_long = true;
        line.clear();
        line.shrink_to_fit();
      }
      if (!too_long) line.append(begin, length);
      position_ += length + (end == nullptr ? 0 : 1);
      if (end != nullptr) return true;
    }
  }

 private:
  bool fill() {
    position_ = size_ = 0;
    for (;;) {
      const ssize_t count = ::read(descriptor_, buffer_.data(), buffer_.size());
      if (count > 0) {
        size_ = static_cast<std::size_t>(count);
        return true;
      }
      if (count == 0) return false;
      if (errno != EINTR) fail();
    }
  }
  [[noreturn]] void fail() const {
    throw Error(Fault{FaultCode::malformed_document,
                      "cannot read " + (name_ == "-" ? "standard input" : "'" + name_ + "'") +
                          ": " + std::strerror(errno),
                      std::nullopt, "file", std::nullopt, std::nullopt});
  }

  std::string name_;
  int descriptor_ = -1;
  std::array<char, std::size_t{1} << 16U> buffer_{};
  std::size_t position_ = 0, size_ = 0;
};

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

Answer answered(const Json& request, std::string& kind) {
  Members members(request, "");
  kind = members.text("request");
  for (const RequestKind& known : request_kinds()) {
    if (known.name == kind) {
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

std::string answer_line(std::string_view line) {
  Json request, id;
  std::string kind;
  try {
    request = parsed_json(line, "the request");
    if (request.is_object() && request.contains("id")) {
      id = request["id"];
      if (!id.is_string() && !id.is_number()) {
        id = Json();
        return fault_line(id, kind, malformed("the id should be a string or a number", "/id"));
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
    return out + "}";
  } catch (const Error& error) {
    return fault_line(id, kind, error.fault());
  } catch (const std::bad_alloc&) {
    return fault_line(id, kind, malformed("there is not enough memory for this request", "memory"));
  } catch (const std::exception& error) {
    return fault_line(id, kind, malformed(error.what()));
  }
}

void run_batch(const std::string& input, const std::string& output) {
  LineReader reader(input);
  std::optional<OutputFile> file;
  if (output != "-") file = OutputFile::create(output).value();
  std::string line;
  bool too_long = false;
  while (reader.next(line, too_long)) {
    if (!too_long && line.find_first_not_of(" \t\r") == std::string::npos) continue;
    std::string answer = too_long
                             ? fault_line(Json(), "",
                                          malformed("the line is longer than " +
                                                    std::to_string(longest_request) + " bytes"))
                             : answer_line(line);
    answer += '\n';
    if (file) {
      file->write(answer);
    } else if (std::fwrite(answer.data(), 1, answer.size(), stdout) != answer.size() ||
               std::fflush(stdout) != 0) {
      throw Error(Fault{FaultCode::not_written,
                        std::string("standard output cannot be written: ") + std::strerror(errno),
                        std::nullopt, "file", std::nullopt, std::nullopt});
    }
  }
  if (file) {
    if (const auto fault = file->commit()) throw Error(*fault);
  }
}

}  // namespace hodograph::cli
