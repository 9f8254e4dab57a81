// SPDX-License-Identifier: MIT
// hodograph._rational: exact rational PH curves, loaded when one of its names is first used.
#include "python/src/rational/exact.hpp"

PYBIND11_MODULE(_rational, m) {
  using namespace hodograph::python;
  m.doc() = "Rational Pythagorean-hodograph curves, exactly.";
  py::module_::import("hodograph._core");
  bind_polynomials(m);
  bind_functions(m);
  bind_spaces(m);
  bind_curves(m);
  bind_hermite_preimages(m);
  bind_hermite_curves(m);
}
