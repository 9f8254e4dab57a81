// SPDX-License-Identifier: MIT
// hodograph._core: the library as Python sees it. The package hodograph re-exports all of it.
#include "python/src/bindings.hpp"

PYBIND11_MODULE(_core, m) {
  using namespace hodograph::python;
  m.doc() = "Pythagorean-hodograph curves, paths and frames: the compiled part of hodograph.";
  bind_foundation(m);
  bind_path(m);
  bind_path_operations(m);
  bind_frame(m);
  bind_spatial_construction(m);
  bind_planar_construction(m);
  bind_fit(m);
  bind_io(m);
}
