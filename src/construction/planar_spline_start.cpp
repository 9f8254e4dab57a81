// SPDX-License-Identifier: MIT
#include "planar_spline_start.hpp"

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

/// The derivatives of the cubic spline at the middle of its spans, from the slopes of the chords,
/// in place. `weight` at the inner nodes, as in SplineProblem.
template <class Weight>
void slopes_to_middle_derivatives(std::vector<Number>& slope, const Weight& weight) {
  const std::size_t size = slope.size();
  if (size == 1) return;
  // d_0 + d_1 = 2p_0;  g d_{k-1} + 2 d_k + (1 - g) d_{k+1} = 3(g p_{k-1} + (1 - g) p_k);
  // d_{N-1} + d_N = 2 p_{N-1}.
  std::vector<Number> d(size + 1);
  std::vector<double> ratio(size + 1);
  d[0] = 2.0 * slope[0];
  ratio[0] = 1.0;
  for (std::size_t k = 1; k < size; ++k) {
    const double g = weight(k), inverse = 1.0 / (2.0 - g * ratio[k - 1]);
    const Number right = 3.0 * (g * slope[k - 1] + (1.0 - g) * slope[k]);
    d[k] = inverse * (right - g * d[k - 1]);
    ratio[k] = (1.0 - g) * inverse;
  }
  d[size] = (1.0 / (1.0 - ratio[size - 1])) * (2.0 * slope[size - 1] - d[size - 1]);
  for (std::size_t k = size; k-- > 0;) d[k] -= ratio[k] * d[k + 1];
  for (std::size_t i = 0; i < size; ++i) {
    slope[i] = 1.5 * slope[i] - 0.25 * (d[i] + d[i + 1]);
  }
}

/// The roots with their signs continued; returns nothing, in place.
void continue_roots(std::vector<Number>& square) {
  Number before{};
  for (Number& x : square) {
    x = root_near(x, before);
    if (x.re != 0.0 || x.im != 0.0) before = x;
  }
}

/// In place, for an open sequence. `left`, `right`: what a fixed end contributes, or straight.
template <class Weight>
void middles_to_unknowns_in_place(std::vector<Number>& z, const Weight& weight, bool left_straight,
                                  bool right_straight, const Number& before, const Number& after) {
  const std::size_t size = z.size();
  std::vector<double> ratio(size);
  double r = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    const bool first = i == 0, last = i + 1 == size;
    if ((first && left_straight) || (last && right_straight)) {
      ratio[i] = r = 0.0;
      continue;
    }
    const double g = weight(i), h = weight(i + 1);  // lower weight and own weight on the right
    Number right = 4.0 * z[i] - g * (first ? before : z[i - 1]);
    if (last) right -= (1.0 - h) * after;
    const double inverse = 1.0 / ((3.0 - g + h) - (first ? 0.0 : g * r));
    z[i] = inverse * right;
    ratio[i] = r = last ? 0.0 : (1.0 - h) * inverse;
  }
  for (std::size_t i = size - 1; i-- > 0;) z[i] -= ratio[i] * z[i + 1];
}

}  // namespace

Number root_near(const Number& square, const Number& like) {
  const Number root = square_root(square);
  return dot(root, like) < 0.0 ? -root : root;
}

std::vector<Number> middles_to_unknowns(const SplineProblem& problem,
                                        const std::vector<Number>& middles) {
  const std::size_t size = middles.size();
  if (problem.first == SplineEnd::periodic) {
    // Unrolled: entry j of the long sequence is span j - margin, times closure for every period.
    std::vector<Number> z(size + 2 * margin);
    const std::size_t periods = margin / size + 1, shift = periods * size - margin;
    for (std::size_t j = 0; j < z.size(); ++j) {
      const std::size_t at = j + shift;
      const bool odd = ((at / size + periods) % 2) == 1;
      z[j] = (odd ? problem.closure : 1.0) * middles[at % size];
    }
    const auto weight = [&](std::size_t k) { return problem.weight_at((k + shift) % size); };
    middles_to_unknowns_in_place(z, weight, true, true, Number{}, Number{});
    return {z.begin() + margin, z.begin() + static_cast<std::ptrdiff_t>(margin + size)};
  }
  std::vector<Number> z = middles;
  const auto solve = [&](const auto& weight) {
    middles_to_unknowns_in_place(z, weight, problem.first == SplineEnd::straight,
                                 problem.last == SplineEnd::straight, problem.before,
                                 problem.after);
  };
  if (problem.weight.empty()) {
    solve([](std::size_t) { return 0.5; });
  } else {
    solve([&](std::size_t k) { return problem.weight[k]; });
  }
  return z;
}

Number middle_value(const SplineProblem& problem, const std::vector<Number>& z, std::size_t i) {
  const std::size_t size = z.size();
  const bool periodic = problem.first == SplineEnd::periodic;
  if ((i == 0 && problem.first == SplineEnd::straight) ||
      (i + 1 == size && problem.last == SplineEnd::straight)) {
    return z[i];
  }
  const double g = problem.weight_at(i), h = problem.weight_at(i + 1);
  const Number x = i > 0 ? z[i - 1] : periodic ? problem.closure * z[size - 1] : problem.before;
  const Number y = i + 1 < size ? z[i + 1] : periodic ? problem.closure * z[0] : problem.after;
  return 0.25 * (g * x + (3.0 - g + h) * z[i] + (1.0 - h) * y);
}

std::vector<Number> unknowns_to_middles(const SplineProblem& problem,
                                        const std::vector<Number>& z) {
  std::vector<Number> middles(z.size());
  for (std::size_t i = 0; i < z.size(); ++i) middles[i] = middle_value(problem, z, i);
  return middles;
}

std::vector<Number> start_from_cubic_spline(SplineProblem& problem) {
  const std::size_t size = problem.size();
  const double third = 1.0 / 15.0;  // the target is 15 times the slope
  if (problem.first == SplineEnd::periodic) {
    const std::size_t periods = margin / size + 1, shift = periods * size - margin;
    std::vector<Number> slope(size + 2 * margin + 1);
    for (std::size_t j = 0; j < slope.size(); ++j) {
      slope[j] = third * problem.target[(j + shift) % size];
    }
    slopes_to_middle_derivatives(
        slope, [&](std::size_t k) { return problem.weight_at((k + shift) % size); });
    std::vector<Number> middles(slope.begin() + margin,
                                slope.begin() + static_cast<std::ptrdiff_t>(margin + size + 1));
    middles.back() = middles.front();  // one period later
    continue_roots(middles);
    problem.closure = dot(middles.back(), middles.front()) < 0.0 ? -1.0 : 1.0;
    middles.pop_back();
    return middles_to_unknowns(problem, middles);
  }
  std::vector<Number> middles(size);
  for (std::size_t i = 0; i < size; ++i) middles[i] = third * problem.target[i];
  if (problem.weight.empty()) {
    slopes_to_middle_derivatives(middles, [](std::size_t) { return 0.5; });
  } else {
    slopes_to_middle_derivatives(middles, [&](std::size_t k) { return problem.weight[k]; });
  }
  continue_roots(middles);
  return middles_to_unknowns(problem, middles);
}

}  // namespace hodograph::planar_spline_detail
