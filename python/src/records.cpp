// SPDX-License-Identifier: MIT
#include "python/src/records.hpp"

namespace hodograph::python {

py::str repr_of(const py::object& self, const std::vector<const char*>& names) {
  std::string text = py::str(py::type::of(self).attr("__name__")).cast<std::string>() + "(";
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i > 0 ? ", " : "") + std::string(names[i]) + "=" +
            py::repr(self.attr(names[i])).cast<std::string>();
  }
  return py::str(text + ")");
}

py::tuple state_of(const py::object& self, const std::vector<const char*>& names) {
  py::tuple state(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) state[i] = self.attr(names[i]);
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
