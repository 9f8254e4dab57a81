// SPDX-License-Identifier: MIT
// Many arc lengths of a path in one call: spans in, spans out, no allocation. (The state of a path
// at many parameters: frame/batch.hpp.)
//
// Runs of points on one segment go through kernels with a point in each lane of a vector register,
// chosen at run time for the processor; sorted input makes long runs. Every result has the same
// bits as the single function's, whatever the processor and the order of the points.
#pragma once

#include <cstddef>
#include <span>

#include "hodograph/path/arc_length_map.hpp"

namespace hodograph {

/// parameter_at_arc_length(path, s[i]) for every i. Throws before anything is written.
template <PreimageAlgebra A, std::size_t n>
void parameters_at_arc_lengths(const Path<A, n>& path, std::span<const typename A::Scalar> s,
                               std::span<typename A::Scalar> xi);

/// point_at_arc_length(path, s[i]) for every i. Throws before anything is written.
template <PreimageAlgebra A, std::size_t n>
void points_at_arc_lengths(const Path<A, n>& path, std::span<const typename A::Scalar> s,
                           std::span<point_t<A>> points);

}  // namespace hodograph

#include "hodograph/path/detail/batch_impl.hpp"
