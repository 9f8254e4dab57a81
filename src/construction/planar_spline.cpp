// SPDX-License-Identifier: MIT
#include "hodograph/construction/planar_spline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "hodograph/path/bending_energy.hpp"
#include "planar_spline_solver.hpp"

namespace hodograph {
namespace {

using planar_spline_detail::Number;
using planar_spline_detail::SplineEnd;
using planar_spline_detail::SplineProblem;

using Points = std::vector<Vector2<double>>;

Fault repeated_fault(std::size_t index) {
  return {FaultCode::outside_domain,
          "point " + std::to_string(index) +
              " is equal to the one before it; neighbouring points must differ (or be merged)",
          index,
          "distance",
          0.0,
          0.0};
}

/// The points to go through, without repetitions, and their indices; the first one is again the
/// last of a closed spline.
struct Nodes {
  Points kept;  ///< only filled when points were left out
  std::vector<std::size_t> index;
  std::span<const Vector2<double>> points;  ///< without the closing one
  std::size_t spans = 0;
  std::size_t merged = 0;

  const Vector2<double>& at(std::size_t k) const {
    return points[k < points.size() ? k : k - points.size()];
  }
  std::size_t index_of(std::size_t k) const {
    const std::size_t at = k < points.size() ? k : k - points.size();
    return index.empty() ? at : index[at];
  }
};

std::optional<Fault> choose_nodes(std::span<const Vector2<double>> points,
                                  const PlanarSplineOptions& options, Nodes& nodes) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!is_finite(points[k])) {
      return Fault{FaultCode::not_finite,
                   "point " + std::to_string(k) + " has a coordinate that is not finite",
                   k,
                   "point",
                   std::nullopt,
                   std::nullopt};
    }
  }
  if (options.closed && points.size() > 1 && points.front() == points.back()) {
    points = points.first(points.size() - 1);
  }
  nodes.points = points;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const bool repeated = points[k] == points[k - 1];
    if (repeated && options.repeated == RepeatedPoints::refuse) return repeated_fault(k);
    if (repeated && nodes.merged == 0) {
      nodes.kept.assign(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(k));
      for (std::size_t i = 0; i < k; ++i) nodes.index.push_back(i);
    }
    if (repeated) {
      ++nodes.merged;
    } else if (nodes.merged > 0) {
      nodes.kept.push_back(points[k]);
      nodes.index.push_back(k);
    }
  }
  if (options.closed && points.size() > 1 && points.front() == points.back()) {
    // A closing point that was given more than once.
    if (options.repeated == RepeatedPoints::refuse) return repeated_fault(points.size());
    if (nodes.merged == 0) {
      nodes.kept.assign(points.begin(), points.end());
      for (std::size_t i = 0; i < points.size(); ++i) nodes.index.push_back(i);
    }
    nodes.kept.pop_back();
    nodes.index.pop_back();
    ++nodes.merged;
  }
  if (nodes.merged > 0) nodes.points = nodes.kept;
  const std::size_t count = nodes.points.size();
  if (count < 2) {
    return Fault{FaultCode::too_few,
                 "a spline needs at least 2 points" +
                     std::string(nodes.merged > 0 ? " that differ" : "") + "; got " +
                     std::to_string(count),
                 std::nullopt,
                 "points",
                 static_cast<double>(count),
                 2.0};
  }
  nodes.spans = options.closed ? count : count - 1;
  return std::nullopt;
}

Fault overflow_fault(std::size_t index) {
  return {FaultCode::not_finite,
          "point " + std::to_string(index) +
              " is farther from the next one than a double can hold; scale the points down",
          index,
          "distance",
          std::nullopt,
          std::nullopt};
}

/// The equations, scaled by 4^-exponent, and the knots.
std::optional<Fault> set_up(const Nodes& nodes, const PlanarSplineOptions& options,
                            SplineProblem& problem, std::vector<double>& knots, int& exponent) {
  const std::size_t size = nodes.spans;
  const bool uniform = options.parameters == SplineParameters::uniform;
  problem.target.resize(size);
  knots.resize(size + 1);
  if (!uniform) problem.step.resize(size);
  double largest = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    const Vector2<double> chord = nodes.at(i + 1) - nodes.at(i);
    problem.target[i] = {chord.x, chord.y};
    const double component = std::max(std::abs(chord.x), std::abs(chord.y));
    if (!is_finite(component)) return overflow_fault(nodes.index_of(i));
    largest = std::max(largest, component);
    if (uniform) {
      knots[i + 1] = static_cast<double>(i + 1);
      continue;
    }
    knots[i + 1] = knots[i] + std::hypot(chord.x, chord.y);
    problem.step[i] = knots[i + 1] - knots[i];
    if (!is_finite(knots[i + 1])) return overflow_fault(nodes.index_of(i));
    if (!(problem.step[i] > 0.0)) {
      const std::size_t index = nodes.index_of(i + 1);
      return Fault{FaultCode::outside_domain,
                   "point " + std::to_string(index) +
                       " is so close to the one before it that its knot, " + to_text(knots[i]) +
                       ", does not advance; use uniform parameters or leave it out",
                   index,
                   "distance",
                   std::hypot(chord.x, chord.y),
                   epsilon<double>() * knots[i]};
    }
  }
  // The largest target gets a size near 1. Chords over chord lengths are of size 1 as they are.
  exponent = 0;
  if (uniform) {
    std::frexp(largest, &exponent);
    exponent = exponent >= 0 ? exponent / 2 : -((1 - exponent) / 2);
  }
  const double scale = std::ldexp(1.0, -exponent);  // twice: 4^-exponent may be out of range
  for (std::size_t i = 0; i < size; ++i) {
    Number& target = problem.target[i];
    if (uniform) {
      target = 15.0 * (scale * (scale * target));
    } else {
      target = 15.0 * Number{target.re / problem.step[i], target.im / problem.step[i]};
    }
  }
  if (!uniform) {
    problem.weight.resize(size + 1, 0.5);
    for (std::size_t k = 0; k <= size; ++k) {
      if (!options.closed && (k == 0 || k == size)) continue;
      const double before = k > 0 ? problem.step[k - 1] : problem.step.back();
      const double after = k < size ? problem.step[k] : problem.step.front();
      problem.weight[k] = after / (before + after);
    }
  }
  if (options.closed) problem.first = problem.last = SplineEnd::periodic;
  return std::nullopt;
}

/// A solved system, and what it takes to turn it into preimages.
struct Solved {
  SplineProblem problem;
  planar_spline_detail::SplineSolution solution;
  std::vector<double> knots;
  int exponent = 0;
  PlanarSplineReport report;

  /// What z is multiplied by.
  double scale() const { return std::ldexp(1.0, exponent); }
  PlanarPhCurve<2> curve(const Nodes& nodes, std::size_t i, double unit) const {
    const auto span = coefficients(problem, solution.z, i);
    return {nodes.at(i),
            BernsteinPolynomial<Number, 2>({unit * span.a, unit * span.z, unit * span.b}),
            knots[i + 1] - knots[i]};
  }
};

std::optional<Fault> solve(const Nodes& nodes, const PlanarSplineOptions& options, Solved& solved) {
  auto& [problem, solution, knots, exponent, report] = solved;
  if (auto fault = set_up(nodes, options, problem, knots, exponent)) return *fault;
  solution = planar_spline_detail::solve(problem, options.most_alternatives);
  report.newton_steps = solution.steps;
  report.residual = solution.misfit.worst / 5.0;  // of 3 squares, and of 15 times the span
  report.worst_span = solution.misfit.row;
  report.closure_sign = problem.closure < 0.0 ? -1 : 1;
  report.continued = solution.continued;
  report.alternatives_tried = solution.alternatives;
  report.alternatives_taken = solution.taken;
  report.solutions_found = solution.found;
  report.merged_points = nodes.merged;
  if (!solution.converged) {
    return Fault{FaultCode::no_convergence,
                 "no C² spline was found: at span " + std::to_string(report.worst_span) +
                     " (from point " + std::to_string(nodes.index_of(report.worst_span)) +
                     ") the best curve misses its end by " + to_text(report.residual) +
                     " of its size; smooth the points there, or use chord-length parameters",
                 nodes.index_of(report.worst_span),
                 "residual",
                 report.residual,
                 std::nullopt};
  }
  return std::nullopt;
}

/// The gap at the end of a curve, as a share of the largest coordinate or displacement there.
double gap_share(const PlanarPhCurve<2>& curve, const Vector2<double>& end, Vector2<double>& gap) {
  gap = end - curve.end();
  const double size = largest_component(gap);
  if (size == 0.0) return 0.0;
  double scale = std::max(largest_component(end), largest_component(curve.end()));
  for (const auto& c : curve.integral().coefficients()) {
    scale = std::max(scale, largest_component(c.displacement));
  }
  return size / scale;
}

/// The curves of all spans. Where the rounding of a curve's own coefficients makes it miss its end
/// by nearly as much as counts as continuous, the gaps are put through one more Newton step.
std::vector<PlanarPhCurve<2>> curves_of(const Nodes& nodes, Solved& solved) {
  constexpr int most_rounds = 4;
  constexpr double allowed = 0.75 * accuracy::continuity_error<double>(5, 0);
  const std::size_t size = nodes.spans;
  const double unit = solved.scale();
  std::vector<PlanarPhCurve<2>> curves;
  curves.reserve(size);
  double worst = 0.0;
  Vector2<double> gap;
  for (std::size_t i = 0; i < size; ++i) {
    curves.push_back(solved.curve(nodes, i, unit));
    worst = std::max(worst, gap_share(curves[i], nodes.at(i + 1), gap));
  }
  for (int round = 0; round < most_rounds && worst > allowed; ++round) {
    const std::vector<Number> before = solved.solution.z;
    std::vector<Number> right(size);
    const double unscale = std::ldexp(1.0, -solved.exponent);
    for (std::size_t i = 0; i < size; ++i) {
      gap_share(curves[i], nodes.at(i + 1), gap);
      const double factor = 15.0 / curves[i].parameter_step();
      right[i] = factor * (unscale * (unscale * Number{gap.x, gap.y}));
    }
    planar_spline_detail::SplineSystem system(solved.problem);
    system.pivoted_solve(before, right);
    for (std::size_t i = 0; i < size; ++i) solved.solution.z[i] += system.step()[i];
    const auto rebuild = [&] {
      double remaining = 0.0;
      for (std::size_t i = 0; i < size; ++i) {
        curves[i] = solved.curve(nodes, i, unit);
        remaining = std::max(remaining, gap_share(curves[i], nodes.at(i + 1), gap));
      }
      return remaining;
    };
    const double remaining = rebuild();
    if (!(remaining < worst)) {
      solved.solution.z = before;
      rebuild();
      break;
    }
    worst = remaining;
  }
  return curves;
}

}  // namespace

Result<PlanarSplinePreimage> planar_spline_preimage(std::span<const Vector2<double>> points,
                                                    const PlanarSplineOptions& options) {
  Nodes nodes;
  if (auto fault = choose_nodes(points, options, nodes)) return *fault;
  Solved solved;
  if (auto fault = solve(nodes, options, solved)) return *fault;
  PlanarSplinePreimage result;
  if (options.with_energy) {
    // ∫κ²ds has the unit 1/length.
    solved.report.energy =
        planar_spline_detail::quadrature_energy(solved.problem, solved.solution.z) /
        solved.scale() / solved.scale();
  }
  result.node.resize(nodes.spans + 1);
  const double scale = solved.scale();
  for (std::size_t i = 0; i < nodes.spans; ++i) {
    const auto span = coefficients(solved.problem, solved.solution.z, i);
    result.node[i] = scale * span.a;
    if (i + 1 == nodes.spans) result.node[i + 1] = scale * span.b;
  }
  result.middle = std::move(solved.solution.z);
  for (Number& x : result.middle) x = scale * x;
  result.knots = std::move(solved.knots);
  result.kept = std::move(nodes.index);
  result.report = solved.report;
  return result;
}

Result<PlanarSpline> planar_spline(std::span<const Vector2<double>> points,
                                   const PlanarSplineOptions& options) {
  Nodes nodes;
  if (auto fault = choose_nodes(points, options, nodes)) return *fault;
  Solved solved;
  if (auto fault = solve(nodes, options, solved)) return *fault;
  auto curves = curves_of(nodes, solved);
  solved.problem = {};
  solved.solution.z = {};
  auto path = PlanarPath<2>::create(std::move(solved.knots), std::move(curves), options.closed);
  if (!path) return path.fault();
  if (!is_finite(path->arc_length())) {
    return Fault{
        FaultCode::not_finite, "the curve is longer than a double can hold; scale the points down",
        std::nullopt,          "arc_length",
        path->arc_length(),    std::nullopt};
  }
  if (options.with_energy) {
    const auto energy = bending_energy(*path);
    solved.report.energy = energy ? *energy : std::numeric_limits<double>::infinity();
  }
  return PlanarSpline{std::move(*path), solved.report};
}

}  // namespace hodograph
