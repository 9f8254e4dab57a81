// SPDX-License-Identifier: MIT
// Turn-limited paths: skeletons of arcs and lines of an exact length, and the quintics that follow
// them.
#include "hodograph/construction/turn_limited.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "hodograph/construction/least_peak_curvature.hpp"
#include "hodograph/path/bounds.hpp"
#include "hodograph/path/rotation_index.hpp"

namespace hodograph {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double rounding = accuracy::join_error<double>();
/// The longest piece of an arc for one quintic, and a bound of how much its curvature may exceed
/// the arc's: 1.04e-5 of it for a twelfth of a turn, falling with the fourth power of the angle
/// (tests/construction/turn_limited_test.cpp); the rest is for the rounding of short arcs. The
/// finer ones are for lengths just above the least.
struct ArcPieces {
  double longest, margin;
};
constexpr ArcPieces coarse_pieces{turn / 12.0, 1.0 + 0x1.0p-16};
constexpr ArcPieces fine_pieces{turn / 24.0, 1.0 + 0x1.0p-20};
/// No arc is smaller than this part of the size of the data: it would be lost in it.
constexpr double least_arc = 0x1.0p-24;
/// An arc of a smaller angle α is made one quintic with its neighbour: as one of its own, the
/// rounding of its coefficients would be ε/α of its curvature.
constexpr double least_angle = 0x1.0p-28;
/// Joined arcs end with one of at least this angle: a quintic along less has a length so close to
/// its chord's that rounding decides its shape.
constexpr double least_joined = 0x1.0p-5;
/// Whole turns are taken where the length is more than this many times the shortest.
constexpr double loiter_beyond = 2.0;
constexpr std::size_t most_whole_turns = 64;
constexpr RangeGoal curvature_goal{0x1.0p-26};

/// One arc (signed angle) of the skeleton's radius, or one straight line.
struct Move {
  double angle = 0.0;
  double straight = 0.0;
};

struct Skeleton {
  std::vector<Move> moves;
  double radius = 0.0;
  TurnLimitedShape shape = TurnLimitedShape::arcs;
  std::size_t whole_turns = 0;

  double length() const {
    double sum = 0.0;
    for (const Move& m : moves) sum += std::abs(m.angle) * radius + m.straight;
    return sum;
  }
  double turning() const {
    double sum = 0.0;
    for (const Move& m : moves) sum += std::abs(m.angle);
    return sum;
  }
};

/// The problem from the origin, in units of a power of two.
struct Ends {
  Vector2<double> way;
  double first, last;  ///< angles of the directions
  double radius;       ///< of the arcs, margin included
};

Vector2<double> left_of(double angle) { return {-std::sin(angle), std::cos(angle)}; }

/// The angle turned to side s (1: left), in [0, 2π); a full turn less rounding is none.
double turned(double s, double angle) {
  double x = std::fmod(s * angle, turn);
  if (x < 0.0) x += turn;
  return x > turn - rounding || x < rounding ? 0.0 : x;
}

/// Two turns to the same side with m whole turns more, if there are such.
std::optional<Skeleton> same_side(const Ends& ends, double s, std::size_t m, double radius) {
  const double change = turned(s, ends.last - ends.first);
  const double all = change + turn * static_cast<double>(m);
  const Vector2<double> apart =
      ends.way + (s * radius) * (left_of(ends.last) - left_of(ends.first));
  const double straight = std::hypot(apart.x, apart.y);
  const double heading = straight > 0.0 ? std::atan2(apart.y, apart.x) : ends.first;
  double first = turned(s, heading - ends.first);
  if (first > all) {
    if (first - all > rounding) return std::nullopt;
    first = all;
  }
  Skeleton found;
  found.radius = radius;
  found.moves = {{s * first, 0.0}, {0.0, straight}, {s * (all - first), 0.0}};
  found.whole_turns = m;
  found.shape = m > 0 ? TurnLimitedShape::loiter : TurnLimitedShape::arcs;
  return found;
}

/// A turn to side s, a line, a turn to the other side.
std::optional<Skeleton> other_side(const Ends& ends, double s, double radius) {
  const Vector2<double> apart =
      ends.way - (s * radius) * (left_of(ends.last) + left_of(ends.first));
  const double distance = std::hypot(apart.x, apart.y);
  if (!(distance >= 2.0 * radius)) return std::nullopt;
  const double straight = std::sqrt((distance - 2.0 * radius) * (distance + 2.0 * radius));
  const double heading = std::atan2(apart.y, apart.x) + s * std::atan2(2.0 * radius, straight);
  Skeleton found;
  found.radius = radius;
  found.moves = {{s * turned(s, heading - ends.first), 0.0},
                 {0.0, straight},
                 {-s * turned(-s, ends.last - heading), 0.0}};
  return found;
}

/// Three arcs, to side s, to the other and back; `bend` = ±1 chooses the middle circle.
std::optional<Skeleton> three_arcs(const Ends& ends, double s, double bend, double radius) {
  const Vector2<double> apart =
      ends.way + (s * radius) * (left_of(ends.last) - left_of(ends.first));
  const double distance = std::hypot(apart.x, apart.y);
  if (!(distance <= 4.0 * radius) || !(distance > 0.0)) return std::nullopt;
  const double along = std::atan2(apart.y, apart.x);
  const double open = bend * std::acos(distance / (4.0 * radius));
  const double quarter = 0.25 * turn;
  const double first = along + open + s * quarter, second = along - open - s * quarter;
  Skeleton found;
  found.radius = radius;
  found.moves = {{s * turned(s, first - ends.first), 0.0},
                 {-s * turned(-s, second - first), 0.0},
                 {s * turned(s, ends.last - second), 0.0}};
  return found;
}

using Word = std::function<std::optional<Skeleton>(double radius)>;

std::vector<Word> words_on_a_grid(const Ends& ends) {
  std::vector<Word> words;
  for (const double s : {1.0, -1.0}) {
    words.emplace_back([ends, s](double radius) { return other_side(ends, s, radius); });
    for (const double bend : {1.0, -1.0}) {
      words.emplace_back(
          [ends, s, bend](double radius) { return three_arcs(ends, s, bend, radius); });
    }
  }
  return words;
}

/// Every word at one radius, without whole turns that it could do without.
std::vector<Skeleton> words_at(const Ends& ends, double radius) {
  std::vector<Skeleton> found;
  for (const double s : {1.0, -1.0}) {
    for (std::size_t m = 0; m < 2; ++m) {
      if (auto one = same_side(ends, s, m, radius)) {
        found.push_back(*std::move(one));
        break;
      }
    }
  }
  for (const Word& word : words_on_a_grid(ends)) {
    if (auto one = word(radius)) found.push_back(*std::move(one));
  }
  return found;
}

/// The root of a function that does not fall, between low (value ≤ 0) and high (value > 0).
template <class Function>
double bisected(double low, double high, const Function& function) {
  constexpr int halvings = 64;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    if (!(low < middle && middle < high)) break;
    (function(middle) > 0.0 ? high : low) = middle;
  }
  return low;
}

/// Two turns to side s and m whole turns, of the radius that gives the length.
std::optional<Skeleton> same_side_of_length(const Ends& ends, double s, std::size_t m,
                                            double length) {
  const double all = turned(s, ends.last - ends.first) + turn * static_cast<double>(m);
  const Vector2<double> change = left_of(ends.last) - left_of(ends.first);
  const auto excess = [&](double radius) {
    const Vector2<double> apart = ends.way + (s * radius) * change;
    return (radius * all - length) + std::hypot(apart.x, apart.y);
  };
  double radius = ends.radius;
  const double at_least = excess(radius);
  if (at_least > rounding * length) return std::nullopt;
  if (at_least < -rounding * length) {
    const double largest = 16.0 * length;  // larger circles lose the digits of what they join
    double high = 2.0 * radius;
    while (high < largest && !(excess(high) > 0.0)) high *= 2.0;
    if (!(excess(high) > 0.0)) return std::nullopt;
    radius = bisected(radius, high, excess);
  }
  return same_side(ends, s, m, radius);
}

/// Skeletons that have the length, those of less turning first.
class Candidates {
 public:
  explicit Candidates(double length) : length_(length) {}

  void add(std::optional<Skeleton> one) {
    if (one && std::abs(one->length() - length_) <= rounding * length_) {
      list_.push_back(*std::move(one));
    }
  }
  std::vector<Skeleton> sorted() && {
    std::stable_sort(list_.begin(), list_.end(), [](const Skeleton& a, const Skeleton& b) {
      return a.turning() < b.turning();
    });
    return std::move(list_);
  }

 private:
  double length_;
  std::vector<Skeleton> list_;
};

/// x - sin x, to rounding.
double bow(double x) {
  constexpr double small = 0.125;  // the next term of the series is below a rounding
  if (x >= small) return x - std::sin(x);
  const double square = x * x;
  return x * square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0 * (1.0 - square / 72.0)));
}

/// The swerve that lengthens a skeleton's line to the whole length.
std::optional<Skeleton> swerving(const Skeleton& plain, double length) {
  const double more = length - plain.length();
  if (!(more > 0.0) || plain.moves[1].angle != 0.0) return std::nullopt;
  const double radius = plain.radius, straight = plain.moves[1].straight;
  const auto excess = [&](double angle) { return 4.0 * radius * bow(angle) - more; };
  constexpr double quarter = 0.25 * turn;
  const double beyond = -excess(quarter);
  const double angle = beyond >= 0.0 ? quarter : bisected(0.0, quarter, excess);
  const double left = straight - 4.0 * radius * std::sin(angle);
  if (!(left >= 0.0)) return std::nullopt;
  Skeleton found = plain;
  found.shape = TurnLimitedShape::swerve;
  if (beyond >= 0.0) {  // quarter turns, and legs sideways
    const Move leg{0.0, 0.5 * beyond}, rest{0.0, 0.5 * left};
    found.moves = {plain.moves[0], rest, {quarter, 0.0}, leg, {-2.0 * quarter, 0.0}, leg,
                   {quarter, 0.0}, rest, plain.moves[2]};
    return found;
  }
  found.moves = {plain.moves[0], {0.0, 0.5 * left}, {angle, 0.0},  {-2.0 * angle, 0.0},
                 {angle, 0.0},   {0.0, 0.5 * left}, plain.moves[2]};
  return found;
}

/// Adds every skeleton of the length that `family` has between two values of its parameter, where
/// a grid brackets it.
void add_from_grid(Candidates& candidates, double length, double low, double ratio, double shift,
                   const Word& family) {
  constexpr int steps = 40;
  double before = low;
  auto shape = family(before);
  double value = shape ? shape->length() - length : 0.0;
  candidates.add(shape);
  for (int i = 1; i <= steps; ++i) {
    const double parameter = before * ratio + shift;
    auto next = family(parameter);
    const double next_value = next ? next->length() - length : 0.0;
    if (shape && next && value * next_value < 0.0) {
      const double sign = next_value > 0.0 ? 1.0 : -1.0;
      bool valid = true;
      const double root = bisected(before, parameter, [&](double r) {
        const auto here = family(r);
        valid = valid && here.has_value();
        return here ? sign * (here->length() - length) : 0.0;
      });
      if (valid) candidates.add(family(root));
    }
    before = parameter;
    shape = std::move(next);
    value = next_value;
  }
}

std::vector<Skeleton> without_whole_turns(const Ends& ends, double length) {
  Candidates candidates(length);
  for (const double s : {1.0, -1.0}) candidates.add(same_side_of_length(ends, s, 0, length));
  constexpr double steps = 40.0;
  const double most = 4.0 * std::max(length, ends.radius);
  for (const Word& word : words_on_a_grid(ends)) {
    add_from_grid(candidates, length, ends.radius, std::pow(most / ends.radius, 1.0 / steps), 0.0,
                  word);
  }
  for (const Skeleton& plain : words_at(ends, ends.radius)) {
    if (plain.whole_turns == 0) candidates.add(swerving(plain, length));
  }
  auto found = std::move(candidates).sorted();
  if (!found.empty()) return found;
  // A line ahead at the start, or at the end: from the shortest word on, every length near it.
  Candidates with_lines(length);
  for (const bool at_end : {false, true}) {
    const Vector2<double> along =
        hodograph_form(Complex<double>{std::cos(0.5 * (at_end ? ends.last : ends.first)),
                                       std::sin(0.5 * (at_end ? ends.last : ends.first))},
                       Complex<double>{std::cos(0.5 * (at_end ? ends.last : ends.first)),
                                       std::sin(0.5 * (at_end ? ends.last : ends.first))});
    for (std::size_t which = 0; which < 8; ++which) {
      const Word led = [&, which](double line) -> std::optional<Skeleton> {
        Ends rest = ends;
        rest.way = ends.way - line * along;
        auto one = which < 2 ? same_side(rest, which == 0 ? 1.0 : -1.0, 0, ends.radius)
                             : words_on_a_grid(rest)[which - 2](ends.radius);
        if (!one) return std::nullopt;
        one->moves.insert(at_end ? one->moves.end() : one->moves.begin(), Move{0.0, line});
        return one;
      };
      add_from_grid(with_lines, length, 0.0, 1.0, length / steps, led);
    }
  }
  return std::move(with_lines).sorted();
}

/// Whole turns: as many as the radius allows, on the side that turns less; then fewer.
std::vector<Skeleton> with_whole_turns(const Ends& ends, double length) {
  const double room = length / (turn * ends.radius);
  std::size_t m = room < static_cast<double>(most_whole_turns) ? static_cast<std::size_t>(room)
                                                               : most_whole_turns;
  std::vector<Skeleton> found;
  constexpr std::size_t enough = 4;
  for (; m > 0 && found.size() < enough; --m) {
    Candidates candidates(length);
    for (const double s : {1.0, -1.0}) candidates.add(same_side_of_length(ends, s, m, length));
    for (Skeleton& one : std::move(candidates).sorted()) found.push_back(std::move(one));
  }
  return found;
}

/// The least length from which on whole turns meet every one.
double loiter_length(const Ends& ends) {
  double least = std::numeric_limits<double>::infinity();
  for (const double s : {1.0, -1.0}) {
    least = std::min(least, same_side(ends, s, 1, ends.radius)->length());
  }
  return least;
}

double shortest_word(const Ends& ends) {
  double least = std::numeric_limits<double>::infinity();
  for (const Skeleton& one : words_at(ends, ends.radius)) least = std::min(least, one.length());
  return least;
}

// ---- spans
// ---------------------------------------------------------------------------------------

using PlanPreimage = BernsteinPolynomial<Complex<double>, 2>;

/// Collects spans that follow one another; parameter steps so that |dr/dξ| = 1 at their ends.
class Spans {
 public:
  explicit Spans(const Vector2<double>& start) : at_(start) {}

  /// A span whose preimage is one for the parameter step 1.
  void add(PlanPreimage w) {
    const double speed = dot(w.front(), w.front());
    const double factor = 1.0 / std::sqrt(speed);
    const bool flip = !curves_.empty() && dot(curves_.back().preimage().back(), w.front()) < 0.0;
    w = w.mapped([&](const Complex<double>& c) { return (flip ? -factor : factor) * c; });
    const double knot = knots_.back() + speed;
    curves_.emplace_back(at_, w, knot - knots_.back());
    knots_.push_back(knot);
    at_ = curves_.back().end();
  }
  Result<PlanarPath<2>> path() && {
    return PlanarPath<2>::create(std::move(knots_), std::move(curves_), false);
  }

 private:
  Vector2<double> at_;
  std::vector<double> knots_{0.0};
  std::vector<PlanarPhCurve<2>> curves_;
};

/// The quintic of prescribed length along an arc: chord X = 2 ρ sin(α/2), S = ρ α, directions
/// ∓α/2 to the chord; the symmetric case |w0|² = 3 (S - X)/(2 m²), w1 real, with l + i m =
/// exp(i α/4), where S - X = 2 ρ (α/2 - sin(α/2)) keeps its digits however short the arc.
/// `phase` is exp(i φ/2) for the heading φ, and is turned along.
PlanPreimage arc(Complex<double>& phase, double angle, double radius) {
  const double size = std::abs(angle), l = std::cos(0.25 * size), m = std::sin(0.25 * size);
  const double excess = 2.0 * radius * bow(0.5 * size);
  const double sum = radius * (size + 2.0 * std::sin(0.5 * size));
  const double z = 1.5 * excess / (m * m), w = std::sqrt(z);
  const double middle = 0.25 * (std::sqrt(60.0 * sum - 20.0 * l * l * z) - 6.0 * l * w);
  const auto turned_by = [](double half) {
    return Complex<double>{std::cos(half), std::sin(half)};
  };
  const Complex<double> before = phase;
  phase = phase * turned_by(0.5 * angle);
  phase = (1.0 / std::sqrt(dot(phase, phase))) * phase;
  return PlanPreimage({w * before, middle * (before * turned_by(0.25 * angle)), w * phase});
}

/// The skeleton cut into groups of pieces, each for one quintic: one piece, or a very short arc
/// with what follows it, up to the first longer arc, or line long enough to take its angle up; the
/// last ones with what is before them.
using Group = std::vector<Move>;
std::vector<Group> groups_of(const Skeleton& skeleton, const ArcPieces& pieces) {
  constexpr double long_enough = 16.0;  // times the short arcs: the curvature is half of theirs
  std::vector<Group> groups;
  Group open;
  double short_arcs = 0.0, lines = 0.0;
  const double all = skeleton.length();
  const auto add = [&](const Move& move) {
    open.push_back(move);
    const bool is_arc = move.straight == 0.0;
    if (is_arc && std::abs(move.angle) < least_angle) short_arcs += std::abs(move.angle);
    if (!is_arc) lines += move.straight;
    const double needed = short_arcs > 0.0 ? least_joined : least_angle;
    const bool longer_arc = is_arc && std::abs(move.angle) >= needed;
    if (longer_arc || (lines > 0.0 && lines >= long_enough * short_arcs * skeleton.radius)) {
      groups.push_back(std::move(open));
      open.clear();
      short_arcs = lines = 0.0;
    }
  };
  for (const Move& move : skeleton.moves) {
    if (move.straight > rounding * all) add({0.0, move.straight});
    if (std::abs(move.angle) <= rounding) continue;
    const double count =
        std::max(1.0, std::ceil(std::abs(move.angle) / pieces.longest * (1.0 - rounding)));
    for (double i = 0.0; i < count; ++i) add({move.angle / count, 0.0});
  }
  if (groups.empty() && !open.empty()) groups.emplace_back();
  if (!open.empty()) groups.back().insert(groups.back().end(), open.begin(), open.end());
  return groups;
}

/// The way along moves from the origin, and the direction at its end.
DirectedPoint end_of(const Group& group, const Vector2<double>& along, double radius) {
  DirectedPoint end{{0.0, 0.0}, along};
  for (const Move& move : group) {
    end.position += move.straight * end.direction;
    const double angle = move.angle, side = angle < 0.0 ? -1.0 : 1.0;
    if (angle == 0.0) continue;
    const double c = std::cos(angle), s = std::sin(angle), half = std::sin(0.5 * angle);
    const Vector2<double> left{-end.direction.y, end.direction.x};
    end.position +=
        (radius * side * s) * end.direction + (side * 2.0 * radius * half * half) * left;
    end.direction = c * end.direction + s * left;
  }
  return end;
}

/// The quintics along a skeleton; `unit` is the skeleton's unit of length.
Result<PlanarPath<2>> spans_along(const Skeleton& skeleton, const ArcPieces& pieces,
                                  const DirectedPoint& begin, double unit) {
  Spans spans(begin.position);
  const double heading = std::atan2(begin.direction.y, begin.direction.x);
  Complex<double> phase{std::cos(0.5 * heading), std::sin(0.5 * heading)};
  for (const Group& group : groups_of(skeleton, pieces)) {
    if (group.size() == 1 && group[0].straight > 0.0) {
      const Complex<double> one = std::sqrt(unit * group[0].straight) * phase;
      spans.add(PlanPreimage({one, one, one}));
      continue;
    }
    if (group.size() == 1) {
      spans.add(arc(phase, group[0].angle, unit * skeleton.radius));
      continue;
    }
    const Vector2<double> along = hodograph_form(phase, phase);
    const DirectedPoint end = end_of(group, along, skeleton.radius);
    double length = 0.0, angle = 0.0;
    for (const Move& move : group) {
      length += move.straight + std::abs(move.angle) * skeleton.radius;
      angle += move.angle;
    }
    const auto made = prescribed_length_curve(
        {{0.0, 0.0}, along}, end, std::max(length, std::hypot(end.position.x, end.position.y)));
    if (!made) return made.fault();
    const double scale = std::sqrt(unit);
    spans.add(made->curve.preimage().mapped([&](const Complex<double>& w) { return scale * w; }));
    phase = phase * Complex<double>{std::cos(0.5 * angle), std::sin(0.5 * angle)};
  }
  return std::move(spans).path();
}

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
    if (!path) continue;
    const double most = curvature_bound(*path);
    if (!keeps(most, turn_radius)) continue;
    return TurnLimitedPath{*std::move(path), skeleton.shape, skeleton.whole_turns,
                           unit * skeleton.radius, most};
  }
  return std::nullopt;
}

Fault not_reached(const Ends& ends, double length, double unit, double turn_radius) {
  const double shortest = shortest_word(ends), every = loiter_length(ends);
  constexpr double safe = 1.0 + 4.0 * rounding;
  if (length < shortest) {
    const double bound = unit * shortest * safe;
    return {FaultCode::no_interpolant,
            "a turn radius of " + to_text(turn_radius) + " needs a length of at least " +
                to_text(bound) + " between these points and directions; got " +
                to_text(unit * length),
            std::nullopt,
            "length",
            unit * length,
            bound};
  }
  const double bound = unit * every * safe;
  return {FaultCode::no_interpolant,
          "a length of " + to_text(unit * length) + " with a turn radius of " +
              to_text(turn_radius) +
              " is too long for a path without whole turns and too short for one with them; every "
              "length from " +
              to_text(bound) + " on is met",
          std::nullopt,
          "length",
          unit * length,
          bound};
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
  const bool too_short =
      !any && any.fault().quantity == "length" && any.fault().code == FaultCode::no_interpolant;
  if (!any && any.fault().code != FaultCode::no_interpolant) return any.fault();
  const double unit = unit_of(begin, end, length, turn_radius);
  const double scaled = length / unit;
  const Ends ends = ends_of(begin, end, turn_radius, coarse_pieces, unit);
  if (!too_short) {
    const bool far_longer =
        scaled > loiter_beyond * shortest_word(ends) && scaled >= loiter_length(ends);
    if (far_longer) {
      auto made =
          first_made(with_whole_turns(ends, scaled), coarse_pieces, begin, unit, turn_radius);
      if (made) return *std::move(made);
    }
    if (any) {
      if (auto found = one_span(begin, end, length, turn_radius)) return *std::move(found);
    }
  }
  for (const ArcPieces& pieces : {coarse_pieces, fine_pieces}) {
    if (too_short) break;
    const Ends these = ends_of(begin, end, turn_radius, pieces, unit);
    for (const auto& skeletons : {without_whole_turns, with_whole_turns}) {
      auto made = first_made(skeletons(these, scaled), pieces, begin, unit, turn_radius);
      if (made) return *std::move(made);
    }
  }
  return not_reached(ends_of(begin, end, turn_radius, fine_pieces, unit), scaled, unit,
                     turn_radius);
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
  if (!arcs) return not_reached(ends, std::max(least, chord) / unit, unit, turn_radius);
  const double length = arcs->path.arc_length();
  // One quintic, from the least length (a little more than the distance) to the arcs' and the
  // detour: the first of a grid that keeps the radius, then bisected.
  const double limit = (1.0 + choice.most_detour) * length;
  constexpr double least_excess = 0x1.0p-20;
  double failed = std::max(least, chord * (1.0 + least_excess)) - chord;
  constexpr int steps = 16, halvings = 12;
  const double begin_excess = std::max(failed, 0x1.0p-8 * limit);
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
