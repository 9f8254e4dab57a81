// SPDX-License-Identifier: MIT
// The lines of a file or of standard input, one at a time, with a fingerprint of each.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hodograph::cli {

/// FNV-1a: tells a changed line from the one that was there, not a forged one.
class Fingerprint {
 public:
  void add(std::string_view bytes) {
    for (const char c : bytes) {
      value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};
std::uint64_t fingerprint_of(std::string_view text);

/// One line, without its end.
struct Line {
  std::string text;
  bool too_long = false;          ///< longer than the limit: `text` is empty
  bool ended = false;             ///< a line feed was there
  std::uint64_t number = 0;       ///< from 1
  std::uint64_t end = 0;          ///< bytes of the input up to here
  std::uint64_t fingerprint = 0;  ///< of all its bytes, also where it is too long
};

class LineReader {
 public:
  /// Of a file ("-": standard input). Lines of more than `longest` bytes are passed over, and said
  /// to be so. Throws Error (malformed_document) where it cannot be opened.
  LineReader(const std::string& name, std::size_t longest);
  ~LineReader();
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  enum class Next { line, end, none_yet };
  /// The next line; `none_yet` where nothing arrived for `most`: what had arrived of a line is
  /// kept. Throws Error where reading fails.
  Next next(Line& line, std::chrono::milliseconds most);
  /// Waits as long as it takes; false at the end.
  bool next(Line& line);

  /// The size of a regular file in bytes; nothing for pipes and terminals.
  std::optional<std::uint64_t> size() const;

 private:
  Next fill(std::chrono::milliseconds most);
  [[noreturn]] void fail() const;

  std::string name_;
  std::size_t longest_;
  int descriptor_ = -1;
  std::array<char, std::size_t{1} << 16U> buffer_{};
  std::size_t position_ = 0, filled_ = 0;
  std::uint64_t lines_ = 0, passed_ = 0;
  Line begun_;
  Fingerprint fingerprint_;
  bool any_ = false;  // of the line that has begun
};

}  // namespace hodograph::cli
