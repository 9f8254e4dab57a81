// SPDX-License-Identifier: MIT
// The loops behind batch.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>

#include "hodograph/path/batch.hpp"
#include "hodograph/path/detail/batch_kernels.hpp"

namespace hodograph {

namespace batch_detail {

/// Runs shorter than this are evaluated one by one.
inline constexpr std::size_t shortest_run = 3;

inline void require_size(std::size_t size, std::size_t wanted, bool may_be_empty,
                         const char* name) {
  if (size == wanted || (may_be_empty && size == 0)) return;
  throw Error(Fault{FaultCode::mismatched_size,
                    std::string("the span of ") + name + " holds " + std::to_string(size) +
                        " items; it must hold " + std::to_string(wanted) +
                        (may_be_empty ? " or none" : ""),
                    std::nullopt, name, static_cast<double>(size), static_cast<double>(wanted)});
}

template <class S>
void require_inside(std::span<const S> values, const S& low, const S& high, const char* quantity) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (low <= values[i] && values[i] <= high) continue;
    const double x = to_double(values[i]);
    const double bound = x < to_double(low) ? to_double(low) : to_double(high);
    throw Error(Fault{FaultCode::outside_domain,
                      std::string(quantity) + " " + to_text(x) + " (index " + std::to_string(i) +
                          ") is outside [" + to_text(to_double(low)) + ", " +
                          to_text(to_double(high)) + "]",
                      i, quantity, x, bound});
  }
}

template <class A, std::size_t n>
constexpr const Kernels* find_kernels() {
  if constexpr (std::is_same_v<typename A::Scalar, double>) {
    return kernels_for(A::dimension, n);
  } else {
    return nullptr;
  }
}

template <class A, std::size_t n>
SegmentData data_of(const Path<A, n>& path, std::size_t k) {
  const auto& curve = path.segment(k);
  return {&curve.preimage().coefficients()[0][0],
          &curve.integral().coefficients()[0][0],
          &curve.start()[0],
          curve.parameter_step(),
          path.knot_arc_lengths()[k],
          path.knot_arc_lengths()[k + 1]};
}

template <class T>
double* numbers(std::span<T> items, std::size_t first) {
  return items.empty() ? nullptr : reinterpret_cast<double*>(items.data() + first);
}

/// The number of values from `first` on, at most longest_run, that lie in [low, high).
template <class S>
std::size_t run_length(std::span<const S> values, std::size_t first, const S& low, const S& high) {
  const std::size_t last = std::min(values.size(), first + longest_run);
  std::size_t i = first + 1;
  while (i < last && low <= values[i] && values[i] < high) ++i;
  return i - first;
}

/// The common loop of the inverses: runs of lengths on one segment to `run`, the rest to `one`.
template <class A, std::size_t n, class Run, class One>
void for_each_length(const Path<A, n>& path, std::span<const typename A::Scalar> s, const Run& run,
                     const One& one) {
  require_inside(s, typename A::Scalar(0), path.arc_length(), "arc length");
  const Kernels* kernels = find_kernels<A, n>();
  for (std::size_t i = 0; i < s.size();) {
    std::size_t count = 1;
    if constexpr (std::is_same_v<typename A::Scalar, double>) {
      if (kernels != nullptr && s[i] < path.arc_length()) {
        const std::size_t k = path.segment_at_arc_length(s[i]);
        const double begin = path.knot_arc_lengths()[k];
        count = run_length(s, i, begin, path.knot_arc_lengths()[k + 1]);
        if (count >= shortest_run) {
          const ArcLengthTable& table = path.arc_length_table(k);
          std::array<double, longest_run> t, guess;
          std::array<unsigned char, longest_run> settled;
          for (std::size_t j = 0; j < count; ++j) t[j] = s[i + j] - begin;
          for (std::size_t j = 0; j < count; ++j) guess[j] = table.guess(t[j]);
          run(*kernels, k, i, t.data(), guess.data(), count, settled.data());
          const double length = path.segment(k).arc_length();
          for (std::size_t j = 0; j < count; ++j) {
            // Lengths at the ends of the segment need no search; one by one they come out exact.
            if (settled[j] == 0 || !(0.0 < t[j] && t[j] < length)) one(i + j);
          }
          i += count;
          continue;
        }
      }
    }
    for (const std::size_t end = i + count; i < end; ++i) one(i);
  }
}

}  // namespace batch_detail

template <PreimageAlgebra A, std::size_t n>
void parameters_at_arc_lengths(const Path<A, n>& path, std::span<const typename A::Scalar> s,
                               std::span<typename A::Scalar> xi) {
  using namespace batch_detail;
  require_size(xi.size(), s.size(), false, "parameters");
  for_each_length(
      path, s,
      [&](const Kernels& kernels, std::size_t k, std::size_t first, const double* t,
          const double* guess, std::size_t count, unsigned char* settled) {
        if constexpr (std::is_same_v<typename A::Scalar, double>) {
          const auto& curve = path.segment(k);
          const double margin = (2.0 * accuracy::arc_length_error<double>(n)) *
                                (curve.parameter_step() * curve.speed_bound());
          std::array<double, longest_run> u;
          kernels.parameters(data_of(path, k), margin, t, guess, count, u.data(), settled);
          for (std::size_t j = 0; j < count; ++j) xi[first + j] = path.xi_of({k, u[j]});
        }
      },
      [&](std::size_t i) { xi[i] = parameter_at_arc_length(path, s[i]); });
}

template <PreimageAlgebra A, std::size_t n>
void points_at_arc_lengths(const Path<A, n>& path, std::span<const typename A::Scalar> s,
                           std::span<point_t<A>> points) {
  using namespace batch_detail;
  require_size(points.size(), s.size(), false, "points");
  for_each_length(
      path, s,
      [&](const Kernels& kernels, std::size_t k, std::size_t first, const double* t,
          const double* guess, std::size_t count, unsigned char* settled) {
        if constexpr (std::is_same_v<typename A::Scalar, double>) {
          kernels.points(data_of(path, k), t, guess, count, numbers(points, first), settled);
        }
      },
      [&](std::size_t i) { points[i] = point_at_arc_length(path, s[i]); });
}

}  // namespace hodograph
