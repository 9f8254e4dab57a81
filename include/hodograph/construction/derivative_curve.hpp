// SPDX-License-Identifier: MIT
// Curves as fitting sees them: position and four derivatives anywhere; and how to make such a curve
// from a function template.
#pragma once

#include <functional>
#include <utility>

#include "hodograph/construction/hermite_data.hpp"
#include "hodograph/foundation/taylor.hpp"

namespace hodograph {

/// A curve that knows its derivatives: ξ -> (γ, γ', γ'', γ''', γ'''') at ξ.
using DerivativeCurve = std::function<HermitePoint<4>(double xi)>;

/// A curve given as a template on its scalar,
///   template <class S> Vector3<S> operator()(const S& xi) const,
/// written with unqualified sin, cos, sqrt, exp, ... after `using std::sin;` and so on.
template <class F>
concept AnalyticCurve = requires(const F& f, const Taylor<double, 4>& xi) {
  { f(xi) } -> std::convertible_to<Vector3<Taylor<double, 4>>>;
};

/// γ and its first m derivatives at ξ, exact up to rounding: forward differentiation.
template <std::size_t m, class S, class F>
HermitePoint<m, S> derivatives_of(const F& f, const S& xi) {
  const Vector3<Taylor<S, m>> value = f(Taylor<S, m>::variable(xi));
  HermitePoint<m, S> result;
  for (std::size_t r = 0; r <= m; ++r) {
    result[r] = {value.x.derivative(r), value.y.derivative(r), value.z.derivative(r)};
  }
  return result;
}

/// An analytic curve as a DerivativeCurve.
template <AnalyticCurve F>
DerivativeCurve differentiated(F f) {
  return [f = std::move(f)](double xi) { return derivatives_of<4, double>(f, xi); };
}

}  // namespace hodograph
