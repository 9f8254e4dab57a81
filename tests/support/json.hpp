// SPDX-License-Identifier: MIT
// A reader for the golden files of tests/golden/: JSON as far as they use it. The tests of the core
// link no JSON library, because the core needs none.
#pragma once

#include <cctype>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "hodograph/algebra/quaternion.hpp"

namespace hodograph::test {

/// A JSON value: a number (0 for null), a string, a list or an object.
class Json {
 public:
  /// The value in a text; throws std::runtime_error where the text is not JSON.
  static Json parse(const std::string& text) {
    std::size_t at = 0;
    Json value = read(text, at);
    skip(text, at);
    if (at != text.size()) throw std::runtime_error("JSON: something follows the value");
    return value;
  }
  static Json of_file(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot open " + path);
    std::ostringstream text;
    text << file.rdbuf();
    return parse(text.str());
  }

  double number() const { return number_; }
  const std::string& string() const { return string_; }
  const std::vector<Json>& list() const { return list_; }
  std::size_t size() const { return list_.size(); }
  bool has(const std::string& name) const { return members_.count(name) > 0; }
  const Json& operator[](const std::string& name) const { return members_.at(name); }
  const Json& operator[](std::size_t i) const { return list_.at(i); }

  Vector3<double> vector() const {
    return {list_.at(0).number_, list_.at(1).number_, list_.at(2).number_};
  }
  Quaternion<double> quaternion() const {
    return {list_.at(0).number_, list_.at(1).number_, list_.at(2).number_, list_.at(3).number_};
  }

 private:
  static void skip(const std::string& text, std::size_t& at) {
    while (at < text.size() && std::isspace(static_cast<unsigned char>(text[at])) != 0) ++at;
  }
  static char next(const std::string& text, std::size_t& at) {
    skip(text, at);
    if (at >= text.size()) throw std::runtime_error("JSON: the text ends too early");
    return text[at];
  }
  static void expect(const std::string& text, std::size_t& at, char what) {
    if (next(text, at) != what) {
      throw std::runtime_error(std::string("JSON: expected ") + what + " at " + std::to_string(at));
    }
    ++at;
  }
  static std::string read_string(const std::string& text, std::size_t& at) {
    expect(text, at, '"');
    const std::size_t end = text.find('"', at);
    if (end == std::string::npos) throw std::runtime_error("JSON: a string does not end");
    const std::string result = text.substr(at, end - at);
    at = end + 1;
    return result;
  }
  static Json read(const std::string& text, std::size_t& at) {
    Json value;
    const char first = next(text, at);
    if (first == '{' || first == '[') {
      const char last = first == '{' ? '}' : ']';
      for (++at; next(text, at) != last;) {
        if (first == '{') {
          const std::string name = read_string(text, at);
          expect(text, at, ':');
          value.members_.emplace(name, read(text, at));
        } else {
          value.list_.push_back(read(text, at));
        }
        if (next(text, at) != last) expect(text, at, ',');
      }
      ++at;
    } else if (first == '"') {
      value.string_ = read_string(text, at);
    } else if (text.compare(at, 4, "null") == 0) {
      at += 4;
    } else {
      char* end = nullptr;
      value.number_ = std::strtod(text.c_str() + at, &end);
      if (end == text.c_str() + at) throw std::runtime_error("JSON: not a value");
      at = static_cast<std::size_t>(end - text.c_str());
    }
    return value;
  }

  double number_ = 0.0;
  std::string string_;
  std::vector<Json> list_;
  std::map<std::string, Json> members_;
};

/// A file of tests/golden/.
#ifdef HODOGRAPH_SOURCE_DIRECTORY
inline Json golden_file(const std::string& name) {
  return Json::of_file(HODOGRAPH_SOURCE_DIRECTORY "/tests/golden/" + name);
}
#endif

}  // namespace hodograph::test
