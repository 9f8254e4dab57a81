// SPDX-License-Identifier: MIT
// Lines answered by several threads, in order: what comes out first went in first.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "cli/requests/batch.hpp"
#include "cli/requests/line_reader.hpp"

namespace hodograph::cli {

/// As many threads as the machine runs at a time.
std::size_t all_cores();
/// The most threads that may be asked for.
inline constexpr std::size_t most_jobs = 1024;

/// A line and its answer.
struct LineAnswer {
  Line line;  ///< its text is gone
  AnsweredLine answer;
};

/// Memory: lines and answers in flight are at most `lines_a_job` times the number of threads, and
/// no line is taken in while they have more than `most_bytes`. So the memory is that, and what the
/// threads work on. One thread submits, one takes (they may be the same).
class AnswerPool {
 public:
  static constexpr std::size_t lines_a_job = 64;
  static constexpr std::size_t most_bytes = std::size_t{1} << 27U;

  /// Threads are started when there is work for them, up to `jobs`.
  explicit AnswerPool(std::size_t jobs);
  /// Drops what no thread has begun, and waits for what has been begun.
  ~AnswerPool();
  AnswerPool(const AnswerPool&) = delete;
  AnswerPool& operator=(const AnswerPool&) = delete;

  /// Whether a line may be submitted; waits at most so long until one may. False after stop().
  bool has_room(std::chrono::milliseconds most = std::chrono::milliseconds(0));
  /// Throws std::system_error where not a single thread can be started.
  void submit(Line line);
  /// No more lines will come.
  void finish();
  /// Drops the lines that no thread has begun; those before them can still be taken.
  void stop();
  bool stopped() const;

  enum class Next { answer, end, none_yet };
  /// The answer to the oldest line that was not taken; waits for it at most so long.
  Next take(LineAnswer& answer, std::chrono::milliseconds most);
  /// Whether take() would not wait.
  bool ready() const;

 private:
  struct Slot {
    LineAnswer content;
    bool done = false;
  };
  bool room() const;
  bool front_done() const { return !in_flight_.empty() && in_flight_.front()->done; }
  void work();

  const std::size_t jobs_;
  mutable std::mutex mutex_;
  std::condition_variable work_there_, room_there_, answer_there_;
  std::deque<std::shared_ptr<Slot>> in_flight_;  // oldest first
  std::size_t begun_ = 0;                        // of them, the first
  std::size_t bytes_ = 0;
  std::size_t idle_ = 0;
  bool finished_ = false, stopped_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace hodograph::cli
