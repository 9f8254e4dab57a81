// SPDX-License-Identifier: MIT
// Where a path of any dimension and degree is sampled; the work is in path/sampling.hpp.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "hodograph/foundation/result.hpp"
#include "hodograph/path/any_path.hpp"

namespace hodograph::cli {

/// The ξ at which the path has come the arc length s. Throws Error (outside_domain).
double parameter_at(const AnyPath& path, double arc_length);

/// More samples than this are refused (as in path/sampling.hpp, which is heavy to include).
inline constexpr std::size_t maximum_count = std::size_t{1} << 26U;

/// Exactly one member is set.
struct SamplePlan {
  std::optional<std::size_t> count{};                     ///< evenly spaced in arc length
  std::optional<std::size_t> count_in_xi{};               ///< evenly spaced in ξ
  std::optional<std::size_t> count_per_segment{};         ///< every knot, and between
  std::optional<double> step{};                           ///< of arc length
  std::optional<double> chord_tolerance{};                ///< of the polyline through the points
  std::optional<std::vector<double>> xi{}, arc_length{};  ///< given places, in any order
};

/// The parameters of a plan. Faults: those of path/sampling.hpp; outside_domain for a given place
/// that is not on the path, with its index.
Result<std::vector<double>> sampled_parameters(const AnyPath& path, const SamplePlan& plan);

}  // namespace hodograph::cli
