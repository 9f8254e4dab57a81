// SPDX-License-Identifier: MIT
#include "cli/path_facts.hpp"

#include <algorithm>
#include <cmath>

#include "hodograph/frame/continuity.hpp"
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

template <class A>
struct EnclosedAlgebra;
template <class S>
struct EnclosedAlgebra<Complex<S>> {
  using type = Complex<Enclosure>;
};
template <class S>
struct EnclosedAlgebra<Quaternion<S>> {
  using type = Quaternion<Enclosure>;
};

Enclosure norm_of(const Enclosure& rate) { return abs(rate); }
Enclosure norm_of(const Vector3<Enclosure>& rate) {
  return sqrt(square(rate.y) + square(rate.z));  // without the part along the tangent
}

template <class V, std::size_t n>
Enclosure hull_of(const BernsteinPolynomial<V, n>& f) {
  Enclosure hull = f[0];
  for (std::size_t i = 1; i <= n; ++i) hull = Enclosure::hull(hull, f[i]);
  return hull;
}

/// The bounds of one segment, cut into equal parts: the polynomials lie between the smallest and
/// the largest of their control points, computed with outward rounding.
template <PreimageAlgebra A, std::size_t n>
void include_bounds(PathFacts& facts, const PhCurve<A, n>& curve, std::size_t parts, bool first) {
  using E = typename EnclosedAlgebra<A>::type;
  const auto preimage = curve.preimage().mapped([](const A& a) {
    E e{};
    for (std::size_t i = 0; i < A::dimension; ++i) e[i] = Enclosure(a[i]);
    return e;
  });
  const Enclosure step(curve.parameter_step());
  const auto speed_of = [](const BernsteinPolynomial<E, n>& part) {
    return symmetric_square(part, [](const E& a, const E& b) { return speed_form(a, b); });
  };
  const Enclosure length = step * speed_of(preimage).integral();
  facts.arc_length = first ? length : facts.arc_length + length;
  for (std::size_t k = 0; k < parts; ++k) {
    const auto end = [parts](std::size_t i) {
      return Enclosure(static_cast<double>(i)) / Enclosure(static_cast<double>(parts));
    };
    const auto part = parts == 1 ? preimage : preimage.restricted(end(k), end(k + 1));
    const Enclosure hull = hull_of(speed_of(part));
    const Enclosure speed(std::max(0.0, hull.lower()), std::max(0.0, hull.upper()));
    if (first && k == 0) {
      facts.smallest_speed = facts.largest_speed = speed;
    } else {
      facts.smallest_speed = Enclosure(std::min(facts.smallest_speed.lower(), speed.lower()),
                                       std::min(facts.smallest_speed.upper(), speed.upper()));
      facts.largest_speed = Enclosure(std::max(facts.largest_speed.lower(), speed.lower()),
                                      std::max(facts.largest_speed.upper(), speed.upper()));
    }
    if constexpr (n > 0) {
      // κ = 2 |vec(A* A')|⊥ / σ², A' per unit ξ.
      const auto rate = product(part, part.derivative(),
                                [](const E& a, const E& b) { return body_rate_form(a, b); });
      Enclosure largest(0.0);
      for (std::size_t i = 0; i <= 2 * n - 1; ++i) {
        const Enclosure size = norm_of(rate[i]);
        if (!(size.upper() <= largest.upper())) largest = size;
      }
      const Enclosure width = step / Enclosure(static_cast<double>(parts));
      const Enclosure bound = Enclosure(2.0) * Enclosure(largest.magnitude()) /
                              (width * Enclosure(speed.lower()) * Enclosure(speed.lower()));
      facts.curvature_bound = std::max(facts.curvature_bound, bound.upper());
    }
  }
}

template <class P>
void bounds_of(PathFacts& facts, const P& path) {
  constexpr std::size_t work = 4000, most_parts = 16;
  const std::size_t parts = std::clamp<std::size_t>(work / path.segment_count(), 1, most_parts);
  facts.curvature_bound = 0.0;
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    include_bounds(facts, path.segment(k), parts, k == 0);
    facts.hodograph_identity =
        std::max(facts.hodograph_identity, hodograph_identity(path.segment(k)));
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
