// SPDX-License-Identifier: MIT
#include "cli/terminal.hpp"

#include <unistd.h>

#include <cstdio>
#include <utility>

#include "hodograph/io/file.hpp"

namespace hodograph::cli {
namespace {

constexpr std::chrono::milliseconds between_updates{200};

std::string& typed_formula() {
  static std::string formula;
  return formula;
}

std::string& typed_place() {
  static std::string lines;
  return lines;
}

}  // namespace

std::string on_one_line(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    if (!control) {
      out += c;
    } else if (!out.empty() && out.back() != ' ') {
      out += ' ';
    }
  }
  return out;
}

void remember_formula(const std::string& formula) { typed_formula() = formula; }

void show_place(std::size_t index) {
  constexpr std::size_t widest = 100;  // characters of a line of a terminal
  const std::string& formula = typed_formula();
  if (isatty(STDERR_FILENO) == 0 || formula.empty() || formula.size() > widest) return;
  std::fprintf(stderr, "  %s\n  %*s^\n", on_one_line(formula).c_str(), static_cast<int>(index), "");
}

void remember_place(const std::string& lines) { typed_place() = lines; }

void show_remembered_place() {
  if (isatty(STDERR_FILENO) != 0) std::fputs(typed_place().c_str(), stderr);
}

Progress::Progress(std::string what)
    : what_(std::move(what)),
      on_terminal_(isatty(STDERR_FILENO) != 0),
      last_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\x1b[K", stderr);
}

bool Progress::operator()(std::size_t segments, double fraction) {
  const auto now = std::chrono::steady_clock::now();
  if (!on_terminal_ || now - last_ < between_updates) return true;
  last_ = now;
  shown_ = true;
  constexpr double percent = 100.0;
  std::fprintf(stderr, "\r\x1b[K%s: %zu segments, %.0f %%", what_.c_str(), segments,
               percent * fraction);
  return true;
}

void print(std::string_view text) {
  if (const auto fault = write_file("-", text)) throw Error(*fault);
}

}  // namespace hodograph::cli
