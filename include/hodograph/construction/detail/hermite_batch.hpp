// SPDX-License-Identifier: MIT
// Many C⁴ segments of order ten at once, a segment in each lane; compiled once for every
// instruction set (src/construction/kernels) and chosen at run time. The results have the bits that
// twist_free_segment gives one by one.
#pragma once

#include <cstddef>

#include "hodograph/construction/detail/hermite_kernel.hpp"
#include "hodograph/construction/hermite_data.hpp"

namespace hodograph::hermite_detail {

/// The most segments of one call.
inline constexpr std::size_t longest_batch = 64;

/// Segments k = 0 ... count - 1 between points k and k + 1 with steps[k] > 0; square is the scale
/// of the data (scale²). Domain: 1 ≤ count ≤ longest_batch; count + 1 points, finite.
void twist_free_segments(const HermitePoint<4>* points, const double* steps, double square,
                         std::size_t count, Segment<double, 4>* segments);

}  // namespace hodograph::hermite_detail
