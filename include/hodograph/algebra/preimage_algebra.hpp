// SPDX-License-Identifier: MIT
// The one place that decides what a PH curve is: the bilinear forms that turn a preimage into a
// hodograph, a parametric speed and a rate of rotation, for the plane and for space alike.
//
//   plane:  r' = w²       σ = |w|²    (complex numbers)
//   space:  r' = A i A*   σ = |A|²    (quaternions)
#pragma once

#include <concepts>

#include "hodograph/algebra/complex.hpp"
#include "hodograph/algebra/quaternion.hpp"

namespace hodograph {

/// An orthonormal frame of the plane, tangent first, normal to the left.
template <class S>
struct Frame2 {
  Vector2<S> e1{}, e2{};
  friend constexpr Frame2 operator+(const Frame2& a, const Frame2& b) {
    return {a.e1 + b.e1, a.e2 + b.e2};
  }
  friend constexpr Frame2 operator*(const S& s, const Frame2& a) { return {s * a.e1, s * a.e2}; }
  friend constexpr bool operator==(const Frame2&, const Frame2&) = default;
};

/// A right-handed orthonormal frame of space, tangent first (the columns of a rotation matrix), or
/// a derivative of one.
template <class S>
struct Frame3 {
  Vector3<S> e1{}, e2{}, e3{};
  friend constexpr Frame3 operator+(const Frame3& a, const Frame3& b) {
    return {a.e1 + b.e1, a.e2 + b.e2, a.e3 + b.e3};
  }
  friend constexpr Frame3 operator*(const S& s, const Frame3& a) {
    return {s * a.e1, s * a.e2, s * a.e3};
  }
  friend constexpr bool operator==(const Frame3&, const Frame3&) = default;
};

// ---- the hodograph form: symmetric, bilinear, form(A, A) = r' --------------------------------

/// a b, so that hodograph_form(w, w) = w².
template <class S>
constexpr Vector2<S> hodograph_form(const Complex<S>& a, const Complex<S>& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
/// (a i b* + b i a*)/2 = vec(a i b*), so that hodograph_form(A, A) = A i A*.
template <class S>
constexpr Vector3<S> hodograph_form(const Quaternion<S>& a, const Quaternion<S>& b) {
  return {(a.w * b.w + a.x * b.x) - (a.y * b.y + a.z * b.z),
          (a.x * b.y + a.y * b.x) + (a.w * b.z + a.z * b.w),
          (a.x * b.z + a.z * b.x) - (a.w * b.y + a.y * b.w)};
}

// ---- the speed form: symmetric, bilinear, form(A, A) = σ = |r'| -------------------------------

/// Re(a b*).
template <class A>
constexpr typename A::Scalar speed_form(const A& a, const A& b) {
  return dot(a, b);
}

// ---- rates of rotation -------------------------------------------------------------------------
// With A' the derivative of A, the angular velocity of the Euler-Rodrigues frame is
// 2 rate_form(A, A')/|A|²; bilinear, and zero on the diagonal.

/// In the plane the rate has one component: Im(a* b).
template <class S>
constexpr S body_rate_form(const Complex<S>& a, const Complex<S>& b) {
  return a.re * b.im - a.im * b.re;
}
/// In body components: vec(a* b).
template <class S>
constexpr Vector3<S> body_rate_form(const Quaternion<S>& a, const Quaternion<S>& b) {
  return {(a.w * b.x - a.x * b.w) - (a.y * b.z - a.z * b.y),
          (a.w * b.y - a.y * b.w) - (a.z * b.x - a.x * b.z),
          (a.w * b.z - a.z * b.w) - (a.x * b.y - a.y * b.x)};
}
/// In world components: in the plane the same number.
template <class S>
constexpr S world_rate_form(const Complex<S>& a, const Complex<S>& b) {
  return body_rate_form(a, b);
}
/// In world components: vec(b a*).
template <class S>
constexpr Vector3<S> world_rate_form(const Quaternion<S>& a, const Quaternion<S>& b) {
  return {(a.w * b.x - a.x * b.w) + (a.y * b.z - a.z * b.y),
          (a.w * b.y - a.y * b.w) + (a.z * b.x - a.x * b.z),
          (a.w * b.z - a.z * b.w) + (a.x * b.y - a.y * b.x)};
}
/// The twist form <b, a i>, the tangential body rate: the first component of vec(a* b).
template <class S>
constexpr S twist_form(const Quaternion<S>& a, const Quaternion<S>& b) {
  return (a.w * b.x - a.x * b.w) - (a.y * b.z - a.z * b.y);
}

// ---- the frame a preimage carries -----------------------------------------------------------

/// |w|² times the frame (tangent, left normal) of the plane preimage w.
template <class S>
constexpr Frame2<S> scaled_frame(const Complex<S>& w) {
  const Vector2<S> tangent = hodograph_form(w, w);
  return {tangent, {-tangent.y, tangent.x}};
}
/// |A|² times the Euler-Rodrigues frame: A i A*, A j A*, A k A*.
template <class S>
constexpr Frame3<S> scaled_frame(const Quaternion<S>& a) {
  const S ww = a.w * a.w, xx = a.x * a.x, yy = a.y * a.y, zz = a.z * a.z;
  const S wx = a.w * a.x, wy = a.w * a.y, wz = a.w * a.z;
  const S xy = a.x * a.y, xz = a.x * a.z, yz = a.y * a.z;
  const S two(2);
  return {{(ww + xx) - (yy + zz), two * (xy + wz), two * (xz - wy)},
          {two * (xy - wz), (ww + yy) - (xx + zz), two * (yz + wx)},
          {two * (xz + wy), two * (yz - wx), (ww + zz) - (xx + yy)}};
}

/// The derivative R [χ]× of a frame R that turns with body rate χ.
template <class S>
constexpr Frame2<S> frame_times_rate(const Frame2<S>& r, const S& chi) {
  return {chi * r.e2, -(chi * r.e1)};
}
template <class S>
constexpr Frame3<S> frame_times_rate(const Frame3<S>& r, const Vector3<S>& chi) {
  return {chi.z * r.e2 - chi.y * r.e3, chi.x * r.e3 - chi.z * r.e1, chi.y * r.e1 - chi.x * r.e2};
}

/// What a preimage's algebra must offer. Models: Complex<S>, Quaternion<S>.
template <class A>
concept PreimageAlgebra = requires(A a, A b, typename A::Scalar s) {
  { a + b } -> std::same_as<A>;
  { s* a } -> std::same_as<A>;
  hodograph_form(a, b);
  { speed_form(a, b) } -> std::same_as<typename A::Scalar>;
  body_rate_form(a, b);
  world_rate_form(a, b);
  scaled_frame(a);
};

/// The points, frames and angular velocities that go with a preimage algebra.
template <class A>
using point_t = decltype(hodograph_form(A{}, A{}));
template <class A>
using frame_t = decltype(scaled_frame(A{}));
template <class A>
using rate_t = decltype(body_rate_form(A{}, A{}));

}  // namespace hodograph
