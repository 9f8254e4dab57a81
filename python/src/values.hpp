// SPDX-License-Identifier: MIT
// Result structs as Python classes, from the list of their members: read-only properties, repr,
// pickle, and equality where C++ has it. Points are arrays, lists of points arrays (n, d), paths of
// any static type Path. What binds results includes this file.
#pragma once

#include <concepts>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python/src/convert.hpp"

namespace pybind11::detail {

/// One point or quaternion as an array of its numbers.
template <class Point>
struct hodograph_point_caster {
  using Doubles = hodograph::python::Doubles;
  PYBIND11_TYPE_CASTER(Point, make_caster<Doubles>::name);
  bool load(handle source, bool) {
    const auto array = Doubles::ensure(source);
    if (!array) {
      PyErr_Clear();
      return false;
    }
    value = hodograph::python::point_of<Point>(array, "a point");
    return true;
  }
  static handle cast(const Point& point, return_value_policy, handle) {
    return hodograph::python::array_of(point).release();
  }
};

/// Points as an array of shape (n, d).
template <class Point>
struct hodograph_points_caster {
  using Doubles = hodograph::python::Doubles;
  PYBIND11_TYPE_CASTER(std::vector<Point>, make_caster<Doubles>::name);
  bool load(handle source, bool) {
    const auto array = Doubles::ensure(source);
    if (!array) {
      PyErr_Clear();
      return false;
    }
    value = hodograph::python::points_of<Point>(array, "points");
    return true;
  }
  static handle cast(const std::vector<Point>& points, return_value_policy, handle) {
    constexpr std::size_t d = Point::dimension;
    Doubles result({static_cast<ssize_t>(points.size()), static_cast<ssize_t>(d)});
    double* to = result.mutable_data();
    for (const Point& point : points) {
      for (std::size_t i = 0; i < d; ++i) *to++ = point[i];
    }
    return result.release();
  }
};

/// A path of static type as a Path.
template <class P>
struct hodograph_path_caster {
  using AnyPath = hodograph::AnyPath;

 public:
  static constexpr auto name = make_caster<AnyPath>::name;
  static handle cast(const P& path, return_value_policy, handle) {
    return pybind11::cast(AnyPath(path)).release();
  }
};

template <>
struct type_caster<hodograph::Vector2<double>>
    : hodograph_point_caster<hodograph::Vector2<double>> {};
template <>
struct type_caster<hodograph::Vector3<double>>
    : hodograph_point_caster<hodograph::Vector3<double>> {};
template <>
struct type_caster<std::vector<hodograph::Vector2<double>>>
    : hodograph_points_caster<hodograph::Vector2<double>> {};
template <>
struct type_caster<std::vector<hodograph::Vector3<double>>>
    : hodograph_points_caster<hodograph::Vector3<double>> {};
template <std::size_t n>
struct type_caster<hodograph::PlanarPath<n>> : hodograph_path_caster<hodograph::PlanarPath<n>> {};
template <std::size_t n>
struct type_caster<hodograph::SpatialPath<n>> : hodograph_path_caster<hodograph::SpatialPath<n>> {};

}  // namespace pybind11::detail

namespace hodograph::python {

/// Numbers as an array of shape (n,).
inline Doubles array_of(const std::vector<double>& values) {
  return Doubles(static_cast<py::ssize_t>(values.size()), values.data());
}

/// A vector as the library takes it, of an array of shape (n,).
std::vector<double> numbers_of(const Doubles& array, const std::string& name);

template <class M>
void assign(M& to, py::handle from) {
  to = from.cast<M>();
}
inline void assign(std::vector<double>& to, py::handle from) {
  to = numbers_of(from.cast<Doubles>(), "numbers");
}
/// The planar quintic from (0, 0) to (1, 0): what a result with a path holds until it is read.
AnyPath unit_line();

/// Throws Error (not_finite) where a number is infinite or not a number.
void require_finite(std::span<const double> values, const std::string& name);

/// Throws Error (unsupported) where the path is of another kind than P.
template <class P>
const P& path_as(const AnyPath& path, const char* kind) {
  if (const P* found = path.get_if<P>()) return *found;
  throw Error(Fault{FaultCode::unsupported,
                    std::string("this is for ") + kind + "; the path is " +
                        (path.dimension() == 2 ? "planar" : "spatial") + " of degree " +
                        std::to_string(path.degree()),
                    std::nullopt, "path", static_cast<double>(path.degree()), std::nullopt});
}
inline void assign(PlanarPath<2>& to, py::handle from) {
  to = path_as<PlanarPath<2>>(from.cast<const AnyPath&>(), "planar quintics");
}

/// Adds repr from the named attributes of a value, and copies, which are the value itself.
void add_value_methods(py::handle type, std::shared_ptr<std::vector<std::string>> names);

/// The named attributes of a value.
py::tuple state_of_value(py::handle value, const std::vector<std::string>& names);

/// A class whose members are listed once. T is a struct; members may be registered classes,
/// numbers, texts, points, enclosures, optionals and lists of them.
template <class T>
class ValueClass : public py::class_<T> {
 public:
  ValueClass(py::handle scope, const char* name, const char* doc)
      : py::class_<T>(scope, name, doc) {
    add_value_methods(*this, names_);
    if constexpr (std::equality_comparable<T>) {
      this->def(
          "__eq__", [](const T& a, const T& b) { return a == b; }, py::is_operator());
      this->attr("__hash__") = py::none();
    }
  }

  template <class M>
  ValueClass& member(const char* name, M T::*pointer, const char* doc = "") {
    if constexpr (std::is_same_v<M, std::vector<double>>) {
      this->def_property_readonly(
          name, [pointer](const T& value) { return array_of(value.*pointer); }, doc);
    } else {
      this->def_readonly(name, pointer, doc);
    }
    names_->emplace_back(name);
    setters_.push_back([pointer](T& value, py::handle from) { assign(value.*pointer, from); });
    return *this;
  }

  /// Pickle by the members; call after all of them. What is read starts as `initial`.
  ValueClass& picklable(const T& initial = T{}) {
    const auto names = names_;
    this->def(py::pickle([names](const py::object& value) { return state_of_value(value, *names); },
                         [setters = setters_, initial](const py::tuple& state) {
                           T value = initial;
                           for (std::size_t i = 0; i < setters.size(); ++i) {
                             setters[i](value, state[i]);
                           }
                           return value;
                         }));
    return *this;
  }

 private:
  std::shared_ptr<std::vector<std::string>> names_ = std::make_shared<std::vector<std::string>>();
  std::vector<std::function<void(T&, py::handle)>> setters_;
};

}  // namespace hodograph::python
