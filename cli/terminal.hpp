// SPDX-License-Identifier: MIT
// What the program says while it works: progress on a terminal, nothing in a pipe.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace hodograph::cli {

/// The text without line breaks and control characters.
std::string on_one_line(std::string_view text);

/// Remembers the formula that was typed, so that a mistake in it can be pointed at.
void remember_formula(const std::string& formula);
/// On a terminal: the formula, and a caret under the character with this index.
void show_place(std::size_t index);

/// Remembers the line of a text with a mistake and the caret below it, and shows them on a
/// terminal.
void remember_place(const std::string& lines);
void show_remembered_place();

/// A progress line on standard error, rewritten in place; shown on a terminal alone, and only once
/// the work has lasted a while. Wiped when the object goes. Elsewhere, where it was asked for, a
/// line now and then.
class Progress {
 public:
  explicit Progress(std::string what, bool asked = false);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows how many segments cover which fraction of ξ; always true, as fit() asks.
  bool operator()(std::size_t segments, double fraction);
  /// Shows any short text.
  void show(const std::string& text);
  /// The same, the text made only where it is shown.
  void show(const std::function<std::string()>& text);
  /// A line of its own that stays, shown in any case.
  void note(const std::string& line);
  bool is_wanted() const { return on_terminal_ || asked_; }
  /// Whether the work has lasted long enough for a progress line.
  bool was_shown() const { return shown_; }

 private:
  bool is_due();
  void put(const std::string& text);
  void wipe();

  std::string what_;
  bool on_terminal_ = false, asked_ = false, shown_ = false, on_screen_ = false;
  std::chrono::steady_clock::time_point last_;
};

/// While it lives, Ctrl-C does not end the program but is remembered, so that work can stop at the
/// next good moment; a second Ctrl-C ends it as ever. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  static bool requested();

 private:
  bool ignored_ = false;
};

/// Writes to standard output, and throws Error (not_written) where that fails.
void print(std::string_view text);

}  // namespace hodograph::cli
