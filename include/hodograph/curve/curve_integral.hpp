// SPDX-License-Identifier: MIT
// What a preimage's square integrates to: displacement and arc length, side by side, so that one
// sum evaluates both.
#pragma once

#include <cstddef>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/bernstein/polynomial.hpp"

namespace hodograph {

/// (∫ hodograph_form(A, A), ∫ speed_form(A, A)), or the integrand: a vector space of one dimension
/// more than the points have.
template <PreimageAlgebra A>
struct CurveIntegral {
  using Scalar = typename A::Scalar;
  static constexpr std::size_t dimension = point_t<A>::dimension + 1;
  point_t<A> displacement{};
  Scalar arc_length{};

  constexpr Scalar& operator[](std::size_t i) {
    return i + 1 < dimension ? displacement[i] : arc_length;
  }
  constexpr const Scalar& operator[](std::size_t i) const {
    return i + 1 < dimension ? displacement[i] : arc_length;
  }
  friend constexpr CurveIntegral operator+(const CurveIntegral& a, const CurveIntegral& b) {
    return {a.displacement + b.displacement, a.arc_length + b.arc_length};
  }
  friend constexpr CurveIntegral operator-(const CurveIntegral& a, const CurveIntegral& b) {
    return {a.displacement - b.displacement, a.arc_length - b.arc_length};
  }
  friend constexpr CurveIntegral operator*(const Scalar& s, const CurveIntegral& a) {
    return {s * a.displacement, s * a.arc_length};
  }
  friend constexpr bool operator==(const CurveIntegral&, const CurveIntegral&) = default;
};

/// What one evaluation of a PH curve at a local parameter u yields.
template <PreimageAlgebra A>
struct CurvePoint {
  A preimage{};                 ///< A(u)
  A preimage_rate{};            ///< dA/du
  CurveIntegral<A> integral{};  ///< displacement and arc length from the start of the curve
};

}  // namespace hodograph
