// SPDX-License-Identifier: MIT
// A picture of a triangle mesh as SVG, and a page around it: nothing else is needed to see it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "hodograph/surface/triangle_mesh.hpp"

namespace hodograph {

/// From where a mesh is seen, by parallel projection: the direction of the eye has this azimuth in
/// the xy plane and this elevation above it, radians; z points up.
struct MeshView {
  double azimuth = -0.7853981633974483;   ///< -π/4
  double elevation = 0.5235987755982988;  ///< π/6
  double width = 640.0, height = 480.0;   ///< pixels, at most
  double margin = 8.0;
  bool closed = true;  ///< leave out triangles that are seen from behind
};

/// The picture as an <svg> element: triangles from far to near, shaded by how they face the light
/// beside the eye. One path a triangle, about 60 bytes: take a coarse mesh.
std::string mesh_svg(const TriangleMesh& mesh, const MeshView& view = {});

}  // namespace hodograph
