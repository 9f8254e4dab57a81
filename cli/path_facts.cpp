// SPDX-License-Identifier: MIT
#include "cli/path_facts.hpp"

#include <algorithm>
#include <cmath>

#include "hodograph/frame/any_continuity.hpp"
#include "hodograph/path/any_bounds.hpp"

namespace hodograph::cli {
namespace {

template <std::size_t count>
std::vector<JumpFact> jump_facts(const WorstJumps<double, count>& worst) {
  std::vector<JumpFact> facts(count);
  for (std::size_t r = 0; r < count; ++r) {
    facts[r] = {worst.jump[r], worst.allowed[r], worst.knot[r]};
  }
  return facts;
}

/// The coefficients of Σ_j f_j² for polynomials f_j of degree m, whose coefficients follow each
/// other. Each passes 2 roundings in a factor, m + 3 in products and the sums over terms and over
/// the f_j, and one more.
std::vector<double> sum_of_squares(std::vector<double> f, std::size_t m) {
  std::vector<double> total(2 * m + 1, 0.0), square(2 * m + 1);
  for (std::size_t first = 0; first < f.size(); first += m + 1) {
    for (std::size_t i = 0; i <= m; ++i) f[first + i] *= static_cast<double>(binomial(m, i));
    std::fill(square.begin(), square.end(), 0.0);
    for (std::size_t i = 0; i <= m; ++i) {
      for (std::size_t j = 0; j <= m; ++j) square[i + j] += f[first + i] * f[first + j];
    }
    for (std::size_t k = 0; k <= 2 * m; ++k) total[k] += square[k];
  }
  for (std::size_t k = 0; k <= 2 * m; ++k) total[k] /= static_cast<double>(binomial(2 * m, k));
  return total;
}

/// The largest coefficient of |r'|² - σ² relative to what rounding makes of it. With M = max
/// |A_i|², coefficients of r' and σ pass at most 3n + 8 roundings (see displacement_error) and are
/// at most M; those of their squares pass 2(2n) + 8 more in sums whose weights add to 1, over 3
/// components and once for σ².
template <PreimageAlgebra A, std::size_t n>
double hodograph_identity(const PhCurve<A, n>& curve) {
  double size = 0.0;
  for (const A& a : curve.preimage().coefficients()) size = std::max(size, speed_form(a, a));
  if (!(size > 0.0)) return 0.0;
  const double scale = 1.0 / size;
  std::vector<double> hodograph, sigma;
  for (std::size_t j = 0; j < point_t<A>::dimension; ++j) {
    for (const auto& r : curve.hodograph().coefficients()) hodograph.push_back(scale * r[j]);
  }
  for (const double s : curve.speed_polynomial().coefficients()) sigma.push_back(scale * s);
  const auto square = sum_of_squares(hodograph, 2 * n), expected = sum_of_squares(sigma, 2 * n);
  double worst = 0.0;
  for (std::size_t i = 0; i <= 4 * n; ++i) {
    worst = std::max(worst, std::abs(square[i] - expected[i]));
  }
  constexpr double roundings = 4.0 * (2.0 * (3.0 * n + 8.0) + (4.0 * n + 8.0));
  return worst / (roundings * epsilon<double>());
}

/// Promised bounds are refined to about this relative width, 2^-20: far below what a drawing or a
/// limit needs, far above rounding.
constexpr double promised_width = 0x1p-20;

template <class P>
void ends_of(PathFacts& facts, const P& path) {
  const auto& last = path.segments().back();
  const auto end = last.end();
  facts.end = {end[0], end[1], 0.0};
  if constexpr (P::Point::dimension == 3) facts.end.z = end[2];
  facts.end_rounding =
      accuracy::join_error<double>() *
      std::max({largest_component(end), largest_component(last.start()), last.arc_length()});
  for (const auto& curve : path.segments()) {
    facts.hodograph_identity = std::max(facts.hodograph_identity, hodograph_identity(curve));
  }
}

}  // namespace

void set_continuity(PathFacts& facts, const AnyPath& path) {
  const auto curve = continuity(path);
  const auto frame = frame_continuity(path);
  facts.continuity = {curve.position.order(), curve.preimage.order(), frame.frame.order(),
                      frame.angular_velocity.order()};
  facts.position = jump_facts(curve.position);
  facts.preimage = jump_facts(curve.preimage);
  facts.frame = jump_facts(frame.frame);
  facts.angular_velocity = jump_facts(frame.angular_velocity);
  facts.antiperiodic = curve.antiperiodic;
  if (const auto left_over = holonomy(path)) facts.holonomy = *left_over;
}

PathFacts facts_of(const AnyPath& path) {
  PathFacts facts;
  set_continuity(facts, path);
  path.visit([&](const auto& p) { ends_of(facts, p); });
  const RangeGoal goal{promised_width};
  facts.arc_length = arc_length_enclosure(path);
  const Extremes speed = speed_extremes(path, goal);
  facts.smallest_speed = speed.minimum;
  facts.largest_speed = speed.maximum;
  const Extremes curvature = curvature_extremes(path, goal);
  facts.curvature_bound = std::max({0.0, -curvature.minimum.lower(), curvature.maximum.upper()});
  return facts;
}

Promises promises_of(const PathFacts& facts) {
  Promises promises;
  promises.continuity = facts.continuity;
  promises.arc_length = facts.arc_length;
  promises.smallest_speed = facts.smallest_speed;
  promises.largest_speed = facts.largest_speed;
  promises.end = facts.end;
  if (std::isfinite(facts.curvature_bound)) promises.curvature_bound = facts.curvature_bound;
  return promises;
}

}  // namespace hodograph::cli
