// SPDX-License-Identifier: MIT
#include "cli/requests/batch_output.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <memory>
#include <system_error>
#include <utility>

#include "hodograph/foundation/result.hpp"
#include "hodograph/foundation/version.hpp"

namespace hodograph::cli {
namespace {

constexpr std::size_t gathered_bytes = std::size_t{1} << 20U;
constexpr mode_t new_file_mode = 0666;  // less the user's umask
constexpr mode_t permission_bits = 07777;

/// The first line of the records. Another version may answer differently: it does not go on.
std::string heading() { return std::string("hodograph batch 1, version ") + version + "\n"; }

// A record is a line of fixed length: two fingerprints in hexadecimal and a letter.
constexpr std::size_t digits = 16;
constexpr std::size_t record_size = 2 * digits + 4;

void append_hexadecimal(std::string& out, std::uint64_t value) {
  std::array<char, digits> text{};
  const auto end = std::to_chars(text.begin(), text.end(), value, 16).ptr;
  out.append(digits - static_cast<std::size_t>(end - text.begin()), '0');
  out.append(text.begin(), end);
}

std::string text_of(const LineRecord& record) {
  std::string out;
  append_hexadecimal(out, record.request);
  out += ' ';
  append_hexadecimal(out, record.answer);
  out += ' ';
  out += static_cast<char>(record.fate);
  return out + '\n';
}

/// Reads a record as it was written, byte for byte.
bool parse(const Line& line, LineRecord& record) {
  const std::string& text = line.text;
  if (!line.ended || text.size() + 1 != record_size) return false;
  const char* const begin = text.data();
  std::from_chars(begin, begin + digits, record.request, 16);
  std::from_chars(begin + digits + 1, begin + 2 * digits + 1, record.answer, 16);
  record.fate = static_cast<LineFate>(text.back());
  switch (record.fate) {
    case LineFate::answered:
    case LineFate::faulted:
    case LineFate::skipped:
      return text_of(record) == text + '\n';
  }
  return false;
}

Fault not_written(const std::string& what, const std::string& why) {
  return {FaultCode::not_written, "cannot write " + what + ": " + why,
          std::nullopt,           "file",
          std::nullopt,           std::nullopt};
}

[[noreturn]] void refuse(std::string sentence) {
  throw Error(Fault{FaultCode::malformed_document, std::move(sentence), std::nullopt, "file",
                    std::nullopt, std::nullopt});
}

std::string parent_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace

void BatchOutput::fail() const {
  throw Error(not_written(shown_, std::generic_category().message(errno)));
}

BatchOutput::BatchOutput(const std::string& file, bool resume)
    : shown_(file == "-" ? "standard output" : "'" + file + "'") {
  struct stat status {};
  const bool exists = file != "-" && ::stat(file.c_str(), &status) == 0;
  if (file != "-" && !exists && (errno != ENOENT || file.empty())) fail();
  if (exists && S_ISDIR(status.st_mode)) {
    errno = EISDIR;
    fail();
  }
  if (file == "-" || (exists && !S_ISREG(status.st_mode))) {
    if (resume) refuse("what went to " + shown_ + " is gone; a run goes on in a file (-o FILE)");
    output_ = file == "-" ? STDOUT_FILENO : ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
    owns_output_ = file != "-";
    if (output_ < 0) fail();
    return;
  }
  if (exists && ::access(file.c_str(), W_OK) != 0) fail();
  target_ = file;
  if (exists) {
    const std::unique_ptr<char, decltype(&std::free)> real(::realpath(file.c_str(), nullptr),
                                                           &std::free);
    if (real != nullptr) target_ = real.get();
  }
  partial_ = target_ + ".partial";
  records_ = partial_ + ".lines";
  open_partial(resume, file);
  if (exists) (void)::fchmod(output_, status.st_mode & permission_bits);
}

void BatchOutput::open_partial(bool resume, const std::string& file) {
  owns_output_ = true;
  output_ = ::open(partial_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, new_file_mode);
  const bool found = output_ < 0 && errno == EEXIST;
  if (found) {
    if (!resume) {
      refuse("'" + file + ".partial' is there, of a run that was broken off or still goes on: go " +
             "on with --resume, or remove that file");
    }
    output_ = ::open(partial_.c_str(), O_RDWR | O_CLOEXEC);
  }
  if (output_ < 0) fail();
  if (::flock(output_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    refuse("'" + file + ".partial' is being written by another process");
  }
  constexpr int read_and_write = O_RDWR | O_CREAT | O_CLOEXEC;
  record_ =
      ::open(records_.c_str(), found ? read_and_write : read_and_write | O_TRUNC, new_file_mode);
  if (record_ < 0) fail();
  if (found) recover();
  if (earlier_lines_ == 0) {
    if (::ftruncate(output_, 0) != 0 || ::ftruncate(record_, 0) != 0) fail();
    pending_records_ = heading();
  }
  empty_ = earlier_lines_ == 0;
}

/// Finds the lines that are whole, and cuts the rest off.
void BatchOutput::recover() {
  struct stat status {};
  if (::fstat(output_, &status) != 0) fail();
  LineReader records(records_, record_size);
  Line line, result;
  const bool any = records.next(line);
  if (status.st_size == 0) return;  // nothing to lose
  if (!any || line.text + '\n' != heading()) {
    refuse("'" + partial_ + "' cannot be gone on with, as '" + records_ +
           "' is not what this version of the program writes beside it; remove the two to start "
           "afresh");
  }
  std::uint64_t records_end = line.end, results_end = 0;
  LineReader results(partial_, 0);  // fingerprints alone
  LineRecord record;
  while (records.next(line) && parse(line, record)) {
    if (record.fate != LineFate::skipped) {
      if (!results.next(result) || !result.ended || result.fingerprint != record.answer) break;
      results_end = result.end;
    }
    records_end = line.end;
    ++earlier_lines_;
  }
  for (const auto& [descriptor, end] : {std::pair(output_, results_end), {record_, records_end}}) {
    const auto offset = static_cast<off_t>(end);
    if (::ftruncate(descriptor, offset) != 0 || ::lseek(descriptor, offset, SEEK_SET) < 0) fail();
  }
}

BatchOutput::~BatchOutput() {
  if (!target_.empty() && empty_) {  // nothing to go on with
    ::unlink(records_.c_str());
    ::unlink(partial_.c_str());
  }
  if (owns_output_ && output_ >= 0) ::close(output_);
  if (record_ >= 0) ::close(record_);
}

LineRecord BatchOutput::next_earlier() {
  Line line;
  if (!earlier_) {
    earlier_ = std::make_unique<LineReader>(records_, record_size);
    earlier_->next(line);  // the heading
  }
  LineRecord record;
  if (!earlier_->next(line) || !parse(line, record)) {  // it was there a moment ago
    refuse("'" + records_ + "' is being changed by somebody else");
  }
  return record;
}

void BatchOutput::add(const LineAnswer& one, LineFate fate) {
  empty_ = false;
  if (fate != LineFate::skipped) {
    pending_ += one.answer.text;
    pending_ += '\n';
  }
  if (!target_.empty()) {
    pending_records_ +=
        text_of({one.line.fingerprint,
                 fate == LineFate::skipped ? 0 : fingerprint_of(one.answer.text), fate});
  }
  if (pending_.size() > gathered_bytes) flush();
}

void BatchOutput::write(int descriptor, std::string& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::write(descriptor, bytes.data() + done, bytes.size() - done);
    if (count >= 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      bytes.erase(0, done);
      fail();
    }
  }
  bytes.clear();
}

void BatchOutput::flush() {
  // The records first: where the disk is full after that, recover() keeps the lines that are whole.
  if (record_ >= 0 && !pending_records_.empty()) write(record_, pending_records_);
  if (!pending_.empty()) write(output_, pending_);
}

void BatchOutput::commit() {
  flush();
  if (!target_.empty()) {
    if (::fsync(output_) != 0 || ::rename(partial_.c_str(), target_.c_str()) != 0) fail();
    ::unlink(records_.c_str());
    const int folder = ::open(parent_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder >= 0) {
      (void)::fsync(folder);
      ::close(folder);
    }
    target_.clear();
  }
  if (owns_output_ && ::close(std::exchange(output_, -1)) != 0) fail();
}

}  // namespace hodograph::cli
