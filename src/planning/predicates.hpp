// SPDX-License-Identifier: MIT
// Exact predicates on points of doubles: a static filter that settles almost every case in a few
// operations, and exact arithmetic (Boost.Multiprecision) behind it.
//
// Why not a geometry kernel's predicates: one predicate decides everything here, so a filter and
// integers suffice; no rounding mode is changed, nothing is asked of the compiler's flags, and no
// licence but Boost's is added.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "hodograph/algebra/vector.hpp"

namespace hodograph::planning_detail {

using Point = Vector2<double>;

/// The rounded determinant (a - c) × (b - c) is off by less than 3 ε/2 + O(ε²) of the sum of the
/// sizes of its two products (three roundings each: two differences and a product, one more for
/// the final difference); 4 ε/2 leaves room for the sum itself.
inline constexpr double orientation_error = 0x1p-51;
/// The filter holds where products are at least this large: rounding below the range of normal
/// numbers (2^-1074 a product) is then far below orientation_error of them.
inline constexpr double smallest_filtered = 0x1p-900;

/// The sign of (a - c) × (b - c), decided in exact arithmetic. Domain: as orientation.
int exact_orientation(const Point& a, const Point& b, const Point& c);

/// +1 where c is to the left of the line from a to b, -1 to the right, 0 on it (also where points
/// coincide). Exact. Domain: finite, differences at most 2^510.
inline int orientation(const Point& a, const Point& b, const Point& c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double determinant = left - right;
  const double size = std::fabs(left) + std::fabs(right);
  const double error = orientation_error * size;
  if (size >= smallest_filtered) {
    if (determinant > error) return 1;
    if (determinant < -error) return -1;
  }
  return exact_orientation(a, b, c);
}

/// True where p lies on the closed segment from a to b. Exact.
inline bool on_segment(const Point& p, const Point& a, const Point& b) {
  const bool in_x = a.x < b.x ? a.x <= p.x && p.x <= b.x : b.x <= p.x && p.x <= a.x;
  const bool in_y = a.y < b.y ? a.y <= p.y && p.y <= b.y : b.y <= p.y && p.y <= a.y;
  return in_x && in_y && orientation(a, b, p) == 0;
}

/// For p on the line through the apex and a (not the apex itself): true where p is on a's side.
inline bool same_side(const Point& apex, const Point& a, const Point& p) {
  return apex.x != a.x ? (apex.x < a.x) == (apex.x < p.x) && apex.x != p.x
                       : (apex.y < a.y) == (apex.y < p.y) && apex.y != p.y;
}

/// Compares the directions from the apex to p and to q by their angle anticlockwise from the
/// direction to `zero`, in [0, 2π): -1, 0, +1. Exact. Domain: none coincides with the apex.
int compare_angles(const Point& apex, const Point& zero, const Point& p, const Point& q);

/// The directions from an apex anticlockwise from `begin` to `end`; a full turn where they agree.
struct Sector {
  Point begin{}, end{};
};

/// True where the direction from the apex to p is strictly inside the sector. Exact.
inline bool strictly_inside(const Point& apex, const Sector& sector, const Point& p) {
  const bool after_begin = orientation(apex, sector.begin, p) > 0;
  const bool before_end = orientation(apex, sector.end, p) < 0;
  const int turn = orientation(apex, sector.begin, sector.end);
  if (turn > 0) return after_begin && before_end;
  if (turn < 0) {
    // More than half a turn: outside is the closed convex sector from end to begin.
    return !(orientation(apex, sector.end, p) >= 0 && orientation(apex, sector.begin, p) <= 0);
  }
  if (same_side(apex, sector.begin, sector.end)) {  // a full turn
    return !(orientation(apex, sector.begin, p) == 0 && same_side(apex, sector.begin, p));
  }
  return after_begin;  // half a turn
}

/// True where two sectors have no direction strictly inside both. Exact.
bool disjoint(const Point& apex, const Sector& a, const Sector& b);

/// The sign of the sum of the signed areas of rings (positive anticlockwise). Exact.
int area_sign(std::span<const std::vector<Point>* const> rings);

}  // namespace hodograph::planning_detail
