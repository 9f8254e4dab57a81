// SPDX-License-Identifier: MIT
// The state of a path at many parameters in one call: spans in, spans out, no allocation. How, and
// what holds of the results: path/batch.hpp.
#pragma once

#include <span>

#include "hodograph/frame/path_state.hpp"
#include "hodograph/path/batch.hpp"

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

}  // namespace hodograph

#include "hodograph/frame/detail/batch_impl.hpp"
