// SPDX-License-Identifier: MIT
// Contacts between the edges of a polygon's rings.
#include "ring_contacts.hpp"

#include <algorithm>
#include <utility>

#include "box_tree.hpp"
#include "predicates.hpp"

namespace hodograph::planning_detail {
namespace {

/// A vertex of the polygon with its neighbours along the ring: the pass of a ring through a point.
struct Pass {
  std::uint32_t ring = 0;
  std::uint32_t vertex = 0;  // in the World's ring, of the bounds, too
  Point before{}, at{}, after{};

  /// The solid sector, and the free one.
  Sector left() const { return {after, before}; }
  Sector right() const { return {before, after}; }
};

class Contacts {
 public:
  Contacts(const std::vector<const Ring*>& rings, const World& world, std::uint32_t obstacle,
           std::vector<RingContact>& found)
      : rings_(rings), world_(world), obstacle_(obstacle), found_(found) {}

  std::optional<Fault> run() {
    if (auto fault = collect()) return fault;
    const BoxTree tree = [&] {
      std::vector<Box> boxes(edges_.size());
      for (std::size_t i = 0; i < edges_.size(); ++i) {
        boxes[i].include(edges_[i].at);
        boxes[i].include(edges_[i].after);
      }
      const auto order = hilbert_order(boxes);
      std::vector<Box> sorted_boxes;
      std::vector<Pass> sorted_edges;
      for (const std::uint32_t i : order) {
        sorted_boxes.push_back(boxes[i]);
        sorted_edges.push_back(edges_[i]);
      }
      edges_ = std::move(sorted_edges);
      return BoxTree(std::move(sorted_boxes));
    }();
    for (std::uint32_t r = 0; r < rings_.size(); ++r) group_.push_back(r);
    std::optional<Fault> fault;
    for (std::uint32_t i = 0; i < edges_.size() && !fault; ++i) {
      const Box& box = tree.box(i);
      tree.any([&](const Box& b) { return b.meets(box); },
               [&](std::uint32_t j) {
                 if (j > i) fault = contact(edges_[i], edges_[j]);
                 return fault.has_value();
               });
    }
    if (!fault && rings_.size() > 1) fault = misplaced_hole(tree);
    if (!fault && rings_.size() > 1 && area_sign(rings_) <= 0) {
      return refused({}, " is filled by its holes, which leaves walls without thickness");
    }
    return fault;
  }

 private:
  std::optional<Fault> collect() {
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      const Ring& ring = *rings_[r];
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const bool turned = obstacle_ == WorldVertex::bounds && i != 0;
        const Pass pass{
            static_cast<std::uint32_t>(r), static_cast<std::uint32_t>(turned ? ring.size() - i : i),
            ring[previous_vertex(i, ring.size())], ring[i], ring[next_vertex(i, ring.size())]};
        if (orientation(pass.before, pass.at, pass.after) == 0 &&
            same_side(pass.at, pass.before, pass.after)) {
          return refused(pass, " turns straight back at " + vertex_text(pass));
        }
        edges_.push_back(pass);
      }
    }
    return std::nullopt;
  }

  /// `edge` stands for the edge from its `at` to its `after`.
  std::optional<Fault> contact(const Pass& a, const Pass& b) {
    const int a0 = orientation(b.at, b.after, a.at), a1 = orientation(b.at, b.after, a.after);
    if (a0 * a1 > 0) return std::nullopt;
    const int b0 = orientation(a.at, a.after, b.at), b1 = orientation(a.at, a.after, b.after);
    if (b0 * b1 > 0) return std::nullopt;
    if (a0 * a1 < 0 && b0 * b1 < 0) return crossing(a, b);
    // Each vertex answers for itself: the contacts at `at`, here; those at `after`, as the `at` of
    // the next edge, except where that lies inside the other edge.
    if (a0 == 0 && on_segment(a.at, b.at, b.after)) {
      if (auto fault = meeting(a, b, a.at)) return fault;
    }
    if (b0 == 0 && on_segment(b.at, a.at, a.after)) {
      if (auto fault = meeting(b, a, b.at)) return fault;
    }
    return std::nullopt;
  }

  /// The pass through the vertex `vertex.at` against the edge's pass through the same point.
  std::optional<Fault> meeting(const Pass& vertex, const Pass& edge, const Point& x) {
    if (x == edge.after) return std::nullopt;  // seen again with the next edge
    Pass other = edge;
    if (x != edge.at) {
      other.before = edge.at;  // straight through the inside of the edge
      other.at = x;
    }
    group_[group_of(vertex.ring)] = group_of(edge.ring);
    found_.push_back(
        {{obstacle_, vertex.ring, vertex.vertex}, {obstacle_, edge.ring, edge.vertex}});
    if (disjoint(x, vertex.left(), other.left())) return std::nullopt;
    if (!disjoint(x, vertex.right(), other.right())) return crossing(vertex, edge);
    const auto same_direction = [&](const Point& p, const Point& q) {
      return orientation(x, p, q) == 0 && same_side(x, p, q);
    };
    if (same_direction(vertex.before, other.after) || same_direction(vertex.after, other.before)) {
      return refused(vertex, " runs along " + text(edge) + " at " + vertex_text(vertex) +
                                 ", which leaves a wall without thickness");
    }
    return std::nullopt;
  }

  std::uint32_t group_of(std::uint32_t ring) {
    while (group_[ring] != ring) ring = group_[ring] = group_[group_[ring]];
    return ring;
  }

  /// Holes that do not touch the outer ring, even through others, lie inside it and in no hole.
  std::optional<Fault> misplaced_hole(const BoxTree& tree) {
    for (std::uint32_t r = 1; r < rings_.size(); ++r) {
      if (group_of(r) == group_of(0)) continue;
      const Point p = (*rings_[r])[0];
      int around = 0;
      bool in_outer = false;
      tree.any([&](const Box& b) { return b.y0 <= p.y && p.y <= b.y1 && p.x <= b.x1; },
               [&](std::uint32_t i) {
                 const Pass& e = edges_[i];
                 if (group_of(e.ring) == group_of(r)) return false;
                 const bool upwards = e.at.y <= p.y;
                 if (upwards == (e.after.y <= p.y)) return false;
                 const int side = upwards ? 1 : -1;
                 if (orientation(e.at, e.after, p) != side) return false;
                 around += side;
                 if (e.ring == 0) in_outer = !in_outer;
                 return false;
               });
      if (around == 1) continue;
      const Pass pass{r, 0, p, p, p};
      return refused(pass, in_outer ? " lies inside another hole" : " lies outside the outer ring");
    }
    return std::nullopt;
  }

  std::optional<Fault> crossing(const Pass& one, const Pass& other) const {
    const bool ordered = std::pair(one.ring, one.vertex) < std::pair(other.ring, other.vertex);
    const Pass &a = ordered ? one : other, &b = ordered ? other : one;
    const std::string where = " near (" + to_text(b.at.x) + ", " + to_text(b.at.y) + ")";
    if (a.ring == b.ring) {
      return refused(a, " crosses itself between the edges from " + vertex_text(a) + " and from " +
                            vertex_text(b) + where);
    }
    return refused(a, " crosses " + text(b) + " between the edges from " + vertex_text(a) +
                          " and from " + vertex_text(b) + where);
  }

  /// Point numbers are those of the data.
  std::string vertex_text(const Pass& pass) const {
    return "point " + std::to_string(world_.source_vertex({obstacle_, pass.ring, pass.vertex}));
  }
  std::string text(const Pass& pass) const {
    return obstacle_ == WorldVertex::bounds ? "it" : ring_text(obstacle_, pass.ring).substr(2);
  }
  Fault refused(const Pass& pass, const std::string& what) const {
    Fault fault{FaultCode::outside_domain,
                world_.name_of(obstacle_) + ring_text(obstacle_, pass.ring) + what, std::nullopt,
                "ring"};
    if (obstacle_ != WorldVertex::bounds) fault.index = obstacle_;
    return fault;
  }

  const std::vector<const Ring*>& rings_;
  const World& world_;
  std::uint32_t obstacle_;
  std::vector<RingContact>& found_;
  std::vector<Pass> edges_;
  std::vector<std::uint32_t> group_;  // of rings that touch: a forest whose roots name the groups
};

}  // namespace

std::string obstacle_text(std::uint32_t obstacle, const std::string& name) {
  if (obstacle == WorldVertex::bounds) return "the bounds";
  std::string text = "obstacle " + std::to_string(obstacle);
  if (name.empty()) return text;
  constexpr std::size_t longest = 40;
  std::string shown = name.substr(0, longest);
  // A character of UTF-8 is not cut in the middle.
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; };
  if (name.size() > longest && continues(name[longest])) {
    while (!shown.empty() && continues(shown.back())) shown.pop_back();
    if (!shown.empty()) shown.pop_back();
  }
  std::replace_if(
      shown.begin(), shown.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == 0x7f; }, '?');
  return text + " ('" + shown + (name.size() > longest ? "…" : "") + "')";
}

std::string ring_text(std::uint32_t obstacle, std::uint32_t ring) {
  if (obstacle == WorldVertex::bounds) return "";
  return ring == 0 ? ", outer ring" : ", hole " + std::to_string(ring);
}

std::optional<Fault> ring_conflict(const std::vector<const Ring*>& rings, const World& world,
                                   std::uint32_t obstacle, std::vector<RingContact>& contacts) {
  return Contacts(rings, world, obstacle, contacts).run();
}

}  // namespace hodograph::planning_detail
