// SPDX-License-Identifier: MIT
// Where the results of a batch go: line by line, so that a run that was broken off can go on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "cli/requests/answer_pool.hpp"

namespace hodograph::cli {

/// What to do with a line that cannot be answered: its fault becomes its result, or it has none, or
/// the run ends there.
enum class OnFault : unsigned char { report, skip, stop };

/// What was done with one line of the input.
enum class LineFate : char { answered = 'a', faulted = 'f', skipped = 's' };
struct LineRecord {
  std::uint64_t request = 0;  ///< the fingerprint of the line
  std::uint64_t answer = 0;   ///< the fingerprint of the result; 0 where it was skipped
  LineFate fate = LineFate::answered;
};

/// Standard output ("-") and what is no regular file are written to directly. Results for the file
/// F go to F.partial, while F.partial.lines says which request each of its lines answers; commit()
/// renames F.partial to F and removes the other. A kill at any time leaves two files of which
/// resume() finds the part that is whole. Faults leave as Error (not_written,
/// malformed_document).
class BatchOutput {
 public:
  /// Nothing is written yet. With `resume` the files of a run that was broken off are taken up,
  /// cut to the lines that are whole and recorded; without, they are refused, as they may be the
  /// work of hours. Also refuses them while another process writes them.
  BatchOutput(const std::string& file, bool resume);
  ~BatchOutput();
  BatchOutput(const BatchOutput&) = delete;
  BatchOutput& operator=(const BatchOutput&) = delete;

  /// How many lines the earlier run did, and what it did with them, one after the other.
  std::uint64_t earlier_lines() const { return earlier_lines_; }
  LineRecord next_earlier();
  /// Whether a run that is broken off can go on.
  bool can_resume() const { return !target_.empty(); }
  /// The name of the file that grows, for sentences.
  const std::string& partial() const { return partial_; }

  /// Adds a result, or the record of a line without one. Written at once where flush() is called
  /// or much has gathered.
  void add(const LineAnswer& one, LineFate fate);
  void flush();
  /// All is done: the file appears under its name. To be called once, last.
  void commit();

 private:
  void open_partial(bool resume, const std::string& file);
  void recover();
  void write(int descriptor, std::string& bytes);
  [[noreturn]] void fail() const;

  std::string shown_, target_, partial_, records_;
  int output_ = -1, record_ = -1;
  bool owns_output_ = false;
  std::string pending_, pending_records_;
  std::uint64_t earlier_lines_ = 0;
  std::unique_ptr<LineReader> earlier_;
  bool empty_ = true;  // no line in the files
};

}  // namespace hodograph::cli
