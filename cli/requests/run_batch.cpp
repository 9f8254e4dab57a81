// SPDX-License-Identifier: MIT
#include "cli/requests/run_batch.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include "cli/terminal.hpp"
#include "hodograph/foundation/result.hpp"

namespace hodograph::cli {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds patience{100};  // between looks at whether to stop

bool is_blank(const Line& line) {
  return !line.too_long && line.text.find_first_not_of(" \t\r") == std::string::npos;
}

std::string counted(std::uint64_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// "42 s", "17 min" or "5.2 h".
std::string duration(double seconds) {
  constexpr double minute = 60.0, hour = 3600.0;
  char text[32];
  if (seconds < 2.0 * minute) {
    std::snprintf(text, sizeof text, "%.0f s", std::ceil(seconds));
  } else if (seconds < 2.0 * hour) {
    std::snprintf(text, sizeof text, "%.0f min", std::ceil(seconds / minute));
  } else {
    std::snprintf(text, sizeof text, "%.1f h", seconds / hour);
  }
  return text;
}

/// What has been done, and what is said of it.
struct Tally {
  std::uint64_t lines = 0, faults = 0;  // with those of the earlier run
  std::uint64_t lines_before = 0, bytes_before = 0, bytes = 0;
  Clock::time_point begin = Clock::now();

  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin).count(); }
  double rate() const {
    const double elapsed = seconds();
    return elapsed > 0.0 ? static_cast<double>(lines - lines_before) / elapsed : 0.0;
  }
  std::string text(std::optional<std::uint64_t> size) const {
    constexpr double percent = 100.0, without_decimals = 100.0;
    char number[48];
    std::snprintf(number, sizeof number, rate() < without_decimals ? ", %.3g/s" : ", %.0f/s",
                  rate());
    std::string text = counted(lines, "line") + number;
    const auto passed = static_cast<double>(bytes - bytes_before);
    if (size && *size > 0 && bytes <= *size && passed > 0.0) {
      std::snprintf(number, sizeof number, ", %.0f %%, ",
                    std::floor(percent * static_cast<double>(bytes) / static_cast<double>(*size)));
      text += number + duration(seconds() * static_cast<double>(*size - bytes) / passed) + " left";
    }
    if (faults > 0) text += ", " + counted(faults, "fault");
    return text;
  }
};

/// Passes over the lines that were answered before, if they still are what they were.
void pass_over(LineReader& reader, BatchOutput& output, OnFault on_fault, Tally& tally) {
  const std::string& partial = output.partial();
  const std::uint64_t count = output.earlier_lines();
  const auto refuse = [&](std::string sentence, std::uint64_t line) {
    throw Error(Fault{FaultCode::malformed_document, std::move(sentence), line, "file",
                      std::nullopt, std::nullopt});
  };
  Line line;
  while (tally.lines < count) {
    const LineRecord record = output.next_earlier();
    do {
      if (!reader.next(line)) {
        refuse("the requests end after " + counted(tally.lines, "line") + ", but " +
                   std::to_string(count) + " were answered in '" + partial +
                   "': give the same requests, or remove that file to start afresh",
               tally.lines);
      }
    } while (is_blank(line));
    if (line.fingerprint != record.request) {
      refuse("line " + std::to_string(line.number) +
                 " of the requests is not what was answered in '" + partial +
                 "': give the same requests, or remove that file to start afresh",
             line.number - 1);
    }
    const bool fits = record.fate == LineFate::answered ||
                      (record.fate == LineFate::faulted && on_fault == OnFault::report) ||
                      (record.fate == LineFate::skipped && on_fault == OnFault::skip);
    if (!fits) {
      const bool reported = record.fate == LineFate::faulted;
      refuse("the run to go on with " + std::string(reported ? "reported" : "skipped") +
                 " the fault of line " + std::to_string(line.number) + ": go on with --on-fault " +
                 (reported ? "report" : "skip"),
             line.number - 1);
    }
    ++tally.lines;
    if (record.fate != LineFate::answered) ++tally.faults;
  }
  tally.lines_before = tally.lines;
  tally.bytes_before = tally.bytes = count == 0 ? 0 : line.end;
}

/// The thread that takes answers and writes them.
class Writer {
 public:
  Writer(AnswerPool& pool, BatchOutput& output, const BatchOptions& options, Tally& tally,
         Progress& progress, std::optional<std::uint64_t> size)
      : pool_(pool),
        output_(output),
        on_fault_(options.on_fault),
        tally_(tally),
        progress_(progress),
        size_(size),
        thread_([this] { run(); }) {}
  ~Writer() {
    if (thread_.joinable()) pool_.stop();  // something was thrown meanwhile
    join();
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// Waits until all is written; what went wrong leaves as it was thrown.
  void finish() {
    join();
    if (problem_) std::rethrow_exception(problem_);
  }

 private:
  void join() {
    if (thread_.joinable()) thread_.join();
  }
  void run() {
    try {
      LineAnswer one;
      for (;;) {
        const AnswerPool::Next next = pool_.take(one, patience);
        if (next == AnswerPool::Next::end) break;
        if (next == AnswerPool::Next::answer && !accept(one)) break;
        if (!pool_.ready()) output_.flush();
        progress_.show([this] { return tally_.text(size_); });
      }
      output_.flush();
    } catch (...) {
      problem_ = std::current_exception();
      pool_.stop();
    }
  }
  /// Whether the run goes on.
  bool accept(LineAnswer& one) {
    LineFate fate = LineFate::answered;
    if (one.answer.fault) {
      const std::string sentence =
          "line " + std::to_string(one.line.number) + ": " + one.answer.fault->sentence;
      if (on_fault_ == OnFault::stop) {
        output_.flush();
        Fault fault = *one.answer.fault;
        fault.sentence = sentence;
        fault.index.reset();  // within the request, not the file
        throw Error(std::move(fault));
      }
      fate = on_fault_ == OnFault::skip ? LineFate::skipped : LineFate::faulted;
      if (fate == LineFate::skipped) progress_.note("hodograph: skipped " + on_one_line(sentence));
      ++tally_.faults;
    }
    output_.add(one, fate);
    ++tally_.lines;
    tally_.bytes = one.line.end;
    return true;
  }

  AnswerPool& pool_;
  BatchOutput& output_;
  OnFault on_fault_;
  Tally& tally_;
  Progress& progress_;
  std::optional<std::uint64_t> size_;
  std::exception_ptr problem_;
  std::thread thread_;
};

}  // namespace

void run_batch(const BatchOptions& options) {
  LineReader reader(options.input, longest_request);
  BatchOutput output(options.output, options.resume);
  Tally tally;
  pass_over(reader, output, options.on_fault, tally);
  tally.begin = Clock::now();
  const InterruptGuard guard;
  Progress progress("answered", options.progress);
  if (tally.lines_before > 0 && progress.is_wanted()) {
    progress.note("hodograph: going on after " + counted(tally.lines_before, "line"));
  }
  {
    AnswerPool pool(options.jobs);
    Writer writer(pool, output, options, tally, progress, reader.size());
    Line line;
    bool pending = false;
    while (!InterruptGuard::requested() && !pool.stopped()) {
      if (!pending) {
        const LineReader::Next next = reader.next(line, patience);
        if (next == LineReader::Next::end) break;
        pending = next == LineReader::Next::line && !is_blank(line);
      }
      if (pending && pool.has_room(patience)) {
        pool.submit(std::move(line));
        line = Line();
        pending = false;
      }
    }
    if (InterruptGuard::requested()) pool.stop();
    pool.finish();
    writer.finish();
  }
  if (InterruptGuard::requested()) {
    throw Error(Fault{FaultCode::cancelled,
                      "interrupted after " + counted(tally.lines, "line") +
                          (output.can_resume() ? "; --resume goes on from there" : ""),
                      std::nullopt, "", std::nullopt, std::nullopt});
  }
  output.commit();
  const bool skipped = options.on_fault == OnFault::skip && tally.faults > 0;
  if (skipped || progress.was_shown() || options.progress) {
    progress.note("hodograph: " + counted(tally.lines, "line") + ", " +
                  counted(tally.faults, skipped ? "skipped fault" : "fault") + ", " +
                  duration(tally.seconds()));
  }
}

}  // namespace hodograph::cli
