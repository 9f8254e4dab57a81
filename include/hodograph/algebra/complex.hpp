// SPDX-License-Identifier: MIT
// Complex numbers over any scalar: the preimage algebra of the plane.
// (std::complex is unspecified for scalars other than float, double and long double.)
#pragma once

#include "hodograph/algebra/vector.hpp"

namespace hodograph {

/// re + im i.
template <class S>
struct Complex {
  using Scalar = S;
  static constexpr std::size_t dimension = 2;
  S re{}, im{};

  constexpr S& operator[](std::size_t i) { return i == 0 ? re : im; }
  constexpr const S& operator[](std::size_t i) const { return i == 0 ? re : im; }

  friend constexpr Complex operator+(const Complex& a, const Complex& b) {
    return {a.re + b.re, a.im + b.im};
  }
  friend constexpr Complex operator-(const Complex& a, const Complex& b) {
    return {a.re - b.re, a.im - b.im};
  }
  friend constexpr Complex operator-(const Complex& a) { return {-a.re, -a.im}; }
  friend constexpr Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend constexpr Complex operator*(const S& s, const Complex& a) { return {s * a.re, s * a.im}; }
  constexpr Complex& operator+=(const Complex& b) { return *this = *this + b; }
  constexpr Complex& operator-=(const Complex& b) { return *this = *this - b; }
  friend constexpr bool operator==(const Complex&, const Complex&) = default;
};

template <class S>
constexpr Complex<S> conjugate(const Complex<S>& a) {
  return {a.re, -a.im};
}

/// The real inner product of two complex numbers as plane vectors, Re(a b*).
template <class S>
constexpr S dot(const Complex<S>& a, const Complex<S>& b) {
  return a.re * b.re + a.im * b.im;
}

}  // namespace hodograph
