// SPDX-License-Identifier: MIT
#include "planar_spline_start.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace hodograph::planar_spline_detail {
namespace {

/// A periodic sequence is solved for as an open one with this many spans of the neighbouring
/// periods at each end: what is assumed there has died out by 0.27 a span, to 2e-13.
constexpr std::size_t margin = 22;

Number square_root(const Number& a) {
  const double square = squared(a);
  const double size = square > 0x1p-900 && square < 0x1p+900  // not a tolerance: safe to square
                          ? std::sqrt(square)
                          : std::hypot(a.re, a.im);
  if (size == 0.0) return {};
  const double larger = std::sqrt(0.5 * (size + std::abs(a.re)));
  const double smaller = std::abs(a.im) / (2.0 * larger);
  const double re = a.re >= 0.0 ? larger : smaller, im = a.re >= 0.0 ? smaller : larger;
  return {re, a.im < 0.0 ? -im : im};
}

/// The weights of uniform knots, and how a tridiagonal elimination remembers its ratios: with these
/// weights they settle to a constant after a few rows.
struct EvenWeights {
  class Ratios {
   public:
    explicit Ratios(std::size_t) {}
    void set(std::size_t k, double ratio) {
      if (k < head_.size()) head_[k] = ratio;
    }
    double operator[](std::size_t k) const {
      return head_[k < head_.size() ? k : head_.size() - 1];
    }

   private:
    std::array<double, 24> head_{};  // each row divides the distance to the constant by 13 or more
  };
  /// Whether row k has the same pivot as the one before it.
  static bool settled(std::size_t k) { return k >= 24; }
  double operator()(std::size_t) const { return 0.5; }
};

/// Any weights, from a function of the node.
template <class Function>
struct AnyWeights {
  class Ratios {
   public:
    explicit Ratios(std::size_t size) : all_(size) {}
    void set(std::size_t k, double ratio) { all_[k] = ratio; }
    double operator[](std::size_t k) const { return all_[k]; }

   private:
    std::vector<double> all_;
  };
  static bool settled(std::size_t) { return false; }
  double operator()(std::size_t k) const { return function(k); }
  Function function;
};

/// Calls use with the weights of a problem; node k of the sequence is node k + shift, periodically.
template <class Use>
void with_weights(const SplineProblem& problem, std::size_t shift, const Use& use) {
  if (problem.weight.empty()) {
    use(EvenWeights{});
  } else {
    const auto weight = [&problem, shift](std::size_t k) {
      const std::size_t at = k + shift;
      return problem.weight[at < problem.weight.size() ? at : at % problem.size()];
    };
    use(AnyWeights<decltype(weight)>{weight});
  }
}

/// From the slopes of the chords, in place, the square roots of the derivatives of the cubic spline
/// at the middle of its spans, with their signs continued (from the last one back).
template <class Weight>
void slopes_to_middles(std::vector<Number>& slope, const Weight& weight) {
  const std::size_t size = slope.size();
  if (size == 1) {
    slope[0] = root_near(slope[0], Number{});
    return;
  }
  // d_0 + d_1 = 2p_0;  g d_{k-1} + 2 d_k + (1 - g) d_{k+1} = 3(g p_{k-1} + (1 - g) p_k);
  // d_{N-1} + d_N = 2 p_{N-1}.
  std::vector<Number> d(size);
  typename Weight::Ratios ratio(size);
  d[0] = 2.0 * slope[0];
  ratio.set(0, 1.0);
  double inverse = 0.0, r = 1.0;
  for (std::size_t k = 1; k < size; ++k) {
    const double g = weight(k);
    if (!Weight::settled(k)) {
      inverse = 1.0 / (2.0 - g * r);
      r = (1.0 - g) * inverse;
      ratio.set(k, r);
    }
    const Number right = (3.0 * inverse) * (g * slope[k - 1] + (1.0 - g) * slope[k]);
    d[k] = right - (inverse * g) * d[k - 1];
  }
  Number later = (1.0 / (1.0 - r)) * (2.0 * slope[size - 1] - d[size - 1]);
  Number root{};
  for (std::size_t k = size; k-- > 0;) {
    const Number here = d[k] - ratio[k] * later;
    const Number next = root_near(1.5 * slope[k] - 0.25 * (here + later), root);
    if (next.re != 0.0 || next.im != 0.0) root = next;
    slope[k] = next;
    later = here;
  }
}

/// In place, for an open sequence: straight ends, or what stands beyond them.
template <class Weight>
void middles_to_unknowns(std::vector<Number>& z, const Weight& weight, const Number* before,
                         const Number* after) {
  const std::size_t size = z.size();
  typename Weight::Ratios ratio(size);
  double inverse = 0.0, r = 0.0;
  std::size_t begin = 0, end = size;
  if (before == nullptr) begin = 1;
  if (after == nullptr) end = end > begin ? end - 1 : begin;
  for (std::size_t i = begin; i < end; ++i) {
    const double g = weight(i), h = weight(i + 1);
    if (!Weight::settled(i)) {
      inverse = 1.0 / ((3.0 - g + h) - g * r);
      r = (1.0 - h) * inverse;
      ratio.set(i, r);
    }
    z[i] = (4.0 * inverse) * z[i] - (inverse * g) * (i > 0 ? z[i - 1] : *before);
  }
  if (begin == end) return;
  Number later = end < size ? z[end] : *after;
  for (std::size_t i = end; i-- > begin;) {
    later = z[i] - ratio[i] * later;
    z[i] = later;
  }
}

/// A periodic sequence laid out `margin` spans beyond both ends: which span entry j is, and whether
/// an odd number of periods away.
struct Unrolled {
  std::size_t size, periods = margin / size + 1, shift = periods * size - margin;
  std::size_t span(std::size_t j) const { return (j + shift) % size; }
  bool odd(std::size_t j) const { return ((j + shift) / size + periods) % 2 == 1; }
};

}  // namespace

Number root_near(const Number& square, const Number& like) {
  const Number root = square_root(square);
  return dot(root, like) < 0.0 ? -root : root;
}

Number middle_value(const SplineProblem& problem, const std::vector<Number>& z, std::size_t i) {
  const SpanCoefficients span = coefficients(problem, z, i);
  return 0.25 * (span.a + 2.0 * span.z + span.b);
}

std::vector<Number> unknowns_to_middles(const SplineProblem& problem,
                                        const std::vector<Number>& z) {
  std::vector<Number> middles(z.size());
  for (std::size_t i = 0; i < z.size(); ++i) middles[i] = middle_value(problem, z, i);
  return middles;
}

std::vector<Number> middles_to_unknowns(const SplineProblem& problem,
                                        const std::vector<Number>& middles) {
  std::vector<Number> z;
  if (problem.first == SplineEnd::periodic) {
    const Unrolled unrolled{middles.size()};
    z.resize(middles.size() + 2 * margin);
    for (std::size_t j = 0; j < z.size(); ++j) {
      z[j] = (unrolled.odd(j) ? problem.closure : 1.0) * middles[unrolled.span(j)];
    }
    with_weights(problem, unrolled.shift,
                 [&](const auto& weight) { middles_to_unknowns(z, weight, nullptr, nullptr); });
    z.erase(z.begin(), z.begin() + margin);
    z.resize(middles.size());
    return z;
  }
  z = middles;
  const Number* before = problem.first == SplineEnd::fixed ? &problem.before : nullptr;
  const Number* after = problem.last == SplineEnd::fixed ? &problem.after : nullptr;
  with_weights(problem, 0,
               [&](const auto& weight) { middles_to_unknowns(z, weight, before, after); });
  return z;
}

std::vector<Number> start_from_cubic_spline(SplineProblem& problem) {
  constexpr double to_slope = 1.0 / 15.0;  // the target is 15 times the chord's slope
  const std::size_t size = problem.size();
  std::vector<Number> z;
  if (problem.first == SplineEnd::periodic) {
    const Unrolled unrolled{size};
    z.resize(size + 2 * margin + 1);
    for (std::size_t j = 0; j < z.size(); ++j) z[j] = to_slope * problem.target[unrolled.span(j)];
    with_weights(problem, unrolled.shift,
                 [&](const auto& weight) { slopes_to_middles(z, weight); });
    problem.closure = dot(z[margin], z[margin + size]) < 0.0 ? -1.0 : 1.0;
    z.erase(z.begin(), z.begin() + margin);
    z.resize(size);
    return middles_to_unknowns(problem, z);
  }
  z.resize(size);
  for (std::size_t i = 0; i < size; ++i) z[i] = to_slope * problem.target[i];
  with_weights(problem, 0, [&](const auto& weight) {
    slopes_to_middles(z, weight);
    middles_to_unknowns(z, weight, nullptr, nullptr);
  });
  return z;
}

}  // namespace hodograph::planar_spline_detail
