// SPDX-License-Identifier: MIT
// Path documents: io/document.hpp.
#include <string>

#include "hodograph/io/document.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"

namespace hodograph::python {

namespace {

PathDocument document_of(const AnyPath& path, const std::string& name,
                         const std::string& length_unit, const std::string& parameter_unit) {
  PathDocument document{path};
  document.name = name;
  document.length_unit = length_unit;
  document.parameter_unit = parameter_unit;
  return document;
}

}  // namespace

void bind_io(py::module_& m) {
  m.def(
      "to_json",
      [](const AnyPath& path, const std::string& name, const std::string& length_unit,
         const std::string& parameter_unit) {
        return to_json(document_of(path, name, length_unit, parameter_unit));
      },
      py::arg("path"), py::kw_only(), py::arg("name") = "", py::arg("length_unit") = "",
      py::arg("parameter_unit") = "", "The path document as JSON text; it reads back bit for bit.");
  m.def(
      "parse_document",
      [](const std::string& text) {
        return unlocked([&]() -> AnyPath { return parse_document(text).value().path; });
      },
      py::arg("text"), "The path of a document's JSON text.");
  m.def(
      "load_document",
      [](const std::string& file) {
        return unlocked([&]() -> AnyPath { return load_document(file).value().path; });
      },
      py::arg("file"), "The path of a document in a file.");
  m.def(
      "save_document",
      [](const AnyPath& path, const std::string& file, const std::string& name,
         const std::string& length_unit, const std::string& parameter_unit) {
        const auto document = document_of(path, name, length_unit, parameter_unit);
        if (const auto fault = unlocked([&] { return save_document(document, file); })) {
          throw Error(*fault);
        }
      },
      py::arg("path"), py::arg("file"), py::kw_only(), py::arg("name") = "",
      py::arg("length_unit") = "", py::arg("parameter_unit") = "",
      "Writes the path document, in one step: the old file is whole until the new one is.");
}

}  // namespace hodograph::python
