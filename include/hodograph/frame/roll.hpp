// SPDX-License-Identifier: MIT
// The roll of an adapted frame against the Euler-Rodrigues frame (ERF), of every kind in one type:
// none, linear, Frenet, rotation-minimising, periodic and rational with γ, least twist.
//
// All of them have θ' = P/Q with polynomials P and Q on each segment (' = d/dξ):
//   none                 0
//   linear               the rate
//   Frenet               the turning of c, Im(c* c')/|c|², θ = arg c, c = V₃ - i V₂, V = vec(A* A')
//   rotation-minimising  -χ₁ = -2N/σ, N = <A', A i>: no rotation about the tangent
//   periodic             the turning of w², θ = 2 arg w, w = 1 - τ + γ τ e^(-iψ), τ =
//   (ξ-ξ_0)/(ξ_N-ξ_0) least twist          k σ - χ₁: the rotation about the tangent is k an arc
//   length
// Source: "Spatial C² closed loops of prescribed arc length ...", section 5; (33) of the paper on
// helical polynomial paths, with a continuous argument.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hodograph/foundation/result.hpp"
#include "hodograph/frame/preimage_table.hpp"
#include "hodograph/path/interval_index.hpp"

namespace hodograph {

enum class RollKind { none, linear, frenet, rotation_minimising, periodic, least_twist };

/// How the angle over a segment was found.
enum class RollMethod {
  polynomial,         ///< none and linear: exact
  argument,           ///< the argument of a complex polynomial: Frenet, periodic, and the
                      ///< rotation-minimising roll of helical segments, in closed form
  partial_fractions,  ///< complex logarithms at the roots of σ, in closed form
  quadrature,         ///< the sum of the integrals of certified series
};

/// How to integrate where there is a choice.
enum class RollIntegration {
  series,       ///< certified series: quicker, with a rigorous bound of what they leave out
  closed_form,  ///< partial fractions over whole segments, where their error is estimated small
};

/// A parameter where the curvature vanishes and the principal normal changes to its opposite (an
/// inflection), which the Frenet roll takes as a jump by π; within `rounding` of the true one.
struct FrenetInflection {
  double xi = 0.0;
  double rounding = 0.0;
};

/// A roll θ(ξ), radians, positive from e₂ to e₃; fits AdaptedFrame. A value; it does not refer to
/// the path. Domain of queries: ξ inside the knots (throws Error outside_domain).
///
/// On pieces of the segments θ is held as a polynomial in the parameter, so that a query costs tens
/// of nanoseconds, whatever the kind. Accuracy: error_bound().
class FrameRoll {
 public:
  static constexpr std::size_t piece_degree = 16;

  /// θ = 0: the ERF itself.
  static FrameRoll none(const PreimageTable& path) { return linear(path, 0.0, 0.0); }
  /// θ(ξ) = begin + rate (ξ - ξ_0), radians and radians per unit ξ. Domain: finite numbers.
  static FrameRoll linear(const PreimageTable& path, double begin, double rate);

  RollKind kind() const { return kind_; }
  const std::vector<double>& knots() const { return knots_; }
  std::size_t segment_count() const { return knots_.size() - 1; }
  RollMethod method(std::size_t segment) const { return segments_[segment].method; }

  /// θ(ξ).
  double angle(double xi) const;
  /// θ, θ', ..., θ^(K) by ξ, K ≤ 4. θ' is the quotient itself, not the derivative of the
  /// polynomials, so that the rates of the frame are correct to rounding.
  template <std::size_t K>
  std::array<double, K + 1> derivatives(double xi) const {
    std::array<double, K + 1> result;
    derivatives(xi, result);
    return result;
  }
  void derivatives(double xi, std::span<double> result) const;

  /// θ at the beginning and at the end of a segment: where the ERF itself jumps at a knot (a
  /// preimage that changes by a factor cos a + i sin a), the roll makes up for it.
  double angle_at_begin(std::size_t segment) const { return segments_[segment].begin; }
  double angle_at_end(std::size_t segment) const { return segments_[segment].end; }

  /// How far any θ(ξ) may be from that of the exact integral, starting from the same angle, for the
  /// path of the stored numbers: bounds of the series and of the closed forms, summed along the
  /// path, and the rounding of sums.
  double error_bound() const { return error_bound_; }

  /// Where the principal normal changes sides: Frenet only.
  const std::vector<FrenetInflection>& inflections() const { return inflections_; }
  /// γ and ψ of a periodic roll; k of a least twist (radians an arc length); the rate of a linear
  /// roll. 0 for others.
  double gamma() const { return gamma_; }
  double psi() const { return psi_; }
  double twist_rate() const { return twist_rate_; }
  double linear_rate() const { return linear_rate_; }

  /// A stretch of one segment, u in [begin, next begin], where
  /// θ = middle + Σ_{k≥1} coefficient[k-1] x^k, x = (u - center) scale in [-1, 1], |θ - middle| ≤
  /// π/4.
  struct Piece {
    double begin = 0.0, center = 0.5, scale = 2.0;
    double middle = 0.0;
    std::array<double, piece_degree> coefficient{};
  };
  /// The pieces of a segment; none where θ is linear.
  std::span<const Piece> pieces(std::size_t segment) const {
    return std::span<const Piece>(pieces_).subspan(
        segments_[segment].first_piece,
        segments_[segment].last_piece - segments_[segment].first_piece);
  }

 private:
  friend class RollBuilder;
  struct Segment {
    std::size_t first_piece = 0, last_piece = 0;
    double begin = 0.0, end = 0.0;
    RollMethod method = RollMethod::polynomial;
    std::vector<double> numerator, denominator;  ///< dθ/du
  };

  FrameRoll() = default;
  std::size_t locate(double xi, double& u) const;
  double angle(std::size_t segment, double u) const;

  RollKind kind_ = RollKind::none;
  std::vector<double> knots_;
  IntervalIndex<double> index_;
  std::vector<Segment> segments_;
  std::vector<Piece> pieces_;
  std::vector<FrenetInflection> inflections_;
  double error_bound_ = 0.0;
  double gamma_ = 0.0, psi_ = 0.0, twist_rate_ = 0.0, linear_rate_ = 0.0;
};

/// The rotation-minimising roll, θ(ξ_0) = begin: θ' = -χ₁, continuous over knots; where the ERF
/// jumps by a roll at a knot, θ jumps back, so that the frame is continuous.
/// Closed form on helical segments, θ = -2 sin(angle to the plane across the axis) arg w with the
/// continuous argument. Elsewhere by certified series, or over whole segments by partial fractions
/// where their error is estimated (from above) below 2^-39 (1 + |change|), and by series otherwise:
/// see method().
/// Faults: not_finite (begin), zero_speed (index: the segment where σ may vanish), not_continuous
/// (index: the knot where the tangent breaks).
Result<FrameRoll> rotation_minimising_roll(const PreimageTable& path, double begin = 0.0,
                                           RollIntegration integration = RollIntegration::series);

/// The same, quicker where an accuracy is enough (radians): error_bound() ≤ accuracy. The series
/// are as short as that allows, whole path at once: their errors are shared by the segments.
/// Faults: as above; outside_domain (an accuracy that is not positive), tolerance_not_reached
/// (rounding alone is more; `bound` is what would do).
Result<FrameRoll> rotation_minimising_roll_within(const PreimageTable& path, double accuracy,
                                                  double begin = 0.0);

/// The roll whose e₂ is the principal normal. Where the curvature vanishes along the way the
/// normal turns to its opposite and θ jumps by π (inflections()); at a knot it may jump by
/// anything, as the normal does. At the ends of segments the limits are taken.
/// Zero means: |c| within its rounding, (11 + 3 deg c) ε M², M the largest |A_i|.
/// Faults: zero_speed, outside_domain (index: the segment that is straight).
Result<FrameRoll> frenet_roll(const PreimageTable& path);

/// The periodic rational frame of a closed path with γ ≠ 0: e^(iψ) is the turn of the preimage,
/// A(ξ_N) = c A(ξ_0) (cos ψ + i sin ψ), ψ in (-π, π].
/// Faults: unsupported (an open path), not_continuous (the tangent does not return; a preimage that
/// jumps at a knot), outside_domain (γ = 0 or not finite; sin ψ = 0 with γ of the sign for which w
/// vanishes on the way: that of -cos ψ), zero_speed.
Result<FrameRoll> periodic_roll(const PreimageTable& path, double gamma);

/// γ₋ < 0 < γ₊ whose frames are C¹ at the closing knot as well (where the path is C²):
/// χ₁/σ + θ'/σ agrees there, γ²/σ_N sin ψ ... a quadratic equation with roots of both signs.
/// Faults: as periodic_roll, and no_interpolant where sin ψ = 0 (every γ, or none).
struct SmoothGammas {
  double negative = 0.0, positive = 0.0;
};
Result<SmoothGammas> smooth_periodic_gammas(const PreimageTable& path);

/// The γ in [-100, -0.01] ∪ [0.01, 100] with the least absolute twist, and that twist. Where a
/// whole interval of γ has it (every rotation in one sense: no γ can do better), the member nearest
/// to ±1, and `plateau`. Faults: as periodic_roll. Accuracy: γ within rounding of a zero of the
/// derivative of the absolute twist, which is found in closed form; the global least among the
/// minima that a grid of 64 γ a sign separates.
struct LeastTwistGamma {
  double gamma = 1.0, absolute_twist = 0.0;
  bool plateau = false;
};
Result<LeastTwistGamma> least_twist_gamma(const PreimageTable& path);

/// The frame of least absolute twist: rotation-minimising but for a rotation about the tangent that
/// is even over the arc length. On a closed path it returns to itself (the least turn that does so,
/// |total| ≤ π, is the least absolute twist of any periodic frame); on an open one it ends with the
/// roll `end` modulo 2π, or is the rotation-minimising one where none is given.
/// Faults: as rotation_minimising_roll; unsupported (an end for a closed path).
Result<FrameRoll> least_twist_roll(const PreimageTable& path, double begin = 0.0,
                                   std::optional<double> end = std::nullopt);

}  // namespace hodograph
