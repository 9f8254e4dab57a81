// SPDX-License-Identifier: MIT
// Planar C² splines through hostile points: each is judged, and the Newton steps are counted.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <map>
#include <string>

#include "hodograph/construction/planar_spline.hpp"
#include "hodograph/path/continuity.hpp"
#include "tests/support/planar_points.hpp"

namespace hodograph::test {

struct SplineCampaign {
  struct Kind {
    std::map<std::size_t, std::size_t> steps;
    std::size_t made = 0, refused = 0, continued = 0, other_taken = 0;
    double worst_residual = 0.0;
  };
  std::array<Kind, kinds_of_points.size()> kinds;
};

/// What is wrong with a spline through the points, or nothing. In long double: every span ends
/// where the next begins, |h∫w² - Δq| within 8 ε h max|w_i|² (the sum of 6 products with weights of
/// total 1, and what the coefficients' own rounding moves it), the joins C² as path/continuity.hpp
/// counts.
inline std::string complaint_about(const PlanarSpline& made, const Points& points) {
  using Wide = Complex<long double>;
  const auto& path = made.path;
  const auto wide = [](const Complex<double>& x) { return Wide{x.re, x.im}; };
  for (std::size_t i = 0; i < path.segment_count(); ++i) {
    const auto& curve = path.segment(i);
    const Wide a = wide(curve.preimage()[0]), z = wide(curve.preimage()[1]),
               b = wide(curve.preimage()[2]);
    const long double h = curve.parameter_step();
    const Wide integral =
        (h / 15) * (3.0L * (a * a + b * b + z * (a + b)) + 2.0L * (z * z) + a * b);
    const auto& from = points[i];
    const auto& to = points[(i + 1) % points.size()];
    const Wide chord{static_cast<long double>(to.x) - from.x,
                     static_cast<long double>(to.y) - from.y};
    const Wide gap = integral - chord;
    const long double size = h * std::max({dot(a, a), dot(z, z), dot(b, b)});
    const long double coordinate =
        std::max({std::abs(to.x), std::abs(to.y), std::abs(from.x), std::abs(from.y)});
    const long double allowed = 8 * epsilon<double>() * std::max(size, coordinate);
    if (!(std::hypot(gap.re, gap.im) <= allowed)) {
      return "span " + std::to_string(i) + " misses its end";
    }
  }
  const auto found = continuity(path);
  if (found.position.order() < 2) {
    return "the curve is C" + std::to_string(found.position.order()) + " only";
  }
  if (found.preimage.order() < 1) {
    return "the preimage is C" + std::to_string(found.preimage.order()) + " only";
  }
  if (found.antiperiodic != (made.report.closure_sign < 0)) return "the closure sign is wrong";
  return {};
}

/// Whether a refusal is justified by the points.
inline bool is_justified(const Fault& fault, const Points& points,
                         const PlanarSplineOptions& options) {
  if (fault.code == FaultCode::too_few) return true;
  if (fault.code != FaultCode::outside_domain || !fault.index) return false;
  const std::size_t k = *fault.index;
  const auto& q = points[k % points.size()];
  const auto& before = points[(k + points.size() - 1) % points.size()];
  if (q == before) return true;
  // A knot that does not advance: the chord is lost beside the sum of those before it.
  double sum = 0.0;
  for (std::size_t i = 1; i < std::min(k, points.size()); ++i) {
    const auto chord = points[i] - points[i - 1];
    sum += std::hypot(chord.x, chord.y);
  }
  return options.parameters == SplineParameters::chord_length &&
         std::hypot(q.x - before.x, q.y - before.y) <= epsilon<double>() * sum;
}

template <class Complain>
SplineCampaign run_spline_campaign(Random& random, std::size_t sets, const Complain& complain) {
  SplineCampaign campaign;
  for (std::size_t set = 0; set < sets; ++set) {
    const std::size_t kind = set % kinds_of_points.size();
    const std::size_t count = random.chance(0.1) ? 100 + random.index(400) : 2 + random.index(30);
    Points points = points_of_kind(random, kind, count);
    PlanarSplineOptions options;
    options.closed = random.chance(0.4);
    if (random.chance(0.3)) options.parameters = SplineParameters::chord_length;
    options.most_alternatives = 64;  // a part of them, to bound the time
    if (options.closed && points.front() == points.back()) points.pop_back();
    const auto made = planar_spline(points, options);
    auto& counts = campaign.kinds[kind];
    const auto where = [&] {
      return std::string(kinds_of_points[kind]) + ", set " + std::to_string(set) + ", " +
             std::to_string(points.size()) + " points" + (options.closed ? ", closed" : "") +
             (options.parameters == SplineParameters::uniform ? "" : ", chord lengths") + ": ";
    };
    if (!made) {
      ++counts.refused;
      if (!is_justified(made.fault(), points, options)) complain(where() + made.fault().sentence);
      continue;
    }
    ++counts.made;
    ++counts.steps[made->report.newton_steps];
    counts.continued += made->report.continued ? 1 : 0;
    counts.other_taken += made->report.alternatives_taken > 0 ? 1 : 0;
    counts.worst_residual = std::max(counts.worst_residual, made->report.residual);
    const std::string complaint = complaint_about(*made, points);
    if (!complaint.empty()) complain(where() + complaint);
  }
  return campaign;
}

inline void print_spline_campaign(const SplineCampaign& campaign) {
  for (std::size_t kind = 0; kind < kinds_of_points.size(); ++kind) {
    const auto& counts = campaign.kinds[kind];
    std::printf("%-24s made %zu, refused %zu, continued %zu, another taken %zu, residual %.1e\n",
                kinds_of_points[kind], counts.made, counts.refused, counts.continued,
                counts.other_taken, counts.worst_residual);
    std::printf("  Newton steps:");
    for (const auto& [steps, times] : counts.steps) std::printf(" %zu: %zu", steps, times);
    std::printf("\n");
  }
}

}  // namespace hodograph::test
