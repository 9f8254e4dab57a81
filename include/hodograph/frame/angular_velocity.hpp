// SPDX-License-Identifier: MIT
// How fast the Euler-Rodrigues frame turns, in every form: per unit ξ or per unit arc length, in
// body components (χ₁, χ₂, χ₃) or as a world vector. In the plane all of them are one number.
//
// With ' = d/dξ:   R' = R [χ]×,   χ = 2 vec(A* A')/|A|²,   ω = 2 vec(A' A*)/|A|² = R χ.
// Source: PHODCOS (12), which is per unit ξ; χ₁ = e₂'·e₃, χ₂ = e₃'·e₁, χ₃ = e₁'·e₂.
// Domain everywhere: σ > 0. Functions return the rate and its derivatives up to order K - 1 when
// the jet holds K derivatives of the preimage: with respect to ξ for the rates per ξ, with respect
// to arc length for those per arc length. Accuracy: a few ε times |A'|/|A| (the rate is a
// difference of such terms).
#pragma once

#include <array>
#include <cstddef>

#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/curve/preimage_jet.hpp"

namespace hodograph {

namespace rate_detail {

/// 2 form(A, A')/σ and its derivatives, for a form with form(X, X) = 0 that is antisymmetric:
/// d^r/dξ^r form(A, A') = Σ_j C(r,j) form(A^(j), A^(r-j+1)), then the quotient rule.
template <class A, std::size_t size, class Form>
constexpr auto quotient_rates(const std::array<A, size>& jet, const Form& form) {
  using S = typename A::Scalar;
  using Rate = decltype(form(jet[0], jet[0]));
  static_assert(size >= 2, "a rate needs the preimage and its derivative");
  const auto sigma = speed_derivatives(jet);
  const S reciprocal = S(1) / sigma[0];
  std::array<Rate, size - 1> rate;
  for (std::size_t r = 0; r + 1 < size; ++r) {
    // form(A, A')^(r) = Σ_{j<=r/2} (C(r,j) - C(r,j-1)) form(A^(j), A^(r+1-j)), pairing equal terms.
    Rate sum = form(jet[0], jet[r + 1]);
    for (std::size_t j = 1; 2 * j <= r; ++j) {
      const S weight(static_cast<double>(binomial(r, j) - binomial(r, j - 1)));
      sum = sum + weight * form(jet[j], jet[r + 1 - j]);
    }
    sum = S(2) * sum;
    for (std::size_t j = 0; j < r; ++j) {
      sum = sum - (S(static_cast<double>(binomial(r, j))) * sigma[r - j]) * rate[j];
    }
    rate[r] = reciprocal * sum;
  }
  return rate;
}

/// From a rate per ξ to the rate per arc length: f/σ, and its derivatives by d/ds = (1/σ) d/dξ.
template <class A, std::size_t size, class Rate, std::size_t count>
constexpr auto per_arc_length(const std::array<A, size>& jet, const std::array<Rate, count>& rate) {
  using S = typename A::Scalar;
  const auto sigma = speed_derivatives(jet);
  const S reciprocal = S(1) / sigma[0];
  // g = f/σ and its ξ-derivatives by the quotient rule, then d/ds twice at most.
  std::array<Rate, count> g;
  for (std::size_t r = 0; r < count; ++r) {
    Rate sum = rate[r];
    for (std::size_t j = 0; j < r; ++j) {
      sum = sum - (S(static_cast<double>(binomial(r, j))) * sigma[r - j]) * g[j];
    }
    g[r] = reciprocal * sum;
  }
  static_assert(count <= 3, "derivatives up to order 2");
  std::array<Rate, count> result;
  result[0] = g[0];
  if constexpr (count > 1) result[1] = reciprocal * g[1];
  if constexpr (count > 2) {
    const S r2 = reciprocal * reciprocal;
    result[2] = r2 * g[2] - (r2 * reciprocal * sigma[1]) * g[1];
  }
  return result;
}

}  // namespace rate_detail

/// χ = (χ₁, χ₂, χ₃) of the ERF, radians per unit ξ, with its derivatives with respect to ξ.
template <class A, std::size_t size>
constexpr auto body_rate_per_xi(const std::array<A, size>& jet) {
  return rate_detail::quotient_rates(jet,
                                     [](const A& a, const A& b) { return body_rate_form(a, b); });
}

/// ω as a world vector, radians per unit ξ, with its derivatives with respect to ξ.
template <class A, std::size_t size>
constexpr auto world_rate_per_xi(const std::array<A, size>& jet) {
  return rate_detail::quotient_rates(jet,
                                     [](const A& a, const A& b) { return world_rate_form(a, b); });
}

/// χ/σ, radians per unit arc length, with its derivatives with respect to arc length.
template <class A, std::size_t size>
constexpr auto body_rate_per_arc_length(const std::array<A, size>& jet) {
  return rate_detail::per_arc_length(jet, body_rate_per_xi(jet));
}

/// ω/σ, radians per unit arc length, with its derivatives with respect to arc length.
template <class A, std::size_t size>
constexpr auto world_rate_per_arc_length(const std::array<A, size>& jet) {
  return rate_detail::per_arc_length(jet, world_rate_per_xi(jet));
}

}  // namespace hodograph
