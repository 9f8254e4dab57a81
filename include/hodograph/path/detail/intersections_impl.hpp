// SPDX-License-Identifier: MIT
// The intersections of whole paths from those of their segments.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "hodograph/bernstein/range.hpp"
#include "hodograph/bernstein/roots.hpp"
#include "hodograph/path/detail/distance_search.hpp"
#include "hodograph/path/detail/intersection_search.hpp"
#include "hodograph/path/intersection.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph::path_detail {

/// Boxes of the segments of a path, in a binary tree over its segments: item i of level 0 is
/// segment i, of level r + 1 the hull of items 2i and 2i + 1 of level r.
class BoxTree {
 public:
  explicit BoxTree(std::vector<PlaneBox> boxes) {
    levels_.push_back(std::move(boxes));
    while (levels_.back().size() > 1) {
      const auto& below = levels_.back();
      std::vector<PlaneBox> level;
      for (std::size_t i = 0; i < below.size(); i += 2) {
        level.push_back(i + 1 < below.size() ? PlaneBox::hull(below[i], below[i + 1]) : below[i]);
      }
      levels_.push_back(std::move(level));
    }
  }
  std::size_t top() const { return levels_.size() - 1; }
  const PlaneBox& box(std::size_t level, std::size_t i) const { return levels_[level][i]; }
  /// Calls visit with the items below item i of a level.
  template <class Visit>
  void below(std::size_t level, std::size_t i, const Visit& visit) const {
    for (std::size_t k = 2 * i; k < std::min(2 * i + 2, levels_[level - 1].size()); ++k) {
      visit(level - 1, k);
    }
  }

 private:
  std::vector<std::vector<PlaneBox>> levels_;
};

/// A place on a path: in a segment, and whether it reaches the ends of it within the rounding of a
/// join.
struct Place {
  std::size_t segment;
  double u;  ///< a representative in [0, 1]
  Enclosure xi;
  bool at_begin, at_end;

  template <std::size_t n>
  static Place of(const PlanarPath<n>& path, std::size_t k, const Enclosure& u,
                  const PlaneCurve<2 * n + 1>& curve) {
    const Enclosure inside(std::clamp(u.lower(), 0.0, 1.0), std::clamp(u.upper(), 0.0, 1.0));
    return {k, inside.middle(), xi_range(path, k, inside), u.lower() <= curve.reach_begin,
            u.upper() >= 1.0 - curve.reach_end};
  }

  /// Whether it is certain that the place u is not beyond an end of an open path.
  template <std::size_t n>
  bool is_on(const PlanarPath<n>& path, const Enclosure& exact) const {
    if (path.is_closed()) return true;
    return (segment > 0 || exact.lower() >= 0.0) &&
           (segment + 1 < path.segment_count() || exact.upper() <= 1.0);
  }

  template <std::size_t n>
  double representative(const PlanarPath<n>& path) const {
    return std::clamp(path.xi_of({segment, u}), xi.lower(), xi.upper());
  }
};

/// Whether `before` and `after` are at either side of one knot; `over_seam` for that where a closed
/// path begins and ends.
template <std::size_t n>
bool at_one_knot(const PlanarPath<n>& path, const Place& before, const Place& after,
                 bool over_seam) {
  if (!before.at_end || !after.at_begin) return false;
  if (!over_seam) return before.segment + 1 == after.segment;
  return path.is_closed() && before.segment + 1 == path.segment_count() && after.segment == 0;
}

/// What two places on one path have in common.
enum class Relation { distinct, same, same_over_seam };
template <std::size_t n>
Relation relation(const PlanarPath<n>& path, const Place& a, const Place& b) {
  if (touch(a.xi, b.xi) || at_one_knot(path, a, b, false) || at_one_knot(path, b, a, false)) {
    return Relation::same;
  }
  if (at_one_knot(path, a, b, true) || at_one_knot(path, b, a, true)) {
    return Relation::same_over_seam;
  }
  return Relation::distinct;
}

/// Both places in one; over the seam it is the one at the beginning.
inline Place merged(const Place& a, const Place& b, Relation how) {
  Place first = a.xi.lower() <= b.xi.lower() ? a : b;
  if (how == Relation::same_over_seam) return first;
  const Place& second = a.xi.lower() <= b.xi.lower() ? b : a;
  first.xi = Enclosure::hull(a.xi, b.xi);
  first.at_end = second.at_end;
  // The later segment holds the knot and what follows.
  first.segment = second.segment;
  first.u = second.u;
  first.at_begin = a.at_begin && b.at_begin;
  return first;
}

/// A meeting on the whole paths.
struct Joint {
  Place u, v;
  bool certain;
  int turn;
};

template <std::size_t n, std::size_t m>
class PathMeetings {
 public:
  PathMeetings(const PlanarPath<n>& first, const PlanarPath<m>& second)
      : first_(first), second_(second), origin_(first.segment(0).start()) {}

  std::vector<PathIntersection> run() {
    const BoxTree a(boxes(first_)), b(boxes(second_));
    visit(a, a.top(), 0, b, b.top(), 0);
    return joined();
  }

  /// Of the first path with itself, which the second is, too.
  std::vector<PathIntersection> run_with_itself() {
    itself_ = true;
    const BoxTree a(boxes(first_));
    visit(a, a.top(), 0, a, a.top(), 0);
    return joined();
  }

 private:
  std::vector<PathIntersection> joined() {
    join();
    std::sort(found_.begin(), found_.end(), [](const Joint& x, const Joint& y) {
      return x.u.xi.lower() < y.u.xi.lower() ||
             (x.u.xi.lower() == y.u.xi.lower() && x.v.xi.lower() < y.v.xi.lower());
    });
    std::vector<PathIntersection> result;
    for (const Joint& at : found_) {
      PathIntersection p;
      p.xi_first_range = at.u.xi;
      p.xi_second_range = at.v.xi;
      p.xi_first = at.u.representative(first_);
      p.xi_second = at.v.representative(second_);
      p.point = first_.segment(at.u.segment).position(at.u.u);
      p.kind = at.certain ? IntersectionKind::crossing : IntersectionKind::undecided;
      result.push_back(p);
    }
    return result;
  }

  template <std::size_t k>
  std::vector<PlaneBox> boxes(const PlanarPath<k>& path) const {
    std::vector<PlaneBox> result;
    result.reserve(path.segment_count());
    for (const auto& curve : path.segments()) {
      const auto made = plane_curve(curve, origin_);
      PlaneBox box = PlaneBox::of(made.position);
      // As far as the curve may reach beyond its ends.
      const PlaneBox rate = PlaneBox::of(made.rate);
      const double beyond = std::max(made.reach_begin, made.reach_end);
      const Enclosure either(-2.0 * beyond, 2.0 * beyond);
      box.x += either * rate.x;
      box.y += either * rate.y;
      result.push_back(box);
    }
    return result;
  }

  void visit(const BoxTree& a, std::size_t level_a, std::size_t i, const BoxTree& b,
             std::size_t level_b, std::size_t j) {
    if (a.box(level_a, i).apart_from(b.box(level_b, j))) return;
    if (itself_ && level_a == level_b && j < i) return;
    if (level_a == 0 && level_b == 0) {
      add(i, j);
    } else if (level_a >= level_b) {
      a.below(level_a, i, [&](std::size_t l, std::size_t k) { visit(a, l, k, b, level_b, j); });
    } else {
      b.below(level_b, j, [&](std::size_t l, std::size_t k) { visit(a, level_a, i, b, l, k); });
    }
  }

  /// Whether some direction has the tangents of both segments on its side, a little beyond their
  /// ends, too: segments that follow each other then have no other point in common, nor has one
  /// with itself. In doubles, quick and by a wide margin: of the largest coefficient of the rates,
  /// rounding takes some 2^-48, and an end that reaches 2^-20 further some 2^-14.
  static bool go_one_way(const PlanarPhCurve<n>& a, const PlanarPhCurve<n>& b) {
    constexpr double margin = 0x1.0p-10;  // some 2^4 times what ends reach further
    const std::array rates{a.hodograph().coefficients(), b.hodograph().coefficients()};
    Vector2<double> way{};
    std::array<double, 2> sizes{};
    for (std::size_t k = 0; k < 2; ++k) {
      for (const auto& c : rates[k]) {
        const double length = std::sqrt(dot(c, c));
        if (length > 0.0) way += (1.0 / length) * c;
        sizes[k] = std::max(sizes[k], length);
      }
    }
    for (std::size_t k = 0; k < 2; ++k) {
      const double least = margin * sizes[k] * std::sqrt(dot(way, way));
      // Below the range of normal numbers rounding is not relative.
      if (!std::isfinite(least) || least < std::numeric_limits<double>::min()) return false;
      for (const auto& c : rates[k]) {
        if (!(least < dot(way, c))) return false;
      }
    }
    return true;
  }

  void add(std::size_t i, std::size_t j) {
    if constexpr (n == m) {
      if (itself_ && (j == i || j == i + 1) && go_one_way(first_.segment(i), first_.segment(j))) {
        return;
      }
    }
    const auto p = plane_curve(first_.segment(i), origin_);
    const auto q = plane_curve(second_.segment(j), origin_);
    Following following;
    if (itself_) {
      const bool over_seam =
          first_.is_closed() && i == 0 && j + 1 == first_.segment_count();  // j may be i
      following = {i == j, i + 1 == j, over_seam};
    }
    for (const CurveMeeting& at : CurveMeetings<2 * n + 1, 2 * m + 1>(p, q, following).run()) {
      Joint joint{Place::of(first_, i, at.u, p), Place::of(second_, j, at.v, q), at.certain,
                  at.turn};
      if (!joint.u.is_on(first_, at.u) || !joint.v.is_on(second_, at.v)) joint.certain = false;
      found_.push_back(joint);
    }
  }

  /// Makes one of what is found at knots from several sides.
  void join() {
    const auto at_knot = [](const Place& p) { return p.at_begin || p.at_end; };
    for (std::size_t i = 0; i < found_.size(); ++i) {
      if (!at_knot(found_[i].u) && !at_knot(found_[i].v)) continue;
      for (std::size_t k = i + 1; k < found_.size();) {
        if (absorb(found_[i], found_[k]) || (itself_ && absorb(found_[i], swapped(found_[k])))) {
          found_.erase(found_.begin() + static_cast<std::ptrdiff_t>(k));
          k = i + 1;
        } else {
          ++k;
        }
      }
    }
  }
  static Joint swapped(const Joint& a) { return {a.v, a.u, a.certain, -a.turn}; }
  bool absorb(Joint& a, const Joint& b) const {
    if (a.u.segment == b.u.segment && a.v.segment == b.v.segment) return false;
    const Relation u = relation(first_, a.u, b.u), v = relation(second_, a.v, b.v);
    if (u == Relation::distinct || v == Relation::distinct) return false;
    const bool over_seam = u == Relation::same_over_seam || v == Relation::same_over_seam;
    // Stretches across the seam stay two entries.
    if (over_seam && !(a.certain && b.certain)) return false;
    a = {merged(a.u, b.u, u), merged(a.v, b.v, v), a.certain && b.certain && a.turn == b.turn,
         a.turn};
    return true;
  }

  const PlanarPath<n>& first_;
  const PlanarPath<m>& second_;
  Vector2<double> origin_;
  bool itself_ = false;
  std::vector<Joint> found_;
};

inline std::optional<Fault> line_fault(const Vector2<double>& q, const Vector2<double>& d) {
  for (const auto* v : {&q, &d}) {
    if (!std::isfinite(v->x) || !std::isfinite(v->y)) {
      return Fault{FaultCode::not_finite,
                   "a line needs a finite point and a finite direction; a component is infinite or "
                   "not a number",
                   std::nullopt,
                   v == &q ? "point" : "direction",
                   std::nullopt,
                   std::nullopt};
    }
  }
  if (d.x == 0.0 && d.y == 0.0) {
    return Fault{FaultCode::outside_domain,
                 "the direction of the line is (0, 0); it needs one that is not zero",
                 std::nullopt,
                 "direction",
                 0.0,
                 std::nullopt};
  }
  return std::nullopt;
}

/// The zeros of f = d × (r - q) along a path.
template <std::size_t n>
class LineMeetings {
 public:
  static constexpr std::size_t degree = 2 * n + 1;

  LineMeetings(const PlanarPath<n>& path, const Vector2<double>& q, const Vector2<double>& d)
      : path_(path), q_(q), exponent_(exponent_of(largest_component(d))), direction_(enclosed(d)) {
    scale();
  }
  /// The line from q to b; d is b - q, rounded.
  LineMeetings(const PlanarPath<n>& path, const Vector2<double>& q, const Vector2<double>& b,
               const Vector2<double>& d)
      : path_(path),
        q_(q),
        exponent_(exponent_of(largest_component(d))),
        direction_(enclosed(b) - enclosed(q)) {
    scale();
  }

  std::vector<LineIntersection> run() {
    for (std::size_t k = 0; k < path_.segment_count(); ++k) add(k);
    join();
    std::vector<LineIntersection> result;
    for (const Found& at : found_) {
      LineIntersection p;
      p.xi_range = at.place.xi;
      p.xi = at.place.representative(path_);
      p.t = at.t;
      p.point = path_.segment(at.place.segment).position(at.place.u);
      p.kind = at.certain ? IntersectionKind::crossing : IntersectionKind::undecided;
      result.push_back(p);
    }
    return result;
  }

 private:
  struct Found {
    Place place;
    Enclosure t;
    bool certain;
    int turn;
  };

  /// The direction in units in which its square is in range.
  void scale() {
    const Enclosure unit = power_of_two(-exponent_);
    direction_ = unit * direction_;
  }

  void add(std::size_t k) {
    const auto curve = plane_curve(path_.segment(k), q_);
    const double begin = -curve.reach_begin;
    const Enclosure whole(begin, 1.0 + curve.reach_end);
    const auto r = part_of(curve.position, whole);
    const auto f = r.mapped([&](const auto& c) { return cross(direction_, c); });
    if (coefficient_hull(f).mignitude() > 0.0) return;
    const auto along = r.mapped([&](const auto& c) { return dot(direction_, c); });
    auto roots = isolated_roots(f);
    if (!roots) roots = std::vector<IsolatedRoot>{{Enclosure(0.0, 1.0), RootKind::cluster, 0, 0}};
    for (const IsolatedRoot& root : *roots) {
      const Enclosure u = Enclosure(begin) + (Enclosure(whole.upper()) - Enclosure(begin)) * root.u;
      const Enclosure t = coefficient_hull(root.u.lower() == root.u.upper()
                                               ? along.restricted(root.u, root.u)
                                               : along.restricted(Enclosure(root.u.lower()),
                                                                  Enclosure(root.u.upper()))) /
                          dot(direction_, direction_) * power_of_two(-exponent_);
      Found found{Place::of(path_, k, u, curve), t, root.kind == RootKind::simple, root.sign_after};
      if (!found.place.is_on(path_, u)) found.certain = false;
      found_.push_back(found);
    }
  }

  void join() {
    std::vector<Found> all;
    for (const Found& at : found_) {
      if (!all.empty() && at_one_knot(path_, all.back().place, at.place, false)) {
        absorb(all.back(), at, Relation::same);
      } else {
        all.push_back(at);
      }
    }
    if (all.size() > 1 && all.front().certain && all.back().certain &&
        at_one_knot(path_, all.back().place, all.front().place, true)) {
      absorb(all.front(), all.back(), Relation::same_over_seam);
      all.pop_back();
    }
    found_ = std::move(all);
  }
  static void absorb(Found& a, const Found& b, Relation how) {
    a = {merged(a.place, b.place, how), Enclosure::hull(a.t, b.t),
         a.certain && b.certain && a.turn == b.turn, a.turn};
  }

  const PlanarPath<n>& path_;
  Vector2<double> q_;
  int exponent_;
  Vector2<Enclosure> direction_;
  std::vector<Found> found_;
};

}  // namespace hodograph::path_detail
