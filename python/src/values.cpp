// SPDX-License-Identifier: MIT
#include "python/src/values.hpp"

#include <cmath>

namespace hodograph::python {

std::vector<double> numbers_of(const Doubles& array, const std::string& name) {
  if (array.ndim() != 1) refuse_shape(name, "(n,)", array);
  const auto all = numbers(array);
  return {all.begin(), all.end()};
}

AnyPath unit_line() {
  return AnyPath::create({2, 2, false, {0.0, 1.0}, {0.0, 0.0}, {1.0, 0.0, 1.0, 0.0, 1.0, 0.0}})
      .value();
}

void require_finite(std::span<const double> values, const std::string& name) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) {
      throw Error(Fault{
          FaultCode::not_finite,
          name + " should be finite; number " + std::to_string(i) + " is " + to_text(values[i]), i,
          name, values[i], std::nullopt});
    }
  }
}

namespace {

/// The text of a member in a repr: short arrays and lists in full, long ones by their shape.
std::string member_text(const py::handle& value) {
  constexpr py::ssize_t most_numbers = 4, most_items = 4;
  if (py::isinstance<py::array>(value)) {
    const auto array = py::reinterpret_borrow<py::array>(value);
    if (array.ndim() == 1 && array.size() <= most_numbers) {
      return py::repr(array.attr("tolist")());
    }
    return "<array of shape " + std::string(py::str(array.attr("shape"))) + ">";
  }
  if (py::isinstance<py::list>(value)) {
    const auto list = py::reinterpret_borrow<py::list>(value);
    if (static_cast<py::ssize_t>(list.size()) > most_items) {
      return "<list of " + std::to_string(list.size()) + ">";
    }
    std::string text = "[";
    for (const py::handle item : list) text += (text == "[" ? "" : ", ") + member_text(item);
    return text + "]";
  }
  return py::repr(value);
}

}  // namespace

void add_value_methods(py::handle type, std::shared_ptr<std::vector<std::string>> names) {
  const auto add = [&](const char* name, auto function, auto&&... extra) {
    type.attr(name) =
        py::cpp_function(std::move(function), py::name(name), py::is_method(type), extra...);
  };
  const auto text = [names = std::move(names)](const py::object& self) {
    std::string result = std::string(py::str(py::type::of(self).attr("__name__"))) + "(";
    for (const std::string& name : *names) {
      result +=
          (result.back() == '(' ? "" : ", ") + name + "=" + member_text(self.attr(name.c_str()));
    }
    return result + ")";
  };
  add("__repr__", text);
  add("__copy__", [](const py::object& self) { return self; });
  add(
      "__deepcopy__", [](const py::object& self, const py::dict&) { return self; },
      py::arg("memo"));
}

py::tuple state_of_value(py::handle value, const std::vector<std::string>& names) {
  py::tuple state(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) state[i] = value.attr(names[i].c_str());
  return state;
}

}  // namespace hodograph::python
