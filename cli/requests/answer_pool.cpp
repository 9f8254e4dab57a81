// SPDX-License-Identifier: MIT
#include "cli/requests/answer_pool.hpp"

#include <algorithm>
#include <cassert>
#include <new>
#include <system_error>
#include <utility>

#ifdef HODOGRAPH_CLI_FLINT
#include <flint.h>
#endif

namespace hodograph::cli {
namespace {

/// FLINT keeps memory for every thread, and gives it back when it is told that the thread ends.
void end_thread() {
#ifdef HODOGRAPH_CLI_FLINT
  flint_cleanup();
#endif
}

/// Where not even the sentence that says so could be put together.
AnsweredLine no_memory() {
  return {R"({"ok": false, "fault": {"code": "malformed_document", "sentence": "there is not )"
          R"(enough memory", "index": null, "quantity": "memory", "value": null, "bound": null}})",
          Fault{FaultCode::malformed_document, "there is not enough memory", std::nullopt, "memory",
                std::nullopt, std::nullopt}};
}

}  // namespace

std::size_t all_cores() { return std::max(1U, std::thread::hardware_concurrency()); }

AnswerPool::AnswerPool(std::size_t jobs) : jobs_(std::clamp<std::size_t>(jobs, 1, most_jobs)) {}

AnswerPool::~AnswerPool() {
  stop();
  for (std::thread& thread : threads_) thread.join();
}

bool AnswerPool::room() const {
  return !stopped_ &&
         (in_flight_.empty() || (in_flight_.size() < jobs_ * lines_a_job && bytes_ < most_bytes));
}

bool AnswerPool::has_room(std::chrono::milliseconds most) {
  std::unique_lock lock(mutex_);
  if (most > most.zero()) {
    room_there_.wait_for(lock, most, [this] { return stopped_ || room(); });
  }
  return room();
}

void AnswerPool::submit(Line line) {
  auto slot = std::make_shared<Slot>();
  slot->content.line = std::move(line);
  const std::lock_guard lock(mutex_);
  if (stopped_) return;  // by another thread, after has_room
  assert(!finished_);
  bytes_ += slot->content.line.text.size();
  in_flight_.push_back(std::move(slot));
  if (in_flight_.size() - begun_ > idle_ && threads_.size() < jobs_) {
    try {
      threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {  // the machine gives no more threads: those there do it
      if (threads_.empty()) throw;
    }
  }
  work_there_.notify_one();
}

void AnswerPool::finish() {
  const std::lock_guard lock(mutex_);
  finished_ = true;
  answer_there_.notify_all();
  work_there_.notify_all();
}

void AnswerPool::stop() {
  const std::lock_guard lock(mutex_);
  stopped_ = finished_ = true;
  in_flight_.resize(begun_);
  answer_there_.notify_all();
  work_there_.notify_all();
  room_there_.notify_all();
}

bool AnswerPool::stopped() const {
  const std::lock_guard lock(mutex_);
  return stopped_;
}

AnswerPool::Next AnswerPool::take(LineAnswer& answer, std::chrono::milliseconds most) {
  std::unique_lock lock(mutex_);
  const auto settled = [this] { return front_done() || (finished_ && in_flight_.empty()); };
  if (!settled() && most > most.zero()) answer_there_.wait_for(lock, most, settled);
  if (front_done()) {
    answer = std::move(in_flight_.front()->content);
    in_flight_.pop_front();
    --begun_;
    bytes_ -= answer.answer.text.size();
    room_there_.notify_one();
    return Next::answer;
  }
  return settled() ? Next::end : Next::none_yet;
}

bool AnswerPool::ready() const {
  const std::lock_guard lock(mutex_);
  return front_done();
}

void AnswerPool::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    ++idle_;
    work_there_.wait(lock, [this] { return finished_ || begun_ < in_flight_.size(); });
    --idle_;
    if (begun_ == in_flight_.size()) break;  // finished
    const std::shared_ptr<Slot> slot = in_flight_[begun_++];
    lock.unlock();
    Line& line = slot->content.line;
    const std::size_t size = line.text.size();
    try {
      slot->content.answer = answered_line(line.text, line.too_long);
    } catch (const std::bad_alloc&) {
      slot->content.answer = no_memory();
    }
    line.text = std::string();
    lock.lock();
    bytes_ += slot->content.answer.text.size();
    bytes_ -= size;
    slot->done = true;
    if (slot == in_flight_.front()) answer_there_.notify_one();
    if (bytes_ < most_bytes) room_there_.notify_one();
  }
  lock.unlock();
  end_thread();
}

}  // namespace hodograph::cli
