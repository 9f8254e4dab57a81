// SPDX-License-Identifier: MIT
// How the intersections of two planar curves are isolated: subdivision by boxes and by the strips
// along the chords, then interval Newton steps where the tangents cannot be parallel.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/foundation/accuracy.hpp"
#include "hodograph/path/detail/enclosed_curve.hpp"
#include "hodograph/path/detail/segment_distance.hpp"

namespace hodograph::path_detail {

/// A planar polynomial curve with its derivative by u, coefficients known to rounding.
template <std::size_t d>
struct PlaneCurve {
  BernsteinPolynomial<Vector2<Enclosure>, d> position;
  BernsteinPolynomial<Vector2<Enclosure>, d - 1> rate;
  /// How far beyond u = 0 and u = 1 the curve may reach within the rounding of a join.
  double reach_begin = 0.0, reach_end = 0.0;

  explicit PlaneCurve(const BernsteinPolynomial<Vector2<Enclosure>, d>& r)
      : position(r), rate(r.derivative()) {
    double size = 0.0;
    for (const auto& c : r.coefficients()) {
      size = std::max({size, c.x.magnitude(), c.y.magnitude()});
    }
    const double noise = accuracy::join_error<double>() * size;
    reach_begin = reach(noise, rate.front());
    reach_end = reach(noise, rate.back());
  }

 private:
  static double reach(double noise, const Vector2<Enclosure>& rate) {
    constexpr double farthest = 0x1.0p-20;  // next to a cusp no further than that
    const double speed = std::max(rate.x.mignitude(), rate.y.mignitude());
    return noise < farthest * speed ? noise / speed : farthest;
  }
};

/// r - origin of one segment.
template <std::size_t n>
PlaneCurve<2 * n + 1> plane_curve(const PhCurve<Complex<double>, n>& curve,
                                  const Vector2<double>& origin) {
  const EnclosedCurve<Complex<double>, n> exact(curve);
  const Enclosure unit = power_of_two(exact.exponent());
  const Enclosure factor = (exact.step() * unit) * unit;
  const Vector2<Enclosure> start = enclosed(curve.start()) - enclosed(origin);
  return PlaneCurve<2 * n + 1>(exact.hodograph().antiderivative().mapped(
      [&](const Vector2<Enclosure>& d) { return start + factor * d; }));
}

/// The ranges of the coordinates.
struct PlaneBox {
  Enclosure x, y;

  template <std::size_t d>
  static PlaneBox of(const BernsteinPolynomial<Vector2<Enclosure>, d>& f) {
    PlaneBox box{f[0].x, f[0].y};
    for (const auto& c : f.coefficients()) {
      box = hull(box, {c.x, c.y});
    }
    return box;
  }
  static PlaneBox hull(const PlaneBox& a, const PlaneBox& b) {
    return {Enclosure::hull(a.x, b.x), Enclosure::hull(a.y, b.y)};
  }
  bool apart_from(const PlaneBox& other) const {
    return x < other.x || other.x < x || y < other.y || other.y < y;
  }
  double size() const { return std::max(x.width(), y.width()); }
};

/// f on u, cut off first at the end that is farther away, so that no quotient is near 0/0.
template <class V, std::size_t m>
BernsteinPolynomial<V, m> part_of(const BernsteinPolynomial<V, m>& f, const Enclosure& u) {
  const Enclosure a(u.lower()), b(u.upper()), zero(0.0), one(1.0);
  if (u.lower() + u.upper() > 1.0) return f.restricted(a, b);
  if (u.lower() == 0.0) return f.restricted(zero, b);
  return f.restricted(a, one).restricted(zero, (b - a) / (one - a));
}

/// A place where two curves may meet. Parameters may lie beyond [0, 1] by the rounding of a join.
struct CurveMeeting {
  Enclosure u, v;
  bool certain = false;        ///< exactly one common point, where the tangents are not parallel
  int turn = 0;                ///< for a certain one, the sign of cross(P', Q')
  Enclosure u_alone, v_alone;  ///< of a certain one, where there is no other
};

inline bool touch(const Enclosure& a, const Enclosure& b) { return !(a < b) && !(b < a); }
inline bool inside(const Enclosure& a, const Enclosure& b) {
  return b.lower() <= a.lower() && a.upper() <= b.upper();
}

/// How two curves follow each other on one path, so that what they have in common for that reason
/// is not looked for.
struct Following {
  bool same = false;    ///< one curve: u < v
  bool first = false;   ///< the end of the first is the beginning of the second
  bool second = false;  ///< the end of the second is the beginning of the first
};

template <std::size_t d, std::size_t e>
class CurveMeetings {
 public:
  CurveMeetings(const PlaneCurve<d>& p, const PlaneCurve<e>& q, const Following& following = {})
      : p_(p), q_(q), following_(following) {}

  /// Every common point lies in one of the meetings.
  std::vector<CurveMeeting> run() {
    const Enclosure u(-p_.reach_begin, 1.0 + p_.reach_end);
    const Enclosure v(-q_.reach_begin, 1.0 + q_.reach_end);
    open_.push_back({u, v, part_of(p_.position, u), part_of(q_.position, v)});
    // Breadth first: where the work ends, what is open is equally small everywhere.
    for (std::size_t next = 0; next < open_.size(); ++next) {
      Pair pair = std::move(open_[next]);
      const bool follows = following(pair);
      if (follows ? goes_one_way(pair) : apart(pair.p, pair.q) || try_newton(pair)) continue;
      const bool small = pair.u.width() <= least_part && pair.v.width() <= least_part;
      if (!small && follows && open_.size() < most_pairs) {
        split_both(pair);
        continue;
      }
      if (small || open_.size() >= most_pairs) {
        undecided_.push_back({pair.u, pair.v, false, 0, {}, {}});
        continue;
      }
      split(pair);
    }
    return settled();
  }

 private:
  template <std::size_t m>
  using Points = BernsteinPolynomial<Vector2<Enclosure>, m>;
  struct Pair {
    Enclosure u, v;
    Points<d> p;
    Points<e> q;
  };
  /// Curves that touch part by the square of their length: below the square root of rounding
  /// nothing is gained.
  static constexpr double least_part = 0x1.0p-28;
  static constexpr std::size_t most_pairs = 1500;

  /// Whether two pieces certainly have no point in common: their boxes, or their strips along
  /// either chord, are apart.
  static bool apart(const Points<d>& p, const Points<e>& q) {
    if (PlaneBox::of(p).apart_from(PlaneBox::of(q))) return true;
    return apart_across(p[d], p[0], p, q) || apart_across(q[e], q[0], p, q);
  }
  static bool apart_across(const Vector2<Enclosure>& end, const Vector2<Enclosure>& begin,
                           const Points<d>& p, const Points<e>& q) {
    const Vector2<Enclosure> chord{Enclosure(end.x.middle() - begin.x.middle()),
                                   Enclosure(end.y.middle() - begin.y.middle())};
    const auto strip = [&](const auto& f) {
      Enclosure all = cross(chord, f[0] - begin);
      for (const auto& c : f.coefficients()) all = Enclosure::hull(all, cross(chord, c - begin));
      return all;
    };
    const Enclosure a = strip(p), b = strip(q);
    return a < b || b < a;
  }

  /// Whether the pieces are one, or one begins where the other ends.
  bool following(const Pair& pair) const {
    return (following_.same && touch(pair.u, pair.v)) ||
           (following_.first && pair.u.upper() >= 1.0 && pair.v.lower() <= 0.0) ||
           (following_.second && pair.v.upper() >= 1.0 && pair.u.lower() <= 0.0);
  }
  /// Whether some direction has every tangent on its side: along it the pieces go on and on, and
  /// have no point in common but where they follow each other.
  bool goes_one_way(const Pair& pair) const {
    const auto a = part_of(p_.rate, pair.u).coefficients();
    const auto b = part_of(q_.rate, pair.v).coefficients();
    Vector2<double> way{};
    const auto add = [&](const auto& rates) {
      for (const auto& c : rates) {
        const Vector2<double> at{c.x.middle(), c.y.middle()};
        const double size = norm(at);
        if (size > 0.0) way += (1.0 / size) * at;
      }
    };
    add(a);
    add(b);
    const Vector2<Enclosure> along{Enclosure(way.x), Enclosure(way.y)};
    const auto on_its_side = [&](const auto& c) { return dot(along, c).lower() > 0.0; };
    return std::all_of(a.begin(), a.end(), on_its_side) &&
           std::all_of(b.begin(), b.end(), on_its_side);
  }
  static std::array<Enclosure, 2> halves(const Enclosure& whole) {
    const double middle = whole.middle();
    return {Enclosure(whole.lower(), middle), Enclosure(middle, whole.upper())};
  }
  void split_both(const Pair& pair) {
    const bool one = following_.same && pair.u.lower() == pair.v.lower();
    for (const Enclosure& u : halves(pair.u)) {
      for (const Enclosure& v : halves(pair.v)) {
        if (one && v.lower() < u.lower()) continue;
        open_.push_back({u, v, part_of(p_.position, u), part_of(q_.position, v)});
      }
    }
  }

  void split(const Pair& pair) {
    const bool first =
        pair.v.width() <= least_part ||
        (pair.u.width() > least_part && PlaneBox::of(pair.p).size() >= PlaneBox::of(pair.q).size());
    for (const Enclosure& half : halves(first ? pair.u : pair.v)) {
      if (first) {
        open_.push_back({half, pair.v, part_of(p_.position, half), pair.q});
      } else {
        open_.push_back({pair.u, half, pair.p, part_of(q_.position, half)});
      }
    }
  }

  /// The range of the sides of a control polygon, which are parallel to the tangents.
  template <std::size_t m>
  static PlaneBox side_box(const Points<m>& f) {
    PlaneBox box{f[1].x - f[0].x, f[1].y - f[0].y};
    for (std::size_t i = 1; i < m; ++i) {
      box = PlaneBox::hull(box, {f[i + 1].x - f[i].x, f[i + 1].y - f[i].y});
    }
    return box;
  }
  static Enclosure cross_of(const PlaneBox& a, const PlaneBox& b) { return a.x * b.y - a.y * b.x; }

  struct Jacobian {
    Vector2<Enclosure> p, q;
    Enclosure determinant;
  };
  Jacobian jacobian(const Enclosure& u, const Enclosure& v) const {
    const PlaneBox p = PlaneBox::of(part_of(p_.rate, u)), q = PlaneBox::of(part_of(q_.rate, v));
    Jacobian j{{p.x, p.y}, {q.x, q.y}, {}};
    j.determinant = cross(j.p, j.q);
    return j;
  }

  /// Interval Newton steps on a box somewhat larger than the pair's, where there is at most one
  /// common point because no two tangents are parallel there: with P(u) - P(c) = A (u - c), A
  /// between the derivatives, the common point lies in N = c - J⁻¹(P(c) - Q(c)); N inside the box
  /// proves that there is one (Brouwer). Returns whether the pair is settled.
  bool try_newton(const Pair& pair) {
    // What is parallel on the pair itself is so on the larger box.
    if (cross_of(side_box(pair.p), side_box(pair.q)).contains(0.0)) return false;
    const Enclosure u_alone = widened(pair.u, 0.25), v_alone = widened(pair.v, 0.25);
    Enclosure u = u_alone, v = v_alone;
    Jacobian j = jacobian(u, v);
    if (j.determinant.contains(0.0) || !j.determinant.is_bounded()) return false;
    const int turn = j.determinant.lower() > 0.0 ? 1 : -1;
    bool proven = false;
    constexpr int most_steps = 30;
    for (int step = 0; step < most_steps; ++step) {
      const auto [nu, nv] = newton(u, v, j);
      proven = proven || (inside(nu, u) && inside(nv, v));
      const double before = std::max(u.width(), v.width());
      if (!touch(nu, u) || !touch(nv, v)) return true;
      u = common(u, nu);
      v = common(v, nv);
      if (!(std::max(u.width(), v.width()) < 0.5 * before)) break;
      j = jacobian(u, v);
    }
    if (!proven) {
      // About a box of the size of rounding.
      const Enclosure wu = widened(u, 1.0), wv = widened(v, 1.0);
      const Jacobian around = jacobian(wu, wv);
      if (around.determinant.contains(0.0)) return false;
      const auto [nu, nv] = newton(wu, wv, around);
      proven = inside(nu, wu) && inside(nv, wv) && inside(wu, u_alone) && inside(wv, v_alone);
      if (!proven) return false;
    }
    // Beyond the pair's own box it is found again by a neighbour, or lies beyond an end.
    if (touch(u, pair.u) && touch(v, pair.v)) {
      const bool known = std::any_of(certain_.begin(), certain_.end(), [&](const CurveMeeting& m) {
        return touch(m.u, u) && touch(m.v, v) && inside(u, m.u_alone) && inside(v, m.v_alone);
      });
      if (!known) certain_.push_back({u, v, true, turn, u_alone, v_alone});
    }
    return true;
  }

  std::pair<Enclosure, Enclosure> newton(const Enclosure& u, const Enclosure& v,
                                         const Jacobian& j) const {
    const Enclosure cu(u.middle()), cv(v.middle());
    const Vector2<Enclosure> gap = p_.position.value(cu) - q_.position.value(cv);
    return {cu - cross(gap, j.q) / j.determinant, cv + cross(j.p, gap) / j.determinant};
  }

  static Enclosure common(const Enclosure& a, const Enclosure& b) {
    return {std::max(a.lower(), b.lower()), std::min(a.upper(), b.upper())};
  }
  /// With a margin on both sides, in lengths of it and an ulp of 1.
  static Enclosure widened(const Enclosure& a, double margin) {
    const double reach = margin * (a.upper() - a.lower()) + epsilon<double>();
    return {a.lower() - reach, a.upper() + reach};
  }

  /// Joins the undecided boxes that touch, and drops those in which the only common point is a
  /// certain one.
  std::vector<CurveMeeting> settled() {
    std::erase_if(undecided_, [&](const CurveMeeting& box) {
      return std::any_of(certain_.begin(), certain_.end(), [&](const CurveMeeting& m) {
        return inside(box.u, m.u_alone) && inside(box.v, m.v_alone);
      });
    });
    std::vector<CurveMeeting> result = joined_boxes(undecided_);
    for (const CurveMeeting& m : certain_) {
      // One that touches a cluster becomes part of it.
      const auto cluster = std::find_if(result.begin(), result.end(), [&](const CurveMeeting& c) {
        return !c.certain && touch(c.u, m.u) && touch(c.v, m.v);
      });
      if (cluster == result.end()) {
        result.push_back(m);
      } else {
        cluster->u = Enclosure::hull(cluster->u, m.u);
        cluster->v = Enclosure::hull(cluster->v, m.v);
      }
    }
    return result;
  }

  static std::vector<CurveMeeting> joined_boxes(const std::vector<CurveMeeting>& boxes) {
    std::vector<std::size_t> leader(boxes.size());
    std::iota(leader.begin(), leader.end(), std::size_t{0});
    const auto find = [&](std::size_t i) {
      while (leader[i] != i) i = leader[i] = leader[leader[i]];
      return i;
    };
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        if (touch(boxes[i].u, boxes[k].u) && touch(boxes[i].v, boxes[k].v)) {
          leader[find(i)] = find(k);
        }
      }
    }
    std::vector<CurveMeeting> clusters;
    std::vector<std::size_t> place(boxes.size(), boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const std::size_t root = find(i);
      if (place[root] == boxes.size()) {
        place[root] = clusters.size();
        clusters.push_back(boxes[i]);
      } else {
        CurveMeeting& m = clusters[place[root]];
        m.u = Enclosure::hull(m.u, boxes[i].u);
        m.v = Enclosure::hull(m.v, boxes[i].v);
      }
    }
    return clusters;
  }

  const PlaneCurve<d>& p_;
  const PlaneCurve<e>& q_;
  Following following_;
  std::vector<Pair> open_;
  std::vector<CurveMeeting> certain_, undecided_;
};

}  // namespace hodograph::path_detail
