// SPDX-License-Identifier: MIT
// Everything a follower of a path asks at one point, in one evaluation.
#pragma once

#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// Position, ERF, its body rate per unit ξ, speed and arc length at one point of a path.
template <class A>
struct PathState {
  point_t<A> position{};
  frame_t<A> frame{};
  rate_t<A> body_rate_per_xi{};
  typename A::Scalar speed{};
  typename A::Scalar arc_length{};
};

/// The state at a location. Where the speed is zero the frame does not exist and Error with code
/// zero_speed is thrown. Accuracy: position and arc length within
/// accuracy::evaluation_error(2n + 1) of the largest coefficient.
template <PreimageAlgebra A, std::size_t n>
PathState<A> evaluate(const Path<A, n>& path, const PathLocation<typename A::Scalar>& at) {
  using S = typename A::Scalar;
  const auto& curve = path.segment(at.segment);
  const CurvePoint<A> point = curve.evaluate(at.u);
  const S sigma = speed_form(point.preimage, point.preimage);
  if (!(S(0) < sigma)) {
    throw Error(Fault{FaultCode::zero_speed,
                      "the path stands still at xi = " + to_text(to_double(path.xi_of(at))) +
                          ": no frame exists there",
                      at.segment, "speed", 0.0, std::nullopt});
  }
  const S reciprocal = S(1) / sigma;
  const S rate_scale = (S(2) * reciprocal) * (S(1) / curve.parameter_step());
  return {curve.start() + point.integral.displacement, reciprocal * scaled_frame(point.preimage),
          rate_scale * body_rate_form(point.preimage, point.preimage_rate), sigma,
          at.u == S(1) ? path.knot_arc_lengths()[at.segment + 1]
                       : path.knot_arc_lengths()[at.segment] + point.integral.arc_length};
}

/// The state at ξ. Domain: ξ inside the knots (throws outside_domain).
template <PreimageAlgebra A, std::size_t n>
PathState<A> evaluate(const Path<A, n>& path, const typename A::Scalar& xi) {
  return evaluate(path, path.locate(xi));
}

}  // namespace hodograph
