// SPDX-License-Identifier: MIT
// Files through the POSIX interface: it alone says why something failed and replaces in one step.
#include "hodograph/io/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cerrno>
#include <cstdlib>
#include <memory>
#include <system_error>
#include <utility>

#include "foreign_text.hpp"

namespace hodograph {
namespace {

using io_detail::in_quotes;

constexpr std::size_t buffer_size = std::size_t{1} << 20;
constexpr mode_t new_file_mode = 0666;  // less the user's umask
constexpr mode_t permission_bits = 07777;

std::string reason(int error_number) { return std::generic_category().message(error_number); }

Fault not_read(const std::string& path, const std::string& why) {
  return {FaultCode::malformed_document, "cannot read " + path + ": " + why, std::nullopt, "file"};
}
Fault not_written(const std::string& path, int error_number) {
  return {FaultCode::not_written, "cannot write " + path + ": " + reason(error_number),
          std::nullopt, "file"};
}

std::string shown(const std::string& path, const char* standard_stream) {
  return path == "-" ? standard_stream : in_quotes(path);
}

std::string parent_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

/// A name beside `target` that no other process or thread uses.
std::string temporary_name(const std::string& target, unsigned attempt) {
  static std::atomic<unsigned> counter{0};
  const std::size_t slash = target.rfind('/');
  const std::size_t base = slash == std::string::npos ? 0 : slash + 1;
  constexpr std::size_t longest_kept = 100;  // a name has at most 255 bytes
  return target.substr(0, base) + "." + target.substr(base, longest_kept) + "." +
         std::to_string(::getpid()) + "-" + std::to_string(counter++) + "-" +
         std::to_string(attempt) + ".part";
}

/// A descriptor closed at the end of the scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ > STDERR_FILENO) ::close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

}  // namespace

Result<std::string> read_file(const std::string& path, std::uint64_t limit) {
  const std::string name = shown(path, "standard input");
  const bool standard_input = path == "-";
  const Descriptor file(standard_input ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) return not_read(name, reason(errno));
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) return not_read(name, reason(errno));
  if (S_ISDIR(status.st_mode)) return not_read(name, "it is a directory, not a file");

  const auto too_large = [&](std::uint64_t size) {
    Fault fault = not_read(name, "it is larger than the limit of " + std::to_string(limit) +
                                     " bytes (the file has at least " + std::to_string(size) + ")");
    fault.value = static_cast<double>(size);
    fault.bound = static_cast<double>(limit);
    return fault;
  };
  std::string bytes;
  if (S_ISREG(status.st_mode)) {
    const auto size = static_cast<std::uint64_t>(status.st_size);
    if (size > limit) return too_large(size);
    bytes.reserve(static_cast<std::size_t>(size) + 1);
  }
  std::size_t filled = 0;
  while (true) {
    const std::size_t room = std::max(buffer_size, bytes.capacity() - filled);
    bytes.resize(filled + room);
    const ssize_t count = ::read(file.number(), bytes.data() + filled, room);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return not_read(name, reason(errno));
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
    if (filled > limit) return too_large(filled);
  }
  bytes.resize(filled);
  return bytes;
}

Result<OutputFile> OutputFile::create(const std::string& path) {
  OutputFile file;
  file.shown_name_ = shown(path, "standard output");
  if (path == "-") {
    file.descriptor_ = STDOUT_FILENO;
    return file;
  }
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (!exists && (errno != ENOENT || path.empty())) return not_written(file.shown_name_, errno);
  if (exists && S_ISDIR(status.st_mode)) return not_written(file.shown_name_, EISDIR);
  file.owns_descriptor_ = true;
  if (exists && !S_ISREG(status.st_mode)) {
    file.descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file.descriptor_ < 0) return not_written(file.shown_name_, errno);
    return file;
  }
  if (exists && ::access(path.c_str(), W_OK) != 0) return not_written(file.shown_name_, errno);
  file.target_ = path;
  if (exists) {
    const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr),
                                                           &std::free);
    if (real != nullptr) file.target_ = real.get();
  }
  constexpr unsigned attempts = 100;
  for (unsigned attempt = 0; attempt < attempts && file.descriptor_ < 0; ++attempt) {
    file.temporary_ = temporary_name(file.target_, attempt);
    file.descriptor_ =
        ::open(file.temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, new_file_mode);
    if (file.descriptor_ < 0 && errno != EEXIST) break;
  }
  if (file.descriptor_ < 0) {
    const int error_number = errno;
    file.temporary_.clear();
    return not_written(file.shown_name_, error_number);
  }
  if (exists) (void)::fchmod(file.descriptor_, status.st_mode & permission_bits);
  return file;
}

OutputFile::OutputFile(OutputFile&& other) noexcept { *this = std::move(other); }

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
  if (this == &other) return *this;
  discard();
  shown_name_ = std::move(other.shown_name_);
  target_ = std::move(other.target_);
  temporary_ = std::exchange(other.temporary_, {});
  buffer_ = std::exchange(other.buffer_, {});
  descriptor_ = std::exchange(other.descriptor_, -1);
  owns_descriptor_ = std::exchange(other.owns_descriptor_, false);
  error_number_ = other.error_number_;
  return *this;
}

OutputFile::~OutputFile() { discard(); }

void OutputFile::discard() noexcept {
  if (owns_descriptor_ && descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  descriptor_ = -1;
  temporary_.clear();
  buffer_.clear();
}

void OutputFile::write(std::string_view bytes) {
  assert(descriptor_ >= 0 && "write after commit");
  if (error_number_ != 0) return;
  while (!bytes.empty()) {
    const std::string_view part = bytes.substr(0, buffer_size - buffer_.size());
    buffer_.append(part);
    bytes.remove_prefix(part.size());
    if (buffer_.size() == buffer_size) flush();
  }
}

void OutputFile::flush() {
  std::size_t done = 0;
  while (done < buffer_.size() && error_number_ == 0) {
    const ssize_t count = ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
    if (count >= 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      error_number_ = errno;
    }
  }
  buffer_.clear();
}

std::optional<Fault> OutputFile::commit() {
  assert(descriptor_ >= 0 && "commit twice");
  flush();
  if (!temporary_.empty()) {
    if (error_number_ == 0 && ::fsync(descriptor_) != 0) error_number_ = errno;
    if (::close(std::exchange(descriptor_, -1)) != 0 && error_number_ == 0) error_number_ = errno;
    if (error_number_ == 0 && ::rename(temporary_.c_str(), target_.c_str()) != 0) {
      error_number_ = errno;
    }
    if (error_number_ == 0) {
      temporary_.clear();
      // The new name is on the disk once its directory is; where that cannot be synced, the file
      // itself is complete all the same.
      const Descriptor directory(
          ::open(parent_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
      if (directory.number() >= 0) (void)::fsync(directory.number());
    }
  } else if (owns_descriptor_) {
    if (::close(std::exchange(descriptor_, -1)) != 0 && error_number_ == 0) error_number_ = errno;
  }
  discard();
  if (error_number_ != 0) return not_written(shown_name_, error_number_);
  return std::nullopt;
}

std::optional<Fault> write_file(const std::string& path, std::string_view bytes) {
  auto file = OutputFile::create(path);
  if (!file) return file.fault();
  file->write(bytes);
  return file->commit();
}

}  // namespace hodograph
