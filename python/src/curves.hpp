// SPDX-License-Identifier: MIT
// Single curves as paths of one segment.
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

}  // namespace hodograph::python
