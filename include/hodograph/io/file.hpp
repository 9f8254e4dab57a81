// SPDX-License-Identifier: MIT
// Whole files in and out. A file appears under its name only when it is complete.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "hodograph/foundation/result.hpp"

namespace hodograph {

/// The largest file read unless the caller says otherwise: 2 GiB, about two million segments of
/// degree 17.
inline constexpr std::uint64_t default_file_limit = std::uint64_t{1} << 31;

/// The bytes of a file; "-" is standard input.
/// Faults: malformed_document, naming the file and the reason: it does not exist, may not be read,
/// is a directory, or is larger than `limit` bytes (reading stops there: an endless pipe is
/// refused, too).
Result<std::string> read_file(const std::string& path, std::uint64_t limit = default_file_limit);

/// A file being written. The bytes go to a temporary file in the same directory; `commit` moves it
/// to its name in one step, and a file that was there before stays whole until then. Without
/// `commit` nothing is left behind.
///
/// An existing file keeps its permissions, a symbolic link stays a link (its target is replaced).
/// What is no regular file (a device, a pipe) is written to directly, as is standard output, "-".
class OutputFile {
 public:
  /// Faults: not_written, naming the file and the reason.
  static Result<OutputFile> create(const std::string& path);

  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&& other) noexcept;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Appends bytes. After a failure (a full disk) the next `commit` reports it.
  void write(std::string_view bytes);

  /// Flushes to the disk and moves the file to its name. To be called once, last.
  /// Returns the fault (not_written) if anything failed since `create`; then nothing has changed on
  /// the disk.
  std::optional<Fault> commit();

 private:
  OutputFile() = default;
  void flush();
  void discard() noexcept;

  std::string shown_name_;  // as the user wrote it
  std::string target_;      // where the file goes; empty when written directly
  std::string temporary_;
  std::string buffer_;
  int descriptor_ = -1;
  bool owns_descriptor_ = false;
  int error_number_ = 0;
};

/// Writes a whole file (see OutputFile); "-" is standard output. Returns the fault if that failed.
std::optional<Fault> write_file(const std::string& path, std::string_view bytes);

}  // namespace hodograph
