// SPDX-License-Identifier: MIT
// Result structs as Python classes: read-only properties, repr, and pickles of those that can be
// made without arguments.
#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/algebra/quaternion.hpp"
#include "python/src/convert.hpp"

namespace hodograph::python {

template <class T>
concept PointLike = requires {
  requires std::same_as<typename T::Scalar, double>;
  T::dimension;
};

/// Rows of points as an array of shape (n, dimension).
template <PointLike Point>
Doubles rows_of(const std::vector<Point>& points) {
  constexpr std::size_t d = Point::dimension;
  Doubles result(Shape{static_cast<py::ssize_t>(points.size()), static_cast<py::ssize_t>(d)});
  double* to = result.mutable_data();
  for (const Point& point : points) {
    for (std::size_t i = 0; i < d; ++i) *to++ = point[i];
  }
  return result;
}
inline Doubles array_of_numbers(std::span<const double> values) {
  return Doubles(static_cast<py::ssize_t>(values.size()), values.data());
}
/// A frame as a matrix whose columns are its axes, shape (3, 3).
inline Doubles matrix_of(const Frame3<double>& frame) {
  Doubles result(Shape{3, 3});
  double* to = result.mutable_data();
  for (std::size_t i = 0; i < 3; ++i) {
    for (const auto* axis : {&frame.e1, &frame.e2, &frame.e3}) *to++ = (*axis)[i];
  }
  return result;
}

/// How members of result structs look in Python, and how they are read back from a pickle.
template <class M>
struct Member {
  static M out(const M& value) { return value; }
  static M in(py::handle from) { return from.cast<M>(); }
};
template <PointLike Point>
struct Member<Point> {
  static Doubles out(const Point& value) { return array_of(value); }
  static Point in(py::handle from) { return point_of<Point>(from.cast<Doubles>(), "state"); }
};
template <PointLike Point>
struct Member<std::vector<Point>> {
  static Doubles out(const std::vector<Point>& value) { return rows_of(value); }
  static std::vector<Point> in(py::handle from) {
    return points_of<Point>(from.cast<Doubles>(), "state");
  }
};
template <>
struct Member<std::vector<double>> {
  static Doubles out(const std::vector<double>& value) { return array_of_numbers(value); }
  static std::vector<double> in(py::handle from) { return from.cast<std::vector<double>>(); }
};
template <std::size_t n>
struct Member<std::array<double, n>> {
  static Doubles out(const std::array<double, n>& value) { return array_of_numbers(value); }
  static std::array<double, n> in(py::handle from) { return from.cast<std::array<double, n>>(); }
};
template <std::size_t n>
struct Member<double[n]> {
  static Doubles out(const double (&value)[n]) { return array_of_numbers(value); }
};
template <>
struct Member<Frame3<double>> {
  static Doubles out(const Frame3<double>& value) { return matrix_of(value); }
  static Frame3<double> in(py::handle from) {
    const auto matrix = from.cast<Doubles>();
    if (matrix.ndim() != 2 || matrix.shape(0) != 3 || matrix.shape(1) != 3) {
      refuse_shape("state", "(3, 3)", matrix);
    }
    Frame3<double> frame{};
    for (py::ssize_t i = 0; i < 3; ++i) {
      const auto row = static_cast<std::size_t>(i);
      frame.e1[row] = matrix.at(i, 0);
      frame.e2[row] = matrix.at(i, 1);
      frame.e3[row] = matrix.at(i, 2);
    }
    return frame;
  }
};

/// "Name(first=..., second=...)" from the attributes of these names.
py::str repr_of(const py::object& self, const std::vector<const char*>& names);
/// The tuple of these attributes.
py::tuple state_of(const py::object& self, const std::vector<const char*>& names);
/// Throws Error (mismatched_size) where a pickle holds another number of members.
void require_members(const py::tuple& state, std::size_t count);

/// Declares a struct's class: Record<T>(m, "T", "...").field<&T::a>("a", "...").done().
template <class T>
class Record {
  template <class M>
  struct TypeOf;
  template <class M>
  struct TypeOf<M T::*> {
    using type = M;
  };

 public:
  Record(py::module_& m, const char* name, const char* doc) : class_(m, name, doc) {}

  /// A member, as a property.
  template <auto member>
  Record& field(const char* name, const char* doc = "") {
    using M = typename TypeOf<decltype(member)>::type;
    class_.def_property_readonly(
        name, [](const T& self) { return Member<M>::out(self.*member); }, doc);
    names().push_back(name);
    if constexpr (std::is_array_v<M>) {
      setters().push_back([](T& self, py::handle from) {
        const auto values = from.cast<std::array<double, std::extent_v<M>>>();
        std::copy(values.begin(), values.end(), std::begin(self.*member));
      });
    } else if constexpr (std::default_initializable<T>) {
      setters().push_back([](T& self, py::handle from) { self.*member = Member<M>::in(from); });
    }
    return *this;
  }
  /// What follows from the members, as a property; not part of the repr.
  template <class Function>
  Record& property(const char* name, const Function& function, const char* doc = "") {
    class_.def_property_readonly(name, function, doc);
    return *this;
  }

  py::class_<T> done() {
    class_.def("__repr__", [](const py::object& self) { return repr_of(self, names()); });
    if constexpr (std::default_initializable<T>) {
      class_.def(py::pickle([](const py::object& self) { return state_of(self, names()); },
                            [](const py::tuple& state) {
                              require_members(state, setters().size());
                              T value{};
                              for (std::size_t i = 0; i < setters().size(); ++i) {
                                setters()[i](value, state[i]);
                              }
                              return value;
                            }));
    }
    return class_;
  }

 private:
  static std::vector<const char*>& names() {
    static std::vector<const char*> all;
    return all;
  }
  using Setter = void (*)(T&, py::handle);
  static std::vector<Setter>& setters() {
    static std::vector<Setter> all;
    return all;
  }

  py::class_<T> class_;
};

}  // namespace hodograph::python
