// SPDX-License-Identifier: MIT
// Structs of the library as Python classes, from the list of their members: read-only properties,
// repr, ==, copies and pickles. What binds results includes this file.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "python/src/convert.hpp"

namespace hodograph::python {

/// How a member looks where it is not simply what pybind11 makes of it: numbers are an array (n,).
template <class M>
struct Shown {
  static constexpr bool as_array = false;
};
template <>
struct Shown<std::vector<double>> {
  static constexpr bool as_array = true;
};
template <std::size_t n>
struct Shown<std::array<double, n>> {
  static constexpr bool as_array = true;
};
template <std::size_t n>
struct Shown<double[n]> {
  static constexpr bool as_array = true;
};

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

/// Members as they are read back from a pickle.
template <class M>
void assign(M& to, py::handle from) {
  if constexpr (Shown<M>::as_array) {
    const auto values = numbers_of(from.cast<Doubles>(), "numbers");
    if constexpr (std::is_same_v<M, std::vector<double>>) {
      to = values;
    } else {
      if (values.size() != std::size(to))
        refuse_shape("numbers", std::to_string(std::size(to)), from.cast<Doubles>());
      std::copy(values.begin(), values.end(), std::begin(to));
    }
  } else if constexpr (std::derived_from<M, FloatOrArray>) {
    to = M(from.cast<Doubles>());
  } else {
    to = from.cast<M>();
  }
}
template <PreimageAlgebra A, std::size_t n>
void assign(Path<A, n>& to, py::handle from) {
  to = path_as<Path<A, n>>(from.cast<const AnyPath&>(), "a path of one kind");
}

/// The planar quintic from (0, 0) to (1, 0): what a result with a path holds until it is read.
AnyPath unit_line();

using MemberNames = std::shared_ptr<std::vector<std::string>>;

/// Adds repr from the named attributes of a value, and copies, which are the value itself.
void add_value_methods(py::handle type, MemberNames names);
/// a == b, where arrays and lists and tuples of them are equal if all of their elements are.
bool equal_values(const py::object& a, const py::object& b);
/// Whether the named attributes of two values are equal.
bool equal_members(const py::object& a, const py::object& b, const std::vector<std::string>& names);
/// The named attributes of a value.
py::tuple state_of_value(py::handle value, const std::vector<std::string>& names);
/// Throws Error (mismatched_size) where a pickle holds another number of members.
void require_members(const py::tuple& state, std::size_t count);

/// Declares a struct's class: Record<T>(m, "T", "...").field("a", &T::a, "..."). Members may be
/// registered classes, numbers, texts, points, enclosures, paths, optionals and lists of them;
/// those not listed keep the value that `initial` has when a pickle is read. A name that starts
/// with an underscore is stored and compared, but not shown.
template <class T>
class Record : public py::class_<T> {
 public:
  Record(py::handle scope, const char* name, const char* doc, const T& initial = T{})
      : py::class_<T>(scope, name, doc) {
    add_value_methods(*this, names_);
    this->def(
        "__eq__",
        [names = names_](const T& a, const T& b) {
          if constexpr (std::equality_comparable<T>) {
            return a == b;
          } else {
            return equal_members(py::cast(&a), py::cast(&b), *names);
          }
        },
        py::is_operator());
    this->attr("__hash__") = py::none();
    this->def(py::pickle(
        [names = names_](const py::object& value) { return state_of_value(value, *names); },
        [setters = setters_, initial](const py::tuple& state) {
          require_members(state, setters->size());
          T value = initial;
          for (std::size_t i = 0; i < setters->size(); ++i) (*setters)[i](value, state[i]);
          return value;
        }));
  }

  /// A member, as a property.
  template <class M, class Owner>
    requires std::derived_from<T, Owner>
  Record& field(const char* name, M Owner::*member, const char* doc = "") {
    if constexpr (Shown<M>::as_array) {
      this->def_property_readonly(
          name,
          [member](const T& value) { return array_of(std::span<const double>(value.*member)); },
          doc);
    } else {
      this->def_readonly(name, member, doc);
    }
    names_->emplace_back(name);
    setters_->push_back([member](T& value, py::handle from) { assign(value.*member, from); });
    return *this;
  }
  /// What follows from the members, as a property; not part of repr and pickle.
  template <class Function>
  Record& property(const char* name, const Function& function, const char* doc = "") {
    this->def_property_readonly(name, function, doc);
    return *this;
  }

 private:
  using Setters = std::vector<std::function<void(T&, py::handle)>>;
  MemberNames names_ = std::make_shared<std::vector<std::string>>();
  std::shared_ptr<Setters> setters_ = std::make_shared<Setters>();
};

}  // namespace hodograph::python
