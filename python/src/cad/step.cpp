// SPDX-License-Identifier: MIT
// hodograph._cad: swept surfaces as STEP: cad/step.hpp.
#include "hodograph/cad/step.hpp"

#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <string>

#include "python/src/swept.hpp"

PYBIND11_MODULE(_cad, m) {
  using namespace hodograph;
  using namespace hodograph::python;
  m.doc() = "Swept surfaces as STEP files.";
  py::module_::import("hodograph._core");
  Record<StepModel>(m, "StepModel", "What a STEP file holds.")
      .field("text", &StepModel::text, "ISO 10303-21, application protocol AP214.")
      .field("faces", &StepModel::faces, "Surfaces and caps.")
      .field("solid", &StepModel::solid, "One closed solid, oriented outwards; else a shell.")
      .field("degree_along", &StepModel::degree_along, "The largest.")
      .field("degree_round", &StepModel::degree_round, "The largest.");
  m.attr("largest_cad_degree") = largest_cad_degree;
  m.def(
      "step_of",
      [](const Sweep& sweep, const std::string& name, const std::string& length_unit, bool caps) {
        return unlocked([&] { return step_of(sweep, {name, length_unit, caps}).value(); });
      },
      py::arg("sweep"), py::kw_only(), py::arg("name") = "", py::arg("length_unit") = "",
      py::arg("caps") = true,
      "A sweep as a STEP model: exact rational B-spline surfaces, sewn to a solid where they "
      "close. "
      "length_unit:\n\"mm\", \"cm\", \"m\", \"km\", \"in\", \"ft\". Raises HodographError: "
      "unsupported (degrees), not_written.");
  m.def(
      "save_step",
      [](const Sweep& sweep, const std::filesystem::path& file, const std::string& name,
         const std::string& length_unit, bool caps) {
        const std::string path = file.string();
        return unlocked([&] { return save_step(sweep, {name, length_unit, caps}, path).value(); });
      },
      py::arg("sweep"), py::arg("file"), py::kw_only(), py::arg("name") = "",
      py::arg("length_unit") = "", py::arg("caps") = true, "The same into a file, in one step.");
}
