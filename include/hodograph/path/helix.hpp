// SPDX-License-Identifier: MIT
// Helical paths recognised: the axis to which the tangent keeps a constant inclination, the climb
// angle, how well they fit, and the path's plan, the planar PH curve that it is a lifting of.
//
// With r' = A i A* and σ = |A|², a path climbs at the angle θ along the axis a where a·r' = σ sin θ
// as polynomials: a linear condition, which holds for every preimage of the curve and needs no
// special form of it. For a preimage in reduced form it gives the axis and angle of "Helical
// polynomial curves interpolating G1 data with prescribed axes and pitch angles", Remark 2 (whose
// formula for the angle is that of r' = A i A*, not of its own convention r' = A k A*).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/any_path.hpp"
#include "hodograph/path/detail/enclosed_curve.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// a/|a|, to a rounding or two. Domain: finite and not zero, of any length.
Vector3<double> unit_axis(const Vector3<double>& axis);

/// The unit quaternion U with U a U* = k: the turn along a great circle that brings the axis a
/// upright; U = (1 + a·k, a × k) normalised, 1 + a_z without cancellation, and i for a = -k.
/// Domain: a finite and not zero, of any length; accurate to a few ε.
Quaternion<double> turn_upright(const Vector3<double>& axis);

/// Consecutive segments of one climb angle.
struct HelixStretch {
  std::size_t first = 0, last = 0;  ///< segments
  double sine = 0.0;                ///< sin θ, of the angle between the tangent and the level
  /// Contains a·r'/σ everywhere on these segments, of the curve of the stored numbers and the axis
  /// as stored, rounding included.
  Enclosure sine_range;
};

/// The axis that fits a path best, and how the path climbs along it.
struct HelixFit {
  Vector3<double> axis{0.0, 0.0, 1.0};  ///< unit; in the upper half-space (z > 0, or y, or x)
  /// The largest |Bernstein coefficient of a·r' - σ sin θ|, in units of the largest |A_i|² of its
  /// segment: |sin of the inclination - sin θ| is at most this where σ is that large.
  double residual = 0.0;
  /// How many independent axes fit within rounding: 0: none; 1: this one; 3: any (straight lines).
  std::size_t freedom = 0;
  std::vector<HelixStretch> stretches;

  /// Whether the tangent keeps its inclination within rounding, on every segment; and with the same
  /// climb angle on all of them.
  bool is_helical() const { return freedom > 0; }
  bool is_helix() const { return is_helical() && stretches.size() == 1; }
};

/// The helix of a path, segments of different climb angles about one axis included: the axis is
/// the unit vector for which the residuals have the least sum of squares, by a singular value
/// decomposition; the vertical axis k where it fits within rounding. The axis of a helix is as
/// accurate as its tangent's circle allows: about ε over the circle's angular height. Planar paths
/// are helices, too, about their normal with θ = 0. Domain: any path in space.
HelixFit recognised_helix(const PathNumbers& path);
template <std::size_t n>
HelixFit recognised_helix(const SpatialPath<n>& path);

/// Contains a·r'/σ everywhere on the segments first to last, of the curve of the stored numbers and
/// the axis as it stands (not normalised), rounding included; the whole line where the speed may
/// vanish. Domain: a path in space, first ≤ last, within it.
Enclosure sine_range(const PathNumbers& path, const Vector3<double>& axis, std::size_t first,
                     std::size_t last);

/// A helical curve as the lifting of a planar one: up to rounding
///   A(u) = U* (a(u) + b(u) k) (c + d j) (cos(roll/2) + i sin(roll/2)),
/// with the plan's preimage w = a + b i, c = √((1 + sec θ)/2), d = -tan θ/(2c), U = turn_upright
/// (axis). So |w|² = σ cos θ, the level direction of flight in the upright frame is w², its angle
/// 2 arg w, and the frame of the reduced preimage (roll = 0) has e₂ level and to the left.
template <std::size_t n>
struct HelicalDecomposition {
  Vector3<double> axis{0.0, 0.0, 1.0};
  double sine = 0.0, cosine = 1.0;  ///< of the climb angle θ
  Quaternion<double> upright{1.0, 0.0, 0.0, 0.0};
  BernsteinPolynomial<Complex<double>, n> plan;  ///< w, in the global scaling of A
  double roll = 0.0;      ///< of this preimage's frame against the level one, radians
  double residual = 0.0;  ///< the largest deviation from the formula, in units of the largest |A_i|
};

/// The decomposition of a curve about an axis. Faults: unsupported (the curve is no helix about
/// this axis within rounding, or its preimage has a factor that rolls along the curve, so that it
/// is not of the form above; with the residual), outside_domain (an axis that is zero or not
/// finite, or the curve's own tangent: there is no plan).
template <std::size_t n>
Result<HelicalDecomposition<n>> helical_decomposition(const SpatialPhCurve<n>& curve,
                                                      const Vector3<double>& axis);

// ------------------------------------------------------------------------------------------------

namespace path_detail {

/// sine, cosine, plan, roll and residual from U A_i, in units of the largest |A_i|; the plan's
/// coefficients as well.
struct PlanFit {
  double sine = 0.0, cosine = 1.0, roll = 0.0, residual = 0.0;
};
Result<PlanFit> fit_plan(std::span<const Quaternion<double>> upright,
                         std::span<Complex<double>> plan);
std::optional<Fault> axis_fault(const Vector3<double>& axis);

}  // namespace path_detail

template <std::size_t n>
HelixFit recognised_helix(const SpatialPath<n>& path) {
  PathNumbers numbers;
  numbers.preimage_degree = n;
  numbers.knots = path.knots();
  for (const auto& curve : path.segments()) {
    for (const Quaternion<double>& a : curve.preimage().coefficients()) {
      numbers.preimages.insert(numbers.preimages.end(), {a.w, a.x, a.y, a.z});
    }
  }
  return recognised_helix(numbers);
}

template <std::size_t n>
Result<HelicalDecomposition<n>> helical_decomposition(const SpatialPhCurve<n>& curve,
                                                      const Vector3<double>& axis) {
  if (auto fault = path_detail::axis_fault(axis)) return *std::move(fault);
  HelicalDecomposition<n> result;
  result.axis = unit_axis(axis);
  result.upright = turn_upright(axis);
  double size = 0.0;
  for (const auto& a : curve.preimage().coefficients()) size = std::max(size, largest_component(a));
  const int exponent = path_detail::exponent_of(size);
  std::array<Quaternion<double>, n + 1> turned;
  for (std::size_t i = 0; i <= n; ++i) {
    const auto& a = curve.preimage()[i];
    turned[i] =
        result.upright * Quaternion<double>{std::ldexp(a.w, -exponent), std::ldexp(a.x, -exponent),
                                            std::ldexp(a.y, -exponent), std::ldexp(a.z, -exponent)};
  }
  std::array<Complex<double>, n + 1> plan;
  const auto fit = path_detail::fit_plan(turned, plan);
  if (!fit) return fit.fault();
  for (Complex<double>& w : plan) {
    w = {std::ldexp(w.re, exponent), std::ldexp(w.im, exponent)};
  }
  result.plan = BernsteinPolynomial<Complex<double>, n>(plan);
  result.sine = fit->sine;
  result.cosine = fit->cosine;
  result.roll = fit->roll;
  result.residual = fit->residual;
  return result;
}

}  // namespace hodograph
