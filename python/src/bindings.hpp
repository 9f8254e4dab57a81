// SPDX-License-Identifier: MIT
// The parts of the extension module, one for each folder of the library.
#pragma once

#include <pybind11/pybind11.h>

namespace hodograph::python {

void bind_foundation(pybind11::module_& m);
void bind_path(pybind11::module_& m);
void bind_path_operations(pybind11::module_& m);
void bind_frame(pybind11::module_& m);
void bind_spatial_construction(pybind11::module_& m);
void bind_planar_construction(pybind11::module_& m);
void bind_fit(pybind11::module_& m);
void bind_io(pybind11::module_& m);

}  // namespace hodograph::python
