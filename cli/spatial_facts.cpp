// SPDX-License-Identifier: MIT
#include "cli/spatial_facts.hpp"

#include <cmath>

#include "hodograph/path/any_operations.hpp"
#include "hodograph/path/bending_energy.hpp"
#include "hodograph/path/torsion.hpp"

namespace hodograph::cli {
namespace {

/// Refined to about this relative width: what people read off.
constexpr RangeGoal shown{0x1p-20};

template <std::size_t n>
SpatialFacts facts_of_spatial(const SpatialPath<n>& path) {
  SpatialFacts facts;
  if (const auto energy = bending_energy_enclosure(path)) facts.bending_energy = *energy;
  const Extremes torsion = torsion_extremes(path, shown);
  if (std::isfinite(torsion.minimum.lower()) && std::isfinite(torsion.maximum.upper())) {
    facts.smallest_torsion = torsion.minimum;
    facts.largest_torsion = torsion.maximum;
  }
  return facts;
}

}  // namespace

std::optional<SpatialFacts> spatial_facts_of(const AnyPath& path) {
  if (path.dimension() != 3) return std::nullopt;
  // Two degrees stand for all, to which the others are elevated: compiling each takes seconds.
  constexpr std::size_t low = 3, high = 8;
  if (path.preimage_degree() > high) return SpatialFacts{};
  const bool is_low = path.preimage_degree() <= low;
  const AnyPath same = with_preimage_degree(path, is_low ? low : high).value();
  return is_low ? facts_of_spatial(*same.get_if<SpatialPath<low>>())
                : facts_of_spatial(*same.get_if<SpatialPath<high>>());
}

Json json_of(const SpatialFacts& facts) {
  const auto maybe = [](const std::optional<Enclosure>& x) { return x ? json_of(*x) : Json(); };
  return {{"bending_energy", maybe(facts.bending_energy)},
          {"smallest_torsion", maybe(facts.smallest_torsion)},
          {"largest_torsion", maybe(facts.largest_torsion)}};
}

}  // namespace hodograph::cli
