// SPDX-License-Identifier: MIT
// Skeletons of turn-limited paths: arcs of one radius and straight lines between two directed
// points, with the radius or the line ahead that gives a length; in any unit.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/construction/turn_limited.hpp"
#include "hodograph/foundation/accuracy.hpp"

namespace hodograph::turn_detail {

inline constexpr double turn = 2.0 * std::numbers::pi;
inline constexpr double rounding = accuracy::join_error<double>();
inline constexpr std::size_t most_whole_turns = 64;

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

/// x - sin x, to rounding. Domain: x ≥ 0.
double bow(double x);

/// Every word at one radius, without whole turns that it could do without.
std::vector<Skeleton> words_at(const Ends& ends, double radius);

/// Skeletons of exactly the length (within `rounding` of it), those of less turning first: without
/// whole turns; and with as many as the radius allows, then fewer.
std::vector<Skeleton> without_whole_turns(const Ends& ends, double length);
std::vector<Skeleton> with_whole_turns(const Ends& ends, double length);

/// The least length from which on whole turns meet every one.
double loiter_length(const Ends& ends);
/// The length of the shortest word.
double shortest_word(const Ends& ends);

}  // namespace hodograph::turn_detail
