// SPDX-License-Identifier: MIT
// What do a path's functions and their first two derivatives cost at the nodes of an optimal
// control problem, against cubic B-spline interpolants of the same functions?
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

#include "support/measure.hpp"
#if defined(HODOGRAPH_HAS_CONTROL)
#include "hodograph/control/lunar_ascent.hpp"
#include "hodograph/control/reference_path.hpp"

namespace {

using namespace hodograph;

constexpr double horizon_begin = 0.5, horizon_end = 0.58;
constexpr std::size_t nodes = 100;

/// Position, frame, body rate, speed.
constexpr std::size_t functions = 3 + 9 + 3 + 1;
using Values = std::array<std::array<double, functions>, 3>;  // with two derivatives
/// The same as they are stored: in whole cache lines, as those of the path.
struct alignas(64) Results : std::array<double, 3 * functions> {};

Values flat(const ReferenceJet<Quaternion<double>>& jet) {
  Values values;
  for (std::size_t r = 0; r < 3; ++r) {
    std::size_t at = 0;
    const auto put = [&](const Vector3<double>& v) {
      for (std::size_t i = 0; i < 3; ++i) values[r][at++] = v[i];
    };
    put(jet.position[r]);
    put(jet.frame[r].e1);
    put(jet.frame[r].e2);
    put(jet.frame[r].e3);
    put(jet.body_rate[r]);
    values[r][at] = jet.speed[r];
  }
  return values;
}

/// All functions interpolated at evenly spaced ξ by one cubic B-spline with their slopes at the
/// ends; the coefficients of all functions at a knot lie together.
class CubicSpline {
 public:
  CubicSpline(const ReferencePath<Quaternion<double>>& path, std::size_t intervals)
      : step_((horizon_end - horizon_begin) / static_cast<double>(intervals)),
        coefficients_(intervals + 3) {
    std::vector<std::array<double, functions>>& c = coefficients_;
    std::array<double, functions> begin{}, end{};
    for (std::size_t k = 0; k <= intervals; ++k) {
      const Values v = flat(path.at(horizon_begin + step_ * static_cast<double>(k)));
      c[k + 1] = v[0];
      if (k == 0) begin = v[1];
      if (k == intervals) end = v[1];
    }
    // (c_{k-1} + 4 c_k + c_{k+1})/6 = f_k and (c_{k+1} - c_{k-1})/(2h) = f' at both ends.
    std::vector<double> above(intervals + 2);
    for (std::size_t f = 0; f < functions; ++f) {
      double divisor = 4.0;
      above[1] = 2.0 / divisor;
      c[1][f] = (6.0 * c[1][f] + 2.0 * step_ * begin[f]) / divisor;
      for (std::size_t k = 2; k <= intervals + 1; ++k) {
        const bool last = k == intervals + 1;
        const double below = last ? 2.0 : 1.0;
        divisor = 4.0 - below * above[k - 1];
        above[k] = 1.0 / divisor;
        const double right = 6.0 * c[k][f] - (last ? 2.0 * step_ * end[f] : 0.0);
        c[k][f] = (right - below * c[k - 1][f]) / divisor;
      }
      for (std::size_t k = intervals + 1; k-- > 1;) c[k][f] -= above[k] * c[k + 1][f];
      c[0][f] = c[2][f] - 2.0 * step_ * begin[f];
      c[intervals + 2][f] = c[intervals][f] + 2.0 * step_ * end[f];
    }
  }
  std::size_t bytes() const { return coefficients_.size() * sizeof coefficients_[0]; }

  /// At one ξ, into 3 times `functions` numbers.
  [[gnu::always_inline]] void at(double xi, double* to) const {
    const double x = (xi - horizon_begin) / step_;
    const auto k = std::min(static_cast<std::size_t>(x), coefficients_.size() - 4);
    const double t = x - static_cast<double>(k), s = 1.0 - t;
    const double once = 1.0 / step_, twice = once * once;
    const std::array<std::array<double, 4>, 3> weight{
        {{s * s * s / 6, (4 - 6 * t * t + 3 * t * t * t) / 6, (4 - 6 * s * s + 3 * s * s * s) / 6,
          t * t * t / 6},
         {-once * s * s / 2, once * (3 * t * t - 4 * t) / 2, once * (4 * s - 3 * s * s) / 2,
          once * t * t / 2},
         {twice * s, twice * (3 * t - 2), twice * (3 * s - 2), twice * t}}};
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t f = 0; f < functions; ++f) {
        to[r * functions + f] =
            weight[r][0] * coefficients_[k][f] + weight[r][1] * coefficients_[k + 1][f] +
            weight[r][2] * coefficients_[k + 2][f] + weight[r][3] * coefficients_[k + 3][f];
      }
    }
  }
  Values at(double xi) const {
    Values values;
    at(xi, values[0].data());
    return values;
  }
  /// At many, compiled as everything here, and for every width of register that the path's
  /// functions are compiled for, which the processor chooses from.
  void at(const std::vector<double>& xi, double* to) const {
    for (const double x : xi) {
      at(x, to);
      to += 3 * functions;
    }
  }
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
  [[gnu::target_clones("default", "avx2", "avx512f")]]
#endif
  void
  at_wide(const std::vector<double>& xi, double* to) const {
    for (const double x : xi) {
      at(x, to);
      to += 3 * functions;
    }
  }

 private:
  double step_;
  std::vector<std::array<double, functions>> coefficients_;
};

/// Largest error of the functions (or of their derivative r), relative to the largest component of
/// the vector, frame or number they belong to.
double error_of(const CubicSpline& spline, const ReferencePath<Quaternion<double>>& path,
                std::size_t r) {
  std::array<double, functions> size{}, error{};
  constexpr std::size_t samples = 20011;
  for (std::size_t i = 0; i <= samples; ++i) {
    const double share = static_cast<double>(i) / samples;
    const double xi = horizon_begin + share * (horizon_end - horizon_begin);
    const Values exact = flat(path.at(xi)), value = spline.at(xi);
    for (std::size_t f = 0; f < functions; ++f) {
      size[f] = std::max(size[f], std::abs(exact[r][f]));
      error[f] = std::max(error[f], std::abs(exact[r][f] - value[r][f]));
    }
  }
  double largest = 0.0;
  for (const auto& [first, last] : {std::pair{0, 3}, {3, 12}, {12, 15}, {15, 16}}) {
    largest = std::max(largest, *std::max_element(error.begin() + first, error.begin() + last) /
                                    *std::max_element(size.begin() + first, size.begin() + last));
  }
  return largest;
}

/// The coarsest spline (with a power of two of intervals) whose functions, or whose derivatives of
/// this order, are within 1e-9.
std::shared_ptr<CubicSpline> spline_of(const ReferencePath<Quaternion<double>>& path,
                                       std::size_t order) {
  constexpr double accuracy = 1e-9;  // not a tolerance: that of the rival
  constexpr std::size_t most_intervals = 1U << 19U;
  std::shared_ptr<CubicSpline> spline;
  std::size_t intervals = 256;
  for (;; intervals *= 2) {
    spline = std::make_shared<CubicSpline>(path, intervals);
    if (error_of(*spline, path, order) <= accuracy || intervals == most_intervals) break;
  }
  std::printf(
      "cubic B-spline, %s at 1e-9: %zu intervals, %.1f MiB; errors of f, f', f'' %.1e %.1e %.1e\n",
      order == 0 ? "values" : "values and first derivatives", intervals,
      static_cast<double>(spline->bytes()) / 1048576, error_of(*spline, path, 0),
      error_of(*spline, path, 1), error_of(*spline, path, 2));
  return spline;
}

}  // namespace

int main() {
  const AscentReference reference = AscentReference::gateway().value();
  const auto path = ReferencePath<Quaternion<double>>::of(AnyPath(reference.path())).value();
  std::vector<double> xi;
  for (std::size_t k = 0; k < nodes; ++k) {
    xi.push_back(horizon_begin + (horizon_end - horizon_begin) * static_cast<double>(k) / nodes);
  }
  const auto values = spline_of(path, 0), slopes = spline_of(path, 1);
  std::vector<Results> numbers(nodes);
  std::vector<ReferenceJet<Quaternion<double>>> jets(nodes);
  const auto items = static_cast<double>(nodes);
  constexpr int repetitions = 301;
  bench::compare(
      "position, frame, angular velocity, speed with two derivatives, a node (100 nodes)",
      {{"cubic B-spline of the values at 1e-9",
        [&] {
          values->at(xi, numbers[0].data());
          bench::keep(numbers);
        },
        items},
       {"the same in this processor's widest registers",
        [&] {
          values->at_wide(xi, numbers[0].data());
          bench::keep(numbers);
        },
        items},
       {"cubic B-spline of the first derivatives at 1e-9",
        [&] {
          slopes->at(xi, numbers[0].data());
          bench::keep(numbers);
        },
        items},
       {"the same in this processor's widest registers",
        [&] {
          slopes->at_wide(xi, numbers[0].data());
          bench::keep(numbers);
        },
        items},
       {"the path's exact functions, all nodes at once",
        [&] {
          path.at(xi, jets);
          bench::keep(jets);
        },
        items},
       {"the path's exact functions, node by node",
        [&] {
          for (const double x : xi) bench::keep(path.at(x));
        },
        items}},
      repetitions);
}
#else
int main() { std::puts("built without the component control"); }
#endif
