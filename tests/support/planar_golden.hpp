// SPDX-License-Identifier: MIT
// What the golden files of planar curves hold, as values of the library.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "hodograph/path/path.hpp"
#include "tests/support/json.hpp"

namespace hodograph::test {

inline Complex<double> complex_of(const Json& json) { return {json[0].number(), json[1].number()}; }
inline Vector2<double> vector2_of(const Json& json) { return {json[0].number(), json[1].number()}; }
/// The preimage of a quintic: three complex numbers.
inline BernsteinPolynomial<Complex<double>, 2> quintic_preimage(const Json& json) {
  return BernsteinPolynomial<Complex<double>, 2>(
      {complex_of(json[0]), complex_of(json[1]), complex_of(json[2])});
}

/// A path of one segment over a parameter interval of length `step`.
template <std::size_t n>
PlanarPath<n> path_of(const BernsteinPolynomial<Complex<double>, n>& preimage,
                      const Vector2<double>& start = {}, double step = 1.0) {
  return PlanarPath<n>::create({0.0, step}, {{start, preimage, step}}, false).value();
}

/// Whether x is within the tolerance of a golden file: relative to max(1, size).
inline bool agrees(double x, double expected, double rel_tol) {
  return std::abs(x - expected) <= rel_tol * std::max(1.0, std::abs(expected));
}

}  // namespace hodograph::test
