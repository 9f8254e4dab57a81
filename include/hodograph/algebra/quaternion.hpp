// SPDX-License-Identifier: MIT
// Quaternions over any scalar: the preimage algebra of space. Scalar part first.
#pragma once

#include "hodograph/algebra/vector.hpp"

namespace hodograph {

/// w + x i + y j + z k, with i j = k.
template <class S>
struct Quaternion {
  using Scalar = S;
  static constexpr std::size_t dimension = 4;
  S w{}, x{}, y{}, z{};

  constexpr S& operator[](std::size_t i) { return i == 0 ? w : i == 1 ? x : i == 2 ? y : z; }
  constexpr const S& operator[](std::size_t i) const {
    return i == 0 ? w : i == 1 ? x : i == 2 ? y : z;
  }

  friend constexpr Quaternion operator+(const Quaternion& a, const Quaternion& b) {
    return {a.w + b.w, a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend constexpr Quaternion operator-(const Quaternion& a, const Quaternion& b) {
    return {a.w - b.w, a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend constexpr Quaternion operator-(const Quaternion& a) { return {-a.w, -a.x, -a.y, -a.z}; }
  friend constexpr Quaternion operator*(const Quaternion& a, const Quaternion& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
            a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
  }
  friend constexpr Quaternion operator*(const S& s, const Quaternion& a) {
    return {s * a.w, s * a.x, s * a.y, s * a.z};
  }
  constexpr Quaternion& operator+=(const Quaternion& b) { return *this = *this + b; }
  constexpr Quaternion& operator-=(const Quaternion& b) { return *this = *this - b; }
  friend constexpr bool operator==(const Quaternion&, const Quaternion&) = default;
};

template <class S>
constexpr Quaternion<S> conjugate(const Quaternion<S>& a) {
  return {a.w, -a.x, -a.y, -a.z};
}

/// The real inner product of two quaternions as 4-vectors, Re(a b*).
template <class S>
constexpr S dot(const Quaternion<S>& a, const Quaternion<S>& b) {
  return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The vector part x i + y j + z k.
template <class S>
constexpr Vector3<S> vector_part(const Quaternion<S>& a) {
  return {a.x, a.y, a.z};
}

/// The pure quaternion with the given vector part.
template <class S>
constexpr Quaternion<S> pure(const Vector3<S>& v) {
  return {S(0), v.x, v.y, v.z};
}

/// a i: right multiplication by i.
template <class S>
constexpr Quaternion<S> times_i(const Quaternion<S>& a) {
  return {-a.x, a.w, a.z, -a.y};
}

/// A unit quaternion cos φ + i sin φ; on the right of a preimage it rolls the frame by 2φ and
/// leaves the curve alone.
template <class S>
struct Roll {
  S cosine{1}, sine{0};

  /// a (cos φ + i sin φ).
  friend constexpr Quaternion<S> operator*(const Quaternion<S>& a, const Roll& q) {
    return {a.w * q.cosine - a.x * q.sine, a.x * q.cosine + a.w * q.sine,
            a.y * q.cosine + a.z * q.sine, a.z * q.cosine - a.y * q.sine};
  }
};

/// The image a v a* of a vector: |a|² times the rotated vector.
template <class S>
constexpr Vector3<S> sandwich(const Quaternion<S>& a, const Vector3<S>& v) {
  return vector_part(a * pure(v) * conjugate(a));
}

}  // namespace hodograph
