// SPDX-License-Identifier: MIT
#include "cli/spatial_facts.hpp"

#include <cmath>

#include "hodograph/path/any_bounds.hpp"

namespace hodograph::cli {
namespace {

/// Refined to about this relative width: what people read off.
constexpr RangeGoal shown{0x1p-20};

}  // namespace

std::optional<SpatialFacts> spatial_facts_of(const AnyPath& path) {
  if (path.dimension() != 3) return std::nullopt;
  SpatialFacts facts;
  if (const auto energy = bending_energy_enclosure(path)) facts.bending_energy = *energy;
  const auto torsion = torsion_extremes(path, shown);
  if (torsion && std::isfinite(torsion->minimum.lower()) &&
      std::isfinite(torsion->maximum.upper())) {
    facts.smallest_torsion = torsion->minimum;
    facts.largest_torsion = torsion->maximum;
  }
  return facts;
}

Json json_of(const SpatialFacts& facts) {
  const auto maybe = [](const std::optional<Enclosure>& x) { return x ? json_of(*x) : Json(); };
  return {{"bending_energy", maybe(facts.bending_energy)},
          {"smallest_torsion", maybe(facts.smallest_torsion)},
          {"largest_torsion", maybe(facts.largest_torsion)}};
}

}  // namespace hodograph::cli
