// SPDX-License-Identifier: MIT
// Swept surfaces: a profile carried along a motion, exactly.
//
//   S(v, u) = c(v) + λ(v) R(v) p(u)
//
// With a planar profile and the motion along a path this is the swept surface
// r + λ (p₁ e₂ + p₂ e₃); with a circle a tube; with a straight line a ribbon; with a curve in space
// and any polynomial motion a tubular family ρ(u) R(u) r(t) + c(u) (Farouki, Knez, Vitrih, Žagar,
// "Spatial C² closed loops of prescribed arc length defined by PH curves", section 5).
#pragma once

#include <vector>

#include "hodograph/foundation/result.hpp"
#include "hodograph/path/self_distance.hpp"
#include "hodograph/surface/motion.hpp"
#include "hodograph/surface/profile.hpp"
#include "hodograph/surface/rational_bezier.hpp"

namespace hodograph {

struct Sweep {
  Motion motion;
  Profile profile;
};

struct SurfacePoint {
  Vector3<double> position;
  Vector3<double> normal;  ///< unit; outwards for a closed planar profile
};

/// The point at v of a piece of the motion and w of a smooth piece of the profile, v, w in [0, 1].
/// Where S_u × S_v vanishes the normal is that of the profile in the frame. Accuracy: a few
/// evaluation errors of the path and the profile. Domain: the motion moves there.
SurfacePoint point_of(const Sweep& sweep, std::size_t piece, double v, std::size_t smooth_piece,
                      double w);

/// The surface as exact rational Bézier patches: pieces of the motion, and for each the pieces of
/// the profile, in order. Homogeneous: W = |B|² w,  W S = |B|² w c + λ (B p̂ B*), p̂ = w p, of
/// degree max(deg c + 2 deg B, deg λ + 2 deg B) along v and that of the profile along u: for a
/// polynomial path of preimage degree n and its ERF 4n + 1. Weights are positive; where those of a
/// piece are not, it is halved. Each coefficient to a few roundings of the largest product it is
/// made of.
/// Faults: unsupported (a frame whose roll is not rational), zero_speed (a piece that stands
/// still).
Result<std::vector<RationalPatch>> rational_patches(const Sweep& sweep);

/// The track of one point p of the frame, c + λ R p, as exact rational Bézier curves: an offset
/// track, the edge of a ribbon. One curve a piece of the motion (halved as above).
/// Faults: those of rational_patches; not_finite (the point, or a track out of the range of
/// numbers).
Result<std::vector<SpatialRationalBezier>> offset_track(const Motion& motion,
                                                        const Vector3<double>& point);

/// Whether the surface advances everywhere: S_v · e₁ > 0, so that cross-sections near each other do
/// not meet.
struct SweepFold {
  enum class Kind {
    none,      ///< certainly it advances
    certain,   ///< it certainly does not, at `xi`
    undecided  ///< within rounding, or after all subdivisions, at `xi`
  };
  Kind kind = Kind::none;
  double xi = 0.0;
};
/// Decided for motions along a path with planar profile by bounds of σ + λ (χ₂ p₂ - χ₃ p₁) over
/// parts of the path, halved until they decide. For other surfaces the answer is undecided.
SweepFold fold_of(const Sweep& sweep);

/// The outer radius of the sweep about the path, an upper bound: largest scale times reach.
double outer_radius(const Sweep& sweep);

/// Why a sweep may not be made: a tube (a circle about the path) that is not certainly free of
/// contact with itself, with the radius that would do; any other sweep that certainly folds, with
/// the factor of its profile that would do. Nothing where it may. Faults: outside_domain.
///
/// A sweep whose outer radius is below the tube radius is certainly free of contact, whatever its
/// profile (is_certainly_free); others may be by their extent in each direction
/// (surface/sweep_contact.hpp).
std::optional<Fault> contact_fault(const Sweep& sweep, const TubeRadius& tube);
bool is_certainly_free(const Sweep& sweep, const TubeRadius& tube);

}  // namespace hodograph
