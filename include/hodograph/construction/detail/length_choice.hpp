// SPDX-License-Identifier: MIT
// The preimage that prescribed_length_curve chooses, for constructions that make another curve of
// it.
#pragma once

#include <optional>

#include "hodograph/construction/detail/planar_solution.hpp"
#include "hodograph/construction/prescribed_length.hpp"

namespace hodograph::planar_detail {

/// As PrescribedLength, with the preimage in place of the curve.
struct LengthChoice {
  Preimage preimage{};
  double rotation_index = 0.0, margin = 0.0, unavoidable_rotation = 0.0;
  TieBreak tie = TieBreak::none;
  bool loop_free = true;
};

/// Fills `choice` in as prescribed_length_curve does, or gives its fault; whether the curve stays
/// in the range of numbers is not looked at.
std::optional<Fault> choose_length(const DirectedPoint& begin, const DirectedPoint& end,
                                   double length, double h, LengthSolutions among,
                                   LengthChoice& choice);

}  // namespace hodograph::planar_detail
