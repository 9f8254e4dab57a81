// SPDX-License-Identifier: MIT
// A packed tree of boxes: items in the order of a space-filling curve, eight to a node, eight
// nodes to the next, without pointers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "hodograph/planning/polygon.hpp"

namespace hodograph::planning_detail {

/// A box that may be empty (lower > upper).
struct Box {
  double x0 = std::numeric_limits<double>::infinity(), y0 = x0, x1 = -x0, y1 = -x0;

  void include(const Vector2<double>& p) {
    x0 = std::min(x0, p.x), y0 = std::min(y0, p.y);
    x1 = std::max(x1, p.x), y1 = std::max(y1, p.y);
  }
  void include(const Box& b) {
    x0 = std::min(x0, b.x0), y0 = std::min(y0, b.y0);
    x1 = std::max(x1, b.x1), y1 = std::max(y1, b.y1);
  }
  bool contains(const Vector2<double>& p) const {
    return x0 <= p.x && p.x <= x1 && y0 <= p.y && p.y <= y1;
  }
  bool meets(const Box& b) const { return x0 <= b.x1 && b.x0 <= x1 && y0 <= b.y1 && b.y0 <= y1; }
};

/// Where (x, y), both below 2^16, stands on the Hilbert curve through the grid of 2^16 squared.
std::uint32_t hilbert_index(std::uint32_t x, std::uint32_t y);

/// The order that a Hilbert curve visits the centres of boxes in (ties by index).
std::vector<std::uint32_t> hilbert_order(const std::vector<Box>& boxes);

/// The tree over boxes 0 … n - 1 *in the given order*, which should be a spatial one.
///
/// A node is a number: nodes below n are the items; the parents of a level follow it. Children of
/// a node are consecutive.
class BoxTree {
 public:
  static constexpr std::size_t fan = 8;

  struct Children {
    std::uint32_t begin = 0, end = 0;
  };

  BoxTree() = default;
  explicit BoxTree(std::vector<Box> items) : boxes_(std::move(items)), items_(boxes_.size()) {
    std::size_t begin = 0, end = items_;
    boxes_.reserve(items_ + items_ / 2 + 2 * fan);
    while (end - begin > 1) {
      first_child_.reserve(first_child_.size() + (end - begin) / fan + 1);
      for (std::size_t child = begin; child < end; child += fan) {
        const std::size_t last = std::min(child + fan, end);
        Box box;
        for (std::size_t i = child; i < last; ++i) box.include(boxes_[i]);
        boxes_.push_back(box);
        first_child_.push_back(static_cast<std::uint32_t>(child));
      }
      begin = end;
      end = boxes_.size();
    }
    first_child_.push_back(static_cast<std::uint32_t>(begin));  // where the root's children end
  }

  bool empty() const { return items_ == 0; }
  std::size_t size() const { return items_; }
  /// Domain: not empty.
  std::uint32_t root() const { return static_cast<std::uint32_t>(boxes_.size() - 1); }
  bool is_item(std::uint32_t node) const { return node < items_; }
  const Box& box(std::uint32_t node) const { return boxes_[node]; }
  /// Domain: not an item.
  Children children(std::uint32_t node) const {
    const std::size_t k = node - items_;
    return {first_child_[k], first_child_[k + 1]};
  }

  /// Calls visit(item) for every item whose box passes `enters`, and so do all boxes above it;
  /// stops early, and returns true, where visit returns true.
  template <class Enters, class Visit>
  bool any(const Enters& enters, const Visit& visit) const {
    if (empty() || !enters(boxes_.back())) return false;
    if (items_ == 1) return visit(std::uint32_t{0});
    std::array<std::uint32_t, 96> stack;  // at most (fan - 1) a level wait, and 11 levels
    std::size_t depth = 0;
    stack[depth++] = root();
    while (depth != 0) {
      const Children range = children(stack[--depth]);
      for (std::uint32_t child = range.begin; child < range.end; ++child) {
        if (!enters(boxes_[child])) continue;
        if (is_item(child)) {
          if (visit(child)) return true;
        } else {
          stack[depth++] = child;
        }
      }
    }
    return false;
  }

 private:
  std::vector<Box> boxes_;
  std::vector<std::uint32_t> first_child_;
  std::size_t items_ = 0;
};

}  // namespace hodograph::planning_detail
