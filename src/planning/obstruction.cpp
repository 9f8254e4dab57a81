// SPDX-License-Identifier: MIT
// Is a segment free, and where does a point stand? Exact on the pieces of a mitred world.
#include <cmath>
#include <utility>

#include "mitred_index.hpp"

namespace hodograph::planning_detail {
namespace {

/// Rounding of a few products and sums of coordinates is below this fraction of their sizes.
constexpr double box_margin = 0x1p-48;

/// Which boxes a segment may meet: a filter, never wrong about a box it leaves out.
class BoxFilter {
 public:
  BoxFilter(const Point& a, const Point& b, double reach) : a_(a), normal_{a.y - b.y, b.x - a.x} {
    box_.include(a);
    box_.include(b);
    const double size = std::max({reach, std::fabs(a.x), std::fabs(a.y)});
    margin_ = box_margin * size * (std::fabs(normal_.x) + std::fabs(normal_.y));
  }
  bool operator()(const Box& box) const {
    if (!box.meets(box_)) return false;
    const double x = 0.5 * (box.x0 + box.x1) - a_.x, y = 0.5 * (box.y0 + box.y1) - a_.y;
    const double half = std::fabs(normal_.x) * (0.5 * (box.x1 - box.x0)) +
                        std::fabs(normal_.y) * (0.5 * (box.y1 - box.y0));
    return std::fabs(normal_.x * x + normal_.y * y) <= half + margin_;
  }

 private:
  Point a_, normal_;
  Box box_;
  double margin_ = 0.0;
};

/// Stretches of a segment, by the coordinate that tells its points apart.
class Stretches {
 public:
  Stretches(const Point& a, const Point& b) : by_x_(a.x != b.x) {
    low_ = std::min(of(a), of(b));
    high_ = std::max(of(a), of(b));
  }
  void add(bool on_left, const Point& p, const Point& q) {
    const double low = std::max(low_, std::min(of(p), of(q)));
    const double high = std::min(high_, std::max(of(p), of(q)));
    if (low < high) (on_left ? left_ : right_).emplace_back(low, high);
  }
  /// True where solid on the left and solid on the right share a stretch.
  bool closed() const {
    for (const auto& [low, high] : left_) {
      for (const auto& [begin, end] : right_) {
        if (std::max(low, begin) < std::min(high, end)) return true;
      }
    }
    return false;
  }

 private:
  double of(const Point& p) const { return by_x_ ? p.x : p.y; }
  bool by_x_;
  double low_ = 0.0, high_ = 0.0;
  std::vector<std::pair<double, double>> left_, right_;
};

/// One segment from a to b (a ≠ b) against pieces.
class Probe {
 public:
  Probe(const MitredIndex& index, const Point& a, const Point& b)
      : index_(index), a_(a), b_(b), stretches_(a, b) {}

  bool stopped_by(const Blocker& blocker) {
    return blocker.corners == 0 ? crosses_edge(blocker.edge) : crosses_piece(blocker);
  }
  bool closed() const { return stretches_.closed(); }

 private:
  /// Two convex sets are apart exactly if a line along an edge of one of them separates them.
  bool crosses_piece(const Blocker& piece) {
    std::array<int, 4> side{};
    int least = 1, most = -1, zeros = 0;
    for (std::size_t i = 0; i < piece.corners; ++i) {
      side[i] = orientation(a_, b_, piece.corner[i]);
      least = std::min(least, side[i]);
      most = std::max(most, side[i]);
      if (side[i] == 0) ++zeros;
    }
    if (least >= 0 || most <= 0) {
      if (zeros > 1) touch_along(piece, side, most > 0);
      return false;
    }
    for (std::size_t i = 0; i < piece.corners; ++i) {
      const Point& p = piece.corner[i];
      const Point& q = piece.corner[i + 1 == piece.corners ? 0 : i + 1];
      if (orientation(p, q, a_) <= 0 && orientation(p, q, b_) <= 0) return false;
    }
    return true;
  }

  void touch_along(const Blocker& piece, const std::array<int, 4>& side, bool on_left) {
    for (std::size_t i = 0; i < piece.corners; ++i) {
      const std::size_t k = i + 1 == piece.corners ? 0 : i + 1;
      if (side[i] == 0 && side[k] == 0) stretches_.add(on_left, piece.corner[i], piece.corner[k]);
    }
  }

  /// The edge p q with the solid to its left; the vertex q answers with the next edge.
  bool crosses_edge(std::uint32_t edge) {
    const std::uint32_t next = index_.next(edge);
    const Point &p = index_.point(edge), &q = index_.point(next);
    const int of_p = orientation(a_, b_, p), of_q = orientation(a_, b_, q);
    if (of_p * of_q > 0) return false;
    if (of_p * of_q < 0) {
      const int of_a = orientation(p, q, a_), of_b = orientation(p, q, b_);
      return of_a * of_b < 0 || (of_a == 0 && of_b > 0) || (of_b == 0 && of_a > 0);
    }
    if (of_p != 0) return false;
    if (of_q == 0) {
      const bool forwards =
          a_.x != b_.x ? (a_.x < b_.x) == (p.x < q.x) : (a_.y < b_.y) == (p.y < q.y);
      stretches_.add(forwards, p, q);
    }
    if (!on_segment(p, a_, b_)) return false;
    const Sector solid{q, index_.point(index_.solid_before(edge))};
    return (p != a_ && strictly_inside(p, solid, a_)) || (p != b_ && strictly_inside(p, solid, b_));
  }

  const MitredIndex& index_;
  const Point &a_, &b_;
  Stretches stretches_;
};

/// What touches a point, as sectors of directions, and what has it strictly inside.
class Surroundings {
 public:
  Surroundings(const MitredIndex& index, const Point& p) : index_(index), p_(p) {}

  /// A piece: its sector where p is on its border. `inside` where p is strictly inside.
  void add_piece(const Blocker& piece) {
    if (piece.corners == 0) return;
    std::array<int, 4> side{};
    for (std::size_t i = 0; i < piece.corners; ++i) {
      side[i] = orientation(piece.corner[i], corner_after(piece, i), p_);
      if (side[i] < 0) return;
    }
    deepen(piece);
    const auto border = std::find(side.begin(), side.begin() + piece.corners, 0);
    if (border == side.begin() + piece.corners) {
      inside_piece_ = true;
      return;
    }
    const auto i = static_cast<std::size_t>(border - side.begin());
    for (std::size_t k = 0; k < piece.corners; ++k) {
      if (piece.corner[k] != p_) continue;
      sectors_.push_back({corner_after(piece, k), piece.corner[(k == 0 ? piece.corners : k) - 1U]});
      return;
    }
    sectors_.push_back({corner_after(piece, i), piece.corner[i]});
  }

  /// An edge of the world: the solid beside it where p is on it; true then.
  bool add_edge(std::uint32_t edge) {
    const Point &p = index_.point(edge), &q = index_.point(index_.next(edge));
    if (!on_segment(p_, p, q)) return false;
    touched_.push_back(index_.ring_of(edge).obstacle);
    if (p_ == p) {
      sectors_.push_back({q, index_.point(index_.solid_before(edge))});
    } else if (p_ != q) {
      sectors_.push_back({q, p});
    }
    return true;
  }

  /// The crossings of the ray to the right of p with the edge, for the winding number.
  void add_crossing(std::uint32_t edge) {
    const Point &p = index_.point(edge), &q = index_.point(index_.next(edge));
    const bool upwards = p.y <= p_.y;
    if (upwards == (q.y <= p_.y)) return;
    const int side = upwards ? 1 : -1;
    if (orientation(p, q, p_) == side) {
      windings_.emplace_back(index_.ring_of(edge).obstacle, side);
    }
  }

  WorldPosition position() {
    WorldPosition result;
    if (const auto obstacle = solid_obstacle()) {
      result.kind = *obstacle == WorldVertex::bounds ? WorldPosition::Kind::out_of_bounds
                                                     : WorldPosition::Kind::in_obstacle;
      result.obstacle = *obstacle;
    } else if (inside_piece_ || surrounded()) {
      result.kind =
          deepest_ == nothing ? WorldPosition::Kind::in_obstacle : WorldPosition::Kind::in_band;
      result.obstacle = deepest_ == nothing ? touched_.front() : index_.ring_of(deepest_).obstacle;
      result.missing = std::max(0.0, depth_);
    }
    return result;
  }

 private:
  static const Point& corner_after(const Blocker& piece, std::size_t i) {
    return piece.corner[i + 1 == piece.corners ? 0 : i + 1];
  }

  /// How far p is behind the outer line of the piece.
  void deepen(const Blocker& piece) {
    const Point &a = piece.corner[0], &b = piece.corner[1];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const double depth =
        ((b.x - a.x) / length) * (p_.y - a.y) - ((b.y - a.y) / length) * (p_.x - a.x);
    if (deepest_ != nothing && depth <= depth_) return;
    depth_ = depth;
    deepest_ = piece.edge;
  }

  /// The first obstacle that has p inside; on the border the sectors decide.
  std::optional<std::uint32_t> solid_obstacle() {
    const auto on_border = [&](std::uint32_t obstacle) {
      return std::find(touched_.begin(), touched_.end(), obstacle) != touched_.end();
    };
    std::sort(windings_.begin(), windings_.end());
    int around_bounds = 0;
    std::optional<std::uint32_t> found;
    for (std::size_t i = 0; i < windings_.size();) {
      const std::uint32_t obstacle = windings_[i].first;
      int around = 0;
      for (; i < windings_.size() && windings_[i].first == obstacle; ++i) {
        around += windings_[i].second;
      }
      if (obstacle == WorldVertex::bounds) {
        around_bounds = around;
      } else if (around != 0 && !found && !on_border(obstacle)) {
        found = obstacle;
      }
    }
    const bool bounded = index_.world().bounds().has_value() && !on_border(WorldVertex::bounds);
    if (bounded && around_bounds == 0) return WorldVertex::bounds;
    return found;
  }

  /// True where the sectors leave no direction free: beside the end of each, another goes on.
  bool surrounded() const {
    if (sectors_.empty()) return false;
    for (const Sector& one : sectors_) {
      bool goes_on = false;
      for (const Sector& other : sectors_) {
        // The direction one.end lies in [other.begin, other.end).
        if (compare_angles(p_, other.begin, one.end, other.end) < 0) goes_on = true;
      }
      if (!goes_on) return false;
    }
    return true;
  }

  const MitredIndex& index_;
  Point p_;
  std::vector<Sector> sectors_;
  std::vector<std::uint32_t> touched_;
  std::vector<std::pair<std::uint32_t, int>> windings_;
  bool inside_piece_ = false;
  std::uint32_t deepest_ = nothing;
  double depth_ = 0.0;
};

}  // namespace

std::optional<Obstruction> MitredIndex::obstruction(const Point& a, const Point& b,
                                                    const Patch* patch) const {
  if (a == b) return std::nullopt;
  Probe probe(*this, a, b);
  Obstruction found;
  const BoxFilter filter(a, b, patch == nullptr ? reach_ : std::max(reach_, patch->reach));
  const bool stopped = pieces_.blocker_tree.any(filter, [&](std::uint32_t i) {
    const Blocker& blocker = pieces_.blockers[i];
    if (patch != nullptr && patch->replaces_edge(blocker.edge)) return false;
    if (!probe.stopped_by(blocker)) return false;
    found.blocker = i;
    return true;
  });
  if (stopped) return found;
  if (patch != nullptr) {
    found.is_extra = true;
    const bool stopped_by_extra = patch->extra.blocker_tree.any(filter, [&](std::uint32_t i) {
      if (!probe.stopped_by(patch->extra.blockers[i])) return false;
      found.blocker = i;
      return true;
    });
    if (stopped_by_extra) return found;
  }
  if (probe.closed()) return Obstruction{};
  return std::nullopt;
}

WorldPosition MitredIndex::locate(const Point& p, const Patch* patch) const {
  Surroundings around(*this, p);
  // Every edge of the world is in the box of its first piece.
  pieces_.blocker_tree.any(
      [&](const Box& box) { return box.y0 <= p.y && p.y <= box.y1 && p.x <= box.x1; },
      [&](std::uint32_t i) {
        const Blocker& blocker = pieces_.blockers[i];
        if (blocker.is_first && !around.add_edge(blocker.edge)) around.add_crossing(blocker.edge);
        if (patch == nullptr || !patch->replaces_edge(blocker.edge)) around.add_piece(blocker);
        return false;
      });
  if (patch != nullptr) {
    patch->extra.blocker_tree.any([&](const Box& box) { return box.contains(p); },
                                  [&](std::uint32_t i) {
                                    around.add_piece(patch->extra.blockers[i]);
                                    return false;
                                  });
  }
  return around.position();
}

}  // namespace hodograph::planning_detail
