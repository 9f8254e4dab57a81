// SPDX-License-Identifier: MIT
#include "polygon_triangulation.hpp"

#include <algorithm>

#include "hodograph/foundation/enclosure.hpp"

namespace hodograph::surface_detail {
namespace {

/// Twice the area of the triangle abc, positive counterclockwise, enclosed.
Enclosure turn(const Vector2<double>& a, const Vector2<double>& b, const Vector2<double>& c) {
  const Enclosure ax(a.x), ay(a.y);
  return (Enclosure(b.x) - ax) * (Enclosure(c.y) - ay) -
         (Enclosure(b.y) - ay) * (Enclosure(c.x) - ax);
}

class EarClipper {
 public:
  explicit EarClipper(std::span<const Vector2<double>> corners)
      : corners_(corners),
        next_(corners.size()),
        previous_(corners.size()),
        reflex_(corners.size()) {
    const auto n = static_cast<std::uint32_t>(corners.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      next_[i] = i + 1 == n ? 0 : i + 1;
      previous_[i] = i == 0 ? n - 1 : i - 1;
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      reflex_[i] = !(turn_at(i).lower() > 0.0);
      if (reflex_[i]) reflex_list_.push_back(i);
    }
  }

  std::optional<std::vector<std::array<std::uint32_t, 3>>> run() {
    std::size_t left = corners_.size(), idle = 0;
    bool flat_allowed = false;  // an ear without certain area, where no other is left
    std::uint32_t at = 0;
    while (left > 3) {
      if (is_ear(at, flat_allowed)) {
        clip(at);
        --left;
        idle = 0;
        flat_allowed = false;
        at = next_[next_[at]];
        continue;
      }
      at = next_[at];
      if (++idle <= left) continue;
      if (flat_allowed) return std::nullopt;
      flat_allowed = true;
      idle = 0;
    }
    triangles_.push_back({previous_[at], at, next_[at]});
    if (turn_at(at).upper() < 0.0) return std::nullopt;
    return std::move(triangles_);
  }

 private:
  Enclosure turn_at(std::uint32_t i) const {
    return turn(corners_[previous_[i]], corners_[i], corners_[next_[i]]);
  }

  bool is_ear(std::uint32_t i, bool flat_allowed) const {
    const Enclosure area = turn_at(i);
    if (!(area.lower() > 0.0) && !(flat_allowed && area.upper() >= 0.0)) return false;
    const std::uint32_t a = previous_[i], c = next_[i];
    for (const std::uint32_t j : reflex_list_) {
      if (!reflex_[j] || j == a || j == i || j == c) continue;
      const bool outside = turn(corners_[a], corners_[i], corners_[j]).upper() < 0.0 ||
                           turn(corners_[i], corners_[c], corners_[j]).upper() < 0.0 ||
                           turn(corners_[c], corners_[a], corners_[j]).upper() < 0.0;
      if (!outside) return false;
    }
    return true;
  }

  void clip(std::uint32_t i) {
    const std::uint32_t a = previous_[i], c = next_[i];
    triangles_.push_back({a, i, c});
    next_[a] = c;
    previous_[c] = a;
    reflex_[i] = false;
    for (const std::uint32_t j : {a, c}) {
      if (reflex_[j] && turn_at(j).lower() > 0.0) reflex_[j] = false;
    }
    if (++clipped_ % compact_every == 0) {
      std::erase_if(reflex_list_, [this](std::uint32_t j) { return !reflex_[j]; });
    }
  }

  static constexpr std::size_t compact_every = 64;
  std::span<const Vector2<double>> corners_;
  std::vector<std::uint32_t> next_, previous_;
  std::vector<char> reflex_;
  std::vector<std::uint32_t> reflex_list_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::size_t clipped_ = 0;
};

}  // namespace

std::optional<std::vector<std::array<std::uint32_t, 3>>> triangulated(
    std::span<const Vector2<double>> corners) {
  if (corners.size() < 3) return std::nullopt;
  return EarClipper(corners).run();
}

}  // namespace hodograph::surface_detail
