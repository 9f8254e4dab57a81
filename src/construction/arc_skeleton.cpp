// SPDX-License-Identifier: MIT
// Dubins' words, their lengths as functions of the radius, and the roots of those.
#include "arc_skeleton.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace hodograph::turn_detail {
namespace {

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

}  // namespace

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

namespace {

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

}  // namespace

double bow(double x) {
  constexpr double small = 0.125;  // the next term of the series is below a rounding
  if (x >= small) return x - std::sin(x);
  const double square = x * x;
  return x * square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0 * (1.0 - square / 72.0)));
}

namespace {

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

}  // namespace

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

}  // namespace hodograph::turn_detail
