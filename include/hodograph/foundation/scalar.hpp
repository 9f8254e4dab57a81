// SPDX-License-Identifier: MIT
// What the library asks of a number, and the few questions it puts to one.
//
// Models: double, long double, Boost.Multiprecision floats, Taylor<S, order> (forward
// differentiation), Enclosure (rigorous bounds). Algorithms call `sqrt`, `sin`, ... unqualified
// after `using std::sqrt;`, so that a scalar's own functions are found beside it.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace hodograph {

/// The real type behind a scalar: the type of its tolerances and of its exact constants.
/// The scalar itself, unless it carries derivatives (see taylor.hpp).
template <class S>
struct RealOf {
  using type = S;
};
template <class S>
using real_of_t = typename RealOf<S>::type;

/// A number that polynomials can have as coefficient: a commutative ring containing the integers.
template <class S>
concept RingScalar = requires(S a, S b) {
  { a + b } -> std::convertible_to<S>;
  { a - b } -> std::convertible_to<S>;
  { a* b } -> std::convertible_to<S>;
  { -a } -> std::convertible_to<S>;
  S(1);
};

/// A number the constructions work on: an ordered field with square roots.
template <class S>
concept Scalar = RingScalar<S> && requires(S a, S b) {
  { a / b } -> std::convertible_to<S>;
  { a < b } -> std::convertible_to<bool>;
};

/// Distance from 1 to the next larger number of the scalar's real type.
template <class S>
constexpr real_of_t<S> epsilon() {
  return std::numeric_limits<real_of_t<S>>::epsilon();
}

/// numerator / denominator, correctly rounded (the scalar's own division of two exact integers).
template <class S>
constexpr S ratio(std::int64_t numerator, std::int64_t denominator) {
  return S(static_cast<double>(numerator)) / S(static_cast<double>(denominator));
}

/// condition ? a : b. A scalar made of several lanes overloads it with a lane mask, so that code
/// written with it has no branch.
template <class T>
constexpr T select(bool condition, const T& a, const T& b) {
  return condition ? a : b;
}

/// The real value of a scalar without its derivatives.
template <class S>
constexpr const S& value_of(const S& x)
  requires std::same_as<S, real_of_t<S>>
{
  return x;
}

/// True when the value, and every derivative it carries, is neither infinite nor NaN.
template <class S>
bool is_finite(const S& x)
  requires(std::same_as<S, real_of_t<S>> && !requires { S::dimension; })
{
  if constexpr (std::is_floating_point_v<S>) {
    return std::isfinite(x);
  } else {
    const S zero = x - x;  // 0 for a finite number, NaN otherwise
    return zero == S(0);
  }
}

/// The nearest double to a scalar's value; for reports, never for computing.
template <class S>
double to_double(const S& x) {
  return static_cast<double>(value_of(x));
}

}  // namespace hodograph
