// SPDX-License-Identifier: MIT
// Faults as Python exceptions, enclosures, the version.
#include <cstdio>
#include <string>
#include <utility>

#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/fault.hpp"
#include "hodograph/foundation/version.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"

namespace hodograph::python {

/// An iterator whose type in signatures says over what.
class Floats : public py::iterator {
 public:
  Floats(const py::iterator& all) : py::iterator(all) {}
};

}  // namespace hodograph::python

template <>
struct pybind11::detail::handle_type_name<hodograph::python::Floats> {
  static constexpr auto name = const_name("Iterator[float]");
};

namespace hodograph::python {

namespace {

/// hodograph.HodographError with the parts of the fault.
void raise_as_python(const Fault& fault) {
  const py::object type = py::module_::import("hodograph.errors").attr("HodographError");
  const auto maybe = [](const auto& value) -> py::object {
    return value ? py::cast(*value) : py::none();
  };
  const py::object error =
      type(fault.sentence, std::string(name_of(fault.code)), maybe(fault.index), fault.quantity,
           maybe(fault.value), maybe(fault.bound));
  PyErr_SetObject(type.ptr(), error.ptr());
}

std::string text_of(const Enclosure& e) {
  return "Enclosure(" + to_text(e.lower()) + ", " + to_text(e.upper()) + ")";
}

}  // namespace

void bind_foundation(py::module_& m) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(std::move(thrown));
    } catch (const Error& error) {
      raise_as_python(error.fault());
    }
  });
  m.attr("__version__") = version;

  py::class_<Enclosure>(m, "Enclosure",
                        "An interval [lower, upper] that contains the true value, rounding "
                        "included.")
      .def(py::init([](double lower, double upper) {
             if (!(lower <= upper)) {
               throw Error(Fault{FaultCode::outside_domain,
                                 "an enclosure runs from its lower to its upper end; got " +
                                     to_text(lower) + " and " + to_text(upper),
                                 std::nullopt, "lower", lower, upper});
             }
             return Enclosure(lower, upper);
           }),
           py::arg("lower"), py::arg("upper"))
      .def_property_readonly("lower", &Enclosure::lower)
      .def_property_readonly("upper", &Enclosure::upper)
      .def_property_readonly("middle", &Enclosure::middle)
      .def_property_readonly("width", &Enclosure::width)
      .def("contains", &Enclosure::contains, py::arg("x"), "True for lower <= x <= upper.")
      .def("__contains__", &Enclosure::contains)
      .def(
          "__eq__",
          [](const Enclosure& a, const Enclosure& b) {
            return a.lower() == b.lower() && a.upper() == b.upper();
          },
          py::is_operator())
      .def("__hash__",
           [](const Enclosure& e) { return py::hash(py::make_tuple(e.lower(), e.upper())); })
      .def("__iter__",
           [](const Enclosure& e) -> Floats {
             return py::iter(py::make_tuple(e.lower(), e.upper()));
           })
      .def("__repr__", text_of)
      .def(py::pickle(
          [](const Enclosure& e) { return py::make_tuple(e.lower(), e.upper()); },
          [](const py::tuple& t) { return Enclosure(t[0].cast<double>(), t[1].cast<double>()); }));
}

}  // namespace hodograph::python
