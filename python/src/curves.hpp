// SPDX-License-Identifier: MIT
// Single curves as paths of one segment, and a path for results to be read into.
#pragma once

#include <array>
#include <cstddef>

#include "hodograph/path/any_path.hpp"

namespace hodograph::python {

/// A curve as an open path on [0, parameter step].
template <PreimageAlgebra A, std::size_t n>
AnyPath path_of(const PhCurve<A, n>& curve) {
  return Path<A, n>::create({0.0, curve.parameter_step()}, {curve}, false).value();
}

/// The straight line from (0, 0) to (1, 0): what a result holds until its own path is set.
inline AnyPath unit_path() {
  return path_of(PlanarPhCurve<0>(
      {0.0, 0.0},
      BernsteinPolynomial<Complex<double>, 0>(std::array<Complex<double>, 1>{{{1.0, 0.0}}}), 1.0));
}

}  // namespace hodograph::python
