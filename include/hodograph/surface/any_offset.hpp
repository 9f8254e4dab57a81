// SPDX-License-Identifier: MIT
// Offsets of planar paths whose degree is known only when the program runs: what surface/offset.hpp
// offers, for AnyPath. Formulas, faults and accuracy are those of the functions of the same names
// there; what is said here is added. Compiled once, in the library. All throw Error (unsupported)
// for a path in space, or return it where they return a Result.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodograph/bernstein/rational_curve.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/any_path.hpp"
#include "hodograph/surface/offset.hpp"

namespace hodograph {

/// A piece of an offset, with positive weights; `curve` covers the parameters begin to end of the
/// path.
struct RationalOffsetPiece {
  std::size_t segment = 0;
  RationalBezier curve;
};

/// The pieces of the offset in sequence, of degree 4n + 1 for a path of preimage degree n.
/// Faults: also not_finite (index of the segment: a piece leaves the range of numbers).
Result<std::vector<RationalOffsetPiece>> rational_offset(const AnyPath& path, double distance);

/// In the preimage degrees 0, 2, 4 and 12: a path of another degree is first written in the next.
std::vector<OffsetCusp> offset_cusps(const AnyPath& path, double distance);
CuspFreeOffsets cusp_free_offsets(const AnyPath& path, const RangeGoal& goal);

/// r + d n at every ξ, two numbers each. Throws Error: also mismatched_size (of the spans).
void offset_positions(const AnyPath& path, double distance, std::span<const double> xi,
                      std::span<double> points);

}  // namespace hodograph
