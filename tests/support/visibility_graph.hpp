// SPDX-License-Identifier: MIT
// The judge of shortest polylines: the full visibility graph over all vertices, every pair tested
// in whole-number arithmetic straight from the definition, and Dijkstra. Shares nothing with the
// library but the polygons.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "hodograph/planning/world.hpp"

namespace hodograph::test {

/// A solid: what is to the left of its rings, by the even-odd rule; everything else if inverted.
struct Solid {
  std::vector<Ring> rings{};
  bool inverted = false;
};

inline std::vector<Solid> solids_of(const World& world) {
  std::vector<Solid> solids;
  for (const Polygon& polygon : world.obstacles()) {
    Solid solid{{polygon.outer}};
    solid.rings.insert(solid.rings.end(), polygon.holes.begin(), polygon.holes.end());
    solids.push_back(std::move(solid));
  }
  if (world.bounds()) {
    Ring ring = *world.bounds();
    std::reverse(ring.begin(), ring.end());
    solids.push_back({{std::move(ring)}, true});
  }
  return solids;
}

/// Points must be whole multiples of 1/scale; Int must hold the seventh power of the largest
/// multiple, times 2^8.
template <class Int>
class VisibilityGraph {
 public:
  /// Paths may turn at the vertices of the solids, unless told otherwise.
  VisibilityGraph(const std::vector<Solid>& solids, double scale, bool vertices_are_nodes = true)
      : scale_(scale) {
    for (const Solid& solid : solids) {
      Shape shape;
      shape.inverted = solid.inverted;
      for (const Ring& ring : solid.rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          shape.edges.push_back({whole(ring[i]), whole(ring[next_vertex(i, ring.size())])});
          if (vertices_are_nodes) nodes_.push_back(ring[i]);
        }
      }
      shapes_.push_back(std::move(shape));
    }
  }

  /// More points where a path may turn.
  void add_node(const Vector2<double>& p) { nodes_.push_back(p); }

  /// True where no stretch of the segment lies in the inside of the union of the closed solids.
  bool is_free(const Vector2<double>& from, const Vector2<double>& to) const {
    const P a = whole(from), b = whole(to), d{b.x - a.x, b.y - a.y};
    if (d.x == 0 && d.y == 0) return true;
    // Where anything may change: parameters along the segment, as fractions.
    std::vector<Fraction> events{{Int(0), Int(1)}, {Int(1), Int(1)}};
    for (const Shape& shape : shapes_) {
      for (const Edge& e : shape.edges) {
        const Int of_p = cross(d, sub(e.p, a)), of_q = cross(d, sub(e.q, a));
        if ((of_p > 0 && of_q > 0) || (of_p < 0 && of_q < 0)) continue;
        if (of_p == 0 && of_q == 0) {
          add_event(events, dot(sub(e.p, a), d), dot(d, d));
          add_event(events, dot(sub(e.q, a), d), dot(d, d));
        } else {
          const P along = sub(e.q, e.p);
          add_event(events, cross(sub(e.p, a), along), cross(d, along));
        }
      }
    }
    std::sort(events.begin(), events.end(), [](const Fraction& s, const Fraction& t) {
      return s.above * t.below < t.above * s.below;
    });
    for (std::size_t i = 0; i + 1 < events.size(); ++i) {
      const Fraction &s = events[i], &t = events[i + 1];
      if (s.above * t.below == t.above * s.below) continue;
      const Int below = 2 * s.below * t.below;
      const Int above = s.above * t.below + t.above * s.below;
      if (is_covered({a.x * below + d.x * above, a.y * below + d.y * above}, below, d))
        return false;
    }
    return true;
  }

  /// The length of the shortest polyline over the nodes; infinite where there is none.
  double shortest(const Vector2<double>& start, const Vector2<double>& goal) const {
    std::vector<Vector2<double>> points{start, goal};
    points.insert(points.end(), nodes_.begin(), nodes_.end());
    std::vector<double> length(points.size(), std::numeric_limits<double>::infinity());
    std::vector<bool> settled(points.size(), false);
    length[0] = 0.0;
    for (;;) {
      std::size_t best = points.size();
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (!settled[i] && std::isfinite(length[i]) &&
            (best == points.size() || length[i] < length[best])) {
          best = i;
        }
      }
      if (best == points.size() || best == 1) return length[1];
      settled[best] = true;
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (settled[i]) continue;
        const double leg = std::hypot(points[i].x - points[best].x, points[i].y - points[best].y);
        // A leg that does not improve need not be tested.
        if (length[best] + leg < length[i] && is_free(points[best], points[i])) {
          length[i] = length[best] + leg;
        }
      }
    }
  }

 private:
  struct P {
    Int x, y;
  };
  struct Edge {
    P p, q;
  };
  struct Shape {
    std::vector<Edge> edges{};
    bool inverted = false;
  };
  struct Fraction {
    Int above, below;
  };

  P whole(const Vector2<double>& p) const {
    return {Int(static_cast<std::int64_t>(std::llround(p.x * scale_))),
            Int(static_cast<std::int64_t>(std::llround(p.y * scale_)))};
  }
  static P sub(const P& a, const P& b) { return {a.x - b.x, a.y - b.y}; }
  static Int cross(const P& a, const P& b) { return a.x * b.y - a.y * b.x; }
  static Int dot(const P& a, const P& b) { return a.x * b.x + a.y * b.y; }

  static void add_event(std::vector<Fraction>& events, Int above, Int below) {
    if (below < 0) {
      above = -above;
      below = -below;
    }
    if (above > 0 && above < below) events.push_back({above, below});
  }

  /// The point m/below on a segment along d that meets no edge but along a stretch.
  bool is_covered(const P& m, const Int& below, const P& d) const {
    bool left = false, right = false;
    for (const Shape& shape : shapes_) {
      bool inside = shape.inverted, on_border = false;
      for (const Edge& e : shape.edges) {
        const P p{e.p.x * below, e.p.y * below}, q{e.q.x * below, e.q.y * below};
        const P along = sub(e.q, e.p);
        const Int side = cross(along, sub(m, p));
        if (side == 0 && dot(sub(m, p), sub(m, q)) < 0) {
          on_border = true;
          (dot(along, d) > 0 ? left : right) = true;
        }
        // Half-open crossing of the ray to the right.
        if ((p.y <= m.y) != (q.y <= m.y) && (side > 0) == (q.y > p.y)) inside = !inside;
      }
      if (inside && !on_border) return true;
    }
    return left && right;
  }

  double scale_;
  std::vector<Vector2<double>> nodes_;
  std::vector<Shape> shapes_;
};

}  // namespace hodograph::test
