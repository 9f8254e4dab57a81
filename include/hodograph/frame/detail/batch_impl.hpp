// SPDX-License-Identifier: MIT
// The loop behind frame/batch.hpp.
#pragma once

#include <array>
#include <type_traits>

#include "hodograph/frame/batch.hpp"

namespace hodograph {

template <PreimageAlgebra A, std::size_t n>
void evaluate(const Path<A, n>& path, std::span<const typename A::Scalar> xi,
              const PathStateSpans<A>& out) {
  using namespace batch_detail;
  require_size(out.positions.size(), xi.size(), true, "positions");
  require_size(out.frames.size(), xi.size(), true, "frames");
  require_size(out.body_rates_per_xi.size(), xi.size(), true, "body rates");
  require_size(out.speeds.size(), xi.size(), true, "speeds");
  require_size(out.arc_lengths.size(), xi.size(), true, "arc lengths");
  require_inside(xi, path.xi_begin(), path.xi_end(), "path parameter xi");

  const bool oriented = !out.frames.empty() || !out.body_rates_per_xi.empty();
  const auto one = [&](std::size_t i, const PathLocation<typename A::Scalar>& at) {
    if (oriented) {
      const PathState<A> state = evaluate(path, at);
      if (!out.positions.empty()) out.positions[i] = state.position;
      if (!out.frames.empty()) out.frames[i] = state.frame;
      if (!out.body_rates_per_xi.empty()) out.body_rates_per_xi[i] = state.body_rate_per_xi;
      if (!out.speeds.empty()) out.speeds[i] = state.speed;
      if (!out.arc_lengths.empty()) out.arc_lengths[i] = state.arc_length;
    } else {
      const auto& curve = path.segment(at.segment);
      const CurvePoint<A> point = curve.evaluate(at.u);
      if (!out.positions.empty()) out.positions[i] = curve.start() + point.integral.displacement;
      if (!out.speeds.empty()) out.speeds[i] = speed_form(point.preimage, point.preimage);
      if (!out.arc_lengths.empty()) {
        out.arc_lengths[i] = at.u == typename A::Scalar(1)
                                 ? path.knot_arc_lengths()[at.segment + 1]
                                 : path.knot_arc_lengths()[at.segment] + point.integral.arc_length;
      }
    }
  };

  const Kernels* kernels = find_kernels<A, n>();
  for (std::size_t i = 0; i < xi.size();) {
    const auto at = path.locate(xi[i]);
    std::size_t count = 1;
    if constexpr (std::is_same_v<typename A::Scalar, double>) {
      if (kernels != nullptr) {
        const std::size_t k = at.segment;
        const double begin = path.knots()[k], step = path.knots()[k + 1] - begin;
        count = run_length(xi, i, begin, path.knots()[k + 1]);
        if (count >= shortest_run) {
          std::array<double, longest_run> u;
          for (std::size_t j = 0; j < count; ++j) u[j] = (xi[i + j] - begin) / step;
          if (kernels->states(data_of(path, k), u.data(), count,
                              {numbers(out.positions, i), numbers(out.frames, i),
                               numbers(out.body_rates_per_xi, i), numbers(out.speeds, i),
                               numbers(out.arc_lengths, i)})) {
            i += count;
            continue;
          }
        }
      }
    }
    one(i++, at);
    for (const std::size_t end = i + count - 1; i < end; ++i) one(i, path.locate(xi[i]));
  }
}

}  // namespace hodograph
