// SPDX-License-Identifier: MIT
// Hermite data in space, and the choices that select one interpolant among many.
#pragma once

#include <array>
#include <cstddef>

#include "hodograph/algebra/vector.hpp"

namespace hodograph {

/// A point and its first m derivatives with respect to the path parameter: p, p', ..., p^(m).
template <std::size_t m, class S = double>
using HermitePoint = std::array<Vector3<S>, m + 1>;

/// Which of the interpolants to take.
enum class HermiteChoice {
  /// The end frames rotation-minimising to order m - 1 and the mean twist of the preimage zero:
  /// approximation order 2m + 2 (ten for C⁴ data). No standard form, no singular directions.
  order_ten,
  /// Every free parameter zero in the standard form of PHODCOS, Algorithm 1: order 4 for C¹ data
  /// and 6 for all others. Single arcs above 180° go the wrong way round, or are refused where they
  /// are symmetric.
  order_six,
};

/// The free parameters of PHODCOS, Section 5.C: angles (radians) on the fibres of A_0, A_n and
/// A_p, and the numbers τ of Lemma 1 for A_1, ..., A_{m-1} and, counted from the other end,
/// A_{n-1}, ..., A_{n-m+1} of the preimage in local scaling (√h A). All zero: order_six.
template <std::size_t m, class S = double>
struct HermiteParameters {
  S theta_begin{}, theta_middle{}, theta_end{};
  std::array<S, (m > 1 ? m - 1 : 1)> tau_begin{}, tau_end{};
};

/// What a construction of order_ten can say about its choice of roll.
enum class MeanTwist {
  zero,       ///< the mean twist vanishes, as it should
  minimised,  ///< no roll makes it vanish; the smallest was taken
};

}  // namespace hodograph
