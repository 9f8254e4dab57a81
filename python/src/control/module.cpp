// SPDX-License-Identifier: MIT
// hodograph._control: optimal control along paths, loaded when one of its names is first used.
#include "hodograph/control/code_generation.hpp"
#include "python/src/control/solving.hpp"

namespace hodograph::python {

std::vector<SolverSetting> settings_of(const py::dict& settings) {
  std::vector<SolverSetting> result;
  for (const auto& [name, value] : settings) {
    result.push_back({py::str(name).cast<std::string>(), py::str(value).cast<std::string>()});
  }
  return result;
}

void bind_code(py::module_& m) {
  Record<GeneratedCode>(m, "GeneratedCode",
                        "A header and a source file; the source includes the header by name.")
      .field("header_name", &GeneratedCode::header_name)
      .field("header", &GeneratedCode::header)
      .field("source_name", &GeneratedCode::source_name)
      .field("source", &GeneratedCode::source);
  m.attr("most_name_letters") = most_name_letters;
  m.def(
      "generate_code",
      [](const AnyPath& path, const std::string& name, bool casadi) {
        return unlocked([&] { return generate_code(path, {name, casadi}).value(); });
      },
      py::arg("path"), py::arg("name") = CodeOptions{}.name, py::kw_only(),
      py::arg("casadi") = false,
      "One path as C99 source: name_position(xi, order, result) and its fellows, whose values are "
      "the\nlibrary's bit for bit; casadi: also the functions that CasADi looks for. Raises "
      "HodographError: unsupported (the name).");
}

}  // namespace hodograph::python

PYBIND11_MODULE(_control, m) {
  using namespace hodograph::python;
  m.doc() = "Optimal control along paths: references, ascents, path following, generated code.";
  py::module_::import("hodograph._core");
  py::module_::import("hodograph._orbit");
  bind_reference(m);
  bind_code(m);
  bind_ascents(m);
  bind_following(m);
}
