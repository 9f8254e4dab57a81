// SPDX-License-Identifier: MIT
// Between NumPy arrays and the library: shapes, spans, batches of points, results. What every file
// of the bindings needs, and nothing else.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hodograph/algebra/vector.hpp"
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

/// The n rows of an array of shape (n, Point::dimension).
template <class Point>
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
template <class Point>
Point point_of(const Doubles& array, const std::string& name) {
  constexpr std::size_t d = Point::dimension;
  if (array.ndim() != 1 || array.shape(0) != static_cast<py::ssize_t>(d)) {
    refuse_shape(name, "(" + std::to_string(d) + ",)", array);
  }
  Point point{};
  for (std::size_t i = 0; i < d; ++i) point[i] = array.data()[i];
  return point;
}

/// The numbers of a point or preimage as an array of shape (dimension,).
template <class V>
Doubles array_of(const V& value) {
  Doubles result(static_cast<py::ssize_t>(V::dimension));
  for (std::size_t i = 0; i < V::dimension; ++i) result.mutable_data()[i] = value[i];
  return result;
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
  FloatOrArray(double number) : py::object(py::float_(number)) {}
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

/// The path, or Error, made without the interpreter's lock.
template <class Make>
auto unlocked(const Make& make) {
  const py::gil_scoped_release unlocked;
  return make();
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
