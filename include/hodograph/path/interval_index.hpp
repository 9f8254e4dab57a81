// SPDX-License-Identifier: MIT
// Which interval of an increasing sequence holds a number: constant time on evenly spread
// breakpoints, logarithmic at worst.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hodograph/foundation/scalar.hpp"

namespace hodograph {

/// Buckets of equal width over breakpoints b_0 ≤ b_1 ≤ ... ≤ b_N, four a interval. The
/// breakpoints themselves stay with their owner and are passed to every call.
template <class S>
class IntervalIndex {
 public:
  IntervalIndex() = default;
  /// Domain: at least two breakpoints, non-decreasing, finite.
  explicit IntervalIndex(const std::vector<S>& breakpoints)
      : bucket_start_(4 * (breakpoints.size() - 1) + 1) {
    const S width = breakpoints.back() - breakpoints.front();
    const double buckets = static_cast<double>(bucket_start_.size() - 1);
    buckets_per_unit_ = S(0) < width ? S(buckets) / width : S(0);
    if (!is_finite(buckets_per_unit_)) buckets_per_unit_ = S(0);
    // bucket_start_[b]: the last interval whose left end falls into a bucket before b (or 0).
    const auto intervals = static_cast<std::uint32_t>(breakpoints.size() - 1);
    std::size_t b = 0;
    for (std::uint32_t k = 0; k + 1 < intervals; ++k) {
      const std::size_t next = bucket(breakpoints, breakpoints[k + 1]);
      for (; b <= next; ++b) bucket_start_[b] = k;
    }
    for (; b < bucket_start_.size(); ++b) bucket_start_[b] = intervals - 1;
  }

  /// The k with b_k ≤ x < b_{k+1}; 0 below the first breakpoint, the last interval at and above
  /// the last one. Of several intervals of width zero that hold x, the last.
  std::size_t find(const std::vector<S>& breakpoints, const S& x) const {
    const std::size_t b = bucket(breakpoints, x);
    std::size_t low = bucket_start_[b];
    const std::size_t last = breakpoints.size() - 2;
    // Most buckets hold one breakpoint or none: a step without a branch, then usually no more.
    low += static_cast<std::size_t>(low < last) &
           static_cast<std::size_t>(!(x < breakpoints[low + 1]));
    std::size_t high = b + 1 < bucket_start_.size() ? bucket_start_[b + 1] + 1 : last;
    if (high > last) high = last;
    if (high <= low + 8) {
      while (low < high && !(x < breakpoints[low + 1])) ++low;
      return low;
    }
    const auto first = breakpoints.begin();
    const auto above = std::upper_bound(first + static_cast<std::ptrdiff_t>(low) + 1,
                                        first + static_cast<std::ptrdiff_t>(high) + 1, x);
    return static_cast<std::size_t>(above - first) - 1;
  }

  /// Bytes held on the heap.
  std::size_t memory() const { return bucket_start_.capacity() * sizeof(std::uint32_t); }

 private:
  std::size_t bucket(const std::vector<S>& breakpoints, const S& x) const {
    const double position = to_double(S((x - breakpoints.front()) * buckets_per_unit_));
    const double last = static_cast<double>(static_cast<std::int64_t>(bucket_start_.size()) - 1);
    return position > 0 ? static_cast<std::size_t>(
                              static_cast<std::int64_t>(position < last ? position : last))
                        : 0;
  }

  S buckets_per_unit_{0};
  std::vector<std::uint32_t> bucket_start_;
};

}  // namespace hodograph
