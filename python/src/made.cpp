// SPDX-License-Identifier: MIT
#include "python/src/made.hpp"

namespace hodograph::python {

py::object make_again(py::handle type, const std::string& by, const py::tuple& of) {
  py::object maker = py::reinterpret_borrow<py::object>(type);
  if (!by.empty()) {
    maker = py::hasattr(type, by.c_str())
                ? type.attr(by.c_str())
                : py::module_::import(py::str(type.attr("__module__")).cast<std::string>().c_str())
                      .attr(by.c_str());
  }
  if (of.empty() || !py::isinstance<py::dict>(of[of.size() - 1])) return maker(*of);
  const py::tuple unnamed = of[py::slice(0, static_cast<py::ssize_t>(of.size()) - 1, 1)];
  return maker(*unnamed, **of[of.size() - 1].cast<py::dict>());
}

void add_equality_of_states(py::handle type) {
  type.attr("__eq__") = py::cpp_function(
      [](const py::object& self, const py::object& other) -> py::object {
        if (!py::type::of(self).is(py::type::of(other))) {
          return py::reinterpret_borrow<py::object>(Py_NotImplemented);
        }
        return py::bool_(equal_values(self.attr("__getstate__")(), other.attr("__getstate__")()));
      },
      py::name("__eq__"), py::is_method(type), py::arg("other"));
  type.attr("__hash__") = py::none();
}

}  // namespace hodograph::python
