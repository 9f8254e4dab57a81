// SPDX-License-Identifier: MIT
// Vectors, quaternions, frames and rows of points as those of Eigen, and back. Header only: link
// Eigen3::Eigen yourself. Everything is exact: numbers are copied, or looked at where they lie.
//
// Eigen stores a quaternion as (x, y, z, w) and its constructor takes (w, x, y, z), as here; the
// functions below go by name. A frame is the rotation matrix whose columns are its axes, tangent
// first; a pose is that with a position.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <type_traits>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/foundation/second_order.hpp"

namespace hodograph {

// ---- one at a time --------------------------------------------------------------------------

template <class S>
Eigen::Matrix<S, 2, 1> to_eigen(const Vector2<S>& a) {
  return {a.x, a.y};
}
template <class S>
Eigen::Matrix<S, 3, 1> to_eigen(const Vector3<S>& a) {
  return {a.x, a.y, a.z};
}
/// w + x i + y j + z k, of any length: Eigen's rotations expect length 1, a preimage seldom has it
/// (`.normalized()` is then the rotation of its frame).
template <class S>
Eigen::Quaternion<S> to_eigen(const Quaternion<S>& a) {
  return {a.w, a.x, a.y, a.z};
}
/// The matrix [e₁ e₂].
template <class S>
Eigen::Matrix<S, 2, 2> to_eigen(const Frame2<S>& frame) {
  Eigen::Matrix<S, 2, 2> result;
  result << to_eigen(frame.e1), to_eigen(frame.e2);
  return result;
}
/// The matrix [e₁ e₂ e₃].
template <class S>
Eigen::Matrix<S, 3, 3> to_eigen(const Frame3<S>& frame) {
  Eigen::Matrix<S, 3, 3> result;
  result << to_eigen(frame.e1), to_eigen(frame.e2), to_eigen(frame.e3);
  return result;
}
/// The rigid motion that takes the axes x, y to the frame and the origin to the position.
template <class S>
Eigen::Transform<S, 2, Eigen::Isometry> to_eigen(const Vector2<S>& position,
                                                 const Frame2<S>& frame) {
  Eigen::Transform<S, 2, Eigen::Isometry> result =
      Eigen::Transform<S, 2, Eigen::Isometry>::Identity();
  result.linear() = to_eigen(frame);
  result.translation() = to_eigen(position);
  return result;
}
/// The rigid motion that takes the axes x, y, z to the frame and the origin to the position.
template <class S>
Eigen::Transform<S, 3, Eigen::Isometry> to_eigen(const Vector3<S>& position,
                                                 const Frame3<S>& frame) {
  Eigen::Transform<S, 3, Eigen::Isometry> result =
      Eigen::Transform<S, 3, Eigen::Isometry>::Identity();
  result.linear() = to_eigen(frame);
  result.translation() = to_eigen(position);
  return result;
}

/// A vector, or a vector expression, of two or three components known when compiling.
template <class Derived>
auto from_eigen(const Eigen::MatrixBase<Derived>& a) {
  using S = typename Derived::Scalar;
  constexpr int size = Derived::SizeAtCompileTime;
  static_assert(Derived::IsVectorAtCompileTime && (size == 2 || size == 3),
                "a vector of two or three components, the size known when compiling");
  const Eigen::Matrix<S, size, 1> values = [&] {
    if constexpr (Derived::ColsAtCompileTime == 1) {
      return a.eval();
    } else {
      return a.transpose().eval();
    }
  }();
  if constexpr (size == 2) {
    return Vector2<S>{values[0], values[1]};
  } else {
    return Vector3<S>{values[0], values[1], values[2]};
  }
}
/// w + x i + y j + z k.
template <class Derived>
Quaternion<typename Derived::Scalar> from_eigen(const Eigen::QuaternionBase<Derived>& a) {
  return {a.w(), a.x(), a.y(), a.z()};
}
/// The columns of a 2 × 2 or 3 × 3 matrix as a frame. Whether they are orthonormal is the caller's
/// business.
template <class Derived>
auto frame_from_eigen(const Eigen::MatrixBase<Derived>& a) {
  using S = typename Derived::Scalar;
  constexpr int size = Derived::RowsAtCompileTime;
  static_assert((size == 2 || size == 3) && Derived::ColsAtCompileTime == size,
                "a matrix of 2 x 2 or 3 x 3, the size known when compiling");
  const Eigen::Matrix<S, size, size> columns = a;
  if constexpr (size == 2) {
    return Frame2<S>{from_eigen(columns.col(0)), from_eigen(columns.col(1))};
  } else {
    return Frame3<S>{from_eigen(columns.col(0)), from_eigen(columns.col(1)),
                     from_eigen(columns.col(2))};
  }
}

// ---- many at once ---------------------------------------------------------------------------

/// The points, Vector2 or Vector3, as the rows of a matrix (n, d), where they lie: nothing is
/// copied, and what is written into the matrix is written into the points, unless they are const.
/// Valid as long as they are.
template <class V>
auto rows_of(std::span<V> points) {
  using Point = std::remove_const_t<V>;
  using S = typename Point::Scalar;
  static_assert(std::is_same_v<Point, Vector2<S>> || std::is_same_v<Point, Vector3<S>>);
  static_assert(sizeof(V) == Point::dimension * sizeof(S) && std::is_standard_layout_v<V>);
  constexpr int columns = static_cast<int>(Point::dimension);
  using Rows = Eigen::Matrix<S, Eigen::Dynamic, columns, Eigen::RowMajor>;
  return Eigen::Map<std::conditional_t<std::is_const_v<V>, const Rows, Rows>>(
      points.empty() ? nullptr : &points.front().x, static_cast<Eigen::Index>(points.size()),
      columns);
}

// ---- derivatives ----------------------------------------------------------------------------

/// (∂f/∂z_1, ..., ∂f/∂z_N) of a scalar that carries its derivatives.
template <class S, std::size_t N>
Eigen::Matrix<S, static_cast<int>(N), 1> gradient_of(const SecondOrder<S, N>& f) {
  Eigen::Matrix<S, static_cast<int>(N), 1> result;
  for (std::size_t i = 0; i < N; ++i) result[static_cast<Eigen::Index>(i)] = f.gradient(i);
  return result;
}
/// The matrix of ∂²f/∂z_i∂z_j, both triangles.
template <class S, std::size_t N>
Eigen::Matrix<S, static_cast<int>(N), static_cast<int>(N)> hessian_of(const SecondOrder<S, N>& f) {
  Eigen::Matrix<S, static_cast<int>(N), static_cast<int>(N)> result;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
      result(row, column) = result(column, row) = f.hessian(i, j);
    }
  }
  return result;
}

}  // namespace hodograph
