// SPDX-License-Identifier: MIT
#include "cli/terminal.hpp"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <utility>

#include "hodograph/io/file.hpp"

namespace hodograph::cli {
namespace {

constexpr std::chrono::milliseconds between_updates{200};
constexpr std::chrono::milliseconds between_lines{5000};  // where nothing is rewritten in place

volatile std::sig_atomic_t interrupted = 0;

std::string& typed_formula() {
  static thread_local std::string formula;
  return formula;
}

std::string& typed_place() {
  static thread_local std::string lines;
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

Progress::Progress(std::string what, bool asked)
    : what_(std::move(what)),
      on_terminal_(isatty(STDERR_FILENO) != 0),
      asked_(asked),
      last_(std::chrono::steady_clock::now()) {}

Progress::~Progress() { wipe(); }

void Progress::wipe() {
  if (on_terminal_ && on_screen_) std::fputs("\r\x1b[K", stderr);
  on_screen_ = false;
}

bool Progress::is_due() {
  if (!is_wanted()) return false;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < (on_terminal_ ? between_updates : between_lines)) return false;
  last_ = now;
  shown_ = on_screen_ = true;
  return true;
}

void Progress::put(const std::string& text) {
  std::fprintf(stderr, on_terminal_ ? "\r\x1b[K%s: %s" : "%s: %s\n", what_.c_str(), text.c_str());
}

void Progress::show(const std::string& text) {
  if (is_due()) put(text);
}

void Progress::show(const std::function<std::string()>& text) {
  if (is_due()) put(text());
}

void Progress::note(const std::string& line) {
  wipe();
  std::fprintf(stderr, "%s\n", line.c_str());
}

bool Progress::operator()(std::size_t segments, double fraction) {
  if (!is_due()) return true;
  constexpr double percent = 100.0;
  char text[64];
  std::snprintf(text, sizeof text, "%zu segments, %.0f %%", segments, percent * fraction);
  put(text);
  return true;
}

InterruptGuard::InterruptGuard() {
  interrupted = 0;
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted = 1; };
  sigemptyset(&action.sa_mask);
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  struct sigaction before {};
  sigaction(SIGINT, nullptr, &before);
  ignored_ = before.sa_handler == SIG_IGN;  // as a shell asks for jobs in the background
  if (!ignored_) sigaction(SIGINT, &action, nullptr);
}
InterruptGuard::~InterruptGuard() {
  if (!ignored_) std::signal(SIGINT, SIG_DFL);
}
bool InterruptGuard::requested() { return interrupted != 0; }

void print(std::string_view text) {
  if (const auto fault = write_file("-", text)) throw Error(*fault);
}

}  // namespace hodograph::cli
