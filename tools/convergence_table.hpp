// SPDX-License-Identifier: MIT
// The convergence of C⁴ Hermite interpolation on curve (23) of PHODCOS, in 60-digit arithmetic.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstddef>
#include <mutex>
#include <thread>
#include <vector>

#include "../tests/support/curves.hpp"
#include "hodograph/construction/derivative_curve.hpp"
#include "hodograph/construction/hermite.hpp"

namespace hodograph::convergence {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>,
                                           boost::multiprecision::et_off>;
using test::Curve23;

/// The largest |γ - p| on N uniform segments.
struct Row {
  Wide sampled{};  ///< over u = i/50 in each segment, as the paper took it
  Wide largest{};  ///< over all u: the three worst segments refined
};

/// Both choices on the same knots.
struct Rows {
  std::size_t segments = 0;
  std::array<Row, 2> of{};  ///< order_six, order_ten
};

inline constexpr std::array<HermiteChoice, 2> choices{HermiteChoice::order_six,
                                                      HermiteChoice::order_ten};

namespace detail {

constexpr int samples = 50;
/// From this many segments on γ is summed from its Taylor series about the segment's middle: its
/// derivatives grow as 9^k, so the remainder of order 31 is below (9/128)^31/31! < 10^-69.
constexpr std::size_t enough_for_series = 64;
constexpr std::size_t series_order = 30;

using Curve = SpatialPhCurve<8, Wide>;

/// The weights of the 17 displacement coefficients after the first (which is 0) at u = i/50.
inline const auto& sample_weights() {
  static const auto table = [] {
    std::array<std::array<Wide, 18>, samples + 1> weights;
    for (int i = 0; i <= samples; ++i) {
      const Wide u = Wide(i) / Wide(samples), v = Wide(1) - u;
      for (std::size_t j = 0; j <= 17; ++j) {
        Wide w(static_cast<double>(binomial(17, j)));
        for (std::size_t k = 0; k < j; ++k) w *= u;
        for (std::size_t k = j; k < 17; ++k) w *= v;
        weights[static_cast<std::size_t>(i)][j] = w;
      }
    }
    return weights;
  }();
  return table;
}

/// γ at the samples of segment k of N.
inline std::array<Vector3<Wide>, samples + 1> sampled_curve(std::size_t k, std::size_t segments) {
  const Curve23 gamma;
  std::array<Vector3<Wide>, samples + 1> values;
  const Wide count(static_cast<double>(segments)), begin(static_cast<double>(k));
  if (segments < enough_for_series) {
    for (int i = 0; i <= samples; ++i) {
      values[static_cast<std::size_t>(i)] = gamma(Wide((begin + Wide(i) / Wide(samples)) / count));
    }
    return values;
  }
  using Series = Taylor<Wide, series_order>;
  const Vector3<Series> series = gamma(Series::variable(Wide((begin + Wide(0.5)) / count)));
  for (int i = 0; i <= samples; ++i) {
    const Wide t = Wide(2 * i - samples) / (Wide(2 * samples) * count);
    for (std::size_t c = 0; c < 3; ++c) {
      Wide sum = series[c][series_order];
      for (std::size_t j = series_order; j-- > 0;) sum = sum * t + series[c][j];
      values[static_cast<std::size_t>(i)][c] = sum;
    }
  }
  return values;
}

/// |γ - p| at one u of segment k.
inline Wide distance(const Curve& curve, std::size_t k, std::size_t segments, const Wide& u) {
  const Wide xi = (Wide(static_cast<double>(k)) + u) / Wide(static_cast<double>(segments));
  return norm(Curve23{}(xi)-curve.position(u));
}

/// The largest |γ - p| near u = i/50, by golden sections over its two neighbours.
inline Wide refined(const Curve& curve, std::size_t k, std::size_t segments, int i) {
  constexpr int steps = 36;  // the maximum is flat: a place to 8 digits gives a value to 16
  const Wide golden = (sqrt(Wide(5)) - Wide(1)) / Wide(2);
  Wide low = Wide(std::max(i - 1, 0)) / Wide(samples);
  Wide high = Wide(std::min(i + 1, samples)) / Wide(samples);
  Wide a = high - golden * (high - low), b = low + golden * (high - low);
  Wide at_a = distance(curve, k, segments, a), at_b = distance(curve, k, segments, b);
  for (int step = 0; step < steps; ++step) {
    if (at_a < at_b) {
      low = a;
      a = b;
      at_a = at_b;
      b = low + golden * (high - low);
      at_b = distance(curve, k, segments, b);
    } else {
      high = b;
      b = a;
      at_b = at_a;
      a = high - golden * (high - low);
      at_a = distance(curve, k, segments, a);
    }
  }
  return at_a < at_b ? at_b : at_a;
}

/// The errors of one segment at the samples, squared.
struct SegmentErrors {
  std::size_t segment = 0;
  Wide largest{-1};
  std::array<Wide, samples + 1> square{};
  friend bool operator<(const SegmentErrors& a, const SegmentErrors& b) {
    return b.largest < a.largest;
  }
};

/// The three segments with the largest errors.
class Worst {
 public:
  void include(const SegmentErrors& errors) {
    worst_.push_back(errors);
    std::sort(worst_.begin(), worst_.end());
    if (worst_.size() > 3) worst_.pop_back();
  }
  const std::vector<SegmentErrors>& segments() const { return worst_; }

 private:
  std::vector<SegmentErrors> worst_;
};

inline SegmentErrors errors_of(const Curve& curve, std::size_t k,
                               const std::array<Vector3<Wide>, samples + 1>& gamma) {
  SegmentErrors errors;
  errors.segment = k;
  const auto& weights = sample_weights();
  for (std::size_t i = 0; i <= samples; ++i) {
    Vector3<Wide> difference = gamma[i] - curve.start();
    for (std::size_t j = 1; j <= 17; ++j) {
      difference -= weights[i][j] * curve.integral()[j].displacement;
    }
    errors.square[i] = dot(difference, difference);
    if (errors.largest < errors.square[i]) errors.largest = errors.square[i];
  }
  return errors;
}

}  // namespace detail

/// The row of N segments, on so many threads.
inline Rows rows(std::size_t segments, unsigned threads) {
  using namespace detail;
  const auto data_at = [&](std::size_t k) {
    return derivatives_of<4, Wide>(
        Curve23{}, Wide(Wide(static_cast<double>(k)) / Wide(static_cast<double>(segments))));
  };
  const Wide h = Wide(1) / Wide(static_cast<double>(segments));
  const auto curve_of = [&](std::size_t k, HermiteChoice choice) {
    return hermite_curve<4, Wide>(data_at(k), data_at(k + 1), h, choice).value();
  };
  sample_weights();

  constexpr std::size_t block = 16;  // segments a thread takes at once
  std::atomic<std::size_t> next{0};
  std::mutex merging;
  std::array<Worst, 2> worst;
  const auto work = [&] {
    std::array<Worst, 2> mine;
    for (std::size_t first; (first = next.fetch_add(block)) < segments;) {
      const std::size_t last = std::min(first + block, segments);
      auto begin = data_at(first);
      for (std::size_t k = first; k < last; ++k) {
        const auto end = data_at(k + 1);
        const auto gamma = sampled_curve(k, segments);
        for (std::size_t c = 0; c < 2; ++c) {
          const Curve curve = hermite_curve<4, Wide>(begin, end, h, choices[c]).value();
          mine[c].include(errors_of(curve, k, gamma));
        }
        begin = end;
      }
    }
    const std::lock_guard lock(merging);
    for (std::size_t c = 0; c < 2; ++c) {
      for (const auto& errors : mine[c].segments()) worst[c].include(errors);
    }
  };
  std::vector<std::thread> pool;
  for (unsigned t = 1; t < threads; ++t) pool.emplace_back(work);
  work();
  for (auto& thread : pool) thread.join();

  Rows result;
  result.segments = segments;
  for (std::size_t c = 0; c < 2; ++c) {
    Row& row = result.of[c];
    row.sampled = row.largest = sqrt(worst[c].segments().front().largest);
    for (const auto& errors : worst[c].segments()) {
      const Curve curve = curve_of(errors.segment, choices[c]);
      for (int i = 0; i <= samples; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const bool peak = (i == 0 || !(errors.square[at] < errors.square[at - 1])) &&
                          (i == samples || !(errors.square[at] < errors.square[at + 1]));
        // A peak below four fifths of the largest is not raised above it by a fiftieth of a step.
        if (!peak || errors.square[at] < Wide(0.64) * worst[c].segments().front().largest) continue;
        const Wide there = refined(curve, errors.segment, segments, i);
        if (row.largest < there) row.largest = there;
      }
    }
  }
  return result;
}

}  // namespace hodograph::convergence
