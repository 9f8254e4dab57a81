// SPDX-License-Identifier: MIT
#include "hodograph/planning/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <string>

#include "box_tree.hpp"
#include "hodograph/foundation/accuracy.hpp"
#include "predicates.hpp"

namespace hodograph {

using planning_detail::Box;
using planning_detail::BoxTree;
using planning_detail::ControlPolygon;
using planning_detail::orientation;

namespace {

struct Edge {
  Vector2<double> a{}, b{};
  std::uint32_t obstacle = 0;
};

Box box_of(const Edge& edge) {
  Box box;
  box.include(edge.a);
  box.include(edge.b);
  return box;
}

/// Points on two segments, as near to each other as any, and where the first one lies (0 ... 1).
struct NearestPair {
  double distance = 0.0;
  double parameter = 0.0;
  Vector2<double> on_second{};
};

/// The parameter of the point of [a, b] nearest to p. Its point is nearest to within a few units
/// of rounding of the coordinates: the quotient's numerator is off by 2 ε |p - a| |b - a|.
double nearest_parameter(const Vector2<double>& p, const Vector2<double>& a,
                         const Vector2<double>& b) {
  const Vector2<double> d = b - a;
  const double square = dot(d, d);
  if (!(square > 0.0)) return 0.0;
  return std::clamp(dot(p - a, d) / square, 0.0, 1.0);
}

bool cross(const Vector2<double>& a, const Vector2<double>& b, const Vector2<double>& c,
           const Vector2<double>& d) {
  return orientation(a, b, c) * orientation(a, b, d) < 0 &&
         orientation(c, d, a) * orientation(c, d, b) < 0;
}

/// Correct to nearest_pair_error times the largest coordinate. Segments that only touch do so at
/// an end of one of them.
NearestPair nearest_pair(const Vector2<double>& a, const Vector2<double>& b, const Edge& edge) {
  NearestPair best{std::numeric_limits<double>::infinity(), 0.0, {}};
  const auto consider = [&](double t, const Vector2<double>& on_first,
                            const Vector2<double>& on_second) {
    const Vector2<double> d = on_second - on_first;
    const double distance = std::hypot(d.x, d.y);
    if (distance < best.distance) best = {distance, t, on_second};
  };
  const auto point = [](const Vector2<double>& p, const Vector2<double>& q, double t) {
    return p + t * (q - p);
  };
  consider(0.0, a, point(edge.a, edge.b, nearest_parameter(a, edge.a, edge.b)));
  consider(1.0, b, point(edge.a, edge.b, nearest_parameter(b, edge.a, edge.b)));
  for (const auto& end : {edge.a, edge.b}) {
    const double t = nearest_parameter(end, a, b);
    consider(t, point(a, b, t), end);
  }
  if (cross(a, b, edge.a, edge.b)) {
    // Where they cross: by the distances of a and b from the edge's line.
    const Vector2<double> d = edge.b - edge.a, normal{-d.y, d.x};
    const double at_a = std::abs(dot(normal, a - edge.a));
    const double at_b = std::abs(dot(normal, b - edge.a));
    const double t = at_a + at_b > 0.0 ? at_a / (at_a + at_b) : 0.5;
    best = {0.0, t, point(a, b, t)};
  }
  return best;
}
/// Differences, products, a quotient, a point on a segment and its distance: fewer than 32
/// roundings, none of a number above four times the largest coordinate.
constexpr double nearest_pair_error = 128.0;

/// A part of one segment of the path.
struct Part {
  std::vector<Vector2<double>> points;
  double error = 0.0;  // of every coordinate
  double xi_begin = 0.0, xi_end = 0.0;
  double deviation = 0.0;    // from the chord
  std::size_t children = 0;  // where its halves are, once they were asked for
};

/// How far the part may be from its chord, at the same parameter; in doubles.
double deviation(const std::vector<Vector2<double>>& points) {
  const double degree = static_cast<double>(points.size() - 1);
  const Vector2<double>&a = points.front(), &b = points.back();
  double worst = 0.0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double t = static_cast<double>(i) / degree;
    const Vector2<double> d = points[i] - (a + t * (b - a));
    worst = std::max(worst, std::hypot(d.x, d.y));
  }
  return worst;
}

/// The parts of a path, halved where that is asked for.
class Parts {
 public:
  /// unit: ε times the largest coordinate.
  Parts(std::span<const ControlPolygon> path, double unit) : unit_(unit) {
    for (const ControlPolygon& polygon : path) {
      parts_.push_back({{polygon.points.begin(), polygon.points.end()},
                        polygon.error,
                        polygon.xi_begin,
                        polygon.xi_end,
                        0.0,
                        0});
      parts_.back().deviation = deviation(parts_.back().points);
    }
  }
  const Part& operator[](std::size_t i) const { return parts_[i]; }
  /// The first of two halves, the other is next to it.
  std::size_t halves(std::size_t i) {
    if (parts_[i].children == 0) {
      Part left = parts_[i], right = parts_[i];
      const std::size_t size = left.points.size();
      for (std::size_t r = 1; r < size; ++r) {
        for (std::size_t k = 0; k + r < size; ++k) {
          right.points[k] = 0.5 * right.points[k] + 0.5 * right.points[k + 1];
        }
        left.points[r] = right.points[0];
      }
      // One more rounding a level of de Casteljau.
      left.error = right.error = left.error + static_cast<double>(size) * unit_;
      left.xi_end = right.xi_begin = 0.5 * (left.xi_begin + left.xi_end);
      left.deviation = deviation(left.points);
      right.deviation = deviation(right.points);
      parts_[i].children = parts_.size();
      parts_.push_back(std::move(left));
      parts_.push_back(std::move(right));
    }
    return parts_[i].children;
  }

 private:
  std::vector<Part> parts_;
  double unit_;
};

/// The bounds of the distance between a part and an edge.
struct Candidate {
  std::size_t part = 0;
  std::uint32_t edge = 0;
  double lower = 0.0, upper = 0.0, xi = 0.0;
  Vector2<double> nearest{};

  friend bool operator<(const Candidate& a, const Candidate& b) { return a.lower > b.lower; }
};

Candidate candidate(const Parts& parts, std::size_t i, std::uint32_t edge, const Edge& ends,
                    double unit) {
  const Part& part = parts[i];
  const NearestPair pair = nearest_pair(part.points.front(), part.points.back(), ends);
  // √2 < 3/2 for the coordinates' errors; the deviation carries as many and its own rounding.
  const double slack = (part.deviation + 3.0 * part.error) + nearest_pair_error * unit;
  const double xi = part.xi_begin + pair.parameter * (part.xi_end - part.xi_begin);
  return {i, edge, std::max(0.0, pair.distance - slack), pair.distance + slack, xi, pair.on_second};
}

}  // namespace

struct ClearanceIndex::Edges {
  World world;
  std::vector<Edge> edges;  // in the order of the tree
  BoxTree tree;
  double largest = 0.0;  // coordinate
};

ClearanceIndex::ClearanceIndex(World world) {
  auto made = std::make_shared<Edges>();
  std::vector<Edge> edges;
  const auto add = [&](const Ring& ring, std::uint32_t obstacle) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.push_back({ring[i], ring[next_vertex(i, ring.size())], obstacle});
      made->largest = std::max(made->largest, largest_component(ring[i]));
    }
  };
  for (std::uint32_t k = 0; k < world.obstacles().size(); ++k) {
    add(world.obstacles()[k].outer, k);
    for (const Ring& hole : world.obstacles()[k].holes) add(hole, k);
  }
  if (world.bounds()) add(*world.bounds(), WorldVertex::bounds);
  std::vector<Box> boxes;
  for (const Edge& edge : edges) boxes.push_back(box_of(edge));
  std::vector<Box> ordered;
  for (const std::uint32_t i : planning_detail::hilbert_order(boxes)) {
    made->edges.push_back(edges[i]);
    ordered.push_back(boxes[i]);
  }
  made->tree = BoxTree(std::move(ordered));
  made->world = std::move(world);
  edges_ = std::move(made);
}

const World& ClearanceIndex::world() const { return edges_->world; }

Enclosure PathClearance::least() const {
  Enclosure result(reach, std::numeric_limits<double>::infinity());
  for (const ObstacleClearance& c : near) {
    result = {std::min(result.lower(), c.distance.lower()),
              std::min(result.upper(), c.distance.upper())};
  }
  return result;
}

namespace {

/// The obstacles (and the bounds, where it is outside them) that a point is in: an odd number of
/// their edges crosses the ray from it to the right. Exact.
std::vector<std::uint32_t> around(const BoxTree& tree, const std::vector<Edge>& edges,
                                  bool has_bounds, const Vector2<double>& p) {
  std::vector<std::uint32_t> crossed;
  tree.any([&](const Box& box) { return box.y0 <= p.y && p.y <= box.y1 && p.x <= box.x1; },
           [&](std::uint32_t i) {
             const Edge& e = edges[i];
             const bool up = e.a.y <= p.y && p.y < e.b.y, down = e.b.y <= p.y && p.y < e.a.y;
             if ((up && orientation(e.a, e.b, p) > 0) || (down && orientation(e.a, e.b, p) < 0)) {
               crossed.push_back(e.obstacle);
             }
             return false;
           });
  std::sort(crossed.begin(), crossed.end());
  std::vector<std::uint32_t> inside;
  bool within_bounds = false;
  for (std::size_t i = 0; i < crossed.size();) {
    std::size_t j = i;
    while (j < crossed.size() && crossed[j] == crossed[i]) ++j;
    if ((j - i) % 2 == 1) {
      if (crossed[i] == WorldVertex::bounds) {
        within_bounds = true;
      } else {
        inside.push_back(crossed[i]);
      }
    }
    i = j;
  }
  if (has_bounds && !within_bounds) inside.push_back(WorldVertex::bounds);
  return inside;
}

}  // namespace

Result<PathClearance> ClearanceIndex::clearance_of(std::span<const ControlPolygon> path,
                                                   double reach) const {
  if (!std::isfinite(reach) || reach < 0.0) {
    return Fault{
        FaultCode::outside_domain,
        "the reach of a clearance must be a number and not negative; got " + to_text(reach),
        std::nullopt,
        "reach",
        reach,
        0.0};
  }
  double largest = edges_->largest;
  for (const ControlPolygon& polygon : path) {
    for (const auto& p : polygon.points) largest = std::max(largest, largest_component(p));
  }
  if (!(largest <= largest_world_coordinate)) {
    return Fault{FaultCode::outside_domain,
                 "the path reaches coordinates of " + to_text(largest) + "; at most " +
                     to_text(largest_world_coordinate) + " is possible",
                 std::nullopt,
                 "coordinate",
                 largest,
                 largest_world_coordinate};
  }
  const double unit = epsilon<double>() * largest;
  const double width = 0.5 * clearance_width * largest;

  /// All pairs of a segment and an edge that may be within reach, by obstacle.
  struct Pair {
    std::uint32_t obstacle, edge;
    std::uint32_t segment;
  };
  std::vector<Pair> pairs;
  // What is not found nearer than this is not nearer than reach.
  const double margin = reach * (1.0 + 4.0 * epsilon<double>()) + nearest_pair_error * unit + width;
  for (std::uint32_t k = 0; k < path.size(); ++k) {
    Box box;
    for (const auto& p : path[k].points) box.include(p);
    const double grow = margin + path[k].error;
    const Box wide{box.x0 - grow, box.y0 - grow, box.x1 + grow, box.y1 + grow};
    edges_->tree.any([&](const Box& b) { return b.meets(wide); },
                     [&](std::uint32_t i) {
                       pairs.push_back({edges_->edges[i].obstacle, i, k});
                       return false;
                     });
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.obstacle < b.obstacle; });

  PathClearance result;
  result.reach = reach;
  if (path.empty()) return result;
  const Vector2<double>& start = path.front().points.front();
  const std::vector<std::uint32_t> inside =
      around(edges_->tree, edges_->edges, world().bounds().has_value(), start);
  for (const std::uint32_t obstacle : inside) {
    result.near.push_back({obstacle, Enclosure(0.0), path.front().xi_begin, start});
  }
  Parts parts(path, unit);
  for (std::size_t i = 0; i < pairs.size();) {
    const std::uint32_t obstacle = pairs[i].obstacle;
    std::priority_queue<Candidate> queue;
    Candidate best;
    best.upper = margin;
    bool found = false;
    const auto add = [&](std::size_t part, std::uint32_t edge) {
      const Candidate c = candidate(parts, part, edge, edges_->edges[edge], unit);
      if (c.lower > best.upper) return;
      if (c.upper < best.upper) {
        best = c;
        found = true;
      }
      queue.push(c);
    };
    for (; i < pairs.size() && pairs[i].obstacle == obstacle; ++i) {
      add(pairs[i].segment, pairs[i].edge);
    }
    if (std::find(inside.begin(), inside.end(), obstacle) != inside.end()) continue;
    double lower = best.upper;
    while (!queue.empty()) {
      const Candidate next = queue.top();
      queue.pop();
      lower = std::min(next.lower, best.upper);
      // Near enough; or so short that rounding tells no more.
      if (next.lower > best.upper - width || parts[next.part].error > 0.25 * width) break;
      const std::size_t half = parts.halves(next.part);
      add(half, next.edge);
      add(half + 1, next.edge);
    }
    if (found) {
      result.near.push_back({obstacle, {lower, best.upper}, best.xi, best.nearest});
    }
  }
  std::sort(result.near.begin(), result.near.end(),
            [](const auto& a, const auto& b) { return a.obstacle < b.obstacle; });
  return result;
}

}  // namespace hodograph
