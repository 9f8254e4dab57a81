// SPDX-License-Identifier: MIT
// hodograph._core: the library as Python sees it. The package hodograph re-exports all of it.
#include "python/src/bindings.hpp"

PYBIND11_MODULE(_core, m) {
  using namespace hodograph::python;
  m.doc() = "Pythagorean-hodograph curves, paths and frames: the compiled part of hodograph.";
  bind_foundation(m);
  bind_path(m);
  bind_bounds(m);
  bind_planar_analysis(m);
  bind_path_operations(m);
  bind_frame(m);
  bind_sampling(m);
  bind_roll(m);
  bind_continuity(m);
  bind_rational_bezier(m);
  bind_offset(m);
  bind_sweep(m);
  bind_mesh(m);
  bind_spatial_construction(m);
  bind_planar_construction(m);
  bind_planar_curves(m);
  bind_turn_limited(m);
  bind_spatial_curves(m);
  bind_climb(m);
  bind_loop(m);
  bind_fit(m);
  bind_timing(m);
  bind_world(m);
  bind_planning(m);
  bind_plan(m);
  bind_timed_motion(m);
  bind_swarm(m);
  bind_document(m);
  bind_mission(m);
  bind_picture(m);
  bind_io(m);
}
