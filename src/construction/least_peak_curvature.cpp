// SPDX-License-Identifier: MIT
// Least peak curvature: global samples, golden sections in the dips, and a certified answer.
#include "hodograph/construction/least_peak_curvature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "hodograph/path/planar_curvature.hpp"

namespace hodograph {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// A length this close to its bound, relatively, is on it: 2^-20, far above what the search leaves
/// (2^-30) and below what matters to a path.
constexpr double on_the_bound = 0x1.0p-20;
/// The relative width of curvature bounds: below the 2^-30 to which minimisers are found, squared.
constexpr RangeGoal curvature_goal{0x1.0p-40};

double peak(const Extremes& extremes) {
  return std::max(extremes.maximum.upper(), -extremes.minimum.lower());
}
double peak(const PlanarPhCurve<2>& curve) {
  return peak(curvature_extremes(curve, curvature_goal));
}

Enclosure certified_peak(const PlanarPhCurve<2>& curve) {
  const Extremes extremes = curvature_extremes(curve, curvature_goal);
  const Enclosure left = extremes.maximum, right = -extremes.minimum;
  return {std::max({0.0, left.lower(), right.lower()}), peak(extremes)};
}

/// The least of a function on [low, high] by golden sections, to 2^-30 of the interval's scale.
template <class F>
LocalMinimum golden_section(const F& f, double low, double high, double narrow) {
  constexpr double ratio = 0x1.3c6ef372fe95p-1;  // (√5 - 1)/2
  double left = high - ratio * (high - low), right = low + ratio * (high - low);
  double at_left = f(left), at_right = f(right);
  while (high - low > narrow) {
    if (at_left <= at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - ratio * (high - low);
      at_left = f(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + ratio * (high - low);
      at_right = f(right);
    }
    if (!(low < left && left < right && right < high)) break;
  }
  return at_left <= at_right ? LocalMinimum{left, at_left} : LocalMinimum{right, at_right};
}

/// All dips of a function on [low, high] that `count` even samples show, refined; ends that lie
/// lower than their neighbours among them. Infinite values are no answers.
template <class F>
std::vector<LocalMinimum> dips(const F& f, double low, double high, std::size_t count) {
  constexpr double narrow = 0x1.0p-30;  // where a smooth function is flat to rounding
  std::vector<double> x(count), y(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count - 1);
    x[i] = i + 1 == count ? high : low + t * (high - low);
    y[i] = f(x[i]);
  }
  std::vector<LocalMinimum> found;
  for (std::size_t i = 0; i < count; ++i) {
    const double before = i > 0 ? y[i - 1] : infinity;
    const double after = i + 1 < count ? y[i + 1] : infinity;
    if (!(y[i] < infinity) || y[i] > before || y[i] > after || (i > 0 && y[i] == before)) continue;
    const LocalMinimum sample{x[i], y[i]};
    const LocalMinimum refined =
        golden_section(f, i > 0 ? x[i - 1] : low, i + 1 < count ? x[i + 1] : high, narrow);
    found.push_back(refined.peak_curvature < sample.peak_curvature ? refined : sample);
  }
  return found;
}

const LocalMinimum* least_of(const std::vector<LocalMinimum>& found) {
  const LocalMinimum* best = nullptr;
  for (const LocalMinimum& m : found) {
    if (best == nullptr || m.peak_curvature < best->peak_curvature) best = &m;
  }
  return best;
}

/// The problem, checked.
struct Problem {
  DirectedPoint begin, end;
  Vector2<double> begin_direction, end_direction;  // of length 1
  double chord, most_length, least_speed, most_speed;
};

std::optional<Fault> check(const DirectedPoint& begin, const DirectedPoint& end, double most_length,
                           const SpeedRange& range, Problem& problem) {
  if (!(std::isfinite(most_length) && most_length > 0.0)) {
    return Fault{FaultCode::outside_domain,
                 "the length bound must be positive and finite; got " + to_text(most_length),
                 std::nullopt,
                 "length",
                 most_length,
                 0.0};
  }
  // The prescribed length finds what is wrong with the points and directions.
  const auto trial = prescribed_length_curve(begin, end, most_length);
  // (Directions off the chord only matter where the bound is the distance itself.)
  const bool direction_only = !trial && trial.fault().code == FaultCode::no_interpolant &&
                              trial.fault().quantity == "direction";
  if (!trial && !direction_only) return trial.fault();
  const auto unit = [](const Vector2<double>& v) {
    const double size = largest_component(v);
    const Vector2<double> u{v.x / size, v.y / size};
    return (1.0 / norm(u)) * u;
  };
  problem.begin = begin;
  problem.end = end;
  problem.begin_direction = unit(begin.direction);
  problem.end_direction = unit(end.direction);
  const Vector2<double> displacement = end.position - begin.position;
  problem.chord = std::hypot(displacement.x, displacement.y);
  problem.most_length = most_length;
  const double size = problem.chord > 0.0 ? problem.chord : most_length;
  const bool given = range.least != 0.0 || range.most != 0.0;
  problem.least_speed = given ? range.least : size / 16.0;
  problem.most_speed = given ? range.most : size * 16.0;
  if (!(0.0 < problem.least_speed && problem.least_speed < problem.most_speed &&
        std::isfinite(problem.most_speed))) {
    return Fault{FaultCode::outside_domain,
                 "the speeds must be positive and increase; got " + to_text(problem.least_speed) +
                     " to " + to_text(problem.most_speed),
                 std::nullopt,
                 "speed",
                 problem.least_speed,
                 problem.most_speed};
  }
  return std::nullopt;
}

std::optional<PlanarPhCurve<2>> curve_of_speeds(const Problem& p, double first, double last) {
  const auto found = planar_hermite({p.begin.position, first * p.begin_direction},
                                    {p.end.position, last * p.end_direction});
  if (!found || found->curve.arc_length() > p.most_length) return std::nullopt;
  return found->curve;
}

double peak_of_speeds(const Problem& p, double first, double last) {
  const auto curve = curve_of_speeds(p, first, last);
  return curve ? peak(*curve) : infinity;
}

/// Whether a minimiser is on the bound of the length, or on an end of its range.
PeakMinimum kind_of(const Problem& p, const PlanarPhCurve<2>& curve,
                    std::initializer_list<double> speeds) {
  if (curve.arc_length() >= p.most_length * (1.0 - on_the_bound)) {
    return PeakMinimum::at_length_bound;
  }
  for (const double speed : speeds) {
    if (speed <= p.least_speed * (1.0 + on_the_bound) ||
        speed >= p.most_speed * (1.0 - on_the_bound)) {
      return PeakMinimum::at_range_end;
    }
  }
  return PeakMinimum::interior;
}

Fault none_within_bound(const Problem& p) {
  return {FaultCode::no_interpolant,
          "no end speed from " + to_text(p.least_speed) + " to " + to_text(p.most_speed) +
              " gives a path of length " + to_text(p.most_length) + " or less",
          std::nullopt,
          "length",
          p.most_length,
          std::nullopt};
}

LeastPeakCurvature answer(const PlanarPhCurve<2>& curve, PeakMinimum kind) {
  const auto& w = curve.preimage();
  LeastPeakCurvature result{
      curve, certified_peak(curve), dot(w.front(), w.front()), dot(w.back(), w.back()),
      kind,  std::nullopt};
  if (result.peak_curvature.upper() == 0.0) result.kind = PeakMinimum::straight_line;
  return result;
}

void note_interior(std::optional<LocalMinimum>& interior, const LocalMinimum& candidate) {
  if (!interior || candidate.peak_curvature < interior->peak_curvature) interior = candidate;
}

}  // namespace

Result<LeastPeakCurvature> least_peak_curvature_of_equal_speeds(const DirectedPoint& begin,
                                                                const DirectedPoint& end,
                                                                double most_length,
                                                                const SpeedRange& range) {
  Problem p;
  if (auto fault = check(begin, end, most_length, range, p)) return *std::move(fault);
  constexpr std::size_t samples = 256;
  const auto f = [&](double t) { return peak_of_speeds(p, std::exp(t), std::exp(t)); };
  const auto found = dips(f, std::log(p.least_speed), std::log(p.most_speed), samples);
  const LocalMinimum* best = least_of(found);
  if (best == nullptr) return none_within_bound(p);
  const double speed = std::exp(best->parameter);
  const auto curve = curve_of_speeds(p, speed, speed);
  LeastPeakCurvature result = answer(*curve, kind_of(p, *curve, {speed}));
  for (const LocalMinimum& m : found) {
    const double l = std::exp(m.parameter);
    const auto candidate = curve_of_speeds(p, l, l);
    if (candidate && kind_of(p, *candidate, {l}) == PeakMinimum::interior) {
      note_interior(result.interior, {l, m.peak_curvature});
    }
  }
  return result;
}

Result<LeastPeakCurvature> least_peak_curvature_of_speeds(const DirectedPoint& begin,
                                                          const DirectedPoint& end,
                                                          double most_length,
                                                          const SpeedRange& range) {
  Problem p;
  if (auto fault = check(begin, end, most_length, range, p)) return *std::move(fault);
  constexpr std::size_t samples = 48;
  const double low = std::log(p.least_speed), high = std::log(p.most_speed);
  // The best ℓ1 for an ℓ0; logarithms.
  const auto inner = [&](double t) {
    const double first = std::exp(t);
    const auto found =
        dips([&](double s) { return peak_of_speeds(p, first, std::exp(s)); }, low, high, samples);
    const LocalMinimum* best = least_of(found);
    return best == nullptr ? LocalMinimum{0.0, infinity} : *best;
  };
  const auto found = dips([&](double t) { return inner(t).peak_curvature; }, low, high, samples);
  const LocalMinimum* best = least_of(found);
  if (best == nullptr) return none_within_bound(p);
  const auto speeds_of = [&](const LocalMinimum& m) {
    return std::pair(std::exp(m.parameter), std::exp(inner(m.parameter).parameter));
  };
  const auto [first, last] = speeds_of(*best);
  const auto curve = curve_of_speeds(p, first, last);
  LeastPeakCurvature result = answer(*curve, kind_of(p, *curve, {first, last}));
  for (const LocalMinimum& m : found) {
    const auto [l0, l1] = speeds_of(m);
    const auto candidate = curve_of_speeds(p, l0, l1);
    if (candidate && kind_of(p, *candidate, {l0, l1}) == PeakMinimum::interior) {
      note_interior(result.interior, {l0, m.peak_curvature});
    }
  }
  return result;
}

Result<LeastPeakCurvature> least_peak_curvature_of_length(const DirectedPoint& begin,
                                                          const DirectedPoint& end,
                                                          double most_length) {
  Problem p;
  if (auto fault = check(begin, end, most_length, {}, p)) return *std::move(fault);
  if (p.chord > 0.0) {
    // Directions along the chord: the line itself. (Others have a curve of this length, too, where
    // rounding makes it exceed the chord, with a curvature beyond all bounds.)
    const auto line = prescribed_length_curve(begin, end, std::min(p.chord, most_length));
    if (line && line->rotation_index == 0.0) {
      return answer(line->curve, PeakMinimum::straight_line);
    }
  }
  constexpr std::size_t samples = 256;
  constexpr double least_excess = 0x1.0p-12;  // of the chord: where the curvature is very large
  const double size = p.chord > 0.0 ? p.chord : most_length;
  const double most = most_length - p.chord;
  const double least = std::min(least_excess * size, 0.5 * most);
  const auto length_of = [&](double t) { return std::min(p.chord + std::exp(t), most_length); };
  const auto curve_of = [&](double length) -> std::optional<PlanarPhCurve<2>> {
    const auto found = prescribed_length_curve(begin, end, length);
    if (!found) return std::nullopt;
    return found->curve;
  };
  const auto f = [&](double t) {
    const auto curve = curve_of(length_of(t));
    return curve ? peak(*curve) : infinity;
  };
  std::vector<LocalMinimum> found;
  if (most > 0.0) found = dips(f, std::log(least), std::log(most), samples);
  const LocalMinimum* best = least_of(found);
  const auto curve = best == nullptr ? curve_of(most_length) : curve_of(length_of(best->parameter));
  if (!curve) {
    return Fault{FaultCode::no_interpolant,
                 "no path of length " + to_text(most_length) +
                     " or less has these directions; its points are " + to_text(p.chord) + " apart",
                 std::nullopt,
                 "length",
                 most_length,
                 p.chord};
  }
  const auto kind = [&](double length) {
    return length >= most_length - on_the_bound * most ? PeakMinimum::at_length_bound
                                                       : PeakMinimum::interior;
  };
  LeastPeakCurvature result = answer(
      *curve, best == nullptr ? PeakMinimum::at_length_bound : kind(length_of(best->parameter)));
  for (const LocalMinimum& m : found) {
    const double length = length_of(m.parameter);
    if (kind(length) == PeakMinimum::interior && length > p.chord + 2.0 * least) {
      note_interior(result.interior, {length, m.peak_curvature});
    }
  }
  return result;
}

}  // namespace hodograph
