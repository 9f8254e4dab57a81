// SPDX-License-Identifier: MIT
// Values that Python keeps as how they were made: a maker's name and its arguments. They pickle as
// that, and are made again when they are read; those made alike of equal things are equal.
#pragma once

#include <string>
#include <utility>

#include "python/src/records.hpp"

namespace hodograph::python {

/// A T of the library, and what made it: the name of a static method of its class, or of a
/// function of the package, or "" for the class itself.
template <class T>
struct Made : T {
  Made(T value, std::string name, py::tuple arguments)
      : T(std::move(value)), by(std::move(name)), of(std::move(arguments)) {}

  std::string by;
  py::tuple of;
};

/// What arguments are kept as: arrays as copies, so that nobody changes them later.
inline py::object kept(const Doubles& array) { return array.attr("copy")(); }
inline py::object kept(const std::optional<Doubles>& array) {
  return array ? kept(*array) : py::none();
}
/// Paths and made values: the objects that the maker was called with.
inline py::object kept(const AnyPath& path) {
  return py::cast(&path, py::return_value_policy::reference);
}
template <class T>
py::object kept(const Made<T>& value) {
  return py::cast(&value, py::return_value_policy::reference);
}
template <class V>
py::object kept(const V& value) {
  if constexpr (std::derived_from<V, py::object>) {
    return value;
  } else {
    return py::cast(value);
  }
}

/// made(value, "name", arguments...).
template <class T, class... Arguments>
Made<T> made(T value, const char* by, const Arguments&... arguments) {
  return {std::move(value), by, py::make_tuple(kept(arguments)...)};
}

/// What `by` makes of `of`, for a class; a dict at the end of `of` holds named arguments.
py::object make_again(py::handle type, const std::string& by, const py::tuple& of);

/// Adds == to a class that pickles: equal where the states are.
void add_equality_of_states(py::handle type);

template <class T>
py::class_<Made<T>> made_class(py::module_& m, const char* name, const char* doc) {
  py::class_<Made<T>> type(m, name, doc);
  type.def("__copy__", [](const py::object& self) { return self; })
      .def(
          "__deepcopy__", [](const py::object& self, const py::dict&) { return self; },
          py::arg("memo"))
      .def(
          "__eq__",
          [](const Made<T>& a, const Made<T>& b) {
            return a.by == b.by && equal_values(a.of, b.of);
          },
          py::is_operator())
      .def(py::pickle([](const Made<T>& self) { return py::make_tuple(self.by, self.of); },
                      [](const py::tuple& state) {
                        require_members(state, 2);
                        return make_again(py::type::of<Made<T>>(), state[0].cast<std::string>(),
                                          state[1].cast<py::tuple>())
                            .template cast<Made<T>>();
                      }));
  return type;
}

}  // namespace hodograph::python

namespace pybind11::detail {

/// Arguments of functions: a Made<T> serves as a T, where type_caster<T> is derived from this.
/// (What is returned is Made.)
template <class T>
struct hodograph_made_caster {
  using Inner = make_caster<hodograph::python::Made<T>>;
  static constexpr auto name = Inner::name;
  template <typename>
  using cast_op_type = const T&;
  bool load(handle source, bool convert) { return inner.load(source, convert); }
  operator const T&() { return cast_op<const hodograph::python::Made<T>&>(inner); }
  Inner inner;
};

}  // namespace pybind11::detail
