// SPDX-License-Identifier: MIT
#include "cli/path_facts.hpp"

#include <algorithm>
#include <cmath>

#include "hodograph/frame/continuity.hpp"
#include "hodograph/path/bounds.hpp"
#include "hodograph/path/continuity.hpp"

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
  const auto hodograph = scale * curve.hodograph();
  const auto sigma = scale * curve.speed_polynomial();
  const auto square = symmetric_square(
      hodograph, [](const point_t<A>& a, const point_t<A>& b) { return dot(a, b); });
  const auto expected = symmetric_square(sigma, [](double a, double b) { return a * b; });
  double worst = 0.0;
  for (std::size_t i = 0; i <= 4 * n; ++i) {
    worst = std::max(worst, std::abs(square[i] - expected[i]));
  }
  constexpr double roundings = 4.0 * (2.0 * (3.0 * n + 8.0) + (4.0 * n + 8.0));
  return worst / (roundings * epsilon<double>());
}

template <class P>
void continuity_of(PathFacts& facts, const P& path) {
  const auto curve = continuity(path);
  const auto frame = frame_continuity(path);
  facts.continuity = {curve.position.order(), curve.preimage.order(), frame.frame.order(),
                      frame.angular_velocity.order()};
  facts.position = jump_facts(curve.position);
  facts.preimage = jump_facts(curve.preimage);
  facts.frame = jump_facts(frame.frame);
  facts.angular_velocity = jump_facts(frame.angular_velocity);
  facts.antiperiodic = curve.antiperiodic;
  if constexpr (P::Point::dimension == 3) {
    if (const auto left_over = holonomy(path)) facts.holonomy = *left_over;
  }
}

/// Promised bounds are refined to about this relative width, 2^-20: far below what a drawing or a
/// limit needs, far above rounding.
constexpr double promised_width = 0x1p-20;

template <class P>
void bounds_of(PathFacts& facts, const P& path) {
  const RangeGoal goal{promised_width};
  facts.arc_length = arc_length_enclosure(path);
  const Extremes speed = speed_extremes(path, goal);
  facts.smallest_speed = speed.minimum;
  facts.largest_speed = speed.maximum;
  const Extremes curvature = curvature_extremes(path, goal);
  facts.curvature_bound = std::max({0.0, -curvature.minimum.lower(), curvature.maximum.upper()});
  for (const auto& curve : path.segments()) {
    facts.hodograph_identity = std::max(facts.hodograph_identity, hodograph_identity(curve));
  }
}

}  // namespace

void set_continuity(PathFacts& facts, const AnyPath& path) {
  path.visit([&](const auto& p) { continuity_of(facts, p); });
}

PathFacts facts_of(const AnyPath& path) {
  PathFacts facts;
  set_continuity(facts, path);
  path.visit([&](const auto& p) { bounds_of(facts, p); });
  return facts;
}

Promises promises_of(const PathFacts& facts) {
  Promises promises;
  promises.continuity = facts.continuity;
  promises.arc_length = facts.arc_length;
  promises.smallest_speed = facts.smallest_speed;
  promises.largest_speed = facts.largest_speed;
  if (std::isfinite(facts.curvature_bound)) promises.curvature_bound = facts.curvature_bound;
  return promises;
}

}  // namespace hodograph::cli
