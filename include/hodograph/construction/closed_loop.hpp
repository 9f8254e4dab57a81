// SPDX-License-Identifier: MIT
// Closed loops of prescribed length: the two-parameter family of single PH curves of degree 7 that
// return to their start with the same tangent, principal normal and curvature.
//
// Source: "Spatial C² closed loops of prescribed arc length defined by Pythagorean-hodograph
// curves", (20), (25)-(32), (34)-(37), with the limit members in homogeneous form and the turn of
// (37) in its right sense for ψ < 0 as well.
//
// Of the family (canonical: start at the origin, tangent i, principal normal j, length 1):
//   ξ = 0                       the torsion is continuous, too; symmetric about the line along j
//   ψ = 0 or ±π                 mirror symmetric in the plane x = 0
//   ξ = 0 and ψ = 0 or ±π       planar: a figure of eight, and an oval close to a circle
//   ξ = ±∞                      the limit members: planar, with a point of zero speed at the start
//   r(ξ, -ψ)(t) = diag(-1, 1, 1) r(ξ, ψ)(1-t), r(-ξ, -ψ) = diag(1, 1, -1) r(ξ, ψ),
//   r(-ξ, ψ)(t) = diag(-1, 1, -1) r(ξ, ψ)(1-t).
// Every member with finite ξ is regular: α and β have no common zero. How slow it gets is certified
// by speed_extremes (path/bounds.hpp).
#pragma once

#include <array>
#include <numbers>

#include "hodograph/construction/start_frame.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// Which member of the family. ψ in [-π, π] is half the roll of the frame round the loop; the
/// doubles next to ±π and π/2 stand for π and π/2 themselves, so that planar members are exactly
/// planar. ξ is any real number or ±infinity.
struct LoopShape {
  double xi = 0.0;
  double psi = std::numbers::pi;
  friend bool operator==(const LoopShape&, const LoopShape&) = default;
};

/// Where it is and how long. The frame is the Frenet frame at the start (for limit members the
/// limit of those): it turns i, j, k to tangent, principal normal and binormal.
struct LoopPlacement {
  double length = 1.0;
  Vector3<double> start{};
  Quaternion<double> frame{1.0, 0.0, 0.0, 0.0};
};

/// The loop as a closed path of one segment on [0, 1], its Euler-Rodrigues frame at the start equal
/// to the given frame (finite ξ).
/// Faults: not_finite (ψ, the start, the frame, a length; ξ not a number), outside_domain (ψ
/// outside [-π, π], a length that is not positive, a frame that is no rotation within
/// accuracy::unit_error), those of Path::create (a length out of range).
/// Accuracy: the preimage is within a few ε of the exact member, of its largest coefficient; the
/// length, the closure and the end derivatives likewise.
Result<SpatialPath<3>> closed_loop(const LoopShape& shape, const LoopPlacement& placement = {});

/// The Bézier control points of the canonical member in closed form, (32). Faults: those of the
/// shape, as above. Accuracy: a few ε of the largest.
Result<std::array<Vector3<double>, 8>> closed_loop_control_points(const LoopShape& shape);

/// Curvature and torsion where the loop closes, for length 1 (divide by the length for others):
///   κ = 6 λ/w³,  τ(0) = (-c0 ξ + d) f,  τ(1) = (c0 ξ + d) f,
///   d = 6 sin ψ + sin 2ψ,  f = -(260 - 144 cos ψ + 4 cos² ψ + 9 ξ²)/(20 c0²).
/// Infinite for limit members. Faults: those of the shape.
struct LoopJuncture {
  double curvature, torsion_begin, torsion_end;
};
Result<LoopJuncture> closed_loop_juncture(const LoopShape& shape);

}  // namespace hodograph
