// SPDX-License-Identifier: MIT
// One PH curve: the integral of a square. The one class behind every path of the library.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/curve/curve_integral.hpp"
#include "hodograph/curve/detail/integrand_form.hpp"
#include "hodograph/curve/preimage_jet.hpp"

namespace hodograph {

/// A PH curve of preimage degree n over an algebra, on the local parameter u in [0, 1]:
///
///   r(u) = start + h ∫₀ᵘ hodograph_form(A, A) dt      degree 2n + 1
///   s(u) =         h ∫₀ᵘ speed_form(A, A) dt          degree 2n + 1, the exact arc length
///
/// h > 0 is the parameter step: the length of the interval of the global parameter ξ that u
/// covers, so that A is in the global scaling, dr/dξ = A i A* (or w²), whatever the knots.
/// Invariant: |dr/dξ| = σ = |A|² ≥ 0 as polynomials.
///
/// Positions are held relative to the start: a far-away origin costs one rounding, not digits.
/// Evaluating outside [0, 1] is an error of the caller. Accuracy of a value of degree d:
/// accuracy::evaluation_error(d) times the largest coefficient.
template <PreimageAlgebra A, std::size_t n>
class PhCurve {
 public:
  using Algebra = A;
  using Scalar = typename A::Scalar;
  using Point = point_t<A>;
  static constexpr std::size_t preimage_degree = n;
  static constexpr std::size_t degree = 2 * n + 1;
  using Preimage = BernsteinPolynomial<A, n>;
  using Integral = BernsteinPolynomial<CurveIntegral<A>, degree>;

  constexpr PhCurve() = default;
  constexpr PhCurve(const Point& start, const Preimage& preimage, const Scalar& parameter_step)
      : start_(start),
        parameter_step_(parameter_step),
        preimage_(preimage),
        integral_(integral_of(preimage, parameter_step)) {
    for (const A& a : preimage_.coefficients()) {
      if (const Scalar bound = speed_form(a, a); speed_bound_ < bound) speed_bound_ = bound;
    }
  }

  /// The polynomials that define the curve, exact up to rounding.
  constexpr const Preimage& preimage() const { return preimage_; }
  /// dr/dξ = A i A* (or w²), of degree 2n.
  constexpr BernsteinPolynomial<Point, 2 * n> hodograph() const {
    return symmetric_square(preimage_, [](const A& a, const A& b) { return hodograph_form(a, b); });
  }
  /// σ = |A|², of degree 2n.
  constexpr BernsteinPolynomial<Scalar, 2 * n> speed_polynomial() const {
    return symmetric_square(preimage_, [](const A& a, const A& b) { return speed_form(a, b); });
  }
  /// (r - start, arc length from the start), of degree 2n + 1; its first coefficient is 0.
  constexpr const Integral& integral() const { return integral_; }
  /// r - start alone; a copy.
  constexpr BernsteinPolynomial<Point, degree> displacement() const {
    return integral_.mapped([](const CurveIntegral<A>& c) { return c.displacement; });
  }
  /// The arc length from the start alone; a copy.
  constexpr BernsteinPolynomial<Scalar, degree> arc_length_polynomial() const {
    return integral_.mapped([](const CurveIntegral<A>& c) { return c.arc_length; });
  }

  constexpr const Point& start() const { return start_; }
  constexpr Point end() const { return start_ + integral_.back().displacement; }
  /// h, the length of the ξ interval.
  constexpr const Scalar& parameter_step() const { return parameter_step_; }
  /// The arc length of the whole curve.
  constexpr const Scalar& arc_length() const { return integral_.back().arc_length; }

  /// r(u).
  constexpr Point position(const Scalar& u) const {
    return start_ + integral_.value(u).displacement;
  }
  /// σ(u) = |A(u)|², per unit ξ.
  constexpr Scalar speed(const Scalar& u) const {
    const A a = preimage_.value(u);
    return speed_form(a, a);
  }
  /// The arc length from the start to u: s(0) = 0, s(1) = arc_length() exactly.
  constexpr Scalar arc_length(const Scalar& u) const { return integral_.value(u).arc_length; }
  /// The largest |A_i|² of the preimage's coefficients: σ ≤ speed_bound() on [0, 1], up to
  /// rounding.
  constexpr const Scalar& speed_bound() const { return speed_bound_; }
  /// A, dA/du, displacement and arc length at u in one evaluation, which shares the powers of u and
  /// 1 - u; the same bits as the separate functions give.
  [[gnu::always_inline]] constexpr CurvePoint<A> evaluate(const Scalar& u) const {
    if (std::is_constant_evaluated()) return evaluate_by<PlainPair<Scalar>>(u);
    return evaluate_by<pair_of_t<Scalar>>(u);
  }

  /// The same without the displacement, which is left at zero.
  [[gnu::always_inline]] constexpr CurvePoint<A> evaluate_speed(const Scalar& u) const {
    if (std::is_constant_evaluated()) return evaluate_by<PlainPair<Scalar>, false>(u);
    return evaluate_by<pair_of_t<Scalar>, false>(u);
  }

  /// A and its derivatives with respect to ξ, at u.
  template <std::size_t K>
  constexpr PreimageJet<A, K> preimage_jet(const Scalar& u) const {
    PreimageJet<A, K> jet = preimage_.template jet<K>(u);
    Scalar scale(1);
    for (std::size_t r = 1; r <= K; ++r) {
      scale = scale / parameter_step_;
      jet[r] = scale * jet[r];
    }
    return jet;
  }

  /// The part on [a, b], 0 ≤ a < b ≤ 1, with its share of the parameter step.
  constexpr PhCurve restricted(const Scalar& a, const Scalar& b) const {
    return {position(a), preimage_.restricted(a, b), (b - a) * parameter_step_};
  }

  /// The same curve with a preimage written in degree m ≥ n.
  template <std::size_t m>
  constexpr PhCurve<A, m> elevated() const {
    return {start_, preimage_.template elevated<m>(), parameter_step_};
  }

  /// Equal in every defining number (the rest follows from them).
  friend constexpr bool operator==(const PhCurve& a, const PhCurve& b) {
    return a.start_ == b.start_ && a.parameter_step_ == b.parameter_step_ &&
           a.preimage_ == b.preimage_;
  }

 private:
  static constexpr Integral integral_of(const Preimage& preimage, const Scalar& h) {
    if (std::is_constant_evaluated()) {
      return curve_detail::curve_integral<PlainPair<Scalar>>(preimage, h);
    }
    return curve_detail::curve_integral<pair_of_t<Scalar>>(preimage, h);
  }

  template <class P, bool with_displacement = true>
  [[gnu::always_inline]] constexpr CurvePoint<A> evaluate_by(const Scalar& u) const {
    const UnitPowers<degree, P> powers(u);
    CurvePoint<A> result;
    if constexpr (n == 0) {
      result.preimage = preimage_[0];
    } else {
      const auto left = weighted_sum<n - 1>(powers, preimage_.coefficients(), 0);
      const auto right = weighted_sum<n - 1>(powers, preimage_.coefficients(), 1);
      const P both = powers[1];
      result.preimage = (both.second_twice() * left + both.first_twice() * right).value();
      result.preimage_rate = (P::both(Scalar(static_cast<double>(n))) * (right - left)).value();
    }
    if constexpr (with_displacement) {
      result.integral = weighted_sum<degree>(powers, integral_.coefficients(), 0).value();
    } else {
      result.integral.arc_length = mirrored_sum<degree>(
          powers, [&](std::size_t i) -> const Scalar& { return integral_[i].arc_length; });
    }
    return result;
  }

  Point start_{};
  Scalar parameter_step_{1};
  Scalar speed_bound_{0};
  Preimage preimage_{};
  Integral integral_{};
};

template <std::size_t n, class S = double>
using PlanarPhCurve = PhCurve<Complex<S>, n>;
template <std::size_t n, class S = double>
using SpatialPhCurve = PhCurve<Quaternion<S>, n>;

}  // namespace hodograph
