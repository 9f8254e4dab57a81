// SPDX-License-Identifier: MIT
// Between NumPy arrays and the library: shapes, spans, batches of points, results; and how points,
// frames, polynomials and paths of a static type cross. Every file of the bindings includes it, so
// that all of them see the same conversions.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>
#include <concepts>
#include <cstddef>
#include <exception>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/algebra/quaternion.hpp"
#include "hodograph/algebra/vector.hpp"
#include "hodograph/bernstein/dynamic_polynomial.hpp"
#include "hodograph/foundation/interruption.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/any_path.hpp"

namespace hodograph::python {

namespace py = pybind11;

/// Any array-like of numbers, seen as doubles: copied only where it is not such an array already.
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Shape = std::vector<py::ssize_t>;

inline std::span<const double> numbers(const Doubles& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}
inline Shape shape_of(const Doubles& array) {
  return {array.shape(), array.shape() + array.ndim()};
}

/// Throws Error (mismatched_size) with what the array `name` should look like.
[[noreturn]] void refuse_shape(const std::string& name, const std::string& wanted,
                               const Doubles& got);

/// Points, complex numbers, quaternions: so many doubles.
template <class T>
concept PointLike = requires(const T& point) {
  requires std::same_as<typename T::Scalar, double>;
  T::dimension;
  { point[0] } -> std::convertible_to<double>;
};

/// The n rows of an array of shape (n, Point::dimension).
template <PointLike Point>
std::vector<Point> points_of(const Doubles& array, const std::string& name) {
  constexpr std::size_t d = Point::dimension;
  if (array.ndim() != 2 || array.shape(1) != static_cast<py::ssize_t>(d)) {
    refuse_shape(name, "(n, " + std::to_string(d) + ")", array);
  }
  std::vector<Point> points(static_cast<std::size_t>(array.shape(0)));
  const double* from = array.data();
  for (Point& point : points) {
    for (std::size_t i = 0; i < d; ++i) point[i] = *from++;
  }
  return points;
}

/// One point: an array of shape (Point::dimension,).
template <PointLike Point>
Point point_of(const Doubles& array, const std::string& name) {
  constexpr std::size_t d = Point::dimension;
  if (array.ndim() != 1 || array.shape(0) != static_cast<py::ssize_t>(d)) {
    refuse_shape(name, "(" + std::to_string(d) + ",)", array);
  }
  Point point{};
  for (std::size_t i = 0; i < d; ++i) point[i] = array.data()[i];
  return point;
}

/// A vector as the library takes it, of an array of shape (n,).
std::vector<double> numbers_of(const Doubles& array, const std::string& name);

/// Throws Error (not_finite) where a number is infinite or not a number.
void require_finite(std::span<const double> values, const std::string& name);

/// The numbers of a point or preimage as an array of shape (dimension,).
template <PointLike Point>
Doubles array_of(const Point& value) {
  Doubles result(static_cast<py::ssize_t>(Point::dimension));
  for (std::size_t i = 0; i < Point::dimension; ++i) result.mutable_data()[i] = value[i];
  return result;
}
/// Numbers as an array of shape (n,).
inline Doubles array_of(std::span<const double> values) {
  return Doubles(static_cast<py::ssize_t>(values.size()), values.data());
}
/// Rows of points as an array of shape (n, dimension).
template <PointLike Point>
Doubles array_of(const std::vector<Point>& points) {
  constexpr std::size_t d = Point::dimension;
  Doubles result(Shape{static_cast<py::ssize_t>(points.size()), static_cast<py::ssize_t>(d)});
  double* to = result.mutable_data();
  for (const Point& point : points) {
    for (std::size_t i = 0; i < d; ++i) *to++ = point[i];
  }
  return result;
}
/// A frame as a matrix whose columns are its axes, shape (3, 3).
Doubles array_of(const Frame3<double>& frame);
/// The coefficients of a polynomial, a row each.
template <class V>
Doubles array_of(const DynamicPolynomial<V>& polynomial) {
  return array_of(polynomial.coefficients());
}

/// The same way back: what an argument or the state in a pickle is read into.
template <PointLike Point>
void read_array(const Doubles& array, Point& to) {
  to = point_of<Point>(array, "a point");
}
template <PointLike Point>
void read_array(const Doubles& array, std::vector<Point>& to) {
  to = points_of<Point>(array, "points");
}
inline void read_array(const Doubles& array, std::vector<double>& to) {
  to = numbers_of(array, "numbers");
}
void read_array(const Doubles& array, Frame3<double>& to);
template <class V>
void read_array(const Doubles& array, DynamicPolynomial<V>& to) {
  std::vector<V> coefficients;
  read_array(array, coefficients);
  if (coefficients.empty()) refuse_shape("coefficients", "at least one row", array);
  to = DynamicPolynomial<V>(std::move(coefficients));
}

/// An array of the shape of `like` followed by `tail`, filled without the interpreter's lock by
/// fill(numbers of `like`, where the result goes).
template <class Fill>
Doubles filled_like(const Doubles& like, const Shape& tail, const Fill& fill) {
  Shape shape = shape_of(like);
  shape.insert(shape.end(), tail.begin(), tail.end());
  Doubles result(shape);
  const std::span<double> to(result.mutable_data(), static_cast<std::size_t>(result.size()));
  const auto from = numbers(like);
  {
    const py::gil_scoped_release unlocked;
    fill(from, to);
  }
  return result;
}

/// Doubles in any order in memory, for results that are views of others.
using Strided = py::array_t<double>;

/// A result whose type in signatures is `float | numpy.ndarray`: one number for one parameter, an
/// array for many. (Results that are py::object have no type in Python; use this.)
class FloatOrArray : public py::object {
 public:
  FloatOrArray(const Doubles& array)
      : py::object(array.ndim() == 0 ? py::object(py::float_(*array.data())) : py::object(array)) {}
  FloatOrArray(double number = 0.0) : py::object(py::float_(number)) {}
};

/// The same where one parameter may yield an array, too (angular velocities: a number in the plane,
/// a vector in space).
class ArrayOrFloat : public FloatOrArray {
  using FloatOrArray::FloatOrArray;
};

/// The same for one number a parameter: a float for a single one.
template <class Fill>
FloatOrArray numbers_like(const Doubles& like, const Fill& fill) {
  return filled_like(like, {}, fill);
}

/// A view of numbers that live as long as `owner`, which cannot be written through.
Doubles view_of(const double* data, const Shape& shape, py::handle owner);

/// Looks for Ctrl-C, and whatever else signals raise, on behalf of work without the lock.
class SignalWatch {
 public:
  /// Whether a signal raised something; looks at most every 20 ms, so that it may be called often.
  bool raised();
  /// Throws what was raised.
  void rethrow() const;

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::exception_ptr exception_;
};

/// What make() returns, or Error, made without the interpreter's lock; Ctrl-C ends it where the
/// library asks (foundation/interruption.hpp).
template <class Make>
auto unlocked(const Make& make) {
  SignalWatch watch;
  const auto run = [&] {
    const py::gil_scoped_release unlocked;
    const InterruptionScope scope([&watch] { return watch.raised(); });
    return make();
  };
  try {
    if constexpr (std::is_void_v<decltype(make())>) {
      run();
      watch.rethrow();
    } else {
      auto result = run();
      watch.rethrow();
      return result;
    }
  } catch (const Error&) {
    watch.rethrow();
    throw;
  }
}

}  // namespace hodograph::python

template <>
struct pybind11::detail::handle_type_name<hodograph::python::FloatOrArray> {
  static constexpr auto name = const_name("float | numpy.ndarray[numpy.float64]");
};
template <>
struct pybind11::detail::handle_type_name<hodograph::python::ArrayOrFloat> {
  static constexpr auto name = const_name("numpy.ndarray[numpy.float64] | float");
};

namespace pybind11::detail {

/// What is an array of doubles in Python.
template <class T>
struct hodograph_array_caster {
  using Doubles = hodograph::python::Doubles;
  PYBIND11_TYPE_CASTER(T, make_caster<Doubles>::name);
  bool load(handle source, bool) {
    const auto array = Doubles::ensure(source);
    if (!array) {
      PyErr_Clear();
      return false;
    }
    hodograph::python::read_array(array, value);
    return true;
  }
  static handle cast(const T& from, return_value_policy, handle) {
    return hodograph::python::array_of(from).release();
  }
};
template <hodograph::python::PointLike Point>
struct type_caster<Point> : hodograph_array_caster<Point> {};
template <hodograph::python::PointLike Point>
struct type_caster<std::vector<Point>> : hodograph_array_caster<std::vector<Point>> {};
template <class V>
struct type_caster<hodograph::DynamicPolynomial<V>>
    : hodograph_array_caster<hodograph::DynamicPolynomial<V>> {};
template <>
struct type_caster<hodograph::Frame3<double>> : hodograph_array_caster<hodograph::Frame3<double>> {
};

/// A path of a static type is a Path.
template <hodograph::PreimageAlgebra A, std::size_t n>
struct type_caster<hodograph::Path<A, n>> {
  static constexpr auto name = make_caster<hodograph::AnyPath>::name;
  static handle cast(const hodograph::Path<A, n>& path, return_value_policy, handle) {
    return pybind11::cast(hodograph::AnyPath(path)).release();
  }
};

}  // namespace pybind11::detail
