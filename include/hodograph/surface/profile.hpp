// SPDX-License-Identifier: MIT
// Profiles: the curve p(u) that a sweep carries along a path, in the coordinates of its frame.
//
// A planar profile lies in the plane of e₂ and e₃: its (x, y) are the components along them. A
// closed one encloses the solid of a sweep: it must not touch itself, and is turned so that it runs
// counterclockwise about the tangent e₁. An open one makes a ribbon. Exact as rational Bézier
// pieces, the circle included: its quarters ((1 - t²), 2t)/(1 + t²) have coefficients that are
// doubles.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hodograph/foundation/result.hpp"
#include "hodograph/path/any_path.hpp"
#include "hodograph/surface/rational_bezier.hpp"

namespace hodograph {

/// A part of a profile with bounds of its derivatives by w, w in [0, 1] over that part.
struct ProfileInterval {
  std::size_t piece = 0;
  double begin = 0.0, end = 1.0;  ///< local parameters of the piece
  double first = 0.0;             ///< ≥ max |dp/dw|
  double second = 0.0;            ///< ≥ max |d²p/dw²|
};

class Profile {
 public:
  /// Whether a profile that touches or crosses itself is refused.
  enum class SelfContact { refuse, allow };

  /// The circle of this radius about the path. Faults: outside_domain (not positive and finite).
  static Result<Profile> circle(double radius);
  /// The ellipse with half axes `a` along e₂ and `b` along e₃. Faults: as circle.
  static Result<Profile> ellipse(double a, double b);
  /// The closed polygon with these corners, in order, convex or not.
  /// Faults: too_few (fewer than 3), and those of `of`.
  static Result<Profile> polygon(std::span<const Vector2<double>> corners);
  /// The open polyline: a ribbon from its first to its last point. Two points (-r, 0), (l, 0) make
  /// the ribbon whose edges are l to the left of the path (towards e₂) and r to its right.
  /// Faults: too_few (fewer than 2), and those of `of`.
  static Result<Profile> polyline(std::span<const Vector2<double>> points);
  /// Rational curves in sequence.
  /// Faults, with the index of the piece: too_few (no piece), mismatched_size (weights),
  /// not_finite, outside_domain (a weight that is not positive; a closed profile without area; one
  /// that reaches further than 2^500 or less far than 2^-500),
  /// not_continuous (a piece that starts elsewhere than the one before it ends, beyond
  /// accuracy::join_error; closed: also the last and the first), unsupported (it touches or crosses
  /// itself, or comes so near that rounding cannot tell).
  static Result<Profile> of(std::vector<RationalBezier> pieces, bool closed,
                            SelfContact contact = SelfContact::refuse);
  /// A planar path; closed as the path is. Faults: unsupported (a path in space), and those above.
  static Result<Profile> of(const AnyPath& path, SelfContact contact = SelfContact::refuse);
  /// Curves in space, for tubular families: components along e₁, e₂, e₃; crossings are not looked
  /// for. Faults: too_few, mismatched_size, not_finite, outside_domain, not_continuous.
  static Result<Profile> in_space(std::vector<SpatialRationalBezier> pieces, bool closed);
  /// A path in space (or in the plane z = 0), as such.
  static Result<Profile> in_space(const AnyPath& path);

  /// The exact pieces, x along e₁ (0 in a planar profile).
  const std::vector<SpatialRationalBezier>& pieces() const { return pieces_; }
  bool is_closed() const { return closed_; }
  bool is_planar() const { return planar_; }
  /// Where the profile is a circle about the path: its radius.
  const std::optional<double>& circle_radius() const { return circle_radius_; }
  /// An upper bound of |p|: the radius of a tube that holds the sweep at scale 1.
  double reach() const { return reach_; }
  /// An upper bound of the largest distance of two points of the profile.
  double extent() const { return extent_; }

  // ---- for meshes: as above, but a circle is one piece, by angle
  std::size_t smooth_piece_count() const { return circle_radius_ ? 1 : pieces_.size(); }
  struct Jet {
    Vector3<double> position, derivative;
  };
  /// p and dp/dw at w in [0, 1] of a smooth piece. Accuracy: evaluation_error of twice the degree.
  Jet at(std::size_t smooth_piece, double w) const;
  /// Parts that cover the profile, in order, with certified bounds (rounding included): the more
  /// even a piece's second derivative, the fewer.
  const std::vector<ProfileInterval>& intervals() const { return intervals_; }

 private:
  Profile() = default;
  void set_sizes();

  std::vector<SpatialRationalBezier> pieces_;
  bool closed_ = true, planar_ = true;
  std::optional<double> circle_radius_;
  double reach_ = 0.0, extent_ = 0.0;
  std::vector<ProfileInterval> intervals_;
};

}  // namespace hodograph
