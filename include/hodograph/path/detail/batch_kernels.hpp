// SPDX-License-Identifier: MIT
// The kernels behind batch.hpp: a run of points on one segment, on doubles. Compiled once for every
// instruction set (src/path/kernels) and chosen at run time.
#pragma once

#include <cstddef>

namespace hodograph::batch_detail {

/// One segment as plain numbers.
struct SegmentData {
  const double* preimage;  ///< n + 1 values of 2 or 4 numbers
  const double* integral;  ///< 2n + 2 values: displacement, then arc length
  const double* start;
  double step;                         ///< h
  double length_before, length_after;  ///< the arc length of the path at both ends
};

/// Where the results of a run go, from the first point of the run; null where not wanted.
struct StateTargets {
  double *positions, *frames, *rates, *speeds, *lengths;
};

/// The longest run a kernel is given.
inline constexpr std::size_t longest_run = 256;

/// Kernels for one algebra and degree. Runs are of 1 to longest_run points.
struct Kernels {
  /// Evaluates the run; false where a speed is zero (what it has written is then unspecified).
  bool (*states)(const SegmentData&, const double* u, std::size_t count, const StateTargets&);
  /// Points at the arc lengths t from the segment's start, 0 < t < length, from first guesses u.
  /// settled[i] = 0 marks the points that the caller is to compute one by one.
  void (*points)(const SegmentData&, const double* t, const double* u, std::size_t count,
                 double* points, unsigned char* settled);
  /// The same for u at the arc lengths t; `margin` as in arc_length_map.
  void (*parameters)(const SegmentData&, double margin, const double* t, const double* guess,
                     std::size_t count, double* u, unsigned char* settled);
};

/// The kernels of this processor for preimages of `dimension` numbers (2: plane, 4: space) and
/// degree n; null where none were compiled. The answer never changes while a program runs.
const Kernels* kernels_for(std::size_t dimension, std::size_t n);

/// The name of the instruction set in use: "baseline", "avx2" or "avx512".
const char* kernel_instruction_set();

}  // namespace hodograph::batch_detail
