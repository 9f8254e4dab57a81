// SPDX-License-Identifier: MIT
#include "cli/requests/line_reader.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "hodograph/foundation/result.hpp"

namespace hodograph::cli {
namespace {

constexpr std::chrono::milliseconds for_ever{-1};  // as poll() has it

}  // namespace

std::uint64_t fingerprint_of(std::string_view text) {
  Fingerprint fingerprint;
  fingerprint.add(text);
  return fingerprint.value();
}

LineReader::LineReader(const std::string& name, std::size_t longest)
    : name_(name),
      longest_(longest),
      descriptor_(name == "-" ? STDIN_FILENO : ::open(name.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (descriptor_ < 0) fail();
}

LineReader::~LineReader() {
  if (descriptor_ > STDIN_FILENO) ::close(descriptor_);
}

void LineReader::fail() const {
  throw Error(Fault{FaultCode::malformed_document,
                    "cannot read " + (name_ == "-" ? "standard input" : "'" + name_ + "'") + ": " +
                        std::generic_category().message(errno),
                    std::nullopt, "file", std::nullopt, std::nullopt});
}

std::optional<std::uint64_t> LineReader::size() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return static_cast<std::uint64_t>(status.st_size);
}

LineReader::Next LineReader::fill(std::chrono::milliseconds most) {
  position_ = filled_ = 0;
  pollfd wanted{descriptor_, POLLIN, 0};
  const int found = ::poll(&wanted, 1, static_cast<int>(most.count()));
  if (found == 0 || (found < 0 && errno == EINTR)) return Next::none_yet;
  const ssize_t count = ::read(descriptor_, buffer_.data(), buffer_.size());
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return Next::none_yet;
  if (count < 0) fail();
  filled_ = static_cast<std::size_t>(count);
  return count == 0 ? Next::end : Next::line;
}

LineReader::Next LineReader::next(Line& line, std::chrono::milliseconds most) {
  const auto finished = [&](bool ended) {
    begun_.ended = ended;
    begun_.number = ++lines_;
    begun_.end = passed_;
    begun_.fingerprint = fingerprint_.value();
    line = std::exchange(begun_, Line());
    fingerprint_ = Fingerprint();
    any_ = false;
    return Next::line;
  };
  for (;;) {
    if (position_ == filled_) {
      const Next filled = fill(most);
      if (filled == Next::none_yet) return filled;
      if (filled == Next::end) return any_ ? finished(false) : Next::end;
    }
    any_ = true;
    const char* const begin = buffer_.data() + position_;
    const void* const end = std::memchr(begin, '\n', filled_ - position_);
    const std::size_t length =
        end == nullptr ? filled_ - position_
                       : static_cast<std::size_t>(static_cast<const char*>(end) - begin);
    const std::size_t taken = length + (end == nullptr ? 0 : 1);
    fingerprint_.add({begin, length});
    if (begun_.text.size() + length > longest_) {
      begun_.too_long = true;
      begun_.text = std::string();
    }
    if (!begun_.too_long) begun_.text.append(begin, length);
    position_ += taken;
    passed_ += taken;
    if (end != nullptr) return finished(true);
  }
}

bool LineReader::next(Line& line) {
  Next found = Next::none_yet;
  while (found == Next::none_yet) found = next(line, for_ever);
  return found == Next::line;
}

}  // namespace hodograph::cli
