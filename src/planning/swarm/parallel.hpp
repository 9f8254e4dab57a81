// SPDX-License-Identifier: MIT
// A loop shared by threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

#include "hodograph/foundation/interruption.hpp"

namespace hodograph::planning_detail {

/// As many threads as asked for, as the machine runs at once where 0 are, at most one a chunk.
inline std::size_t thread_count(unsigned wanted, std::size_t chunks) {
  const unsigned offered = std::max(1U, std::thread::hardware_concurrency());
  return std::max<std::size_t>(1, std::min<std::size_t>(wanted > 0 ? wanted : offered, chunks));
}

/// body(begin, end, thread) over chunks of [0, count), each once; which thread takes a chunk is
/// open, so a body writes only what its own indices own. Where the calling thread's work is to
/// stop, Error (cancelled), between two chunks or in one; what a body throws is passed on when all
/// threads are done.
template <class Body>
void in_parallel(std::size_t count, std::size_t chunk, unsigned wanted, const Body& body) {
  const std::size_t threads = thread_count(wanted, (count + chunk - 1) / chunk);
  std::atomic<std::size_t> next{0};
  std::vector<std::exception_ptr> thrown(threads);
  const auto work = [&](std::size_t thread) {
    try {
      for (;;) {
        if (thread == 0) check_interruption();
        const std::size_t begin = next.fetch_add(chunk);
        if (begin >= count) return;
        body(begin, std::min(begin + chunk, count), thread);
      }
    } catch (...) {
      thrown[thread] = std::current_exception();
      next = count;  // nothing more for the others
    }
  };
  std::vector<std::thread> others;
  for (std::size_t t = 1; t < threads; ++t) others.emplace_back(work, t);
  work(0);
  for (std::thread& other : others) other.join();
  for (const std::exception_ptr& one : thrown) {
    if (one) std::rethrow_exception(one);
  }
}

}  // namespace hodograph::planning_detail
