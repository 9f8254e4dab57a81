// SPDX-License-Identifier: MIT
// A* over the corners of a mitred world, one taut wedge at a time.
#include "hodograph/planning/shortest_polyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <string>
#include <tuple>
#include <utility>

#include "mitred_index.hpp"

namespace hodograph {
namespace planning_detail {
namespace {

/// Rounding of a few products and sums of coordinates is below this fraction of their sizes.
constexpr double half_plane_margin = 0x1p-48;
/// Two ways to a corner whose lengths differ by less than this fraction may be equal: more than
/// 2^8 legs' sums would have to go wrong the same way.
constexpr double equal_lengths = 0x1p-44;
/// Edges before and after the one that stopped a leg that hide what is behind them.
constexpr int occluding_edges = 12;
/// From this many corners on, the search tries from time to time whether the goal is walled in.
constexpr std::size_t first_check_from_goal = 512;

struct HalfPlane {
  double x = 0.0, y = 0.0, least = 0.0;  ///< x p.x + y p.y > least

  double most_in(const Box& b) const {
    return x * (x > 0.0 ? b.x1 : b.x0) + y * (y > 0.0 ? b.y1 : b.y0);
  }
  double least_in(const Box& b) const {
    return x * (x > 0.0 ? b.x0 : b.x1) + y * (y > 0.0 ? b.y0 : b.y1);
  }
};

double length_of(const Point& v) { return std::sqrt(v.x * v.x + v.y * v.y); }

/// What a piece hides from a label: what all three half-planes hold.
struct Shadow {
  std::array<HalfPlane, 3> sides{};
  std::uint32_t next = nothing;
};

/// A way to a corner (or the start), and the wedge of directions in which it may go on tautly.
struct Label {
  Point at{};
  Point from{};                 ///< goes on strictly to the turning side of the line from → at
  Point limit_a{}, limit_b{};   ///< and not to that side of the line a → b
  HalfPlane first{}, second{};  ///< the same, a little wider
  double length = 0.0;
  std::uint32_t parent = nothing;
  std::uint32_t corner = nothing;
  std::uint32_t shadows = nothing;
  int side = 0;  ///< of turning: 1 left, -1 right, 0 at the start: every direction
};

/// What waits in the queue: a box of corners to look into, or a leg to a corner.
struct Entry {
  double least = 0.0;  ///< no path this way is shorter
  std::uint32_t label = 0;
  std::uint32_t node = 0;  ///< of a corner tree
  std::uint8_t kind = 0;   ///< 0 box, 1 box of extra corners, 2 leg turning right, 3 left

  friend bool operator>(const Entry& a, const Entry& b) {
    if (a.least != b.least) return a.least > b.least;
    return std::tie(a.label, a.kind, a.node) > std::tie(b.label, b.kind, b.node);
  }
};

struct Prohibitions {
  std::vector<std::pair<std::uint32_t, int>> corners;         // vertex, side; sorted
  std::vector<std::pair<std::uint32_t, std::uint32_t>> legs;  // vertices or `nothing`; sorted

  bool any() const { return !corners.empty() || !legs.empty(); }
  bool corner(std::uint32_t vertex, int side) const {
    return std::binary_search(corners.begin(), corners.end(), std::pair(vertex, side));
  }
  bool leg(std::uint32_t from, std::uint32_t to) const {
    return std::binary_search(legs.begin(), legs.end(), std::pair(from, to));
  }
};

class Search {
 public:
  Search(const MitredIndex& index, const Patch* patch, const Prohibitions& forbidden,
         const Point& start, const Point& goal)
      : index_(index),
        patch_(patch),
        forbidden_(forbidden),
        goal_(goal),
        base_corners_(static_cast<std::uint32_t>(index.pieces().corners.size())) {
    const std::size_t corners =
        base_corners_ + (patch == nullptr ? 0 : patch->extra.corners.size());
    reached_.assign(2 * corners, nothing);
    reach_ = patch == nullptr ? index.reach() : std::max(index.reach(), patch->reach);
    for (const double x : {start.x, start.y, goal.x, goal.y}) {
      reach_ = std::max(reach_, std::fabs(x));
    }
    Label label;
    label.at = start;
    add(label);
  }

  enum class State { found, exhausted, going_on };

  /// Goes on until the goal is reached, nothing is left, or so many corners are expanded.
  State run(std::size_t most_expanded) {
    if (found_) return State::found;
    while (!queue_.empty()) {
      if (labels_.size() > most_expanded) return State::going_on;
      const Entry entry = queue_.top();
      queue_.pop();
      if (entry.kind < 2) {
        open_box(entry);
      } else {
        try_leg(entry);
      }
      if (found_) return State::found;
    }
    return State::exhausted;
  }

  Polyline result() const {
    Polyline line;
    line.expanded = labels_.size();
    line.visibility_tests = tests_;
    std::vector<std::uint32_t> chain;
    for (std::uint32_t l = last_; l != nothing; l = labels_[l].parent) chain.push_back(l);
    std::reverse(chain.begin(), chain.end());
    for (const std::uint32_t l : chain) {
      const Label& label = labels_[l];
      if (label.corner != nothing) {
        line.corners.push_back({label.at, index_.identity(corner(label.corner).vertex),
                                label.side > 0 ? TurnSide::left : TurnSide::right});
      }
      line.points.push_back(label.at);
    }
    line.points.push_back(goal_);
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
      line.length += std::hypot(line.points[i + 1].x - line.points[i].x,
                                line.points[i + 1].y - line.points[i].y);
    }
    return line;
  }

 private:
  const Corner& corner(std::uint32_t number) const {
    return number < base_corners_ ? index_.pieces().corners[number]
                                  : patch_->extra.corners[number - base_corners_];
  }
  std::uint32_t vertex_of(const Label& label) const {
    return label.corner == nothing ? nothing : corner(label.corner).vertex;
  }

  /// The half-plane of points p to the given side of the line a → b, `slack` roundings wider
  /// (or narrower).
  HalfPlane half_plane(const Point& a, const Point& b, int side, double slack) const {
    const double x = -side * (b.y - a.y), y = side * (b.x - a.x);
    const double margin = half_plane_margin * reach_ * (std::fabs(x) + std::fabs(y));
    return {x, y, x * a.x + y * a.y - slack * margin};
  }

  // ---- labels --------------------------------------------------------------------------------

  void add(Label label) {
    if (label.side != 0) {
      label.first = half_plane(label.from, label.at, label.side, 1.0);
      label.second = half_plane(label.limit_a, label.limit_b, -label.side, 1.0);
    }
    const auto number = static_cast<std::uint32_t>(labels_.size());
    labels_.push_back(label);
    if (reaches_goal(number)) return;
    const double least = label.length + length_of(goal_ - label.at);
    const BoxTree& tree = index_.pieces().corner_tree;
    if (!tree.empty()) queue_.push({least, number, tree.root(), 0});
    if (patch_ != nullptr && !patch_->extra.corner_tree.empty()) {
      queue_.push({least, number, patch_->extra.corner_tree.root(), 1});
    }
  }

  /// The way straight to the goal: no way from this label, and from no other that waits, is
  /// shorter.
  bool reaches_goal(std::uint32_t number) {
    const Label& label = labels_[number];
    if (!in_wedge(label, goal_) || forbidden_.leg(vertex_of(label), nothing)) return false;
    if (!visible(number, goal_)) return false;
    found_ = true;
    last_ = number;
    return true;
  }

  static bool in_wedge(const Label& label, const Point& p) {
    if (label.side == 0) return true;
    return label.side * orientation(label.from, label.at, p) > 0 &&
           label.side * orientation(label.limit_a, label.limit_b, p) <= 0;
  }

  // ---- boxes ---------------------------------------------------------------------------------

  void open_box(const Entry& entry) {
    const bool extra = entry.kind == 1;
    const BoxTree& tree = extra ? patch_->extra.corner_tree : index_.pieces().corner_tree;
    const auto look_at = [&](std::uint32_t child) {
      if (tree.is_item(child)) {
        consider(entry.label, extra ? base_corners_ + child : child);
        return;
      }
      const Label& label = labels_[entry.label];
      const Box& box = tree.box(child);
      if (label.side != 0 && (label.first.most_in(box) < label.first.least ||
                              label.second.most_in(box) < label.second.least)) {
        return;
      }
      if (is_hidden(label, box)) return;
      const double least =
          std::max(entry.least, label.length + distance(box, label.at) + distance(box, goal_));
      queue_.push({least, entry.label, child, entry.kind});
    };
    if (tree.is_item(entry.node)) return look_at(entry.node);
    const BoxTree::Children range = tree.children(entry.node);
    for (std::uint32_t child = range.begin; child < range.end; ++child) look_at(child);
  }

  static double distance(const Box& box, const Point& p) {
    const double x = std::max({box.x0 - p.x, p.x - box.x1, 0.0});
    const double y = std::max({box.y0 - p.y, p.y - box.y1, 0.0});
    return std::sqrt(x * x + y * y);
  }

  // ---- legs ----------------------------------------------------------------------------------

  /// Queues the leg to a corner if it leaves within the wedge and arrives tangentially.
  void consider(std::uint32_t number, std::uint32_t target) {
    const Label& label = labels_[number];
    const Corner& c = corner(target);
    if (c.at == label.at) return;
    if (label.side != 0 &&
        (label.first.x * c.at.x + label.first.y * c.at.y < label.first.least ||
         label.second.x * c.at.x + label.second.y * c.at.y < label.second.least)) {
      return;
    }
    const int after = orientation(label.at, c.at, c.after);
    const int before = orientation(label.at, c.at, c.before);
    const int side = after > 0 && before >= 0 ? 1 : before < 0 && after <= 0 ? -1 : 0;
    if (side == 0 || !in_wedge(label, c.at)) return;
    if (patch_ != nullptr && target < base_corners_ && patch_->replaces_vertex(c.vertex)) return;
    if (forbidden_.any() &&
        (forbidden_.corner(c.vertex, side) || forbidden_.leg(vertex_of(label), c.vertex))) {
      return;
    }
    const double length = label.length + length_of(c.at - label.at);
    if (is_settled(target, side, length, label.at)) return;
    Box box;
    box.include(c.at);
    if (is_hidden(label, box)) return;
    queue_.push({length + length_of(goal_ - c.at), number, target,
                 static_cast<std::uint8_t>(side > 0 ? 3 : 2)});
  }

  /// True where what is reached already makes this way to a corner useless.
  bool is_settled(std::uint32_t target, int side, double length, const Point& from) const {
    const std::uint32_t same = reached_[2 * target + (side > 0 ? 1 : 0)];
    if (same != nothing) {
      if (!forbidden_.any()) return true;
      // A longer way may go on where the shorter one would not be taut: beyond its wedge.
      const Label& shorter = labels_[same];
      return side * orientation(shorter.from, shorter.at, from) >= 0;
    }
    if (forbidden_.any()) return false;
    const std::uint32_t other = reached_[2 * target + (side > 0 ? 0 : 1)];
    return other != nothing && length > (1.0 + equal_lengths) * labels_[other].length;
  }

  void try_leg(const Entry& entry) {
    const int side = entry.kind == 3 ? 1 : -1;
    const Corner& c = corner(entry.node);
    const Point from = labels_[entry.label].at;
    const double length = labels_[entry.label].length + length_of(c.at - from);
    if (is_settled(entry.node, side, length, from)) return;
    if (!visible(entry.label, c.at)) return;
    Label label;
    label.at = c.at;
    label.from = from;
    label.length = length;
    label.parent = entry.label;
    label.corner = entry.node;
    label.side = side;
    std::uint32_t& reached = reached_[2 * entry.node + (side > 0 ? 1 : 0)];
    if (reached == nothing) {
      label.limit_a = c.at;
      label.limit_b = side > 0 ? c.after : c.before;
    } else {  // what the shorter way leaves out
      label.limit_a = labels_[reached].from;
      label.limit_b = c.at;
    }
    reached = static_cast<std::uint32_t>(labels_.size());
    add(label);
  }

  // ---- visibility ----------------------------------------------------------------------------

  bool visible(std::uint32_t number, const Point& target) {
    Label& label = labels_[number];
    Box box;
    box.include(target);
    if (is_hidden(label, box)) return false;
    ++tests_;
    const auto obstruction = index_.obstruction(label.at, target, patch_);
    if (!obstruction) return true;
    if (obstruction->blocker != nothing && !obstruction->is_extra) {
      cast_shadow(label, index_.pieces().blockers[obstruction->blocker].edge);
    }
    return false;
  }

  bool is_hidden(const Label& label, const Box& box) const {
    for (std::uint32_t s = label.shadows; s != nothing; s = shadows_[s].next) {
      const auto& sides = shadows_[s].sides;
      if (sides[0].least_in(box) > sides[0].least && sides[1].least_in(box) > sides[1].least &&
          sides[2].least_in(box) > sides[2].least) {
        return true;
      }
    }
    return false;
  }

  /// The outer line of the solid about an edge hides what lies behind all of it, between its
  /// outermost directions.
  void cast_shadow(Label& label, std::uint32_t edge) {
    const Point v = label.at;
    const auto cross = [&](const Point& p, const Point& q) {
      return (p.x - v.x) * (q.y - v.y) - (p.y - v.y) * (q.x - v.x);
    };
    chain_.clear();
    Point right = index_.outer_begin(edge), left = index_.outer_end(edge);
    if (patch_ != nullptr && patch_->replaces_edge(edge)) return;
    if (cross(right, left) < 0.0) std::swap(left, right);
    if (!(cross(right, left) > 0.0)) return;
    chain_.push_back(left);
    chain_.push_back(right);
    const auto extend = [&](const Point& p) {
      const double to_right = cross(right, p), to_left = cross(left, p);
      if (to_left > 0.0) {
        if (!(to_right > 0.0)) return false;
        left = p;
      } else if (to_right < 0.0) {
        right = p;
      }
      chain_.push_back(p);
      return true;
    };
    const auto usable = [&](std::uint32_t e) {
      return patch_ == nullptr || !patch_->replaces_edge(e);
    };
    std::uint32_t e = edge;
    for (int i = 0; i < occluding_edges; ++i) {
      const Point end = index_.outer_end(e);
      e = index_.next(e);
      if (e == edge || !usable(e) || index_.outer_begin(e) != end) break;
      if (!extend(index_.outer_end(e))) break;
    }
    e = edge;
    for (int i = 0; i < occluding_edges; ++i) {
      const Point begin = index_.outer_begin(e);
      e = index_.previous(e);
      if (e == edge || !usable(e) || index_.outer_end(e) != begin) break;
      if (!extend(index_.outer_begin(e))) break;
    }
    Shadow shadow;
    shadow.sides[0] = half_plane(v, right, 1, -1.0);
    shadow.sides[1] = half_plane(v, left, -1, -1.0);
    shadow.sides[2] = half_plane(left, right, 1, -1.0);
    HalfPlane& behind = shadow.sides[2];
    const double margin = half_plane_margin * reach_ * (std::fabs(behind.x) + std::fabs(behind.y));
    for (const Point& p : chain_) {
      behind.least = std::max(behind.least, behind.x * p.x + behind.y * p.y + margin);
    }
    shadow.next = label.shadows;
    label.shadows = static_cast<std::uint32_t>(shadows_.size());
    shadows_.push_back(shadow);
  }

  const MitredIndex& index_;
  const Patch* patch_;
  const Prohibitions& forbidden_;
  Point goal_;
  std::uint32_t base_corners_;
  double reach_ = 0.0;
  std::vector<std::uint32_t> reached_;  // label of each corner and side
  std::vector<Label> labels_;
  std::vector<Shadow> shadows_;
  std::vector<Point> chain_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::size_t tests_ = 0;
  bool found_ = false;
  std::uint32_t last_ = nothing;
};

// ---- the query
// -----------------------------------------------------------------------------------

std::optional<Fault> unusable_point(const Point& p, const char* which) {
  for (const double x : {p.x, p.y}) {
    if (std::isfinite(x) && std::fabs(x) <= largest_world_coordinate) continue;
    return Fault{std::isfinite(x) ? FaultCode::outside_domain : FaultCode::not_finite,
                 std::string("the ") + which + " has the coordinate " + to_text(x) +
                     "; coordinates are finite and at most 2^500",
                 std::nullopt, which, x};
  }
  return std::nullopt;
}

std::optional<Fault> unusable_place(const MitredIndex& index, const Patch* patch,
                                    const PolylineQuery& query, const Point& p, const char* which) {
  const WorldPosition position = index.locate(p, patch);
  const std::string subject =
      std::string("the ") + which + " (" + to_text(p.x) + ", " + to_text(p.y) + ") ";
  const std::string obstacle = index.world().name_of(position.obstacle);
  Fault fault{FaultCode::outside_domain, "", std::nullopt, which};
  if (position.obstacle != WorldVertex::bounds) fault.index = position.obstacle;
  switch (position.kind) {
    case WorldPosition::Kind::free:
      return std::nullopt;
    case WorldPosition::Kind::out_of_bounds:
      fault.sentence = subject + "lies outside the bounds";
      return fault;
    case WorldPosition::Kind::in_obstacle:
      fault.sentence = subject + "lies inside " + obstacle;
      return fault;
    case WorldPosition::Kind::in_band:
      break;
  }
  double offset = position.obstacle == WorldVertex::bounds ? index.bounds_offset() : index.offset();
  for (const ObstacleOffset& change : query.obstacle_offsets) {
    if (change.obstacle == position.obstacle) offset = change.offset;
  }
  fault.value = std::max(0.0, offset - position.missing);
  fault.bound = offset;
  fault.sentence = subject + "is too near to " + obstacle + ": it has a clearance of " +
                   to_text(*fault.value) + ", " + to_text(position.missing) + " less than the " +
                   to_text(offset) + " needed (to the mitred outline)";
  return fault;
}

Result<Prohibitions> prohibitions(const MitredIndex& index, const PolylineQuery& query) {
  Prohibitions result;
  std::optional<Fault> fault;
  const auto number = [&](const WorldVertex& vertex) {
    const auto found = index.find(vertex);
    if (!found) {
      fault = Fault{FaultCode::outside_domain,
                    "vertex " + std::to_string(vertex.vertex) + " of ring " +
                        std::to_string(vertex.ring) + " of obstacle " +
                        std::to_string(vertex.obstacle) + " is forbidden but does not exist",
                    std::nullopt, "forbidden"};
    }
    return found.value_or(0);
  };
  for (const ForbiddenCorner& corner : query.forbidden_corners) {
    result.corners.emplace_back(number(corner.vertex), corner.side == TurnSide::left ? 1 : -1);
  }
  for (const ForbiddenLeg& leg : query.forbidden_legs) {
    result.legs.emplace_back(leg.from ? number(*leg.from) : nothing,
                             leg.to ? number(*leg.to) : nothing);
  }
  if (fault) return *fault;
  std::sort(result.corners.begin(), result.corners.end());
  std::sort(result.legs.begin(), result.legs.end());
  return result;
}

Fault no_route(const std::string& why) { return {FaultCode::no_route, why, std::nullopt, "route"}; }

}  // namespace
}  // namespace planning_detail

Result<Polyline> shortest_polyline(const MitredWorld& world, const PolylineQuery& query) {
  using namespace planning_detail;
  const MitredIndex& index = world.index();
  if (auto fault = unusable_point(query.start, "start")) return *fault;
  if (auto fault = unusable_point(query.goal, "goal")) return *fault;
  std::optional<Patch> changes;
  if (!query.corner_offsets.empty() || !query.obstacle_offsets.empty()) {
    auto made = index.patch(query.obstacle_offsets, query.corner_offsets);
    if (!made) return made.fault();
    changes = std::move(*made);
  }
  const Patch* const patch = changes ? &*changes : nullptr;
  const auto forbidden = prohibitions(index, query);
  if (!forbidden) return forbidden.fault();
  if (auto fault = unusable_place(index, patch, query, query.start, "start")) return *fault;
  if (auto fault = unusable_place(index, patch, query, query.goal, "goal")) return *fault;

  Search search(index, patch, *forbidden, query.start, query.goal);
  if (forbidden->any()) {
    if (search.run(std::numeric_limits<std::size_t>::max()) == Search::State::found) {
      return search.result();
    }
    return no_route("no route from start to goal is left beside what is forbidden");
  }
  // A start or goal that is walled in may have few corners about it and the other one many: a
  // search from the goal, held back to a fraction of the first, finds the smaller of the two.
  std::optional<Search> backwards;
  for (std::size_t most = first_check_from_goal;; most *= 4) {
    switch (search.run(most)) {
      case Search::State::found:
        return search.result();
      case Search::State::exhausted:
        return no_route("there is no route: the start (" + to_text(query.start.x) + ", " +
                        to_text(query.start.y) + ") is walled in from the goal");
      case Search::State::going_on:
        break;
    }
    if (!backwards) backwards.emplace(index, patch, *forbidden, query.goal, query.start);
    if (backwards->run(most / 4) == Search::State::exhausted) {
      return no_route("there is no route: the goal (" + to_text(query.goal.x) + ", " +
                      to_text(query.goal.y) + ") is walled in from the start");
    }
  }
}

}  // namespace hodograph
