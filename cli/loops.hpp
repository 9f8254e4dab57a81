// SPDX-License-Identifier: MIT
// A closed loop as it is asked for, made, and told: what `hodograph loop` and the request "loop"
// have in common.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/made_path.hpp"
#include "hodograph/construction/loop_choice.hpp"
#include "hodograph/construction/loop_facts.hpp"

namespace hodograph::cli {

/// The words for what a loop is chosen for.
inline constexpr std::array<const char*, 4> loop_purposes = {"least-energy", "least-torsion",
                                                             "near", "extents"};

/// What is asked for. Without a purpose and a box, the loop is the one of ξ and ψ.
struct LoopRequest {
  double length = 1.0;
  Vector3<double> start{}, direction{1.0, 0.0, 0.0};
  std::optional<Vector3<double>> normal{};
  double roll = 0.0;
  std::optional<double> xi{}, psi{};
  std::optional<std::string> limit{};    ///< positive or negative: ξ = ±infinity
  std::optional<std::string> purpose{};  ///< one of loop_purposes
  std::optional<Vector3<double>> point{}, extents{};
  std::optional<LoopBox> within{};
  bool free_roll = false;
  std::optional<double> largest_xi{};
};

struct MadeLoop {
  LoopShape shape;
  double roll = 0.0;  ///< beyond the one asked for
  std::string purpose;
  std::optional<ChosenLoop> chosen{};
  SpatialPath<3> path;
  LoopFacts facts;
  LoopJuncture juncture{};  ///< at the given length
};

/// Throws Error.
MadeLoop make_loop(const LoopRequest& request);

/// The document with its promises.
MadePath made_path(const MadeLoop& loop, const std::string& source);
/// Rows of the short table and of the report.
std::vector<std::pair<std::string, std::string>> rows_of(const MadeLoop& loop);

}  // namespace hodograph::cli
