// SPDX-License-Identifier: MIT
// Turn-limited paths: the choice among one quintic and the skeletons of arcs, certified.
#include "hodograph/construction/turn_limited.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "arc_skeleton.hpp"
#include "arc_spans.hpp"
#include "end_point_faults.hpp"
#include "hodograph/construction/least_peak_curvature.hpp"
#include "hodograph/path/bounds.hpp"
#include "hodograph/path/continuity.hpp"

namespace hodograph {
namespace {

using namespace turn_detail;

/// No arc is smaller than this part of the size of the data: it would be lost in it.
constexpr double least_arc = 0x1.0p-24;
/// Whole turns are taken where the length is more than this many times the shortest.
constexpr double loiter_beyond = 2.0;
/// The certificate is this sharp: a small part of the finer margin.
constexpr double certificate_width = 0x1.0p-26;
constexpr RangeGoal curvature_goal{certificate_width};

double curvature_bound(const PlanarPath<2>& path) {
  const Extremes found = curvature_extremes(path, curvature_goal);
  return std::max(std::abs(found.minimum.lower()), std::abs(found.maximum.upper()));
}

/// κ ≤ 1/R, rounded the safe way.
bool keeps(double most_curvature, double turn_radius) {
  return turn_radius == 0.0 || Enclosure::up(most_curvature * turn_radius) <= 1.0;
}

Result<TurnLimitedPath> of_curve(const PlanarPhCurve<2>& curve) {
  Spans spans(curve.start());
  const double factor = std::sqrt(curve.parameter_step());
  spans.add(curve.preimage().mapped([&](const Complex<double>& w) { return factor * w; }));
  auto path = std::move(spans).path();
  if (!path) return path.fault();
  const double most = curvature_bound(*path);
  return TurnLimitedPath{*std::move(path), TurnLimitedShape::one_span, 0, 0.0, most};
}

/// The one quintic of this length that keeps the radius; nothing where there is none.
std::optional<TurnLimitedPath> one_span(const DirectedPoint& begin, const DirectedPoint& end,
                                        double length, double turn_radius) {
  const auto solutions = prescribed_length_solutions(begin, end, length, 1.0, LengthSolutions::all);
  if (!solutions) return std::nullopt;
  for (const PlanarSolution& solution : *solutions) {
    auto made = of_curve(solution.curve);
    if (made && std::isfinite(made->most_curvature) && keeps(made->most_curvature, turn_radius)) {
      return *std::move(made);
    }
  }
  return std::nullopt;
}

std::optional<Fault> radius_fault(double turn_radius) {
  if (turn_radius >= 0.0 && std::isfinite(turn_radius)) return std::nullopt;
  return Fault{
      std::isnan(turn_radius) ? FaultCode::not_finite : FaultCode::outside_domain,
      "the turn radius must be finite and not negative (0: none); got " + to_text(turn_radius),
      std::nullopt,
      "turn_radius",
      turn_radius,
      0.0};
}

/// The ends in units of `unit`, a power of two.
Ends ends_of(const DirectedPoint& begin, const DirectedPoint& end, double turn_radius,
             const ArcPieces& pieces, double unit) {
  const Vector2<double> way = end.position - begin.position;
  return {{way.x / unit, way.y / unit},
          std::atan2(begin.direction.y, begin.direction.x),
          std::atan2(end.direction.y, end.direction.x),
          std::max(pieces.margin * (turn_radius / unit), least_arc)};
}

double unit_of(const DirectedPoint& begin, const DirectedPoint& end, double length,
               double turn_radius) {
  int exponent = 0;
  std::frexp(std::max({largest_component(end.position - begin.position), length, turn_radius}),
             &exponent);
  return std::ldexp(1.0, std::clamp(exponent, -1000, 1000));
}

/// The path along the first skeleton whose quintics keep the radius, certified.
std::optional<TurnLimitedPath> first_made(const std::vector<Skeleton>& skeletons,
                                          const ArcPieces& pieces, const DirectedPoint& begin,
                                          double unit, double turn_radius) {
  for (const Skeleton& skeleton : skeletons) {
    auto path = spans_along(skeleton, pieces, begin, unit);
    if (!path || continuity(*path).position.order() < 1) continue;  // joined by rounding alone
    const double most = curvature_bound(*path);
    if (!keeps(most, turn_radius)) continue;
    return TurnLimitedPath{*std::move(path), skeleton.shape, skeleton.whole_turns,
                           unit * skeleton.radius, most};
  }
  return std::nullopt;
}

/// The path of a length, where the data are not at fault.
std::optional<TurnLimitedPath> made_of_length(const DirectedPoint& begin, const DirectedPoint& end,
                                              double length, double turn_radius) {
  const auto any = prescribed_length_curve(begin, end, length);
  const bool too_short = !any && any.fault().quantity == "length";
  if (too_short) return std::nullopt;
  const double unit = unit_of(begin, end, length, turn_radius);
  const double scaled = length / unit;
  const Ends ends = ends_of(begin, end, turn_radius, coarse_pieces, unit);
  const bool far_longer =
      scaled > loiter_beyond * shortest_word(ends) && scaled >= loiter_length(ends);
  if (far_longer) {
    auto made = first_made(with_whole_turns(ends, scaled), coarse_pieces, begin, unit, turn_radius);
    if (made) return made;
  }
  if (any) {
    if (auto found = one_span(begin, end, length, turn_radius)) return found;
  }
  for (const ArcPieces& pieces : {coarse_pieces, fine_pieces}) {
    const Ends these = ends_of(begin, end, turn_radius, pieces, unit);
    for (const auto& skeletons : {without_whole_turns, with_whole_turns}) {
      auto made = first_made(skeletons(these, scaled), pieces, begin, unit, turn_radius);
      if (made) return made;
    }
  }
  return std::nullopt;
}

/// What to say of a length that is not reached, and the length that is: the shortest, or one a
/// little above it where rounding decides about the shortest, or the first with a whole turn. The
/// length named is tried.
Fault not_reached(const DirectedPoint& begin, const DirectedPoint& end, double length,
                  double turn_radius) {
  const Vector2<double> way = end.position - begin.position;
  const double chord = std::hypot(way.x, way.y);
  const double unit = unit_of(begin, end, std::max(length, chord), turn_radius);
  const Ends ends = ends_of(begin, end, turn_radius, fine_pieces, unit);
  constexpr double safe = 1.0 + 4.0 * rounding;
  const double shortest = safe * std::max(unit * shortest_word(ends), chord);
  const double every = safe * unit * loiter_length(ends);
  std::vector<double> tried;
  for (const double least : {shortest, every}) {
    for (const double excess : planar_detail::tried_excesses) {
      if (least * (1.0 + excess) > length) tried.push_back(least * (1.0 + excess));
    }
  }
  std::stable_sort(tried.begin(), tried.end());
  const auto met = std::find_if(tried.begin(), tried.end(), [&](double some) {
    return made_of_length(begin, end, some, turn_radius).has_value();
  });
  const double bound = met != tried.end() ? *met : every;
  const bool too_short = length < shortest;
  const std::string radius = "a turn radius of " + to_text(turn_radius);
  std::string sentence;
  if (too_short && bound == shortest) {
    sentence = radius + " needs a length of at least " + to_text(bound) +
               " between these points and directions; got " + to_text(length);
  } else if (too_short) {
    sentence = radius + " needs a length of more than " + to_text(shortest) +
               " between these points and directions (" + to_text(bound) + " will do); got " +
               to_text(length);
  } else {
    sentence = "a length of " + to_text(length) + " with " + radius +
               " is too long for a path without whole turns and too short for one with them; " +
               to_text(bound) + " will do";
  }
  return {FaultCode::no_interpolant, sentence, std::nullopt, "length", length, bound};
}

}  // namespace

Result<TurnLimitedPath> turn_limited_path(const DirectedPoint& begin, const DirectedPoint& end,
                                          double length, double turn_radius) {
  if (auto fault = radius_fault(turn_radius)) return *std::move(fault);
  if (turn_radius == 0.0) {
    const auto made = prescribed_length_curve(begin, end, length, 1.0, LengthSolutions::all);
    if (!made) return made.fault();
    return of_curve(made->curve);
  }
  // Whatever is wrong with the data is wrong here, too.
  const auto any = prescribed_length_curve(begin, end, length);
  if (!any && any.fault().code != FaultCode::no_interpolant) return any.fault();
  if (auto made = made_of_length(begin, end, length, turn_radius)) return *std::move(made);
  return not_reached(begin, end, length, turn_radius);
}

Result<TurnLimitedPath> shortest_turn_limited_path(const DirectedPoint& begin,
                                                   const DirectedPoint& end, double turn_radius,
                                                   const TurnLimitedChoice& choice) {
  if (auto fault = radius_fault(turn_radius)) return *std::move(fault);
  const Vector2<double> way = end.position - begin.position;
  const double chord = std::hypot(way.x, way.y), least = choice.least_length;
  if (turn_radius == 0.0) {
    const double base = std::max(chord, least);
    const auto found = least_peak_curvature_of_length(begin, end, 2.0 * base);
    if (!found) return found.fault();
    if (found->curve.arc_length() >= least) return of_curve(found->curve);
    return turn_limited_path(begin, end, least, 0.0);
  }
  if (least > 0.0) {
    auto exact = turn_limited_path(begin, end, least, turn_radius);
    if (exact || exact.fault().code != FaultCode::no_interpolant) return exact;
  } else {
    const auto any = prescribed_length_curve(begin, end, 2.0 * std::max(chord, turn_radius));
    if (!any && any.fault().code != FaultCode::no_interpolant) return any.fault();
  }
  const double unit = unit_of(begin, end, std::max(chord, least), turn_radius);
  const Ends ends = ends_of(begin, end, turn_radius, coarse_pieces, unit);
  std::vector<Skeleton> words;
  for (Skeleton& one : words_at(ends, ends.radius)) {
    const bool some = one.length() > rounding * ends.radius;  // else it stands where it is
    if (some && one.length() * unit >= least) words.push_back(std::move(one));
  }
  for (Skeleton& one : with_whole_turns(ends, loiter_length(ends))) {
    words.push_back(std::move(one));
  }
  std::stable_sort(words.begin(), words.end(),
                   [](const Skeleton& a, const Skeleton& b) { return a.length() < b.length(); });
  const auto arcs = first_made(words, coarse_pieces, begin, unit, turn_radius);
  if (!arcs) return not_reached(begin, end, std::max(least, chord), turn_radius);
  const double length = arcs->path.arc_length();
  // One quintic, from the least length (a little more than the distance) to the arcs' and the
  // detour: the first of a grid that keeps the radius, then bisected.
  const double limit = (1.0 + choice.most_detour) * length;
  constexpr double least_excess = 0x1.0p-20;  // of the distance: shorter ones are all but straight
  constexpr double first_excess = 0x1.0p-8;   // of the largest length, where the grid begins
  double failed = std::max(least, chord * (1.0 + least_excess)) - chord;
  constexpr int steps = 16, halvings = 12;
  const double begin_excess = std::max(failed, first_excess * limit);
  std::optional<TurnLimitedPath> span;
  double excess = begin_excess;
  if (auto made = one_span(begin, end, chord + failed, turn_radius)) return *std::move(made);
  const double ratio = std::pow(std::max(limit - chord, begin_excess) / begin_excess, 1.0 / steps);
  for (int i = 0; i <= steps && !span && chord + excess <= limit; ++i) {
    span = one_span(begin, end, chord + excess, turn_radius);
    if (!span) {
      failed = excess;
      excess *= ratio;
    }
  }
  if (span) {
    double works = excess;
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (failed + works);
      if (auto made = one_span(begin, end, chord + middle, turn_radius)) {
        span = std::move(made);
        works = middle;
      } else {
        failed = middle;
      }
    }
    return *std::move(span);
  }
  return *arcs;
}

}  // namespace hodograph
