// SPDX-License-Identifier: MIT
// Of hodograph/path/any_bounds.hpp what takes long to compile: torsion, energy, tubes.
#include <optional>
#include <string>

#include "hodograph/path/any_bounds.hpp"
#include "hodograph/path/bending_energy.hpp"
#include "hodograph/path/detail/any_degree.hpp"
#include "hodograph/path/torsion.hpp"

namespace hodograph {

namespace {

constexpr std::size_t most_degree = 8;

std::optional<Fault> degree_fault(const AnyPath& path, const char* what) {
  if (path.preimage_degree() <= most_degree) return std::nullopt;
  return Fault{FaultCode::unsupported,
               std::string(what) + " of a path in space is bounded up to preimage degree " +
                   std::to_string(most_degree) + "; this path has " +
                   std::to_string(path.preimage_degree()),
               std::nullopt,
               "preimage_degree",
               static_cast<double>(path.preimage_degree()),
               static_cast<double>(most_degree)};
}

/// visitor(path) in one of two degrees.
template <class Visitor>
auto in_two_degrees(const AnyPath& path, const Visitor& visitor) {
  return path_detail::in_degree<path_detail::Spatial, 3, most_degree>(path, visitor);
}

}  // namespace

Result<Extremes> torsion_extremes(const AnyPath& path, const RangeGoal& goal) {
  if (path.dimension() != 3) return path_detail::of_other_dimension("the torsion", 2);
  if (auto fault = degree_fault(path, "the torsion")) return *fault;
  return in_two_degrees(path,
                        [&](const auto& p) { return Result<Extremes>(torsion_extremes(p, goal)); });
}

Result<Enclosure> bending_energy_enclosure(const AnyPath& path) {
  const auto energy = [](const auto& p) { return bending_energy_enclosure(p); };
  if (path.dimension() == 2) return path_detail::in_planar_degree(path, energy);
  if (auto fault = degree_fault(path, "the bending energy")) return *fault;
  return in_two_degrees(path, energy);
}

Result<double> bending_energy(const AnyPath& path) {
  const auto energy = [](const auto& p) { return bending_energy(p); };
  if (path.dimension() == 2) return path_detail::in_planar_degree(path, energy);
  if (auto fault = degree_fault(path, "the bending energy")) return *fault;
  return in_two_degrees(path, energy);
}

Result<SelfDistance> self_distance(const AnyPath& path, double separation, const RangeGoal& goal) {
  return path_detail::in_any_degree(
      path, [&](const auto& p) { return self_distance(p, separation, goal); });
}

TubeRadius largest_tube_radius(const AnyPath& path, const RangeGoal& goal) {
  return path_detail::in_any_degree(path,
                                    [&](const auto& p) { return largest_tube_radius(p, goal); });
}

}  // namespace hodograph
