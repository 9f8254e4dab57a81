// SPDX-License-Identifier: MIT
// Many points of a path in one call: spans in, spans out, no allocation.
//
// Runs of points on one segment go through kernels with a point in each lane of a vector register,
// chosen at run time for the processor; sorted input makes long runs. Every result has the same
// bits as the single function's, whatever the processor and the order of the points.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "hodograph/frame/path_state.hpp"
#include "hodograph/path/arc_length_map.hpp"

namespace hodograph {

/// Where evaluate() puts what: each span is empty (not wanted) or as long as the input. See
/// PathState for the quantities.
template <class A>
struct PathStateSpans {
  std::span<point_t<A>> positions{};
  std::span<frame_t<A>> frames{};
  std::span<rate_t<A>> body_rates_per_xi{};
  std::span<typename A::Scalar> speeds{};
  std::span<typename A::Scalar> arc_lengths{};
};

/// evaluate(path, xi[i]) for every i. Throws Error before anything is written where a span has the
/// wrong length (mismatched_size) or a parameter is outside the knots (outside_domain, with its
/// index). Where frames or rates are wanted and the path stands still at a parameter, Error
/// zero_speed is thrown when the evaluation gets there; results from that index on are unspecified.
template <PreimageAlgebra A, std::size_t n>
void evaluate(const Path<A, n>& path, std::span<const typename A::Scalar> xi,
              const PathStateSpans<A>& out);

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
