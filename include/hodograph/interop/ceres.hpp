// SPDX-License-Identifier: MIT
// The dual numbers of Ceres Solver (ceres::Jet) as a scalar: paths built and evaluated inside an
// automatically differentiated cost function, whose residuals then carry exact gradients.
//
// Nothing of Ceres is included or linked here; what follows names its type only. Include
// <ceres/jet.h>, or <ceres/ceres.h>, yourself. Another library's dual numbers are told in the same
// way: RealOf and ScalarOf in this namespace, value_of and is_finite beside the type.
#pragma once

#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/foundation/scalar.hpp"

namespace ceres {

template <typename T, int N>
struct Jet;

/// The value of a dual number without its derivatives. Exact.
template <typename T, int N>
constexpr const T& value_of(const Jet<T, N>& x) {
  return x.a;
}

/// True when the value and all N derivatives are neither infinite nor NaN.
template <typename T, int N>
bool is_finite(const Jet<T, N>& x) {
  using hodograph::is_finite;
  if (!is_finite(x.a)) return false;
  for (int i = 0; i < N; ++i) {
    if (!is_finite(x.v[i])) return false;
  }
  return true;
}

}  // namespace ceres

namespace hodograph {

/// Tolerances and exact constants are those of the value.
template <typename T, int N>
struct RealOf<ceres::Jet<T, N>> {
  using type = real_of_t<T>;
};

/// A number, not a vector, though it has a member type Scalar.
template <typename T, int N>
struct ScalarOf<ceres::Jet<T, N>> {
  using type = ceres::Jet<T, N>;
};

}  // namespace hodograph
