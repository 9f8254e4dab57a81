// SPDX-License-Identifier: MIT
// What carries a profile: a motion c(v), R(v) with a scale λ(v), piecewise polynomial data.
//
// A point p of the carried frame goes to  c + λ R p,  R = [B i B*, B j B*, B k B*]/|B|². Along a
// path, c is the path and B its preimage times a complex polynomial q on the right, whose argument
// is half the roll: e₁ is the tangent, and everything is rational. A roll that is not rational is
// carried beside it, as a FrameRoll.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/bernstein/dynamic_polynomial.hpp"
#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/frame/roll.hpp"
#include "hodograph/path/any_path.hpp"

namespace hodograph {

/// One piece, over the parameters [begin, end]; polynomials in its local parameter v in [0, 1].
struct MotionPiece {
  double begin = 0.0, end = 1.0;
  Vector3<double> start{};
  DynamicPolynomial<Vector3<double>> displacement;  ///< c = start + displacement
  DynamicPolynomial<Quaternion<double>> preimage;   ///< B
  DynamicPolynomial<double> scale{1.0};             ///< λ
};

/// Which frame goes along a path.
enum class MotionFrame {
  /// The Euler-Rodrigues frame; where it jumps by a roll at a knot, as on a path that is only G¹,
  /// later segments are rolled back.
  euler_rodrigues,
  /// The same, on a closed path turned so that it returns to itself: the leftover roll φ is taken
  /// away by the rational roll -2 arg((1 - t) + t e^(iφ/2)) in parts proportional to arc length.
  closing,
};

/// A path of the plane as one of space in z = 0, with the preimage a + b k for a + bi: its frame is
/// (tangent, left normal, k). A path of space as it is.
AnyPath in_space(const AnyPath& path);

/// Where a motion is and how it moves, per unit of a piece's local parameter.
struct MotionState {
  Vector3<double> position{}, velocity{};
  Frame3<double> frame{};
  Vector3<double> body_rate{};  ///< χ, of the frame as rolled
  double scale = 1.0, scale_rate = 0.0;
};

/// Bounds over a part of a piece, derivatives by the local parameter of that part; rounding
/// included.
struct MotionBounds {
  double acceleration = 0.0;  ///< ≥ |c''|
  double rate = 0.0;          ///< ≥ |χ|
  double rate_change = 0.0;   ///< ≥ |ω'|, ω the angular velocity as a vector
  double scale = 0.0, scale_rate = 0.0, scale_change = 0.0;  ///< ≥ |λ|, |λ'|, |λ''|
  double least_scale = 0.0;                                  ///< ≤ λ
  double least_advance = 0.0;                                ///< ≤ |c'|
  double rounding = 0.0;        ///< ≥ the error of a computed position c
  double frame_rounding = 0.0;  ///< ≥ the error of a computed unit vector of the frame
  /// χ₂ and χ₃ of the frame of the pieces (before a FrameRoll).
  Enclosure across_2{}, across_3{};
  bool is_bounded() const;
};

class Motion {
 public:
  /// Along a path, the scale λ given by its Bernstein coefficients over the whole of it (by ξ).
  /// Faults: outside_domain (no coefficient; one that is not finite; a scale that is not positive
  /// everywhere, or differs at the ends of a closed path), not_continuous (with the knot: tangents
  /// that break there by more than rounding; a frame that does not return on a closed path),
  /// zero_speed (the path stands still at a knot).
  static Result<Motion> along(const AnyPath& path, MotionFrame frame = MotionFrame::closing,
                              const std::vector<double>& scale = {1.0});
  /// The same with the Euler-Rodrigues frame as the path has it (no steps at knots are undone) and
  /// a roll of that path. None and periodic rolls are rational. Faults: as above; not_continuous
  /// also where the rolled frame jumps, as Frenet's does at an inflection (`value` is its ξ).
  static Result<Motion> along(const AnyPath& path, const FrameRoll& roll,
                              const std::vector<double>& scale = {1.0});
  /// Any polynomial motion with positive scale, of one piece over [0, 1]: the carrier of a tubular
  /// family S(t, u) = ρ(u) R(u) r(t) + c(u), R the rotation of Q(u).
  /// Faults: outside_domain (a scale that is not positive), zero_speed (Q vanishes), not_finite.
  static Result<Motion> polynomial(const DynamicPolynomial<Vector3<double>>& position,
                                   DynamicPolynomial<Quaternion<double>> rotation,
                                   const DynamicPolynomial<double>& scale);

  const std::vector<MotionPiece>& pieces() const { return pieces_; }
  bool is_closed() const { return closed_; }
  /// Whether e₁ is the tangent of c.
  bool is_adapted() const { return adapted_; }
  /// The roll beside the pieces' frames; null where there is none, and everything is rational.
  const FrameRoll* roll() const { return roll_.get(); }
  /// Largest scale, an upper bound.
  double largest_scale() const { return largest_scale_; }
  /// Smallest scale, a lower bound, positive.
  double least_scale() const { return least_scale_; }

  /// The state at v, and bounds over [a, b], of piece k. Domain: 0 ≤ v ≤ 1, 0 ≤ a < b ≤ 1.
  MotionState at(std::size_t k, double v) const;
  MotionBounds bounds(std::size_t k, double a, double b) const;

 private:
  Motion() = default;
  std::optional<Fault> set_scale(const std::vector<double>& scale);
  std::optional<Fault> check_frames() const;
  double roll_angle(std::size_t k, double v) const;
  double roll_rate(std::size_t k, double v) const;

  std::vector<MotionPiece> pieces_;
  std::shared_ptr<const FrameRoll> roll_;
  bool closed_ = false, adapted_ = true;
  double largest_scale_ = 1.0, least_scale_ = 1.0;
};

}  // namespace hodograph
