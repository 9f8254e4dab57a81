// SPDX-License-Identifier: MIT
#include "python/src/records.hpp"

namespace hodograph::python {

AnyPath unit_line() {
  return AnyPath::create({2, 2, false, {0.0, 1.0}, {0.0, 0.0}, {1.0, 0.0, 1.0, 0.0, 1.0, 0.0}})
      .value();
}

namespace {

/// The text of a member in a repr: short arrays and lists in full, long ones by their shape.
std::string member_text(const py::handle& value) {
  constexpr py::ssize_t most_numbers = 4, most_items = 4;
  constexpr std::size_t most_letters = 200;
  if (py::isinstance<py::array>(value)) {
    const auto array = py::reinterpret_borrow<py::array>(value);
    if (array.ndim() == 1 && array.size() <= most_numbers) {
      return py::repr(array.attr("tolist")());
    }
    return "<array of shape " + std::string(py::str(array.attr("shape"))) + ">";
  }
  if (py::isinstance<py::str>(value) && py::len(value) > most_letters) {
    return "<text of " + std::to_string(py::len(value)) + " characters>";
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

bool equal_values(const py::object& a, const py::object& b) {
  if (py::isinstance<py::array>(a) && py::isinstance<py::array>(b)) {
    return py::bool_(py::module_::import("numpy").attr("array_equal")(a, b));
  }
  const bool lists = py::isinstance<py::list>(a) && py::isinstance<py::list>(b);
  if (lists || (py::isinstance<py::tuple>(a) && py::isinstance<py::tuple>(b))) {
    const py::sequence first(a), second(b);
    if (first.size() != second.size()) return false;
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (!equal_values(first[i], second[i])) return false;
    }
    return true;
  }
  return a.equal(b);
}

void add_value_methods(py::handle type, MemberNames names) {
  const auto add = [&](const char* name, auto function, auto&&... extra) {
    type.attr(name) =
        py::cpp_function(std::move(function), py::name(name), py::is_method(type), extra...);
  };
  const auto text = [names = std::move(names)](const py::object& self) {
    std::string result = std::string(py::str(py::type::of(self).attr("__name__"))) + "(";
    for (const std::string& name : *names) {
      if (name.front() == '_') continue;
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

bool equal_members(const py::object& a, const py::object& b,
                   const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (!equal_values(a.attr(name.c_str()), b.attr(name.c_str()))) return false;
  }
  return true;
}

py::tuple state_of_value(py::handle value, const std::vector<std::string>& names) {
  py::tuple state(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) state[i] = value.attr(names[i].c_str());
  return state;
}

void require_members(const py::tuple& state, std::size_t count) {
  if (state.size() == count) return;
  throw Error(Fault{FaultCode::mismatched_size,
                    "a pickle of this version holds " + std::to_string(count) +
                        " members; this one has " + std::to_string(state.size()),
                    std::nullopt, "state", static_cast<double>(state.size()),
                    static_cast<double>(count)});
}

}  // namespace hodograph::python
