// SPDX-License-Identifier: MIT
// Points and vectors of the plane and of space, with named components.
#pragma once

#include <cmath>
#include <cstddef>

#include "hodograph/foundation/scalar.hpp"

namespace hodograph {

/// A vector (or point) of the plane.
template <class S>
struct Vector2 {
  using Scalar = S;
  static constexpr std::size_t dimension = 2;
  S x{}, y{};

  constexpr S& operator[](std::size_t i) { return i == 0 ? x : y; }
  constexpr const S& operator[](std::size_t i) const { return i == 0 ? x : y; }

  friend constexpr Vector2 operator+(const Vector2& a, const Vector2& b) {
    return {a.x + b.x, a.y + b.y};
  }
  friend constexpr Vector2 operator-(const Vector2& a, const Vector2& b) {
    return {a.x - b.x, a.y - b.y};
  }
  friend constexpr Vector2 operator-(const Vector2& a) { return {-a.x, -a.y}; }
  friend constexpr Vector2 operator*(const S& s, const Vector2& a) { return {s * a.x, s * a.y}; }
  constexpr Vector2& operator+=(const Vector2& b) { return *this = *this + b; }
  constexpr Vector2& operator-=(const Vector2& b) { return *this = *this - b; }
  friend constexpr bool operator==(const Vector2&, const Vector2&) = default;
};

/// A vector (or point) of space.
template <class S>
struct Vector3 {
  using Scalar = S;
  static constexpr std::size_t dimension = 3;
  S x{}, y{}, z{};

  constexpr S& operator[](std::size_t i) { return i == 0 ? x : i == 1 ? y : z; }
  constexpr const S& operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : z; }

  friend constexpr Vector3 operator+(const Vector3& a, const Vector3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend constexpr Vector3 operator-(const Vector3& a, const Vector3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend constexpr Vector3 operator-(const Vector3& a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vector3 operator*(const S& s, const Vector3& a) {
    return {s * a.x, s * a.y, s * a.z};
  }
  constexpr Vector3& operator+=(const Vector3& b) { return *this = *this + b; }
  constexpr Vector3& operator-=(const Vector3& b) { return *this = *this - b; }
  friend constexpr bool operator==(const Vector3&, const Vector3&) = default;
};

template <class S>
constexpr S dot(const Vector2<S>& a, const Vector2<S>& b) {
  return a.x * b.x + a.y * b.y;
}
template <class S>
constexpr S dot(const Vector3<S>& a, const Vector3<S>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The third component of the vector product of two plane vectors; cross((1,0), (0,1)) = 1.
template <class S>
constexpr S cross(const Vector2<S>& a, const Vector2<S>& b) {
  return a.x * b.y - a.y * b.x;
}
/// The vector product; cross((1,0,0), (0,1,0)) = (0,0,1).
template <class S>
constexpr Vector3<S> cross(const Vector3<S>& a, const Vector3<S>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The plain vector norm √(a·a); overflows where a·a does.
template <class V>
auto norm(const V& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// The largest absolute component: a norm that cannot overflow.
template <class V>
typename V::Scalar largest_component(const V& a) {
  using std::abs;
  typename V::Scalar largest = abs(a[0]);
  for (std::size_t i = 1; i < V::dimension; ++i) {
    if (const auto size = abs(a[i]); largest < size) largest = size;
  }
  return largest;
}

/// True when every component is finite.
template <class V>
  requires requires { V::dimension; }
bool is_finite(const V& a) {
  for (std::size_t i = 0; i < V::dimension; ++i) {
    if (!is_finite(a[i])) return false;
  }
  return true;
}

}  // namespace hodograph
