// SPDX-License-Identifier: MIT
// Checks obstacles and bounds and brings them into one form.
#include "hodograph/planning/world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "predicates.hpp"
#include "ring_contacts.hpp"

namespace hodograph {
namespace {

using planning_detail::area_sign;
using planning_detail::obstacle_text;
using planning_detail::ring_text;
using Point = Vector2<double>;

constexpr std::uint32_t bounds_number = WorldVertex::bounds;
/// Indices are 32 bits; the last value stands for the bounds.
constexpr std::size_t most_items = std::numeric_limits<std::uint32_t>::max() - 1;

Fault refusal(FaultCode code, std::uint32_t obstacle, std::string sentence,
              std::string quantity = "ring") {
  Fault fault{code, std::move(sentence), std::nullopt, std::move(quantity)};
  if (obstacle != bounds_number) fault.index = obstacle;
  return fault;
}

/// One ring being cleaned: where it is, and what it is called.
struct Place {
  std::uint32_t obstacle = 0;
  std::uint32_t ring = 0;
  const std::string* name = nullptr;

  std::string text() const { return obstacle_text(obstacle, *name) + ring_text(obstacle, ring); }
};

std::optional<Fault> unusable_coordinate(const Ring& ring, const Place& place) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (const double x : {ring[i].x, ring[i].y}) {
      if (std::isfinite(x) && std::fabs(x) <= largest_world_coordinate) continue;
      const bool finite = std::isfinite(x);
      Fault fault = refusal(
          finite ? FaultCode::outside_domain : FaultCode::not_finite, place.obstacle,
          place.text() + ": point " + std::to_string(i) + " has the coordinate " + to_text(x) +
              (finite ? ", beyond 2^500, the largest that a world takes" : ", which is not finite"),
          "point");
      fault.value = x;
      if (finite) fault.bound = largest_world_coordinate;
      return fault;
    }
  }
  return std::nullopt;
}

/// Takes out points that equal the one before them; the last one is compared with the first.
void remove_repeated(Ring& ring, const Place& place, std::vector<WorldRepair>& repairs) {
  Ring kept;
  kept.reserve(ring.size());
  std::vector<std::uint32_t> removed;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (!kept.empty() && kept.back() == ring[i]) {
      removed.push_back(static_cast<std::uint32_t>(i));
    } else {
      kept.push_back(ring[i]);
    }
  }
  // The tail that equals the first point; the indices that were kept are those not yet removed.
  std::size_t last = ring.size();
  while (kept.size() > 1 && kept.back() == kept.front()) {
    do {
      --last;
    } while (std::binary_search(removed.begin(), removed.end(), static_cast<std::uint32_t>(last)));
    kept.pop_back();
    removed.insert(
        std::upper_bound(removed.begin(), removed.end(), static_cast<std::uint32_t>(last)),
        static_cast<std::uint32_t>(last));
  }
  for (const std::uint32_t i : removed) {
    repairs.push_back({WorldRepair::Kind::repeated_point, place.obstacle, place.ring, i});
  }
  ring = std::move(kept);
}

/// Cleans a ring and turns it to the wanted sign of area.
std::optional<Fault> normalise(Ring& ring, const Place& place, int wanted_sign,
                               std::vector<WorldRepair>& repairs) {
  if (ring.size() > most_items) {
    return refusal(FaultCode::unsupported, place.obstacle,
                   place.text() + " has more points than an index of 32 bits can number");
  }
  if (auto fault = unusable_coordinate(ring, place)) return fault;
  for (Point& p : ring) p = {p.x + 0.0, p.y + 0.0};  // -0 becomes 0: equal points are equal bits
  remove_repeated(ring, place, repairs);
  if (ring.size() < 3) {
    Fault fault = refusal(FaultCode::too_few, place.obstacle,
                          place.text() + " has " + std::to_string(ring.size()) +
                              " different points; a ring needs at least 3");
    fault.value = static_cast<double>(ring.size());
    fault.bound = 3.0;
    return fault;
  }
  const std::array<const Ring*, 1> one{&ring};
  const int sign = area_sign(one);
  if (sign == 0) {
    return refusal(FaultCode::outside_domain, place.obstacle,
                   place.text() +
                       " surrounds no area: its points lie on one line, or what it "
                       "surrounds to the left and to the right is equal");
  }
  if (sign != wanted_sign) {
    std::reverse(ring.begin() + 1, ring.end());
    repairs.push_back({WorldRepair::Kind::turned_ring, place.obstacle, place.ring, 0});
  }
  return std::nullopt;
}

void include(std::optional<PlanarBox>& box, const Ring& ring) {
  for (const Point& p : ring) {
    if (!box) box = PlanarBox{p, p};
    box->lower = {std::min(box->lower.x, p.x), std::min(box->lower.y, p.y)};
    box->upper = {std::max(box->upper.x, p.x), std::max(box->upper.y, p.y)};
  }
}

}  // namespace

Result<World> World::create(std::vector<Polygon> obstacles, std::optional<Ring> bounds) {
  World world;
  if (obstacles.size() >= most_items) {
    return refusal(FaultCode::unsupported, bounds_number,
                   "the world has more obstacles than an index of 32 bits can number", "obstacles");
  }
  for (std::size_t k = 0; k < obstacles.size(); ++k) {
    Polygon& polygon = obstacles[k];
    const auto number = static_cast<std::uint32_t>(k);
    Place place{number, 0, &polygon.name};
    if (auto fault = normalise(polygon.outer, place, 1, world.repairs_)) return *fault;
    for (Ring& hole : polygon.holes) {
      ++place.ring;
      if (auto fault = normalise(hole, place, -1, world.repairs_)) return *fault;
    }
  }
  world.obstacles_ = std::move(obstacles);
  if (bounds) {
    const std::string no_name;
    if (auto fault = normalise(*bounds, {bounds_number, 0, &no_name}, 1, world.repairs_)) {
      return *fault;
    }
    world.bounds_ = std::move(bounds);
  }
  for (std::size_t k = 0; k < world.obstacles_.size(); ++k) {
    const Polygon& polygon = world.obstacles_[k];
    std::vector<const Ring*> rings{&polygon.outer};
    for (const Ring& hole : polygon.holes) rings.push_back(&hole);
    if (auto fault = planning_detail::ring_conflict(rings, world, static_cast<std::uint32_t>(k),
                                                    world.contacts_)) {
      return *fault;
    }
  }
  if (world.bounds_) {
    Ring clockwise = *world.bounds_;
    std::reverse(clockwise.begin() + 1, clockwise.end());
    const std::vector<const Ring*> rings{&clockwise};
    if (auto fault = planning_detail::ring_conflict(rings, world, bounds_number, world.contacts_)) {
      return *fault;
    }
  }
  for (const Polygon& polygon : world.obstacles_) {
    include(world.box_, polygon.outer);
    world.vertex_count_ += polygon.outer.size();
    for (const Ring& hole : polygon.holes) world.vertex_count_ += hole.size();
  }
  if (world.bounds_) {
    include(world.box_, *world.bounds_);
    world.vertex_count_ += world.bounds_->size();
  }
  if (world.vertex_count_ > most_items / 4) {
    return refusal(FaultCode::unsupported, bounds_number,
                   "the world has " + std::to_string(world.vertex_count_) + " vertices; at most " +
                       std::to_string(most_items / 4) + " can be numbered",
                   "vertices");
  }
  return world;
}

const Ring& World::ring(std::uint32_t obstacle, std::uint32_t ring) const {
  if (obstacle == bounds_number) return *bounds_;
  const Polygon& polygon = obstacles_[obstacle];
  return ring == 0 ? polygon.outer : polygon.holes[ring - 1];
}

std::size_t World::source_vertex(const WorldVertex& vertex) const {
  const auto key = [](const WorldRepair& r) { return std::pair(r.obstacle, r.ring); };
  const std::pair wanted(vertex.obstacle, vertex.ring);
  const auto begin =
      std::lower_bound(repairs_.begin(), repairs_.end(), wanted,
                       [&](const WorldRepair& r, const auto& place) { return key(r) < place; });
  std::size_t index = vertex.vertex;
  for (auto it = begin; it != repairs_.end() && key(*it) == wanted; ++it) {
    if (it->kind == WorldRepair::Kind::turned_ring && index != 0) {
      index = ring(vertex.obstacle, vertex.ring).size() - index;
    }
  }
  for (auto it = begin; it != repairs_.end() && key(*it) == wanted; ++it) {
    if (it->kind == WorldRepair::Kind::repeated_point && it->vertex <= index) ++index;
  }
  return index;
}

std::string World::name_of(std::uint32_t obstacle) const {
  if (obstacle == bounds_number) return obstacle_text(obstacle, {});
  return obstacle_text(obstacle, obstacles_[obstacle].name);
}

std::string to_text(const WorldRepair& repair) {
  const std::string place =
      obstacle_text(repair.obstacle, {}) + ring_text(repair.obstacle, repair.ring);
  if (repair.kind == WorldRepair::Kind::turned_ring) {
    return place + " went round the other way and was turned";
  }
  return place + ": point " + std::to_string(repair.vertex) + " repeats the one before it";
}

}  // namespace hodograph
