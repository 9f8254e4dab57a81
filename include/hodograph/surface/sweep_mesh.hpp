// SPDX-License-Identifier: MIT
// Triangle meshes of swept surfaces within a chord tolerance: watertight, oriented, manifold.
#pragma once

#include <cstddef>

#include "hodograph/foundation/result.hpp"
#include "hodograph/surface/sweep.hpp"
#include "hodograph/surface/triangle_mesh.hpp"

namespace hodograph {

struct SweepMeshOptions {
  double tolerance = 0.0;                   ///< the largest distance from the surface, positive
  std::size_t most_triangles = 20'000'000;  ///< a mesh that needs more is refused
  bool caps = true;                         ///< close the ends of an open sweep with flat faces
};

struct SweepMesh {
  TriangleMesh mesh;
  /// No point of the mesh is further from the surface at the same parameters (nor the surface from
  /// the mesh), rounding of the vertices included: a bound, at most the tolerance.
  double deviation = 0.0;
  std::size_t rings = 0, columns = 0;  ///< vertices along the motion and round the profile
  std::size_t cap_triangles = 0;       ///< the last ones of the mesh, in two equal halves
};

/// The mesh: rings of the sampled profile, joined by triangles; a closed profile on a closed motion
/// gives a torus (its last ring is the first), on an open one a sphere with flat caps, an open
/// profile a surface with boundary. Outward normals for closed planar profiles; where the profile
/// has an edge of more than crease_angle, its sides have their own normals.
///
/// Tolerance: on a triangle whose legs are h_v along the motion and h_u along the profile, linear
/// interpolation is off by at most (h_v² |S_vv| + 2 h_v h_u |S_vu| + h_u² |S_uu|)/8 (Filip,
/// Magedson and Markot 1986). The second derivatives are bounded over parts of the motion from
/// Bernstein coefficients: |S_vv| ≤ |c''| + |p| (|λ''| + 2|λ'||χ| + λ (|ω'| + |χ|²)), |S_vu| ≤
/// (|λ'| + λ|χ|) |p'|, |S_uu| ≤ λ |p''|; the numbers of rings and columns are chosen so that the
/// bound holds with few triangles. A tolerance above a sixteenth of the profile's extent has no
/// further effect.
///
/// Faults: outside_domain (a tolerance that is not positive and finite), tolerance_not_reached
/// (more triangles than allowed, with their number; a tolerance below the rounding of the
/// vertices), zero_speed (the path stands still), unsupported (a profile of which the tolerance
/// merges distinct sides, so that no cap exists; caps on a profile in space are left out).
Result<SweepMesh> mesh_of(const Sweep& sweep, const SweepMeshOptions& options);

/// Tangents of a profile that turn by more than this, radians, make an edge: a degree, below which
/// shading does not show it.
inline constexpr double crease_angle = 0.017453292519943295;

}  // namespace hodograph
