// SPDX-License-Identifier: MIT
// Grows obstacles into pieces and indexes them.
#include "mitred_index.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace hodograph::planning_detail {
namespace {

/// Tips are kept below this, so that differences stay in the domain of the predicates.
constexpr double largest_tip = 0x1p508;

/// Of long double: sums and products keep eleven digits more where the machine has it.
struct Direction {
  long double x = 0.0L, y = 0.0L, length = 0.0L;
};

Direction direction(const Point& from, const Point& to) {
  const long double x = static_cast<long double>(to.x) - from.x;
  const long double y = static_cast<long double>(to.y) - from.y;
  const long double length = std::hypot(x, y);
  return {x / length, y / length, length};
}

/// x × y of a product of two numbers given as sums high + low, as such a sum.
struct Sum {
  double high = 0.0, low = 0.0;
};
Sum difference(double a, double b) {  // exact, barring underflow
  const double high = a - b;
  const double b_part = a - high, a_part = high + b_part;
  return {high, (a - a_part) + (b_part - b)};
}
Sum product(const Sum& a, const Sum& b) {  // to about 2^-104 of it
  const double high = a.high * b.high;
  return {high, std::fma(a.high, b.high, -high) + (a.high * b.low + a.low * b.high)};
}

/// (at - before) × (after - at), to a few units of 2^-100 of its terms.
long double turn_product(const Point& before, const Point& at, const Point& after) {
  const Sum ax = difference(at.x, before.x), ay = difference(at.y, before.y);
  const Sum bx = difference(after.x, at.x), by = difference(after.y, at.y);
  const Sum left = product(ax, by), right = product(ay, bx);
  const Sum high = difference(left.high, right.high);
  return static_cast<long double>(high.high) + (high.low + (left.low - right.low));
}

bool strictly_convex(const std::array<Point, 4>& c, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (orientation(c[i], c[(i + 1) % count], c[(i + 2) % count]) <= 0) return false;
  }
  return true;
}

Box box_of(const Blocker& blocker, const Point& p, const Point& q) {
  Box box;
  if (blocker.is_first || blocker.corners == 0) {
    box.include(p);
    box.include(q);
  }
  for (std::size_t i = 0; i < blocker.corners; ++i) box.include(blocker.corner[i]);
  return box;
}

/// True where a piece, seen as a point set, has p strictly inside.
bool inside_piece(const Blocker& b, const Point& p) {
  if (b.corners == 0) return false;
  for (std::size_t i = 0; i < b.corners; ++i) {
    if (orientation(b.corner[i], b.corner[i + 1 == b.corners ? 0 : i + 1], p) <= 0) return false;
  }
  return true;
}

bool hidden_in(const std::vector<Blocker>& blockers, const BoxTree& tree, const Point& p) {
  return tree.any([&](const Box& box) { return box.contains(p); },
                  [&](std::uint32_t i) { return inside_piece(blockers[i], p); });
}

template <class Item>
BoxTree sort_into_tree(std::vector<Item>& items, const std::vector<Box>& boxes) {
  const std::vector<std::uint32_t> order = hilbert_order(boxes);
  std::vector<Item> sorted;
  std::vector<Box> sorted_boxes;
  sorted.reserve(items.size());
  sorted_boxes.reserve(items.size());
  for (const std::uint32_t i : order) {
    sorted.push_back(items[i]);
    sorted_boxes.push_back(boxes[i]);
  }
  items = std::move(sorted);
  return BoxTree(std::move(sorted_boxes));
}

}  // namespace

double Pieces::reach() const {
  double reach = 0.0;
  if (blocker_tree.empty()) return reach;
  const Box& all = blocker_tree.box(blocker_tree.root());
  for (const double x : {all.x0, all.x1, all.y0, all.y1}) reach = std::max(reach, std::fabs(x));
  return reach;
}

/// Makes the pieces and corners of some edges and vertices, for given kinds and offsets.
class MitredIndex::Builder {
 public:
  explicit Builder(const MitredIndex& index) : index_(index) {}

  std::map<std::uint32_t, double> ring_offset;                  // where it is not the ring's own
  std::map<std::uint32_t, std::vector<VertexKind>> ring_kinds;  // of those rings
  std::map<std::uint32_t, double> corner_offset;
  std::vector<Blocker> blockers;
  std::vector<Corner> corners;
  std::vector<std::pair<Point, Point>> outer_ends;  // of the edges added
  std::optional<Fault> fault;

  void add_edge(std::uint32_t edge) {
    const Point p = index_.points_[edge], q = index_.points_[index_.next(edge)];
    const Point a = outer_begin(edge), b = outer_end(edge);
    bool first = true;
    const auto add = [&](std::array<Point, 4> corner, std::uint8_t count) {
      blockers.push_back({corner, edge, count, first});
      first = false;
    };
    outer_ends.emplace_back(a, b);
    if (a == p && b == q) return add({}, 0);
    const bool is_triangle = a == p || b == q;
    const std::array<Point, 4> piece = a == p   ? std::array{p, b, q, Point{}}
                                       : b == q ? std::array{a, q, p, Point{}}
                                                : std::array{a, b, q, p};
    const std::uint8_t count = is_triangle ? 3 : 4;
    if (strictly_convex(piece, count)) {
      add(piece, count);
    } else {  // strips that rounding or tapering folded: as triangles, either way round
      add_triangle(a, b, q, add);
      add_triangle(a, q, p, add);
      if (first) add({}, 0);
    }
    // Where the strip narrows to nothing at one end, the edge itself guards that end.
    if (is_triangle) add({}, 0);
  }

  void add_corners(std::uint32_t v) {
    const std::uint32_t before = index_.previous(v);
    const Point p = index_.points_[v];
    const auto add = [&](const Corner& corner) {
      if (orientation(corner.before, corner.at, corner.after) > 0) corners.push_back(corner);
    };
    if (offset_at(v) == 0.0) {
      return add({p, outer_begin(index_.solid_before(v)), outer_end(v), v});
    }
    switch (kind(v)) {
      case VertexKind::tip:
        return add({outer_begin(v), outer_begin(before), outer_end(v), v});
      case VertexKind::square_end:  // covered by the other strip, but for rounding
        add({outer_end(before), outer_begin(before), p, v});
        return add({outer_begin(v), p, outer_end(v), v});
      case VertexKind::inner_tip:
        return;
    }
  }

  Pieces finish(std::vector<Corner>& hidden) {
    Pieces pieces;
    std::vector<Box> boxes(blockers.size());
    for (std::size_t i = 0; i < blockers.size(); ++i) {
      const std::uint32_t edge = blockers[i].edge;
      boxes[i] = box_of(blockers[i], index_.points_[edge], index_.points_[index_.next(edge)]);
    }
    pieces.blocker_tree = sort_into_tree(blockers, boxes);
    pieces.blockers = std::move(blockers);
    boxes.clear();
    for (const Corner& corner : corners) {
      if (hidden_in(pieces.blockers, pieces.blocker_tree, corner.at)) {
        hidden.push_back(corner);
      } else {
        pieces.corners.push_back(corner);
        Box box;
        box.include(corner.at);
        boxes.push_back(box);
      }
    }
    pieces.corner_tree = sort_into_tree(pieces.corners, boxes);
    return pieces;
  }

  Point outer_begin(std::uint32_t edge) { return outer(edge, edge); }
  Point outer_end(std::uint32_t edge) { return outer(edge, index_.next(edge)); }

 private:
  template <class Add>
  static void add_triangle(const Point& a, const Point& b, const Point& c, const Add& add) {
    const int turn = orientation(a, b, c);
    if (turn > 0) add({a, b, c, Point{}}, 3);
    if (turn < 0) add({a, c, b, Point{}}, 3);
  }

  VertexKind kind(std::uint32_t v) const {
    if (ring_kinds.empty()) return index_.kinds_[v];
    const auto found = ring_kinds.find(index_.ring_of_[v]);
    return found == ring_kinds.end() ? index_.kinds_[v]
                                     : found->second[v - index_.ring_of(v).begin];
  }
  double ring_distance(std::uint32_t v) const {
    if (ring_offset.empty()) return index_.ring_of(v).offset;
    const auto found = ring_offset.find(index_.ring_of_[v]);
    return found == ring_offset.end() ? index_.ring_of(v).offset : found->second;
  }

  double offset_at(std::uint32_t v) const {
    if (!corner_offset.empty() && kind(v) == VertexKind::tip) {
      const auto found = corner_offset.find(v);
      if (found != corner_offset.end()) return found->second;
    }
    return ring_distance(v);
  }

  /// The outer end of the strip of an edge at its vertex v.
  Point outer(std::uint32_t edge, std::uint32_t v) {
    const double d = offset_at(v);
    const VertexKind what = kind(v);
    if (d == 0.0) return index_.points_[v];
    if (what != VertexKind::square_end) return checked(v, index_.meeting_point(v, d), d);
    const Direction u = direction(index_.points_[edge], index_.points_[index_.next(edge)]);
    return checked(v,
                   {static_cast<double>(index_.points_[v].x + d * u.y),
                    static_cast<double>(index_.points_[v].y - d * u.x)},
                   d);
  }

  Point checked(std::uint32_t v, const Point& tip, double d) {
    if (std::fabs(tip.x) <= largest_tip && std::fabs(tip.y) <= largest_tip) return tip;
    if (!fault) {
      const WorldVertex id = index_.identity(v);
      const std::string place = index_.world_.name_of(id.obstacle) + ", vertex " +
                                std::to_string(index_.world_.source_vertex(id));
      fault = Fault{FaultCode::outside_domain,
                    place + ": the mitre for the offset " + to_text(d) +
                        " leaves the range of coordinates; the solid is too sharp there",
                    std::nullopt, "offset", d};
      if (id.obstacle != WorldVertex::bounds) fault->index = id.obstacle;
    }
    return index_.points_[v];
  }

  const MitredIndex& index_;
};

Result<std::shared_ptr<const MitredIndex>> MitredIndex::create(World world, double offset,
                                                               double bounds_offset) {
  const std::shared_ptr<MitredIndex> index(new MitredIndex);
  index->world_ = std::move(world);
  index->offset_ = offset;
  index->bounds_offset_ = bounds_offset;
  if (auto fault = index->unusable_offset(offset, "offset")) return *fault;
  if (auto fault = index->unusable_offset(bounds_offset, "bounds offset")) return *fault;
  index->flatten();
  for (const RingSpan& ring : index->rings_) {
    const auto kinds = index->kinds_of(ring, ring.offset);
    index->kinds_.insert(index->kinds_.end(), kinds.begin(), kinds.end());
  }
  Builder builder(*index);
  const auto count = static_cast<std::uint32_t>(index->points_.size());
  builder.blockers.reserve(count);
  builder.corners.reserve(count);
  builder.outer_ends.reserve(count);
  for (std::uint32_t v = 0; v < count; ++v) {
    builder.add_edge(v);
    builder.add_corners(v);
  }
  if (builder.fault) return *builder.fault;
  index->outer_ends_ = std::move(builder.outer_ends);
  index->pieces_ = builder.finish(index->hidden_corners_);
  index->reach_ = index->pieces_.reach();
  return std::shared_ptr<const MitredIndex>(index);
}

std::optional<Fault> MitredIndex::unusable_offset(double offset, const char* quantity) const {
  double size = 0.0;
  if (world_.box()) {
    const PlanarBox& box = *world_.box();
    for (const double x : {box.lower.x, box.lower.y, box.upper.x, box.upper.y}) {
      size = std::max(size, std::fabs(x));
    }
  }
  const double least = least_offset_ratio * size;
  if (offset == 0.0 || (offset >= least && offset <= largest_world_coordinate)) {
    return std::nullopt;
  }
  Fault fault{std::isfinite(offset) ? FaultCode::outside_domain : FaultCode::not_finite,
              std::string("the ") + quantity + " is " + to_text(offset) + "; it is 0 or between " +
                  to_text(least) + " (2^-40 of the largest coordinate) and 2^500",
              std::nullopt, quantity, offset};
  fault.bound = offset < least ? least : largest_world_coordinate;
  return fault;
}

void MitredIndex::flatten() {
  // What touches which edge, by the edge.
  std::vector<RingContact> contacts = world_.contacts();
  std::erase_if(contacts, [&](const RingContact& c) {
    return world_.point(c.vertex) == world_.point(c.edge);
  });
  std::sort(contacts.begin(), contacts.end(), [](const RingContact& a, const RingContact& b) {
    return std::pair(a.edge, a.vertex) < std::pair(b.edge, b.vertex);
  });
  const auto add = [&](std::uint32_t obstacle, std::uint32_t number, const Ring& ring, double d) {
    const auto begin = static_cast<std::uint32_t>(points_.size());
    const auto size = static_cast<std::uint32_t>(ring.size());
    const auto world_begin = static_cast<std::uint32_t>(flat_.size());
    flat_.resize(world_begin + size);
    for (std::uint32_t i = 0; i < size; ++i) {
      // The bounds are solid outside: they run the other way round.
      const auto turned = [&](std::uint32_t k) {
        return obstacle == WorldVertex::bounds && k != 0 ? size - k : k;
      };
      const WorldVertex vertex{obstacle, number, turned(i)};
      flat_[world_begin + vertex.vertex] = static_cast<std::uint32_t>(points_.size());
      const Point from = ring[vertex.vertex];
      points_.push_back(from);
      identities_.push_back(vertex);
      auto touching = std::lower_bound(
          contacts.begin(), contacts.end(), vertex,
          [](const RingContact& c, const WorldVertex& edge) { return c.edge < edge; });
      std::vector<std::pair<Point, WorldVertex>> inside;
      for (; touching != contacts.end() && touching->edge == vertex; ++touching) {
        inside.emplace_back(world_.point(touching->vertex), touching->vertex);
      }
      std::sort(inside.begin(), inside.end(), [&](const auto& a, const auto& b) {
        const auto away = [&](const Point& p) {
          return std::max(std::fabs(p.x - from.x), std::fabs(p.y - from.y));
        };
        return std::pair(away(a.first), a.second) < std::pair(away(b.first), b.second);
      });
      for (const auto& [point, touching_vertex] : inside) {
        if (points_.back() == point) continue;
        points_.push_back(point);
        identities_.push_back(touching_vertex);
      }
    }
    const auto flat_size = static_cast<std::uint32_t>(points_.size()) - begin;
    ring_of_.insert(ring_of_.end(), flat_size, static_cast<std::uint32_t>(rings_.size()));
    rings_.push_back({obstacle, number, begin, flat_size, world_begin, size, d});
  };
  points_.reserve(world_.vertex_count());
  identities_.reserve(world_.vertex_count());
  ring_of_.reserve(world_.vertex_count());
  flat_.reserve(world_.vertex_count());
  for (std::uint32_t k = 0; k < world_.obstacles().size(); ++k) {
    const Polygon& polygon = world_.obstacles()[k];
    first_ring_of_obstacle_.push_back(static_cast<std::uint32_t>(rings_.size()));
    add(k, 0, polygon.outer, offset_);
    for (std::uint32_t h = 0; h < polygon.holes.size(); ++h) {
      add(k, h + 1, polygon.holes[h], offset_);
    }
  }
  first_ring_of_obstacle_.push_back(static_cast<std::uint32_t>(rings_.size()));
  if (world_.bounds()) add(WorldVertex::bounds, 0, *world_.bounds(), bounds_offset_);
  solid_before_.resize(points_.size());
  for (std::uint32_t v = 0; v < points_.size(); ++v) solid_before_[v] = previous(v);
  pair_touching_edges();
}

void MitredIndex::pair_touching_edges() {
  // All vertices here that stand at a point of contact, by obstacle and point.
  std::map<std::tuple<std::uint32_t, double, double>, std::vector<std::uint32_t>> meetings;
  for (const RingContact& contact : world_.contacts()) {
    const Point at = world_.point(contact.vertex);
    auto& vertices = meetings[{contact.vertex.obstacle, at.x, at.y}];
    vertices.push_back(*find(contact.vertex));
    std::uint32_t v = *find(contact.edge);
    while (points_[v] != at) v = next(v);
    vertices.push_back(v);
  }
  struct Ray {
    Point towards{};
    bool leaves = false;
    std::uint32_t vertex = 0;  // the one it leaves from, or comes from
  };
  for (auto& [place, vertices] : meetings) {
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const Point at = points_[vertices.front()];
    std::vector<Ray> rays;
    for (const std::uint32_t v : vertices) {
      rays.push_back({points_[next(v)], true, v});
      rays.push_back({points_[previous(v)], false, previous(v)});
    }
    const Point zero = rays.front().towards;
    std::sort(rays.begin(), rays.end(), [&](const Ray& a, const Ray& b) {
      const int order = compare_angles(at, zero, a.towards, b.towards);
      if (order != 0) return order < 0;
      // In one direction, solid ends before solid begins; the first ray begins.
      const bool both_at_zero = compare_angles(at, zero, a.towards, zero) == 0;
      return both_at_zero ? a.leaves && !b.leaves : !a.leaves && b.leaves;
    });
    // Anticlockwise from an edge that leaves, solid goes on to the next edge that comes in.
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (!rays[i].leaves) continue;
      std::size_t k = i;
      do {
        k = k + 1 == rays.size() ? 0 : k + 1;
      } while (rays[k].leaves && k != i);
      solid_before_[rays[i].vertex] = rays[k].vertex;
    }
  }
}

std::optional<std::uint32_t> MitredIndex::find(const WorldVertex& vertex) const {
  std::size_t number = 0;
  if (vertex.obstacle == WorldVertex::bounds) {
    if (!world_.bounds() || vertex.ring != 0) return std::nullopt;
    number = rings_.size() - 1;
  } else {
    if (vertex.obstacle >= world_.obstacles().size()) return std::nullopt;
    number = first_ring_of_obstacle_[vertex.obstacle] + std::size_t{vertex.ring};
    if (number >= first_ring_of_obstacle_[vertex.obstacle + 1]) return std::nullopt;
  }
  const RingSpan& ring = rings_[number];
  if (vertex.vertex >= ring.world_size) return std::nullopt;
  return flat_[ring.world_begin + vertex.vertex];
}

std::vector<VertexKind> MitredIndex::kinds_of(const RingSpan& ring, double d) const {
  // Where the solid does not stick out, the strips overlap by a triangle on either side of the line
  // to their meeting point. It may be cut off where it lies in the other strip, whose far end may
  // be cut, too: where both edges are as long as what is cut from both ends.
  std::vector<VertexKind> kinds(ring.size, VertexKind::inner_tip);
  std::vector<long double> need(ring.size, 0.0L), length(ring.size);
  for (std::uint32_t i = 0; i < ring.size; ++i) {
    const Point& at = points_[ring.begin + i];
    const Point& before = points_[ring.begin + (i == 0 ? ring.size : i) - 1];
    const Point& after = points_[ring.begin + (i + 1 == ring.size ? 0 : i + 1)];
    const Direction u = direction(before, at), w = direction(at, after);
    length[i] = w.length;
    const int turn = orientation(before, at, after);
    if (turn > 0) kinds[i] = VertexKind::tip;
    if (turn < 0) {
      const long double sine = std::fabs(u.x * w.y - u.y * w.x), cosine = u.x * w.x + u.y * w.y;
      // Opposite directions give an infinite need, which no edge meets.
      need[i] = d * std::max(sine, cosine > -1.0L ? sine / (1.0L + cosine)
                                                  : std::numeric_limits<long double>::infinity());
    }
  }
  for (std::uint32_t i = 0; i < ring.size && d > 0.0; ++i) {
    const std::uint32_t k = i + 1 == ring.size ? 0 : i + 1;
    if (need[i] + need[k] <= length[i]) continue;
    if (need[i] > 0.0L) kinds[i] = VertexKind::square_end;
    if (need[k] > 0.0L) kinds[k] = VertexKind::square_end;
  }
  return kinds;
}

Point MitredIndex::meeting_point(std::uint32_t v, double d) const {
  // With unit directions u, w of the edges and normals n, m to their right, the point v + t has
  // n·t = m·t = d: t = d (n + m)/(1 + u·w), or, for sharp turns, t = d (u - w)/(u × w).
  const Point &before = points_[previous(v)], &at = points_[v], &after = points_[next(v)];
  const Direction u = direction(before, at), w = direction(at, after);
  const long double cosine = u.x * w.x + u.y * w.y;
  long double x = 0.0L, y = 0.0L;
  if (cosine >= -0.5L) {
    x = (u.y + w.y) / (1.0L + cosine);
    y = -(u.x + w.x) / (1.0L + cosine);
  } else {
    const long double sine = turn_product(before, at, after) / (u.length * w.length);
    x = (u.x - w.x) / sine;
    y = (u.y - w.y) / sine;
  }
  return {static_cast<double>(at.x + d * x), static_cast<double>(at.y + d * y)};
}

Result<Patch> MitredIndex::patch(std::span<const ObstacleOffset> obstacles,
                                 std::span<const CornerOffset> corners) const {
  Builder builder(*this);
  Patch patch;
  for (const ObstacleOffset& change : obstacles) {
    if (auto fault = unusable_offset(change.offset, "obstacle offset")) return *fault;
    const auto first = find({change.obstacle, 0, 0});
    if (!first) {
      return Fault{FaultCode::outside_domain,
                   "an offset is given for obstacle " + std::to_string(change.obstacle) +
                       "; the world has " + std::to_string(world_.obstacles().size()),
                   change.obstacle, "obstacle offset"};
    }
    for (std::uint32_t r = ring_of_[*first];
         r < rings_.size() && rings_[r].obstacle == change.obstacle; ++r) {
      builder.ring_offset[r] = change.offset;
      builder.ring_kinds[r] = kinds_of(rings_[r], change.offset);
      for (std::uint32_t i = 0; i < rings_[r].size; ++i) {
        patch.replaced_edges.push_back(rings_[r].begin + i);
        patch.replaced_vertices.push_back(rings_[r].begin + i);
      }
    }
  }
  for (const CornerOffset& change : corners) {
    if (auto fault = unusable_offset(change.offset, "corner offset")) return *fault;
    const auto v = find(change.vertex);
    if (!v) {
      return Fault{FaultCode::outside_domain,
                   "an offset is given for vertex " + std::to_string(change.vertex.vertex) +
                       " of ring " + std::to_string(change.vertex.ring) + " of obstacle " +
                       std::to_string(change.vertex.obstacle) + ", which does not exist",
                   std::nullopt, "corner offset"};
    }
    builder.corner_offset[*v] = change.offset;
    for (const std::uint32_t edge : {previous(*v), *v}) patch.replaced_edges.push_back(edge);
    for (const std::uint32_t near : {previous(*v), *v, next(*v)}) {
      patch.replaced_vertices.push_back(near);
    }
  }
  for (auto* list : {&patch.replaced_edges, &patch.replaced_vertices}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  for (const std::uint32_t edge : patch.replaced_edges) builder.add_edge(edge);
  for (const std::uint32_t v : patch.replaced_vertices) builder.add_corners(v);
  if (builder.fault) return *builder.fault;
  // What was hidden may have come free.
  Box changed;
  for (const std::uint32_t edge : patch.replaced_edges) {
    for (const Point& p :
         {points_[edge], points_[next(edge)], outer_begin(edge), outer_end(edge)}) {
      changed.include(p);
    }
  }
  for (const Corner& corner : hidden_corners_) {
    if (changed.contains(corner.at) && !patch.replaces_vertex(corner.vertex)) {
      builder.corners.push_back(corner);
    }
  }
  std::vector<Corner> hidden;
  patch.extra = builder.finish(hidden);
  patch.reach = patch.extra.reach();
  return patch;
}

}  // namespace hodograph::planning_detail
