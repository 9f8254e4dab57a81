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

#include "hodograph/foundation/interruption.hpp"
#include "mitred_index.hpp"

namespace hodograph {
namespace planning_detail {
namespace {

/// Rounding of a few products and sums of coordinates is below this fraction of their sizes.
constexpr double half_plane_margin = 0x1p-48;
/// Two ways to a corner whose lengths differ by less than this fraction may be equal: more than
/// 2^8 legs' sums would have to go wrong the same way.
constexpr double equal_lengths = 0x1p-44;
/// Edges before and after a corner that are looked at for what they hide.
constexpr int occluding_edges = 8;
/// From this many corners on, the search tries from time to time whether the goal is walled in.
constexpr std::size_t first_check_from_goal = 512;

/// The closed half-plane x p.x + y p.y ≥ least.
struct HalfPlane {
  double x = 0.0, y = 0.0, least = 0.0;

  bool holds(const Point& p) const { return x * p.x + y * p.y >= least; }
  bool meets(const Box& b) const {
    return x * (x > 0.0 ? b.x1 : b.x0) + y * (y > 0.0 ? b.y1 : b.y0) >= least;
  }
};

double square_of(const Point& v) { return v.x * v.x + v.y * v.y; }
double length_of(const Point& v) { return std::sqrt(square_of(v)); }
double cross_of(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }

/// How far one sees from a point in the directions of a wedge: the square of a distance beyond
/// which everything in a direction is certainly hidden, as a step function of the direction.
///
/// A direction p = α a + β b, a and b along the wedge's borders, has the coordinate β/(α + β): 0 to
/// 1 across the wedge, monotonic in the angle wherever α + β > 0.
class View {
 public:
  View() = default;
  /// Domain: unit vectors, b less than half a turn anticlockwise from a.
  View(const Point& a, const Point& b) : a_(a), b_(b) {
    // Coordinates of narrower wedges would lose more than half of their digits.
    constexpr double narrowest = 0x1p-26;
    usable_ = cross_of(a, b) > narrowest;
    steps_.push_back({0.0, std::numeric_limits<double>::infinity()});
  }

  bool usable() const { return usable_; }

  /// The coordinate; absent behind, and beside within rounding. Correct to 2^-24.
  std::optional<double> coordinate(const Point& v) const {
    const double beta = cross_of(a_, v), alpha = cross_of(v, b_);
    const double sum = alpha + beta;
    constexpr double least = 0x1p-26;  // of the size of v: as for narrow wedges
    if (!(sum > least * (std::fabs(v.x) + std::fabs(v.y)))) return std::nullopt;
    return beta / sum;
  }

  /// Hides what is further than √square in directions strictly between two coordinates.
  void hide(double from, double to, double square) {
    from = std::max(from + slack, 0.0);
    to = std::min(to - slack, 1.0);
    if (!(from < to)) return;
    const double limit = square * rounding_up;
    std::size_t i = step_at(from);
    bool changes = false;
    for (std::size_t k = i; k < steps_.size() && steps_[k].begin < to; ++k) {
      if (steps_[k].limit > limit) changes = true;
    }
    if (!changes) return;
    std::size_t last = i;  // the step that `to` falls into, or ends
    while (last + 1 < steps_.size() && steps_[last + 1].begin < to) ++last;
    const double after = steps_[last].limit;
    const bool splits_end = last + 1 < steps_.size() ? steps_[last + 1].begin > to : to < 1.0;
    if (splits_end && after > limit) insert(last + 1, {to, after});
    if (steps_[i].limit > limit && steps_[i].begin < from) {
      insert(i + 1, {from, steps_[i].limit});
      ++i;
      ++last;
    }
    for (std::size_t k = i; k <= last; ++k) steps_[k].limit = std::min(steps_[k].limit, limit);
    // Steps of equal height become one.
    const auto begin = steps_.begin() + static_cast<std::ptrdiff_t>(i);
    const auto end = steps_.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    steps_.erase(
        std::unique(begin, end, [](const Step& a, const Step& b) { return a.limit == b.limit; }),
        end);
  }

  /// True where everything at least √square away between two coordinates is hidden.
  bool hidden(double from, double to, double square) const {
    from = std::max(from - slack, 0.0);
    to = std::min(to + slack, 1.0);
    const double limit = square / rounding_up;
    for (std::size_t i = step_at(from); i < steps_.size() && steps_[i].begin <= to; ++i) {
      if (!(steps_[i].limit < limit)) return false;
    }
    return true;
  }

 private:
  struct Step {
    double begin = 0.0, limit = 0.0;
  };
  // More than the rounding of coordinates, which is 2^-24.
  static constexpr double slack = 0x1p-22;
  // More than the roundings of squares of distances, some 2^-50.
  static constexpr double relative_slack = 0x1p-40;
  static constexpr double rounding_up = 1.0 + relative_slack;

  /// The last step that begins at or before t.
  std::size_t step_at(double t) const {
    const auto after = std::upper_bound(steps_.begin(), steps_.end(), t,
                                        [](double x, const Step& s) { return x < s.begin; });
    return after == steps_.begin() ? 0 : static_cast<std::size_t>(after - steps_.begin()) - 1;
  }
  void insert(std::size_t i, const Step& step) {
    steps_.insert(steps_.begin() + static_cast<std::ptrdiff_t>(i), step);
  }

  Point a_{}, b_{};
  std::vector<Step> steps_;
  bool usable_ = false;
};

/// What waits at a label: a box of corners to look into, or a leg to a corner.
struct Entry {
  double least = 0.0;      ///< no path this way is shorter
  double near = 0.0;       ///< how far away: what is nearer may hide what is further
  std::uint32_t node = 0;  ///< of a corner tree
  std::uint8_t kind = 0;   ///< 0 box, 1 box of extra corners, 2 leg turning right, 3 left

  friend bool operator>(const Entry& a, const Entry& b) {
    if (a.least != b.least) return a.least > b.least;
    if (a.near != b.near) return a.near > b.near;
    return std::tie(a.kind, a.node) > std::tie(b.kind, b.node);
  }
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
  int side = 0;      ///< of turning: 1 left, -1 right, 0 at the start
  int quadrant = 0;  ///< at the start: of the directions, anticlockwise from +x
  View view{};
  std::array<std::uint32_t, 8> seen_chains{};  ///< whose shadows are cast, most recently
  std::vector<Entry> waiting{};                ///< a heap
};

/// A label by the least that waits there.
struct Turn {
  double least = 0.0;
  std::uint32_t label = 0;

  friend bool operator>(const Turn& a, const Turn& b) {
    return a.least != b.least ? a.least > b.least : a.label > b.label;
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
    for (int quadrant = 0; quadrant < 4 && !found_; ++quadrant) {
      Label label;
      label.at = start;
      label.quadrant = quadrant;
      add(std::move(label));
    }
  }

  enum class State { found, exhausted, going_on };

  /// Goes on until the goal is reached, nothing is left, or so many corners are expanded.
  State run(std::size_t most_expanded) {
    while (!found_ && !turns_.empty()) {
      if (labels_.size() > most_expanded) return State::going_on;
      const std::uint32_t number = turns_.top().label;
      turns_.pop();
      do {
        check_interruption();
        const Entry entry = take(labels_[number]);
        if (entry.kind < 2) {
          open_box(labels_[number], entry,
                   turns_.empty() ? entry.least : std::max(entry.least, turns_.top().least));
        } else {
          try_leg(number, entry);
        }
        if (found_) return State::found;
      } while (!labels_[number].waiting.empty() &&
               (turns_.empty() || labels_[number].waiting.front().least <= turns_.top().least));
      if (!labels_[number].waiting.empty()) {
        turns_.push({labels_[number].waiting.front().least, number});
      }
    }
    return found_ ? State::found : State::exhausted;
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

  static void put(Label& label, const Entry& entry) {
    label.waiting.push_back(entry);
    std::push_heap(label.waiting.begin(), label.waiting.end(), std::greater<>());
  }
  static Entry take(Label& label) {
    std::pop_heap(label.waiting.begin(), label.waiting.end(), std::greater<>());
    const Entry entry = label.waiting.back();
    label.waiting.pop_back();
    return entry;
  }

  // ---- labels --------------------------------------------------------------------------------

  /// The half-plane to the left of a direction at a point, a few roundings wider.
  HalfPlane left_of(const Point& at, const Point& direction) const {
    const double x = -direction.y, y = direction.x;
    const double margin = half_plane_margin * reach_ * (std::fabs(x) + std::fabs(y));
    return {x, y, x * at.x + y * at.y - margin};
  }

  void set_wedge(Label& label) const {
    Point a, b;  // anticlockwise from a to b
    if (label.side == 0) {
      constexpr std::array<Point, 5> axes{
          {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}, {1.0, 0.0}}};
      a = axes[static_cast<std::size_t>(label.quadrant)];
      b = axes[static_cast<std::size_t>(label.quadrant) + 1];
    } else {
      const auto unit = [](const Point& p, const Point& q) {
        return (1.0 / length_of(q - p)) * (q - p);
      };
      a = unit(label.from, label.at);
      b = unit(label.limit_a, label.limit_b);
      if (label.side < 0) std::swap(a, b);
    }
    label.first = left_of(label.at, a);
    label.second = left_of(label.at, -b);
    label.view = View(a, b);
    label.seen_chains.fill(nothing);
  }

  void add(Label label) {
    const auto number = static_cast<std::uint32_t>(labels_.size());
    set_wedge(label);
    labels_.push_back(std::move(label));
    if (reaches_goal(number)) return;
    Label& added = labels_.back();
    const double least = added.length + length_of(goal_ - added.at);
    const BoxTree& tree = index_.pieces().corner_tree;
    if (!tree.empty()) put(added, {least, 0.0, tree.root(), 0});
    if (patch_ != nullptr && !patch_->extra.corner_tree.empty()) {
      put(added, {least, 0.0, patch_->extra.corner_tree.root(), 1});
    }
    if (!added.waiting.empty()) turns_.push({least, number});
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
    if (label.side == 0) {
      switch (label.quadrant) {
        case 0:
          return p.x > label.at.x && p.y >= label.at.y;
        case 1:
          return p.x <= label.at.x && p.y > label.at.y;
        case 2:
          return p.x < label.at.x && p.y <= label.at.y;
        default:
          return p.x >= label.at.x && p.y < label.at.y;
      }
    }
    return label.side * orientation(label.from, label.at, p) > 0 &&
           label.side * orientation(label.limit_a, label.limit_b, p) <= 0;
  }

  // ---- boxes ---------------------------------------------------------------------------------

  /// Looks into a box; boxes in it whose turn has come, too, at once and the nearest first.
  void open_box(Label& label, const Entry& entry, double limit) {
    const bool extra = entry.kind == 1;
    const BoxTree& tree = extra ? patch_->extra.corner_tree : index_.pieces().corner_tree;
    if (is_hidden(label, tree.box(entry.node))) return;
    if (tree.is_item(entry.node)) {
      return consider(label, extra ? base_corners_ + entry.node : entry.node);
    }
    std::array<Entry, BoxTree::fan> due{};
    std::size_t count = 0;
    const BoxTree::Children range = tree.children(entry.node);
    for (std::uint32_t child = range.begin; child < range.end; ++child) {
      const Box& box = tree.box(child);
      if (tree.is_item(child)) {
        consider(label, extra ? base_corners_ + child : child);
        continue;
      }
      if (!label.first.meets(box) || !label.second.meets(box)) continue;
      const double near = distance(box, label.at);
      const double least = std::max(entry.least, label.length + near + distance(box, goal_));
      const Entry inner{least, near, child, entry.kind};
      if (least > limit) {
        put(label, inner);
      } else {
        std::size_t i = count++;
        for (; i > 0 && near < due[i - 1].near; --i) due[i] = due[i - 1];
        due[i] = inner;
      }
    }
    for (std::size_t i = 0; i < count; ++i) open_box(label, due[i], limit);
  }

  static double distance(const Box& box, const Point& p) {
    const double x = std::max({box.x0 - p.x, p.x - box.x1, 0.0});
    const double y = std::max({box.y0 - p.y, p.y - box.y1, 0.0});
    return std::sqrt(x * x + y * y);
  }

  // ---- legs ----------------------------------------------------------------------------------

  /// Queues the leg to a corner if it leaves within the wedge and arrives tangentially.
  void consider(Label& label, std::uint32_t target) {
    const Corner& c = corner(target);
    if (c.at == label.at || !label.first.holds(c.at) || !label.second.holds(c.at)) return;
    if (is_hidden(label, c.at)) return;
    if (target < base_corners_) cast_shadow(label, c.vertex);
    const int after = orientation(label.at, c.at, c.after);
    const int before = orientation(label.at, c.at, c.before);
    const int side = after > 0 && before >= 0 ? 1 : before < 0 && after <= 0 ? -1 : 0;
    if (side == 0 || !in_wedge(label, c.at)) return;
    if (patch_ != nullptr && target < base_corners_ && patch_->replaces_vertex(c.vertex)) return;
    if (forbidden_.any() &&
        (forbidden_.corner(c.vertex, side) || forbidden_.leg(vertex_of(label), c.vertex))) {
      return;
    }
    const double near = length_of(c.at - label.at), length = label.length + near;
    if (is_settled(target, side, length, label.at)) return;
    put(label, {length + length_of(goal_ - c.at), near, target,
                static_cast<std::uint8_t>(side > 0 ? 3 : 2)});
  }

  /// True where what is reached already makes this way to a corner useless.
  bool is_settled(std::uint32_t target, int side, double length, const Point& from) const {
    const std::uint32_t same = reached_[2 * target + (side > 0 ? 1 : 0)];
    if (same != nothing) {
      if (!forbidden_.any()) return true;
      // A longer way may go on where the shorter one would not be taut: beyond its wedge.
      const Label& shorter = labels_[same];
      return side * orientation(shorter.from, shorter.at, from) <= 0;
    }
    if (forbidden_.any()) return false;
    const std::uint32_t other = reached_[2 * target + (side > 0 ? 0 : 1)];
    return other != nothing && length > (1.0 + equal_lengths) * labels_[other].length;
  }

  void try_leg(std::uint32_t number, const Entry& entry) {
    const int side = entry.kind == 3 ? 1 : -1;
    const Corner& c = corner(entry.node);
    const Point from = labels_[number].at;
    const double length = labels_[number].length + length_of(c.at - from);
    if (is_settled(entry.node, side, length, from)) return;
    if (!visible(number, c.at)) return;
    Label label;
    label.at = c.at;
    label.from = from;
    label.length = length;
    label.parent = number;
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
    add(std::move(label));
  }

  // ---- visibility ----------------------------------------------------------------------------

  bool visible(std::uint32_t number, const Point& target) {
    Label& label = labels_[number];
    if (is_hidden(label, target)) return false;
    ++tests_;
    const auto obstruction = index_.obstruction(label.at, target, patch_);
    if (!obstruction) return true;
    if (obstruction->blocker != nothing && !obstruction->is_extra) {
      cast_shadow(label, index_.pieces().blockers[obstruction->blocker].edge);
    }
    return false;
  }

  static bool is_hidden(const Label& label, const Point& p) {
    if (!label.view.usable()) return false;
    const Point v = p - label.at;
    const auto t = label.view.coordinate(v);
    return t && label.view.hidden(*t, *t, square_of(v));
  }

  static bool is_hidden(const Label& label, const Box& box) {
    if (!label.view.usable()) return false;
    double from = std::numeric_limits<double>::infinity(), to = -from;
    for (const Point& corner : {Point{box.x0, box.y0}, Point{box.x1, box.y0}, Point{box.x0, box.y1},
                                Point{box.x1, box.y1}}) {
      const auto t = label.view.coordinate(corner - label.at);
      if (!t) return false;
      from = std::min(from, *t);
      to = std::max(to, *t);
    }
    const double near = distance(box, label.at);
    return label.view.hidden(from, to, near * near);
  }

  /// The outer line of the solid about a vertex hides what lies behind all of it. It is followed
  /// while it stays in front, and ends where it is broken (at square ends of strips) and where the
  /// polygon touches itself, since one may pass through such a point.
  void cast_shadow(Label& label, std::uint32_t vertex) {
    if (!label.view.usable()) return;
    constexpr std::uint32_t chain_size = 4;
    const std::uint32_t chain = vertex / chain_size;
    std::uint32_t& slot = label.seen_chains[chain % label.seen_chains.size()];
    if (slot == chain) return;
    slot = chain;
    double from = std::numeric_limits<double>::infinity(), to = -from, far = 0.0;
    const auto extend = [&](const Point& p) {
      const Point v = p - label.at;
      const auto t = label.view.coordinate(v);
      if (!t) return false;
      from = std::min(from, *t);
      to = std::max(to, *t);
      far = std::max(far, square_of(v));
      return true;
    };
    const auto usable = [&](std::uint32_t e) {
      return patch_ == nullptr || !patch_->replaces_edge(e);
    };
    if (!usable(vertex) || !extend(index_.outer_begin(vertex))) return;
    std::uint32_t e = vertex;
    for (int i = 0; i < occluding_edges && usable(e) && extend(index_.outer_end(e)); ++i) {
      const std::uint32_t next = index_.next(e);
      if (next == vertex || index_.solid_before(next) != e ||
          index_.outer_begin(next) != index_.outer_end(e)) {
        break;
      }
      e = next;
    }
    e = vertex;
    for (int i = 0; i < occluding_edges; ++i) {
      const std::uint32_t before = index_.previous(e);
      if (before == vertex || !usable(before) || index_.solid_before(e) != before ||
          index_.outer_end(before) != index_.outer_begin(e) ||
          !extend(index_.outer_begin(before))) {
        break;
      }
      e = before;
    }
    label.view.hide(from, to, far);
  }

  const MitredIndex& index_;
  const Patch* patch_;
  const Prohibitions& forbidden_;
  Point goal_;
  std::uint32_t base_corners_;
  double reach_ = 0.0;
  std::vector<std::uint32_t> reached_;  // label of each corner and side
  std::vector<Label> labels_;
  std::priority_queue<Turn, std::vector<Turn>, std::greater<>> turns_;
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
  if (position.kind == WorldPosition::Kind::free) return std::nullopt;
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

  if (query.start == query.goal) return Polyline{{query.start, query.goal}};
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
