// SPDX-License-Identifier: MIT
// The parts of the extension module, one for each folder of the library.
#pragma once

#include <pybind11/pybind11.h>

namespace hodograph::python {

void bind_foundation(pybind11::module_& m);
void bind_path(pybind11::module_& m);
void bind_path_operations(pybind11::module_& m);
void bind_sampling(pybind11::module_& m);
void bind_offset(pybind11::module_& m);
void bind_rational_bezier(pybind11::module_& m);
void bind_sweep(pybind11::module_& m);
void bind_mesh(pybind11::module_& m);
void bind_bounds(pybind11::module_& m);
void bind_planar_analysis(pybind11::module_& m);
void bind_continuity(pybind11::module_& m);
void bind_roll(pybind11::module_& m);
void bind_frame(pybind11::module_& m);
void bind_spatial_construction(pybind11::module_& m);
void bind_planar_construction(pybind11::module_& m);
void bind_planar_curves(pybind11::module_& m);
void bind_turn_limited(pybind11::module_& m);
void bind_spatial_curves(pybind11::module_& m);
void bind_climb(pybind11::module_& m);
void bind_loop(pybind11::module_& m);
void bind_fit(pybind11::module_& m);
void bind_timing(pybind11::module_& m);
void bind_world(pybind11::module_& m);
void bind_planning(pybind11::module_& m);
void bind_plan(pybind11::module_& m);
void bind_timed_motion(pybind11::module_& m);
void bind_swarm(pybind11::module_& m);
void bind_document(pybind11::module_& m);
void bind_mission(pybind11::module_& m);
void bind_picture(pybind11::module_& m);
void bind_io(pybind11::module_& m);

}  // namespace hodograph::python
