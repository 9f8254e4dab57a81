// SPDX-License-Identifier: MIT
// Curves of known formula, as templates on their scalar.
#pragma once

#include <cmath>

#include "hodograph/algebra/vector.hpp"

namespace hodograph::test {

/// (numerator / denominator) as a scalar: decimal constants of a formula, exact in every scalar.
template <class S>
S fraction(int numerator, int denominator) {
  return S(static_cast<double>(numerator)) / S(static_cast<double>(denominator));
}

/// Curve (23) of PHODCOS: (1.5 sin 7.2ξ, cos 9ξ, e^(cos 1.8ξ)), ξ in [0, 1].
struct Curve23 {
  template <class S>
  Vector3<S> operator()(const S& xi) const {
    using std::cos;
    using std::exp;
    using std::sin;
    return {fraction<S>(3, 2) * sin(fraction<S>(36, 5) * xi), cos(S(9.0) * xi),
            exp(cos(fraction<S>(9, 5) * xi))};
  }
};

/// (cos ξ, sin ξ, ξ/4).
struct Helix {
  template <class S>
  Vector3<S> operator()(const S& xi) const {
    using std::cos;
    using std::sin;
    return {cos(xi), sin(xi), S(0.25) * xi};
  }
};

/// ((2 + cos 3ξ) cos 2ξ, (2 + cos 3ξ) sin 2ξ, sin 3ξ), closed on [0, 2π].
struct TorusKnot {
  template <class S>
  Vector3<S> operator()(const S& xi) const {
    using std::cos;
    using std::sin;
    const S radius = S(2) + cos(S(3) * xi);
    return {radius * cos(S(2) * xi), radius * sin(S(2) * xi), sin(S(3) * xi)};
  }
};

/// Viviani's curve (1 + cos ξ, sin ξ, 2 sin ξ/2), closed on [0, 4π].
struct Viviani {
  template <class S>
  Vector3<S> operator()(const S& xi) const {
    using std::cos;
    using std::sin;
    return {S(1) + cos(xi), sin(xi), S(2) * sin(S(0.5) * xi)};
  }
};

/// The unit circle in the plane z = 0.
struct Circle {
  template <class S>
  Vector3<S> operator()(const S& xi) const {
    using std::cos;
    using std::sin;
    return {cos(xi), sin(xi), S(0)};
  }
};

}  // namespace hodograph::test
