// SPDX-License-Identifier: MIT
// How smooth the Euler-Rodrigues frame and its angular velocity are at the knots of a path.
//
// Jumps are stated as in path/continuity.hpp, |f^(r)(ξ+) - f^(r)(ξ-)| h^r with the shorter step h;
// the frame has size 1 and needs no other scale, the world angular velocity per ξ has h^(r+1). What
// rounding may make of them follows from what it may make of the preimage, below.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/frame/angular_velocity.hpp"
#include "hodograph/path/continuity.hpp"

namespace hodograph {

/// The jumps at one knot. Where the path stands still there is no frame: every jump is then 1 with
/// nothing allowed.
template <class S>
struct FrameKnotJumps {
  ScaledJumps<S, 4> frame;  ///< R, R', R'', R'''
  ScaledJumps<S, 3>
      angular_velocity;  ///< ω, ω', ω''; the world vector, which no constant roll changes
};

/// The jumps at knot k. Domain: 1 ≤ k < N, or k = 0 on a closed path.
template <PreimageAlgebra A, std::size_t n>
FrameKnotJumps<typename A::Scalar> frame_jumps_at_knot(const Path<A, n>& path, std::size_t k);

/// The worst jumps over all inner knots, and the closing one of a closed path.
template <class S>
struct FrameContinuity {
  WorstJumps<S, 4> frame;
  WorstJumps<S, 3> angular_velocity;
};
template <PreimageAlgebra A, std::size_t n>
FrameContinuity<typename A::Scalar> frame_continuity(const Path<A, n>& path);

// ------------------------------------------------------------------------------------------------

namespace frame_detail {

/// A quantity's derivatives by size, and the error of each, relative to powers of |A| and 1/h.
template <class S, std::size_t count>
struct Sizes {
  std::array<S, count> size{}, error{};
};

/// f g^(r) for a bilinear form of norm 1: Σ_j C(r,j) f_j g_{r-j}, with first-order errors.
template <class S, std::size_t count>
Sizes<S, count> form_sizes(const Sizes<S, count>& f, const Sizes<S, count>& g) {
  Sizes<S, count> result;
  for (std::size_t r = 0; r < count; ++r) {
    for (std::size_t j = 0; j <= r; ++j) {
      const S weight(static_cast<double>(binomial(r, j)));
      result.size[r] = result.size[r] + weight * f.size[j] * g.size[r - j];
      result.error[r] =
          result.error[r] + weight * (f.error[j] * g.size[r - j] + f.size[j] * g.error[r - j]);
    }
  }
  return result;
}

/// (f/g)^(r) for a number g of size at least 1, by the quotient rule.
template <class S, std::size_t count>
Sizes<S, count> quotient_sizes(const Sizes<S, count>& f, const Sizes<S, count>& g) {
  Sizes<S, count> q;
  for (std::size_t r = 0; r < count; ++r) {
    q.size[r] = f.size[r];
    q.error[r] = f.error[r];
    for (std::size_t j = 0; j < r; ++j) {
      const S weight(static_cast<double>(binomial(r, j)));
      q.size[r] = q.size[r] + weight * g.size[r - j] * q.size[j];
      q.error[r] = q.error[r] + weight * (g.error[r - j] * q.size[j] + g.size[r - j] * q.error[j]);
    }
    q.error[r] = q.error[r] + g.error[0] * q.size[r];
  }
  return q;
}

/// |A^(r)| h^r / |A| and the jump it may have: accuracy::continuity_error in each of at most 4
/// components (norm 2), and 8 roundings for each form that it enters.
template <PreimageAlgebra A, std::size_t n, std::size_t count>
Sizes<typename A::Scalar, count> preimage_sizes(const std::array<A, count>& before,
                                                const std::array<A, count>& after,
                                                const typename A::Scalar& largest) {
  using S = typename A::Scalar;
  const S first = norm(before[0]), second = norm(after[0]);
  const S reciprocal = S(1) / (first < second ? first : second);
  Sizes<S, count> result;
  for (std::size_t r = 0; r < count; ++r) {
    const S a = norm(before[r]), b = norm(after[r]);
    result.size[r] = reciprocal * (a < b ? b : a);
    result.error[r] = S(2) * S(accuracy::continuity_error<S>(n, r)) * (largest * reciprocal) +
                      S(4) * S(epsilon<S>()) * result.size[r];
  }
  return result;
}

template <class S>
S largest_difference(const S& a, const S& b) {
  using std::abs;
  return abs(S(b - a));
}
template <class V>
  requires requires { V::dimension; }
auto largest_difference(const V& a, const V& b) {
  return largest_component(b - a);
}
template <class S>
S largest_difference(const Frame2<S>& a, const Frame2<S>& b) {
  return largest_component(b.e1 - a.e1);  // e₂ is e₁ turned
}
template <class S>
S largest_difference(const Frame3<S>& a, const Frame3<S>& b) {
  S largest = largest_component(b.e1 - a.e1);
  for (const S& other : {largest_component(b.e2 - a.e2), largest_component(b.e3 - a.e3)}) {
    if (largest < other) largest = other;
  }
  return largest;
}

}  // namespace frame_detail

template <PreimageAlgebra A, std::size_t n>
FrameKnotJumps<typename A::Scalar> frame_jumps_at_knot(const Path<A, n>& path, std::size_t k) {
  using S = typename A::Scalar;
  const auto [before, after, step] = path_detail::meeting_at(path, k);
  const auto end = path_detail::jet_in_steps<3>(*before, S(1), step);
  const auto begin = path_detail::jet_in_steps<3>(*after, S(0), step);
  FrameKnotJumps<S> result;
  if (!(S(0) < speed_form(end[0], end[0])) || !(S(0) < speed_form(begin[0], begin[0]))) {
    result.frame.jump.fill(S(1));
    result.angular_velocity.jump.fill(S(1));
    return result;
  }

  // With the sizes a_r = |A^(r)| h^r/|A|: σ and the numerator of R are forms of A with itself, the
  // numerator of ω is 2 form(A, A'); both are divided by σ.
  const S first = path_detail::largest_coefficient(before->preimage());
  const S second = path_detail::largest_coefficient(after->preimage());
  const auto a = frame_detail::preimage_sizes<A, n>(end, begin, first < second ? second : first);
  const auto square = frame_detail::form_sizes(a, a);
  frame_detail::Sizes<S, 4> derivative;
  for (std::size_t r = 0; r < 3; ++r) {
    derivative.size[r] = S(2) * a.size[r + 1];
    derivative.error[r] = S(2) * a.error[r + 1];
  }
  result.frame.allowed = frame_detail::quotient_sizes(square, square).error;
  const auto rate = frame_detail::quotient_sizes(frame_detail::form_sizes(a, derivative), square);

  const auto frame_before = euler_rodrigues_frame_derivatives(end);
  const auto frame_after = euler_rodrigues_frame_derivatives(begin);
  for (std::size_t r = 0; r < 4; ++r) {
    result.frame.jump[r] = frame_detail::largest_difference(frame_before[r], frame_after[r]);
  }
  const auto rate_before = world_rate_per_xi(end);
  const auto rate_after = world_rate_per_xi(begin);
  for (std::size_t r = 0; r < 3; ++r) {
    result.angular_velocity.jump[r] =
        frame_detail::largest_difference(rate_before[r], rate_after[r]);
    result.angular_velocity.allowed[r] = rate.error[r];
  }
  return result;
}

template <PreimageAlgebra A, std::size_t n>
FrameContinuity<typename A::Scalar> frame_continuity(const Path<A, n>& path) {
  FrameContinuity<typename A::Scalar> result;
  path_detail::for_each_meeting(path, [&](std::size_t k) {
    const auto jumps = frame_jumps_at_knot(path, k);
    result.frame.include(jumps.frame, k);
    result.angular_velocity.include(jumps.angular_velocity, k);
  });
  return result;
}

}  // namespace hodograph
