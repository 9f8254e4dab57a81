// SPDX-License-Identifier: MIT
// The order of items in a box tree.
#include "box_tree.hpp"

#include <numeric>
#include <utility>

namespace hodograph::planning_detail {
namespace {

constexpr double cells = 65535.0;  // along each side of the grid

}  // namespace

std::uint32_t hilbert_index(std::uint32_t x, std::uint32_t y) {
  std::uint32_t index = 0;
  for (std::uint32_t half = 1U << 15U; half != 0; half >>= 1U) {
    const std::uint32_t right = (x & half) != 0 ? 1 : 0, upper = (y & half) != 0 ? 1 : 0;
    index = (index << 2U) | ((3U * right) ^ upper);
    if (upper == 0) {  // the quarter is passed along the other diagonal, or backwards
      if (right == 1) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return index;
}

std::vector<std::uint32_t> hilbert_order(const std::vector<Box>& boxes) {
  Box all;
  for (const Box& box : boxes) all.include(box);
  const auto scale = [](double low, double high) {
    const double step = cells / (high - low);
    return std::isfinite(step) ? step : 0.0;
  };
  const double in_x = scale(all.x0, all.x1), in_y = scale(all.y0, all.y1);
  const auto cell = [](double low, double high, double begin, double step) {
    return static_cast<std::uint32_t>(std::clamp((0.5 * (low + high) - begin) * step, 0.0, cells));
  };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> keyed(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box& b = boxes[i];
    keyed[i] = {hilbert_index(cell(b.x0, b.x1, all.x0, in_x), cell(b.y0, b.y1, all.y0, in_y)),
                static_cast<std::uint32_t>(i)};
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::uint32_t> order(boxes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = keyed[i].second;
  return order;
}

}  // namespace hodograph::planning_detail
